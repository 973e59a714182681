// SPDX-License-Identifier: GPL-3.0-or-later
// Names of platforms as FMI 2.0 (2.2.4) and FMI 3.0 (2.5.1.4) give them.
#include "torsor/generator/cli/fmi_platform.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::fmi_platform_test {
namespace {

std::string defined(const std::vector<std::string>& macros) {
  std::string text = "#define __STDC__ 1\n";
  for (const std::string& macro : macros) text += "#define " + macro + " 1\n";
  return text;
}

std::string file(const std::vector<std::string>& macros, FmiVersion version) {
  const FmiPlatform platform = fmi_platform(defined(macros), version);
  return platform.folder + platform.suffix;
}

TEST(FmiPlatform, HasTheFolderOfItsCompiler) {
  const auto two = FmiVersion::two, three = FmiVersion::three;
  EXPECT_EQ(file({"__x86_64__", "__linux__", "__LP64__"}, two), "linux64.so");
  EXPECT_EQ(file({"__x86_64__", "__linux__", "__LP64__"}, three), "x86_64-linux.so");
  EXPECT_EQ(file({"__i386__", "__linux__"}, two), "linux32.so");
  EXPECT_EQ(file({"__i386__", "__linux__"}, three), "x86-linux.so");
  EXPECT_EQ(file({"_WIN32", "_WIN64", "__x86_64__"}, two), "win64.dll");
  EXPECT_EQ(file({"_WIN32", "__i386__"}, two), "win32.dll");
  EXPECT_EQ(file({"_WIN32", "_WIN64", "__x86_64__"}, three), "x86_64-windows.dll");
  EXPECT_EQ(file({"__APPLE__", "__x86_64__"}, two), "darwin64.dylib");
  EXPECT_EQ(file({"__APPLE__", "__aarch64__"}, three), "aarch64-darwin.dylib");
  EXPECT_EQ(file({"__aarch64__", "__linux__", "__LP64__"}, two), "aarch64-linux.so");
  EXPECT_EQ(file({"__arm__", "__linux__"}, three), "aarch32-linux.so");
  EXPECT_EQ(file({"__riscv", "__linux__", "__LP64__"}, three), "riscv64-linux.so");
  EXPECT_EQ(file({"__riscv", "__linux__"}, three), "riscv32-linux.so");
}

TEST(FmiPlatform, RefusesWhatHasNoName) {
  EXPECT_THROW((void)file({"__arm__"}, FmiVersion::three), FileError);  // a microcontroller without a system
  EXPECT_THROW((void)file({"__linux__"}, FmiVersion::two), FileError);
  EXPECT_THROW((void)file({"__x86_64__32", "__linux__"}, FmiVersion::two), FileError);
}

}  // namespace
}  // namespace torsor::fmi_platform_test
