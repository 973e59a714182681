// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/output_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "torsor/generator/base/error.hpp"
#include "tests/faults/full_disk.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace torsor::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::TemporaryFolder {
 protected:
  std::string text(const std::string& name) const { return contents(path(name)); }
  static std::string message_of(const std::string& path, std::string_view bytes = "x") {
    return ::error_of<FileError>([&] { write_file_if_changed(path, bytes); });
  }
};

TEST_F(OutputFile, HasExactlyTheBytesGiven) {
  const std::string bytes("a\0b\r\n\xff", 6);
  EXPECT_TRUE(write_file_if_changed(path("new"), bytes));
  EXPECT_EQ(text("new"), bytes);
  EXPECT_TRUE(write_file_if_changed(path("new"), "short"));
  EXPECT_EQ(text("new"), "short");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFile, IsNotTouchedWhenItHasTheBytesAlready) {
  write_file_if_changed(path("same"), "bytes");
  const auto long_ago = fs::last_write_time(path("same")) - std::chrono::hours(1);
  fs::last_write_time(path("same"), long_ago);
  EXPECT_FALSE(write_file_if_changed(path("same"), "bytes"));
  EXPECT_EQ(fs::last_write_time(path("same")), long_ago);
}

TEST_F(OutputFile, IsOneUnderSeveralNamesBeforeItIsThere) {
  EXPECT_TRUE(same_file("not_there_yet.hpp", "./not_there_yet.hpp"));
  EXPECT_TRUE(same_file(path("new.hpp"), path("./new.hpp")));
  EXPECT_FALSE(same_file("not_there_yet.hpp", "not_there_either.hpp"));
  EXPECT_FALSE(same_file("/dev/null", "/dev/null"));
}

TEST_F(OutputFile, KeepsItsPermissions) {
  write_file_if_changed(path("mine"), "old");
  ASSERT_EQ(chmod(path("mine").c_str(), 0640), 0);
  write_file_if_changed(path("mine"), "new");
  EXPECT_EQ(fs::status(path("mine")).permissions(), static_cast<fs::perms>(0640));
}

TEST_F(OutputFile, StaysALinkWhenItIsOne) {
  write_file_if_changed(path("target"), "old");
  fs::create_symlink("target", path("link"));
  EXPECT_TRUE(write_file_if_changed(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(text("target"), "new");

  fs::create_symlink("nowhere_yet", path("dangling"));
  EXPECT_TRUE(write_file_if_changed(path("dangling"), "first"));
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(text("nowhere_yet"), "first");
}

TEST_F(OutputFile, IsWrittenThroughWhenItIsAPipe) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = text("pipe"); });
  EXPECT_TRUE(write_file_if_changed(path("pipe"), "through"));
  reader.join();
  EXPECT_EQ(received, "through");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFile, AppendsToStandardOutputWhereverThatGoes) {
  testing::internal::CaptureStdout();  // a regular file behind /dev/stdout
  std::cout << "before ";
  EXPECT_TRUE(write_file_if_changed("/dev/stdout", "through"));
  std::cout << " after" << std::flush;
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "before through after");
}

TEST_F(OutputFile, ReportsAFullDevice) {
  EXPECT_EQ(message_of("/dev/full"),
            "cannot write '/dev/full': No space left on device; make room, or choose another disk");
}

TEST_F(OutputFile, LeavesNothingHalfWrittenWhenTheDiskIsFull) {
  write_file_if_changed(path("kept"), "old");
  const std::string big(10000, 'x');
  std::string over_old, anew;
  {
    const testing_files::FullDisk disk(4096);
    over_old = message_of(path("kept"), big);
    anew = message_of(path("anew"), big);
  }
  EXPECT_EQ(over_old, "cannot write '" + path("kept") + "': File too large; make room, or choose another disk");
  EXPECT_EQ(anew, "cannot write '" + path("anew") + "': File too large; make room, or choose another disk");
  EXPECT_EQ(text("kept"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFile, NamesAMissingFolder) {
  EXPECT_EQ(message_of(path("missing/header.hpp")), "cannot write '" + path("missing/header.hpp") +
                                                        "': No such file or directory; create the folder first, or "
                                                        "choose another one");
}

TEST_F(OutputFile, RefusesAFolderAndAnEmptyName) {
  EXPECT_EQ(message_of(path("")), "cannot write '" + path("") + "': Is a directory; name a file in it");
  EXPECT_EQ(message_of(""), "cannot write a file without a name: give a path, or /dev/stdout");
}

TEST_F(OutputFile, RespectsPermissions) {
  write_file_if_changed(path("locked"), "old");
  ASSERT_EQ(chmod(path("locked").c_str(), 0444), 0);
  fs::create_directory(path("closed"));
  ASSERT_EQ(chmod(path("closed").c_str(), 0555), 0);
  ASSERT_EQ(chmod(path("").c_str(), 0777), 0);
  const auto as_anybody = [this](const std::string& name) {
    if (geteuid() == 0 && setuid(65534) != 0) std::exit(2);  // root may write everything: a child that is not root
    std::cerr << message_of(path(name), "new");
    std::exit(3);
  };
  const std::string refusal = "Permission denied; ask for the right to write there, or choose another place";
  EXPECT_EXIT(as_anybody("locked"), testing::ExitedWithCode(3), "locked.: " + refusal);
  EXPECT_EXIT(as_anybody("closed/new"), testing::ExitedWithCode(3), "closed/new.: " + refusal);
  EXPECT_EQ(text("locked"), "old");
  EXPECT_EQ(files(), 2U);
}

}  // namespace
}  // namespace torsor::output_file_test
