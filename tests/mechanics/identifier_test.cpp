// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/identifier.hpp"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::identifier_test {
namespace {

/// What a command prints, line by line.
std::vector<std::string> lines_of(const std::string& command) {
  std::vector<std::string> lines;
  FILE* output = ::popen(command.c_str(), "r");
  if (output == nullptr) return lines;
  std::string line;
  for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) {
    if (c != '\n') {
      line += static_cast<char>(c);
    } else {
      lines.push_back(line);
      line.clear();
    }
  }
  ::pclose(output);
  return lines;
}

/// Headers that generated files include, and those that a program of the runtime includes besides.
const std::string of_generated_files = "#include <array>\\n#include <cmath>\\n";
const std::string of_programs = of_generated_files +
                                "#include <algorithm>\\n#include <cerrno>\\n#include <charconv>\\n#include <cstdint>\\n#include <cstdio>\\n"
                                "#include <cstdlib>\\n#include <cstring>\\n#include <filesystem>\\n#include <fstream>\\n"
                                "#include <iostream>\\n#include <limits>\\n#include <thread>\\n#include <unistd.h>\\n"
                                "#include <sys/file.h>\\n#include <sys/wait.h>\\n";

/// Macros that headers bring along with that compiler, but those that no name of a scene can be (names begin with a
/// letter); empty when the compiler is not there.
std::vector<std::string> macros_of(const std::string& compiler, const std::string& headers) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of("printf '" + headers + "' | " + compiler + " -x c++ -dM -E - 2>/dev/null")) {
    const std::string define = "#define ";
    if (line.compare(0, define.size(), define) != 0 || line[define.size()] == '_') continue;
    names.push_back(line.substr(define.size(), line.find_first_of(" (", define.size()) - define.size()));
  }
  return names;
}

bool may_name_a_scene(const std::string& name) {
  try {
    require_identifier(name, "scene");
  } catch (const SceneError&) {
    return false;
  }
  return reserved_in_headers(name, true) == nullptr;
}

/// Words of the headers as that compiler sees them, each once.
std::set<std::string> words_of(const std::string& compiler, const std::string& headers) {
  std::set<std::string> words;
  for (const std::string& line : lines_of("printf '" + headers + "' | " + compiler + " -x c++ -E - 2>/dev/null")) {
    std::string word;
    for (const char c : line.substr(0, line.find('#')) + " ") {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        word += c;
      } else {
        words.insert(word);
        word.clear();
      }
    }
  }
  return words;
}

TEST(Identifier, IsNoMacroOfTheHeadersThatGeneratedFilesInclude) {
  std::size_t count = 0;
  for (const std::string compiler : {"g++", "clang++"}) {
    for (const std::string standard : {" -std=c++17", " -std=gnu++17", " -std=gnu++20"}) {
      for (const std::string& name : macros_of(compiler + standard, of_generated_files)) {
        ++count;
        EXPECT_NE(reserved_in_headers(name, false), nullptr) << compiler << standard << ": " << name;
      }
    }
    for (const std::string& name : macros_of(compiler, of_programs)) {
      EXPECT_NE(reserved_in_headers(name, false), nullptr) << compiler << ": " << name;
    }
  }
  EXPECT_GT(count, 100U);  // some compiler was there
}

// A scene's name is a namespace: it cannot be what a header declares, nor what a compiler knows without any.
TEST(Identifier, OfASceneIsNothingThatTheLibraryDeclares) {
  std::size_t compilers = 0;
  for (const std::string compiler : {"g++", "clang++"}) {
    const std::set<std::string> words = words_of(compiler, of_programs);
    if (words.size() < 1000) continue;  // not installed
    ++compilers;
    std::string source;
    std::size_t count = 0;
    for (const std::string& word : words) {
      if (!may_name_a_scene(word)) continue;
      source += "namespace " + word + " { struct Mechanism {}; }\n";
      ++count;
    }
    EXPECT_GT(count, 500U);
    const std::filesystem::path path = std::filesystem::temp_directory_path() / ("torsor_names_" + std::to_string(::getpid()) + ".cpp");
    for (const std::string& headers : {of_generated_files, of_programs}) {
      std::ofstream(path) << std::regex_replace(headers, std::regex(R"(\\n)"), "\n") << source;
      const auto errors = lines_of(compiler + " -Wall -Wextra -Werror -fsyntax-only " + path.string() + " 2>&1");
      EXPECT_TRUE(errors.empty()) << compiler << ": " << errors.front();
    }
    std::filesystem::remove(path);
  }
  EXPECT_GT(compilers, 0U);
}

TEST(Identifier, MayLookLikeAMacroAndBeNone) {
  for (const std::string name : {"LF_HAA", "M", "M_1", "M_A", "J1", "TORQUE_MAX", "FP", "SIZE", "smooth", "E", "I", "INT_A"}) {
    EXPECT_EQ(reserved_in_headers(name, false), nullptr) << name;
  }
}

}  // namespace
}  // namespace torsor::identifier_test
