// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "tests/cli/tool_runner.hpp"

namespace torsor::xacro_program_test {
namespace {

using testing_programs::Outcome;
using testing_programs::torsor_tool;

/// Runs the tool in this process on files of a folder of its own.
class TorsorToolWithXacro : public testing::Test {
 protected:
  TorsorToolWithXacro() : folder_(std::filesystem::path(testing::TempDir()) / ("tool_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_ / "inc");
    write("robot.urdf.xacro", R"xml(<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="links" default="2"/>
  <xacro:include filename="inc/link.xacro"/>
  <link name="base"/>
  <xacro:chain i="0" n="$(arg links)" parent="base"/>
</robot>)xml");
    write("inc/link.xacro", R"xml(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="0.3"/>
  <xacro:macro name="chain" params="i n parent m:=1.2">
    <xacro:if value="${i &lt; n}">
      <link name="l${i}">
        <inertial><origin xyz="0 0 ${length/2}"/><mass value="${m}"/>
          <inertia ixx="${m*length**2/12}" iyy="${m*length**2/12}" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
      </link>
      <joint name="j${i}" type="revolute"><parent link="${parent}"/><child link="l${i}"/>
        <origin xyz="0 0 ${length if i else 0}" rpy="${pi/2 if i else 0} 0 0"/><axis xyz="${i % 2} ${1 - i % 2} 0"/>
        <limit lower="${radians(-90)}" upper="${radians(90)}" effort="10" velocity="2"/></joint>
      <xacro:chain i="${i + 1}" n="${n}" parent="l${i}"/>
    </xacro:if>
  </xacro:macro>
</robot>)xml");
    // What Python's arithmetic makes of it.
    write("robot.urdf", R"xml(<robot name="arm">
  <link name="base"/>
  <link name="l0"><inertial><origin xyz="0 0 0.15"/><mass value="1.2"/>
    <inertia ixx="0.009" iyy="0.009" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j0" type="revolute"><parent link="base"/><child link="l0"/><origin xyz="0 0 0" rpy="0 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-1.5707963267948966" upper="1.5707963267948966" effort="10" velocity="2"/></joint>
  <link name="l1"><inertial><origin xyz="0 0 0.15"/><mass value="1.2"/>
    <inertia ixx="0.009" iyy="0.009" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j1" type="revolute"><parent link="l0"/><child link="l1"/><origin xyz="0 0 0.3" rpy="1.5707963267948966 0 0"/>
    <axis xyz="1 0 0"/><limit lower="-1.5707963267948966" upper="1.5707963267948966" effort="10" velocity="2"/></joint>
</robot>)xml");
  }
  ~TorsorToolWithXacro() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream file(folder_ / name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  std::filesystem::path folder_;
};

/// A header without its first lines, which name the file.
std::string body(const std::string& header) { return header.substr(std::min(header.find("#include"), header.size())); }

TEST_F(TorsorToolWithXacro, GivesTheHeaderOfTheExpandedFile) {
  const Outcome from_xacro =
      torsor_tool({"generate", path("robot.urdf.xacro"), "--kernels", "inverse_dynamics", "-o", "-"});
  ASSERT_EQ(from_xacro.code, 0) << from_xacro.err;
  const Outcome from_urdf = torsor_tool({"generate", path("robot.urdf"), "--kernels", "inverse_dynamics", "-o", "-"});
  ASSERT_EQ(from_urdf.code, 0) << from_urdf.err;
  EXPECT_GT(body(from_urdf.out).size(), 1000U);
  EXPECT_EQ(body(from_xacro.out), body(from_urdf.out));
}

TEST_F(TorsorToolWithXacro, TakesArgumentsAndTellsThemInTheHeader) {
  const Outcome three =
      torsor_tool({"generate", path("robot.urdf.xacro"), "--arg", "links:=3", "--kernels", "energy", "-o", "-"});
  ASSERT_EQ(three.code, 0) << three.err;
  EXPECT_NE(three.out.find("j2"), std::string::npos);
  EXPECT_NE(three.out.find("//   torsor generate robot.urdf.xacro --arg 'links:=3' --kernels energy"),
            std::string::npos)
      << three.out.substr(0, 2000);
  EXPECT_EQ(torsor_tool({"list", path("robot.urdf.xacro"), "--arg", "links=3"}).err,
            "torsor: --arg takes NAME:=VALUE, e.g. prefix:=left_, and got 'links=3'\n");
  EXPECT_EQ(torsor_tool({"list", path("robot.urdf.xacro"), "--arg", "link:=3"}).err,
            "torsor: --arg link: did you mean 'links'? the file declares links\n");
  EXPECT_EQ(torsor_tool({"list", path("robot.urdf"), "--arg", "links:=3"}).code, 2);
}

TEST_F(TorsorToolWithXacro, NamesTheFileTheLineAndTheMacroOfWhatURDFRefuses) {
  write("inc/link.xacro", R"xml(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="chain" params="i n parent">
    <link name="l"><inertial><mass value="${'heavy'}"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  </xacro:macro>
</robot>)xml");
  const Outcome outcome = torsor_tool({"list", path("robot.urdf.xacro")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "torsor: " + path("inc/link.xacro") +
                             ":3: <mass> of <inertial> of <link name=\"l\"> (in the macro "
                             "'chain', called at " +
                             path("robot.urdf.xacro") +
                             ":5): value=\"heavy\": 'heavy' is not a number; "
                             "write a decimal such as 0.25 or -1.5e-3\n");
}

TEST_F(TorsorToolWithXacro, WritesWhatItReadAsARuleOfMake) {
  ASSERT_EQ(torsor_tool({"list", path("robot.urdf.xacro"), "--depfile", path("arm.stamp.d")}).code, 0);
  EXPECT_EQ(text("arm.stamp.d"),
            path("arm.stamp") + ": \\\n  " + path("robot.urdf.xacro") + " \\\n  " + path("inc/link.xacro") + "\n");
  EXPECT_EQ(torsor_tool({"list", path("robot.urdf"), "--depfile", path("arm")}).code, 2);
}

/// Exit 2, the files' names in the message, and every file as it was.
#define EXPECT_KEPT(outcome, name, named)                                                \
  do {                                                                                   \
    const Outcome kept = outcome;                                                        \
    EXPECT_EQ(kept.code, 2);                                                             \
    EXPECT_NE(kept.err.find("would overwrite '" + path(named) + "'"), std::string::npos) << kept.err; \
    EXPECT_EQ(text(name), before);                                                       \
  } while (false)

TEST_F(TorsorToolWithXacro, OverwritesNoFileThatItReads) {
  const std::string robot = path("robot.urdf.xacro"), macros = path("inc/link.xacro");
  std::string before = text("robot.urdf.xacro");
  EXPECT_KEPT(torsor_tool({"generate", robot, "--kernels", "energy", "-o", robot}), "robot.urdf.xacro", "robot.urdf.xacro");
  EXPECT_KEPT(torsor_tool({"equations", robot, "-o", path("inc/../robot.urdf.xacro")}), "robot.urdf.xacro", "robot.urdf.xacro");
  EXPECT_KEPT(torsor_tool({"generate", robot, "--kernels", "energy", "--language", "c99", "-o", path("e.h"), "--source", robot}),
              "robot.urdf.xacro", "robot.urdf.xacro");
  before = text("inc/link.xacro");
  EXPECT_KEPT(torsor_tool({"list", robot, "-o", macros}), "inc/link.xacro", "inc/link.xacro");
  std::filesystem::copy_file(robot, path("robot.d"));
  before = text("robot.d");
  EXPECT_KEPT(torsor_tool({"list", path("robot.d"), "--depfile", path("robot.d")}), "robot.d", "robot.d");
  EXPECT_FALSE(std::filesystem::exists(path("e.h")));
}

TEST_F(TorsorToolWithXacro, WritesTheRuleOfMakeWithTheOtherFilesOrNotAtAll) {
  const std::string robot = path("robot.urdf.xacro"), rule = path("e.hpp.d");
  const Outcome twice = torsor_tool({"generate", robot, "--kernels", "energy", "-o", rule, "--depfile", rule});
  EXPECT_EQ(twice.code, 2);
  EXPECT_NE(twice.err.find("name one file"), std::string::npos) << twice.err;
  EXPECT_FALSE(std::filesystem::exists(rule));
  EXPECT_EQ(torsor_tool({"generate", robot, "--kernels", "energy", "-o", path("none/e.hpp"), "--depfile", rule}).code, 3);
  EXPECT_FALSE(std::filesystem::exists(rule));
  EXPECT_EQ(torsor_tool({"generate", robot, "--kernels", "energy", "-o", path("e.hpp"), "--depfile", rule}).code, 0);
  EXPECT_TRUE(text("e.hpp.d").starts_with(path("e.hpp") + ": \\\n"));
}

}  // namespace
}  // namespace torsor::xacro_program_test
