// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/embedded_templates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"

namespace torsor::embedded_templates_test {
namespace {

const std::filesystem::path folder = std::filesystem::path(TORSOR_SOURCE_DIR) / "templates";

std::vector<std::string> files_of_the_folder() {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(EmbeddedTemplates, AreTheFilesOfTheFolderInAlphabeticalOrder) {
  const std::vector<std::string_view> names = embedded_template_names();
  EXPECT_EQ(std::vector<std::string>(names.begin(), names.end()), files_of_the_folder());
}

TEST(EmbeddedTemplates, KeepEveryByteOfTheirFile) {
  for (const std::string& name : files_of_the_folder()) {
    std::ifstream file(folder / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(embedded_template(name), text.str()) << name;
  }
}

TEST(EmbeddedTemplates, NameTheUnknownOne) {
  try {
    embedded_template("no/such/template");
    FAIL() << "an unknown template was found";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/template"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace torsor::embedded_templates_test
