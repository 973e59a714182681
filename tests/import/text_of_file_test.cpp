// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/text_of_file.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/urdf.hpp"

namespace torsor::text_of_file_test {
namespace {

std::string refusal(const std::string& path) {
  try {
    text_of_file(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(TextOfFile, SaysWhatCannotBeRead) {
  EXPECT_EQ(refusal("/tmp"), "cannot read '/tmp': it is a folder; name a file in it");
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: the file is binary and no XML");
  EXPECT_EQ(refusal("/no/such.urdf"), "cannot read '/no/such.urdf': does the file exist?");
  EXPECT_EQ(text_of_file("/dev/null"), "");
  EXPECT_THROW(read_urdf("/tmp"), FileError);
  EXPECT_THROW(read_urdf("/dev/zero"), FileError);
}

TEST(TextOfFile, ReadsAPipeWhoseWriterComesLaterAndWritesInPieces) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("torsor_pipe_" + std::to_string(::getpid()) + ".urdf");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&path] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::ofstream pipe(path);
    pipe << "<robot name=\"r\">" << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pipe << "</robot>";
  });
  EXPECT_EQ(text_of_file(path.string()), "<robot name=\"r\"></robot>");
  writer.join();
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace torsor::text_of_file_test
