// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/fmi_platform.hpp"

#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

using Names = std::initializer_list<std::pair<const char*, const char*>>;

/// What stands beside the first macro that is defined; empty: none is.
std::string first_defined(const std::string& macros, Names names) {
  for (const auto& [macro, name] : names) {
    if (("\n" + macros).find(fmt::format("\n#define {} ", macro)) != std::string::npos) return name;
  }
  return {};
}

std::string name_of_2(const std::string& platform) {
  for (const auto& [three, two] : Names{{"x86_64-linux", "linux64"},
                                        {"x86-linux", "linux32"},
                                        {"x86_64-windows", "win64"},
                                        {"x86-windows", "win32"},
                                        {"x86_64-darwin", "darwin64"}}) {
    if (platform == three) return two;
  }
  return platform;
}

}  // namespace

FmiPlatform fmi_platform(const std::string& macros, FmiVersion version) {
  std::string processor =
      first_defined(macros, {{"__x86_64__", "x86_64"}, {"__i386__", "x86"}, {"__aarch64__", "aarch64"}, {"__arm__", "aarch32"},
                             {"__riscv", "riscv"}, {"__powerpc64__", "ppc64"}, {"__powerpc__", "ppc32"}});
  if (processor == "riscv") processor += first_defined(macros, {{"__LP64__", "64"}, {"__riscv", "32"}});
  const std::string system =
      first_defined(macros, {{"__linux__", "linux"}, {"_WIN32", "windows"}, {"__APPLE__", "darwin"}});
  if (processor.empty() || system.empty()) {
    throw FileError("the compiler builds for a processor or a system that FMI has no name for: leave the binary out "
                    "(--sources-only), or set CC to a compiler for Linux, Windows or macOS");
  }
  const std::string platform = processor + "-" + system;
  return {version == FmiVersion::two ? name_of_2(platform) : platform,
          system == "windows"  ? ".dll"
          : system == "darwin" ? ".dylib"
                               : ".so"};
}

}  // namespace torsor
