// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/temporary_folder.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::temporary_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsNewEmptyOfThisUserAloneAndGoesWithWhatIsInIt) {
  fs::path first;
  {
    const TemporaryFolder one(fs::temp_directory_path(), "torsor-test-"), other(fs::temp_directory_path(), "torsor-test-");
    first = one.path();
    EXPECT_NE(first, other.path());
    EXPECT_TRUE(fs::is_empty(first));
    EXPECT_EQ(fs::status(first).permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
    fs::create_directory(first / "inner");
    std::ofstream(first / "inner" / "file") << "text";
    EXPECT_TRUE(fs::exists(first / "inner" / "file"));
  }
  EXPECT_FALSE(fs::exists(first));
}

TEST(TemporaryFolder, SaysWhereItCannotBe) {
  try {
    const TemporaryFolder none("/no/such/folder", "torsor-");
    FAIL() << none.path();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("'/no/such/folder': No such file"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace torsor::temporary_folder_test
