// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/identifier.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace torsor::identifier_test {
namespace {

/// Macros that the headers of a generated file bring along with that compiler, but those that no name of a scene can be
/// (names begin with a letter); empty when the compiler is not there.
std::vector<std::string> macros_of(const std::string& compiler) {
  const std::string command =
      "printf '#include <array>\\n#include <cmath>\\n' | " + compiler + " -x c++ -dM -E - 2>/dev/null";
  std::vector<std::string> names;
  FILE* output = ::popen(command.c_str(), "r");
  if (output == nullptr) return names;
  std::string text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), output) != nullptr) {
    const std::string line = buffer.data();
    const std::string define = "#define ";
    if (line.compare(0, define.size(), define) != 0 || line[define.size()] == '_') continue;
    names.push_back(line.substr(define.size(), line.find_first_of(" (\n", define.size()) - define.size()));
  }
  ::pclose(output);
  return names;
}

TEST(Identifier, IsNoMacroOfTheHeadersThatGeneratedFilesInclude) {
  std::size_t count = 0;
  for (const std::string compiler : {"g++", "clang++"}) {
    for (const std::string standard : {" -std=c++17", " -std=gnu++17", " -std=gnu++20"}) {
      for (const std::string& name : macros_of(compiler + standard)) {
        ++count;
        EXPECT_NE(reserved_in_headers(name, false), nullptr) << compiler << standard << ": " << name;
      }
    }
  }
  EXPECT_GT(count, 100U);  // some compiler was there
}

TEST(Identifier, MayLookLikeAMacroAndBeNone) {
  for (const std::string name : {"LF_HAA", "M", "M_1", "M_A", "J1", "TORQUE_MAX", "FP", "SIZE", "smooth", "E", "I", "INT_A"}) {
    EXPECT_EQ(reserved_in_headers(name, false), nullptr) << name;
  }
}

}  // namespace
}  // namespace torsor::identifier_test
