// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "torsor/generator/import/identifiers.hpp"
#include "tests/base/error_of.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_names_test {
namespace {

using namespace testing_urdf;
using testing_errors::error_of;

TEST(UrdfNames, BecomeIdentifiers) {
  EXPECT_EQ(as_identifier("left-arm.upper", "joint"), "left_arm_upper");
  EXPECT_EQ(as_identifier("  tool//0  ", "link"), "tool_0");
  EXPECT_EQ(as_identifier("_hidden__name_", "link"), "hidden_name");
  EXPECT_EQ(as_identifier("7dof", "joint"), "joint_7dof");
  EXPECT_EQ(as_identifier("switch", "joint"), "joint_switch");
  EXPECT_EQ(as_identifier("State", "joint"), "joint_State");
  EXPECT_EQ(as_identifier("RAND_MAX", "joint"), "joint_RAND_MAX");
  EXPECT_EQ(as_identifier("M_PI_2f32x", "link"), "link_M_PI_2f32x");
  EXPECT_EQ(as_identifier("LF_HAA", "joint"), "LF_HAA");
  EXPECT_EQ(as_identifier("index", "robot"), "robot_index");
  EXPECT_EQ(as_identifier("index", "joint"), "index");
  EXPECT_EQ(as_identifier("\xe8\x85\x95", "joint"), "joint");
}

TEST(UrdfNames, StayDistinct) {
  Identifiers names({"ground"});
  EXPECT_EQ(names.take("a-b", "joint"), "a_b");
  EXPECT_EQ(names.take("a.b", "joint"), "a_b_2");
  EXPECT_EQ(names.take("a b", "joint"), "a_b_3");
  EXPECT_EQ(names.take("ground", "link"), "ground_2");
  EXPECT_EQ(names.take("p", "joint", {"_x", "_y"}), "p");
  EXPECT_EQ(names.take("p_y", "joint"), "p_y_2");
  EXPECT_EQ(names.take("p", "joint", {"_y", "_z"}), "p_2");
  EXPECT_EQ(names.take("M", "joint", {"", "_PI"}), "M_3");  // M_PI and M_2_PI are macros
}

TEST(UrdfNames, ThatWouldCollideStillMakeAValidScene) {
  const ImportedRobot robot =
      read_urdf_text("<robot name=\"my robot-2\"><link name=\"ground\"/>" + link("arm-1") + link("arm.1") +
                         link("hand") + joint("arm-1", "revolute", "ground", "arm-1", "") +
                         joint("arm_1_torque", "prismatic", "arm-1", "arm.1", "<axis xyz=\"0 1 0\"/>") +
                         joint("t", "revolute", "arm.1", "hand", "<axis xyz=\"0 1 0\"/>") + "</robot>",
                     "folder/machine.urdf");
  validate(robot.scene);
  EXPECT_EQ(robot.scene.name(), "my_robot_2");
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_EQ(robot.joints[0].coordinate, "arm_1");
  EXPECT_EQ(robot.joints[1].coordinate, "arm_1_torque_2");
  EXPECT_EQ(robot.joints[2].coordinate, "t_2");
  const std::vector<std::string>& notes = robot.scene.content().origin.notes;
  const std::vector<std::string> expected{"Names that became identifiers:",
                                          "  robot 'my robot-2' is my_robot_2",
                                          "  link 'ground' is ground_2",
                                          "  link 'arm-1' is arm_1",
                                          "  link 'arm.1' is arm_1_2",
                                          "  joint 'arm-1' is arm_1",
                                          "  joint 'arm_1_torque' is arm_1_torque_2",
                                          "  joint 't' is t_2"};
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(robot.scene.content().origin.file, "machine.urdf");
}

// The kernel kinematics makes members of these names: "a" has a_angular_velocity, and so has "a_angular".
TEST(UrdfNames, StayDistinctInTheKernelsToo) {
  const Scene scene = read("<link name=\"base\"/>" + link("a") + link("a_angular") +
                           joint("i", "revolute", "base", "a", "") + joint("j", "prismatic", "a", "a_angular", ""));
  EXPECT_EQ(scene.content().bodies[0].name, "a");
  EXPECT_EQ(scene.content().bodies[1].name, "a_angular_2");
}

TEST(UrdfData, OfJointsIsKeptAndTold) {
  const ImportedRobot robot = read_urdf_text(
      testing_urdf::robot(
          "<link name=\"base\"/>" + link("arm") + link("finger") +
          joint("hinge", "revolute", "base", "arm",
                "<axis xyz=\"0 0 1\"/><limit lower=\"-1.5\" upper=\"2\" velocity=\"3\" effort=\"150\"/><dynamics "
                "damping=\"0.7\" friction=\"0.1\"/>") +
          joint("grip", "prismatic", "arm", "finger", "<origin rpy=\"0 3.14159 0\"/><limit effort=\"5\"/>")),
      "machine.urdf");
  ASSERT_EQ(robot.joints.size(), 2U);
  EXPECT_EQ(robot.joints[0].lower, parse_decimal("-1.5"));
  EXPECT_EQ(robot.joints[0].effort, Number(150));
  EXPECT_TRUE(robot.joints[0].damping_acts);
  EXPECT_EQ(robot.joints[1].lower, std::nullopt);
  const std::vector<std::string> expected{
      "Angles that look exact and are not:",
      "  3.14159 in joint grip (rpy) is near pi but beyond the tolerance: sines and cosines that would vanish do not; "
      "a "
      "larger --angle-tolerance takes it as that",
      "Stated of joints, in SI, and not in the kernels:", "  hinge: friction 0.1"};
  EXPECT_EQ(robot.scene.content().origin.notes, expected);
  // On the command line too, where it can still be mended.
  EXPECT_EQ(robot.notes, std::vector<std::string>{expected[1].substr(2)});
  const std::vector<CoordinateContent>& coordinates = robot.scene.content().coordinates;
  ASSERT_TRUE(coordinates[0].limits && coordinates[1].limits);
  EXPECT_EQ(coordinates[0].limits->upper, Number(2));
  EXPECT_EQ(coordinates[1].limits->effort, Number(5));
  EXPECT_EQ(coordinates[1].limits->upper, std::nullopt);
}

TEST(UrdfData, WithoutEffectIsTold) {
  const ImportedRobot robot = read_urdf_text(
      testing_urdf::robot("<link name=\"base\"/>" + link("arm") + link("wheel") +
                          joint("hinge", "revolute", "base", "arm",
                                "<limit upper=\"2\" jerk=\"30\" acceleration=\"4\" drake:acceleration=\"5\"/>"
                                "<safety_controller soft_upper_limit=\"1.5\" k_velocity=\"10\"/>") +
                          joint("axle", "continuous", "arm", "wheel", "<limit lower=\"-1\" upper=\"1\" effort=\"3\"/>")),
      "machine.urdf");
  const std::vector<std::string> expected{"Noted while reading (--strict refuses it):",
                                          "  attribute drake:acceleration of <limit> is not read: joint hinge",
                                          "  <limit> has no lower, which is 0 by the format: joint hinge",
                                          "Stated of joints and without effect:",
                                          "  hinge: acceleration 4, jerk 30 of <limit>",
                                          "  hinge: soft_upper_limit 1.5, k_velocity 10 of <safety_controller>",
                                          "  axle: lower -1, upper 1 of <limit>, because the joint is continuous"};
  EXPECT_EQ(robot.scene.content().origin.notes, expected);
  EXPECT_EQ(robot.joints[1].lower, std::nullopt);
  EXPECT_EQ(robot.joints[1].effort, Number(3));
}

TEST(UrdfData, OfFixedJointsMayHoldANullAxis) {
  const Scene scene =
      read("<link name=\"base\"/>" + link("arm") + link("tool") + joint("hinge", "revolute", "base", "arm", "") +
           joint("mount", "fixed", "arm", "tool", "<axis xyz=\"0 0 0\"/><limit lower=\"1\" upper=\"0\"/>"));
  EXPECT_EQ(scene.content().bodies.size(), 2U);
}

TEST(UrdfLinks, WithoutMassAreFramesOnly) {
  const Scene scene = read("<link name=\"base\"/>" + link("arm") +
                           "<link name=\"tip\"><inertial><mass value=\"0\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" "
                           "iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>" +
                           joint("hinge", "revolute", "base", "arm", "") + joint("mount", "fixed", "arm", "tip", ""));
  validate(scene);
  EXPECT_EQ(scene.content().bodies.size(), 1U);
  EXPECT_EQ(scene.content().frames.size(), 4U);  // ground, base, arm, tip
}

TEST(UrdfOptions, FixTheJointOfThatName) {
  const auto moving = [](const std::vector<std::string>& fix, const std::string& first, const std::string& second) {
    UrdfOptions options;
    options.fix = fix;
    const ImportedRobot robot = read_urdf_text("<robot name=\"r\">" + link("base") + link("a") + link("b") +
                                                   joint(first, "revolute", "base", "a", "") +
                                                   joint(second, "prismatic", "a", "b", "<axis xyz=\"1 0 0\"/>") + "</robot>",
                                               "r.urdf", options);
    std::string all;
    for (const UrdfJointData& each : robot.joints) all += each.joint + " ";
    return all;
  };
  EXPECT_EQ(moving({"arm_1"}, "arm-1", "arm_1"), "arm-1 ") << "another becomes the same identifier";
  EXPECT_EQ(moving({"arm-1"}, "arm-1", "arm_1"), "arm_1 ");
  EXPECT_EQ(moving({"arm_1"}, "arm-1", "tip"), "tip ") << "the scene's identifier";
  EXPECT_EQ(error_of([&] { moving({"arm_1"}, "arm-1", "arm.1"); }),
            "'arm_1' in --fix may be the joint 'arm-1' or 'arm.1' of the robot 'r': write the name as the file has it");
}

TEST(UrdfOptions, SetTheInitialStateByNames) {
  UrdfOptions options;
  options.base = UrdfBase::floating;
  options.initial = {{"hinge", "0.25"}, {"hinge'", "-2"}, {"drone_z", "1.5"}, {"drone_attitude_omega_y", "3"}};
  const std::string body = link("drone") + link("arm") + joint("hinge", "revolute", "drone", "arm", "");
  const auto numbers = [](const Scene& scene) {
    const WorkingDigits precision(50);
    std::vector<double> all;
    for (const Real& x : initial_state(scene)) all.push_back(x.to_double());
    return all;
  };
  // x, y, z, quaternion (w first), hinge; their rates.
  EXPECT_EQ(numbers(read(body, options)), (std::vector<double>{0, 0, 1.5, 1, 0, 0, 0, 0.25, 0, 0, 0, 0, 3, 0, -2}));
  options.initial = {{"drone_attitude_x", "-2"}};
  EXPECT_EQ(numbers(read(body, options)), (std::vector<double>{0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

// What holds the robot in the file is left out, but not where.
TEST(UrdfOptions, LetAFloatingBaseStartWhereTheWorldHeldIt) {
  const auto start = [](const std::string& rpy, const std::vector<std::pair<std::string, std::string>>& given = {}) {
    UrdfOptions options;
    options.base = UrdfBase::floating;
    options.initial = given;
    const Scene scene = read("<link name=\"world\"/>" + link("drone") +
                                 joint("hold", "fixed", "world", "drone",
                                       "<origin xyz=\"0 -0.5 2\" rpy=\"" + rpy + "\"/>"),
                             options);
    const WorkingDigits precision(50);
    std::vector<double> all;
    for (const Real& x : initial_state(scene)) all.push_back(x.to_double());
    all.resize(7);
    return all;
  };
  const auto expect = [](const std::vector<double>& state, const std::vector<double>& quaternion) {
    EXPECT_EQ(state[0], 0);
    EXPECT_EQ(state[1], -0.5);
    EXPECT_EQ(state[2], 2);
    // Three operations make a component of doubles.
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(state[3 + k], quaternion[k], 5e-16) << k;
  };
  const double half = std::sqrt(0.5);
  expect(start("0 0 0"), {1, 0, 0, 0});
  expect(start("1.5707963267948966 0 0"), {half, half, 0, 0});
  expect(start("0 0 -1.5707963267948966"), {half, 0, 0, -half});
  expect(start("3.141592653589793 0 0"), {0, 1, 0, 0});
  expect(start("3.141592653589793 0 3.141592653589793"), {0, 0, 1, 0});
  expect(start("0 0 3.141592653589793"), {0, 0, 0, 1});
  // Rz(0.7) Ry(-0.4) Rx(2.5) as the product of their quaternions.
  expect(start("2.5 -0.4 0.7"),
         {std::cos(0.35) * std::cos(-0.2) * std::cos(1.25) + std::sin(0.35) * std::sin(-0.2) * std::sin(1.25),
          std::cos(0.35) * std::cos(-0.2) * std::sin(1.25) - std::sin(0.35) * std::sin(-0.2) * std::cos(1.25),
          std::cos(0.35) * std::sin(-0.2) * std::cos(1.25) + std::sin(0.35) * std::cos(-0.2) * std::sin(1.25),
          std::sin(0.35) * std::cos(-0.2) * std::cos(1.25) - std::cos(0.35) * std::sin(-0.2) * std::sin(1.25)});
  EXPECT_EQ(start("0 0 3.141592653589793", {{"drone_y", "7"}, {"drone_attitude_w", "1"}}),
            (std::vector<double>{0, 7, 2, 1, 0, 0, 0}));
}

TEST(UrdfOptions, MakePointsOfTheOriginsOfLinks) {
  using Names = std::vector<std::string>;
  const auto points = [](Names named, const std::string& mount) {
    UrdfOptions options;
    options.points = std::move(named);
    const Scene scene = read("<link name=\"base\"/>" + link("arm") + "<link name=\"" + mount + "\"/>" +
                                 joint("hinge", "revolute", "base", "arm", "") +
                                 joint("mount", "fixed", "arm", mount, "<origin xyz=\"0 0 0.5\"/>"),
                             options);
    validate(scene);
    Names names;
    for (const PointContent& point : scene.content().points) names.push_back(point.name);
    return names;
  };
  EXPECT_EQ(points({"tool-0"}, "tool-0"), Names{"tool_0_origin"});
  EXPECT_EQ(points({"all"}, "tool-0"), (Names{"base_origin", "arm_origin", "tool_0_origin"}));
  EXPECT_EQ(points({"all"}, "all"), Names{"all_origin"});  // a link of that name
  EXPECT_THROW(points({"all", "arm"}, "tool-0"), UsageError);
}

TEST(UrdfJoints, MayComeInAnyOrder) {
  const std::string elbow = joint("elbow", "revolute", "upper", "lower", "<axis xyz=\"0 1 0\"/>");
  const std::string shoulder = joint("shoulder", "revolute", "base", "upper", "");
  const std::string links = link("lower") + "<link name=\"base\"/>" + link("upper");
  const Values q{{"shoulder", "0.7"}, {"elbow", "-1.1"}}, v{{"shoulder", "2"}, {"elbow", "-3"}};
  expect_same(accelerations(read(links + elbow + shoulder), q, v), accelerations(read(shoulder + elbow + links), q, v),
              fifty_digits);
}

}  // namespace
}  // namespace torsor::urdf_names_test
