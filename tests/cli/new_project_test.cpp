// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/cli/tool_runner.hpp"

namespace torsor::new_project_test {
namespace {

using testing_programs::Outcome;
using testing_programs::torsor_tool;

/// A fresh folder that is the working folder as long as this lives.
class InFreshFolder {
 public:
  InFreshFolder() : before_(std::filesystem::current_path()) {
    std::string name = (std::filesystem::temp_directory_path() / "torsor-new-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    folder_ = name;
    std::filesystem::current_path(folder_);
  }
  ~InFreshFolder() {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }
  InFreshFolder(const InFreshFolder&) = delete;
  InFreshFolder& operator=(const InFreshFolder&) = delete;

 private:
  std::filesystem::path before_, folder_;
};

std::string content(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(NewProject, HasASceneAProgramAndAPage) {
  const InFreshFolder here;
  const Outcome outcome = torsor_tool({"new", "crane"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "crane/scene.cpp\ncrane/main.cpp\ncrane/CMakeLists.txt\ncrane/README.md\n");
  EXPECT_NE(content("crane/scene.cpp").find("TORSOR_SCENE(crane_scene)"), std::string::npos);
  EXPECT_NE(content("crane/main.cpp").find("#include \"crane.hpp\""), std::string::npos);
  EXPECT_NE(content("crane/CMakeLists.txt").find("torsor_add_mechanism(crane SCENE scene.cpp"), std::string::npos);
  EXPECT_NE(content("crane/README.md").find("build/crane_scene equations"), std::string::npos);
}

// A second run would write over what its author has made of the first.
TEST(NewProject, WritesOverNothing) {
  const InFreshFolder here;
  EXPECT_EQ(torsor_tool({"new", "crane"}).code, 0);
  std::ofstream("crane/scene.cpp") << "mine";
  const Outcome again = torsor_tool({"new", "crane"});
  EXPECT_EQ(again.code, 3);
  EXPECT_NE(again.err.find("'crane' exists already"), std::string::npos) << again.err;
  EXPECT_EQ(content("crane/scene.cpp"), "mine");
}

TEST(NewProject, RefusesNamesThatNoSceneCanHave) {
  const InFreshFolder here;
  for (const char* name : {"../up", "a b", "class", "1st", "$(touch x)", "printf"}) {
    const Outcome outcome = torsor_tool({"new", name});
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(torsor_tool({"new"}).code, 2);
  EXPECT_TRUE(std::filesystem::is_empty("."));
}

}  // namespace
}  // namespace torsor::new_project_test
