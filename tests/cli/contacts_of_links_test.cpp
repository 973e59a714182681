// SPDX-License-Identifier: GPL-3.0-or-later
// Links of a robot's file that touch each other, through the tool's commands.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/tool_runner.hpp"

namespace torsor::contacts_of_links_test {
namespace {

using testing_programs::Outcome;
using testing_programs::MotionTable;
using testing_programs::table;
using testing_programs::torsor_tool;

/// Two balls on one rail, 1 m apart, and a plate that slides along the same rail behind the second.
std::string balls() {
  const std::string path = testing::TempDir() + "balls.urdf";
  std::ofstream(path) << R"(<robot name="balls"><link name="rail"/>
<link name="left"><inertial><mass value="2"/><inertia ixx="0.008" ixy="0" ixz="0" iyy="0.008" iyz="0" izz="0.008"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision></link>
<link name="right"><inertial><mass value="1"/><inertia ixx="0.009" ixy="0" ixz="0" iyy="0.009" iyz="0" izz="0.009"/></inertial>
  <collision><geometry><sphere radius="0.15"/></geometry></collision></link>
<link name="plate"><inertial><mass value="4"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  <collision><geometry><box size="0.2 1 1"/></geometry></collision></link>
<joint name="a" type="prismatic"><parent link="rail"/><child link="left"/><axis xyz="1 0 0"/>
  <limit lower="-9" upper="9" effort="1" velocity="9"/></joint>
<joint name="b" type="prismatic"><parent link="rail"/><child link="right"/><origin xyz="1 0 0"/><axis xyz="1 0 0"/>
  <limit lower="-9" upper="9" effort="1" velocity="9"/></joint>
<joint name="c" type="prismatic"><parent link="rail"/><child link="plate"/><origin xyz="3 0 0"/><axis xyz="1 0 0"/>
  <limit lower="-9" upper="9" effort="1" velocity="9"/></joint></robot>)";
  return path;
}

Outcome run(const std::string& command, const std::vector<std::string>& options) {
  std::vector<std::string> arguments{command, balls(), "--no-motors", "--gravity", "0,0,0"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return torsor_tool(arguments);
}

// The gap of 0.75 m closes at 0.25 s. With e = 1/2: v_left = (2·3 - 1·3/2)/3, v_right = (2·3 + 2·3/2)/3, and
// (1/2) (2/3) (1 - e²) 3² J are lost.
TEST(ContactsOfLinks, MoveTwoBallsByMomentumAndRestitution) {
  const Outcome outcome = run("simulate", {"--contacts", "left:right", "--contacts-restitution", "0.5", "--initial",
                                           "a'=3", "--to", "0.5", "--step", "0.25"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  // Roundings of numbers up to 9.
  EXPECT_NEAR(motion.end("a'"), 1.5, 4e-15);
  EXPECT_NEAR(motion.end("b'"), 3, 4e-15);
  EXPECT_NEAR(motion.end("a"), 0.75 + 0.25 * 1.5, 4e-15);
  EXPECT_NEAR(motion.end("b"), 0.25 * 3, 4e-15);
  EXPECT_NEAR(motion.at(0, "kinetic_energy") - motion.end("kinetic_energy"), 2.25, 1e-14);
  EXPECT_NEAR(motion.end("left_right_gap"), 0.25 * 1.5, 4e-15);
  EXPECT_NE(outcome.out.find("# Event: impact of left_right at t = 0.25 s, energy lost 2.25 J"), std::string::npos)
      << outcome.out;
}

// The right ball, struck elastically, comes to the plate's face -x: 2·3·2/3 = 4 m/s, over 3 - 0.1 - 1 - 0.15 m, and
// there with e = 1: v_right = 4 (1 - 4)/5, v_plate = 2·4/5.
TEST(ContactsOfLinks, MoveABallAgainstAFaceOfABox) {
  const Outcome outcome =
      run("simulate", {"--contacts", "left:right", "--contacts", "right:plate-x", "--contacts-restitution", "1",
                       "--initial", "a'=3", "--to", "0.75", "--step", "0.25"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  const double strikes = 0.25 + 1.75 / 4, after = 0.75 - strikes;
  EXPECT_NEAR(motion.end("a'"), 1, 4e-15);
  EXPECT_NEAR(motion.end("b'"), -2.4, 4e-15);
  EXPECT_NEAR(motion.end("c'"), 1.6, 4e-15);
  EXPECT_NEAR(motion.end("b"), 1.75 - 2.4 * after, 4e-15);
  EXPECT_NEAR(motion.end("c"), 1.6 * after, 4e-15);
  EXPECT_NEAR(motion.end("kinetic_energy"), 9, 1e-14);
}

Scene by_hand() {
  Scene scene("balls", "");
  const auto number = [](const char* value, const char* unit) { return Expression::quantity(value, unit); };
  const Expression a = scene.coordinate("a", "m"), b = scene.coordinate("b", "m"), c = scene.coordinate("c", "m");
  for (const Expression& q : {a, b, c}) scene.limits(q, {Number(-9), Number(9), Number(9), Number(1)});
  const FrameHandle rail = scene.weld("rail", scene.ground(), {});
  const FrameHandle left = scene.prismatic("left", rail, axis::x, a);
  const FrameHandle right = scene.prismatic("right", rail, axis::x, b, {.origin = {number("1", "m"), 0, 0}});
  const FrameHandle plate = scene.prismatic("plate", rail, axis::x, c, {.origin = {number("3", "m"), 0, 0}});
  const auto body = [&](const char* name, const FrameHandle& frame, const char* mass, const char* inertia) {
    const std::string word = name;
    const Expression m = scene.parameter(word + "_mass", "kg", number(mass, "kg"));
    const auto moment = [&](const char* axes) {
      return scene.parameter(word + "_inertia_" + axes, "kg m^2", number(inertia, "kg m^2"));
    };
    const Expression xx = moment("xx"), yy = moment("yy"), zz = moment("zz");
    scene.body(name, frame, Inertia::general({.mass = m, .xx = xx, .yy = yy, .zz = zz}));
  };
  body("left", left, "2", "0.008");
  body("right", right, "1", "0.009");
  body("plate", plate, "4", "0.1");
  const Expression f = scene.run_time_parameter("contacts_friction", "1", number("0.5", "1"));
  const Expression e = scene.run_time_parameter("contacts_restitution", "1", 0);
  const shape::Sphere right_ball{.frame = right, .radius = number("0.15", "m")};
  scene.contact("left_right", shape::Sphere{.frame = left, .radius = number("0.1", "m")}, right_ball,
                {.friction = f, .restitution = e});
  const FrameHandle face = scene.weld("face", plate, {{number("-0.1", "m"), 0, 0}, Rotation::about(1, -6)});
  scene.contact("right_plate", right_ball, shape::Plane{.frame = face}, {.friction = f, .restitution = e});
  return scene;
}

// A scene that says the same prints the same equations and has the same kernels.
TEST(ContactsOfLinks, AreThoseOfASceneThatSaysTheSame) {
  const std::vector<std::string> contacts{"--contacts", "left:right,right:plate-x"};
  EXPECT_EQ(run("equations", contacts).out, testing_programs::run(by_hand, {"equations"}).out);
  const std::vector<std::string> kernels{"--kernels", "mass_matrix,bias,contacts,contact_coefficients", "-o", "-"};
  std::vector<std::string> options = contacts;
  options.insert(options.end(), kernels.begin(), kernels.end());
  std::vector<std::string> of_scene{"generate"};
  of_scene.insert(of_scene.end(), kernels.begin(), kernels.end());
  const auto code = [](const std::string& header) {
    return header.substr(std::min(header.find("#pragma once"), header.size()));
  };
  const std::string text = code(run("generate", options).out);
  EXPECT_GT(text.size(), 1000U);
  EXPECT_TRUE(text == code(testing_programs::run(by_hand, of_scene).out));
}

// Every command reads the option, and a header repeats it so that a shell reads it again.
TEST(ContactsOfLinks, AreTakenByEveryCommand) {
  const std::vector<std::string> options{"--contacts", "left:right,right:plate-x", "--contacts-friction",
                                         "0.25",       "--contacts-restitution",   "0.5"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    return more;
  };
  const Outcome header = run("generate", with({"--kernels", "contacts", "-o", "-"}));
  ASSERT_EQ(header.code, 0) << header.err;
  EXPECT_NE(header.out.find(
                "//   torsor generate balls.urdf --gravity 0,0,0 --no-motors --contacts 'left:right,right:plate-x' "
                "--contacts-friction 0.25 --contacts-restitution 0.5 --kernels contacts --output balls.hpp\n"),
            std::string::npos)
      << header.out.substr(0, 3000);
  const Outcome list = run("list", options);
  EXPECT_NE(list.out.find("contacts_friction = 0.25 [1] (run time)"), std::string::npos) << list.out;
  const Outcome check = run("check", with({"--digits", "30", "--states", "1"}));
  EXPECT_EQ(check.code, 0) << check.out;
  EXPECT_NE(check.out.find("contacts"), std::string::npos);
  const std::string page = testing::TempDir() + "balls.html";
  EXPECT_EQ(run("report", with({"-o", page})).code, 0);
  EXPECT_TRUE(std::filesystem::exists(page));
}

TEST(ContactsOfLinks, SayWhatIsMissing) {
  const auto expect = [](const std::vector<std::string>& options, int code, const std::string& message) {
    const Outcome outcome = run("list", options);
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.err, "torsor: " + message + "\n");
  };
  expect({"--contacts-friction", "1"}, 2, "--contacts-friction is of the pairs in --contacts: name them");
  expect({"--contacts-restitution", "1", "--ground", "left"}, 2,
         "--contacts-restitution is of the pairs in --contacts: name them");
  expect({"--ground-friction", "1"}, 2, "--ground-friction is of the links in --ground: name them");
  expect({"--contacts", "left:right", "--initial", "a=0.9"}, 3,
         "contact 'left_right' starts penetrating: its gap is -0.15 m at t = 0 and must not be negative; give "
         "another start by --initial of the coordinates that it depends on");
  expect({"--contacts", "left:right", "--contacts-restitution", "2"}, 3,
         "contact 'left_right' has the restitution contacts_restitution = 2: it must lie between 0 and 1");
  const std::string crane = TORSOR_SOURCE_DIR "/tests/import/data/mjcf/crane.xml";
  EXPECT_EQ(torsor_tool({"list", crane, "--contacts", "boom:hook"}).err,
            "torsor: --contacts is for URDF; '" + crane + "' is MJCF\n");
}

}  // namespace
}  // namespace torsor::contacts_of_links_test
