// SPDX-License-Identifier: GPL-3.0-or-later
// Files on disks that fail at the last moment: the file that was there stays as it was, and nothing else is left.
#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/runtime/records/file.hpp"
#include "tests/faults/file_calls.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace torsor::file_faults_test {
namespace {

using testing_files::file_calls;

class FileFaults : public TemporaryFolder {
 protected:
  /// Writes "new" over "old" while that call fails; the message that says so.
  template <class Error, class Write>
  std::string message_of_failing(const std::string& call, const Write& write) const {
    const std::filesystem::path path = put("kept", "old");
    file_calls() = {call, {}};
    const std::string message = error_of<Error>([&] { write(path); });
    file_calls() = {};
    EXPECT_EQ(contents(path), "old") << call;
    EXPECT_EQ(files(), 1U) << call;
    return message;
  }

  /// The calls that bring "new" to the disk in the place of "old".
  template <class Write>
  std::vector<std::string> calls_of(const Write& write) const {
    const std::filesystem::path path = put("kept", "old");
    file_calls() = {};
    write(path);
    const std::vector<std::string> made = file_calls().made;
    EXPECT_EQ(contents(path), "new");
    return made;
  }
};

void generate(const std::filesystem::path& path) { write_file_if_changed(path.string(), "new"); }
void record(const std::filesystem::path& path) { runtime::write_file(path, "new"); }

/// Where in the calls that one is made for the last time.
std::ptrdiff_t last(const std::vector<std::string>& calls, const std::string& call) {
  for (std::size_t i = calls.size(); i > 0; --i) {
    if (calls[i - 1] == call) return static_cast<std::ptrdiff_t>(i) - 1;
  }
  return -1;
}

TEST_F(FileFaults, OfGeneratedFilesKeepTheOldOneAndSayWhy) {
  for (const std::string call : {"fsync", "close", "rename"}) {
    EXPECT_TRUE(mentions(message_of_failing<FileError>(call, generate), {"cannot write", "kept"})) << call;
  }
}

TEST_F(FileFaults, OfFilesOfTheRuntimeKeepTheOldOneAndSayWhy) {
  for (const std::string call : {"fsync", "fclose", "rename"}) {
    EXPECT_TRUE(mentions(message_of_failing<runtime::FileError>(call, record), {"cannot write", "kept"})) << call;
  }
}

TEST_F(FileFaults, CannotLeaveANameWithoutItsBytes) {
  const std::vector<std::string> generated = calls_of(generate), recorded = calls_of(record);
  for (const std::vector<std::string>& calls : {generated, recorded}) {
    EXPECT_GE(last(calls, "fsync"), 0);
    EXPECT_LT(last(calls, "fsync"), last(calls, "rename"));
  }
}

}  // namespace
}  // namespace torsor::file_faults_test
