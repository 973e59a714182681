// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "tests/cli/tool_runner.hpp"

namespace torsor::torsor_program_test {
namespace {

using testing_programs::Outcome;
using testing_programs::torsor_tool;

const std::string ur5 = TORSOR_SOURCE_DIR "/tests/reference/urdf/ur5.urdf";
const std::string arm = TORSOR_SOURCE_DIR "/tests/import/data/arm.urdf";

TEST(TorsorTool, HasEveryCommandOfASceneProgram) {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"equations"},
                                             {"list", "--json"},
                                             {"counts", "--kernels", "mass_matrix"},
                                             {"check", "--digits", "30", "--states", "1"},
                                             {"reference", "--digits", "12", "--times", "0.01"},
                                             {"force-function"},
                                             {"unknowns"},
                                             {"structure"},
                                             {"graph"},
                                             {"generate", "--kernels", "energy", "--output", "-"}}) {
    SCOPED_TRACE(command[0]);
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.begin() + 1, arm);
    const Outcome outcome = torsor_tool(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_GT(outcome.out.size(), 20U);
  }
}

TEST(TorsorTool, WritesTheSameHeaderAgainByTheCommandInTheHeader) {
  const std::vector<std::string> options{"--kernels",
                                         "energy,mass_matrix",
                                         "--base",
                                         "floating",
                                         "--gravity",
                                         "0,0.5,-9.81",
                                         "--angle-tolerance",
                                         "1e-5",
                                         "--no-dampers",
                                         "--fix",
                                         "massless",
                                         "--initial",
                                         "turn=0.25,turn'=-1",
                                         "--name",
                                         "walker",
                                         "--output",
                                         "-"};
  std::vector<std::string> arguments{"generate", arm};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome first = torsor_tool(arguments);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.out.find("namespace walker"), std::string::npos);
  EXPECT_NE(first.out.find("// Made by torsor " TORSOR_VERSION " from arm.urdf; change that and write the file again"),
            std::string::npos);
  // No folder of the file, and the whole command.
  EXPECT_EQ(first.out.find("tests/import"), std::string::npos);
  EXPECT_NE(
      first.out.find("//   torsor generate arm.urdf --base floating --gravity 0,0.5,-9.81 --angle-tolerance 1e-05 "
                     "--no-dampers --fix massless --name walker --initial 'turn=0.25,turn'\\''=-1' --kernels "
                     "mass_matrix,energy --output walker.hpp\n"),
      std::string::npos)
      << first.out.substr(0, 4000);
  EXPECT_NE(first.out.find("//   1.5708 is pi/2: joint turn (rpy)\n"), std::string::npos);
  EXPECT_EQ(torsor_tool(arguments).out, first.out);
  const Outcome again = torsor_tool({"generate", arm, "--base", "floating", "--gravity", "0,0.5,-9.81",
                                     "--angle-tolerance", "1e-05", "--no-dampers", "--fix", "massless", "--name", "walker",
                                     "--initial", "turn=0.25,turn'=-1", "--kernels", "mass_matrix,energy", "--output",
                                     "-"});
  EXPECT_EQ(again.out, first.out);
}

TEST(TorsorTool, StatesTheMethodOfForwardDynamicsInTheCommandInTheHeader) {
  for (const std::string method : {"factorisation", "articulated_body"}) {
    const Outcome outcome =
        torsor_tool({"generate", arm, "--kernels", "forward_dynamics", "--forward", method, "--output", "-"});
    EXPECT_NE(outcome.out.find("//   torsor generate arm.urdf --kernels forward_dynamics --forward " + method + " --output"),
              std::string::npos);
  }
}

// Each option that changes what is written stands in the command of the header.
TEST(TorsorTool, RepeatsEveryOptionInTheCommandInTheHeader) {
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--base", "floating"},
                                                                                       {"--gravity", "0,0,-1.62"},
                                                                                       {"--gravity", "0.1,1/3,-9.81"},
                                                                                       {"--angle-tolerance", "1e-05"},
                                                                                       {"--no-dampers"},
                                                                                       {"--no-motors"},
                                                                                       {"--fix", "turn"},
                                                                                       {"--name", "crane"},
                                                                                       {"--points", "rod,base"},
                                                                                       {"--initial", "turn=0.5"}}) {
    std::vector<std::string> arguments{"generate", arm, "--quiet", "--kernels", "mass_matrix", "--output", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::string text = options.size() == 1 ? options[0] : options[0] + " " + options[1];
    EXPECT_NE(
        torsor_tool(arguments).out.find("//   torsor generate arm.urdf " + text + " --kernels mass_matrix --output"),
        std::string::npos)
        << text;
  }
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--run-time", "all"},
                                                                                       {"--run-time", "rod_mass"},
                                                                                       {"--forward", "sums_of_squares"},
                                                                                       {"--without", "factoring"}}) {
    std::vector<std::string> arguments{"generate", arm, "--quiet", "--kernels", "forward_dynamics", "--output", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::string text = options[0] + " " + options[1];
    EXPECT_NE(torsor_tool(arguments).out.find(" --kernels forward_dynamics " + text + " --output"), std::string::npos)
        << text;
  }
}

TEST(TorsorTool, LeavesOutMotorsAndDampersWhereItIsAsked) {
  const auto page = [](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"list", arm, "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return torsor_tool(arguments).out;
  };
  EXPECT_NE(page({}).find("turn_torque"), std::string::npos);
  EXPECT_NE(page({}).find("turn_damping"), std::string::npos);
  EXPECT_EQ(page({"--no-motors"}).find("turn_torque"), std::string::npos);
  EXPECT_NE(page({"--no-motors"}).find("turn_damping"), std::string::npos);
  EXPECT_EQ(page({"--no-dampers"}).find("turn_damping"), std::string::npos);
  EXPECT_NE(page({"--no-dampers"}).find("turn_torque"), std::string::npos);
}

// What a joint without mass lacks is told; what is there is generated all the same.
TEST(TorsorTool, KeepsJointsThatMoveNoMass) {
  const std::string path = testing::TempDir() + "massless hand.urdf";
  std::ofstream(path) << R"(<robot name="hand"><link name="base"/><link name="palm"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="finger"/>
    <joint name="wrist" type="revolute"><parent link="base"/><child link="palm"/></joint>
    <joint name="grip" type="revolute"><parent link="palm"/><child link="finger"/></joint><gazebo/></robot>)";
  const std::string why =
      "the mass matrix is singular at every state, because the coordinate 'grip' moves no mass; give the links mass, or fix "
      "the joints: --fix grip, or --fix massless\n";
  const Outcome all = torsor_tool({"generate", path, "--output", "-"});
  EXPECT_EQ(all.code, 0);
  EXPECT_EQ(all.err, "note: <gazebo> in <robot> is not read\nnote: the kernels forward_dynamics, linearisation, "
                     "forward_dynamics_derivatives, jets are absent: " + why);
  EXPECT_NE(all.out.find("static void inverse_dynamics("), std::string::npos);
  EXPECT_NE(all.out.find("//   <gazebo> in <robot> is not read\n"), std::string::npos);
  EXPECT_NE(all.out.find("//   torsor generate 'massless hand.urdf' --kernels"), std::string::npos);
  EXPECT_EQ(torsor_tool({"generate", path, "--quiet", "--output", "-"}).err, "");
  const Outcome named = torsor_tool({"generate", path, "--quiet", "--kernels", "forward_dynamics", "--output", "-"});
  EXPECT_EQ(named.code, 3);
  EXPECT_EQ(named.err, "torsor: there is no kernel forward_dynamics: " + why);
  const Outcome fixed = torsor_tool({"generate", path, "--quiet", "--fix", "massless", "--kernels", "forward_dynamics",
                                     "--output", "-"});
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_EQ(torsor_tool({"list", path, "--strict"}).code, 3);
  // The kernels that are there are checked; a motion is not determined.
  const Outcome checked = torsor_tool({"check", path, "--digits", "30", "--states", "2"});
  EXPECT_EQ(checked.code, 0) << checked.out;
  EXPECT_NE(checked.out.find("ok    energy_theorem "), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("ok    double.inverse_dynamics "), std::string::npos) << checked.out;
  EXPECT_EQ(checked.out.find("forward_dynamics"), std::string::npos) << checked.out;
  EXPECT_NE(checked.err.find("note: not checked, for there are none: forward_dynamics, linearisation, "
                             "forward_dynamics_derivatives, jets: " + why),
            std::string::npos)
      << checked.err;
  const Outcome moved = torsor_tool({"reference", path, "--quiet", "--times", "0.1"});
  EXPECT_EQ(moved.code, 3);
  EXPECT_EQ(moved.err, "torsor: 'hand' cannot be solved: " + why);
  EXPECT_EQ(torsor_tool({"list", path, "--accept-inertia"}).code, 0);
}

TEST(TorsorTool, ListsNumbersInDigitsThatAPersonReads) {
  const std::string path = testing::TempDir() + "turned.urdf";
  std::ofstream(path) << R"(<robot name="turned"><link name="base"/><link name="arm"><inertial><origin rpy="0 0 0.5"/>
    <mass value="0.25"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.03"/></inertial></link>
    <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/></joint></robot>)";
  const Outcome list = torsor_tool({"list", path});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_NE(list.out.find("arm_mass = 0.25 [kg], "), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("arm_inertia_zz = 0.03 [kg m^2]"), std::string::npos) << list.out;
  const std::string turned = "arm_inertia_xx = ";
  const std::size_t place = list.out.find(turned);
  ASSERT_NE(place, std::string::npos) << list.out;
  // J_xx = 0.015 - 0.005 cos 2 psi: the digits of a double, and three roundings here, of at most 2^-59 each.
  EXPECT_NEAR(std::stod(list.out.substr(place + turned.size())), 0.015 - 0.005 * std::cos(1.0), 8e-18);
}

TEST(TorsorTool, SavesOperationsByEachPassOnBodies) {
  for (const char* robot : {"/tests/reference/urdf/ur5.urdf", "/examples/quadruped/quadruped.urdf"}) {
    const auto operations = [&](const std::string& without) {
      const Outcome outcome = torsor_tool({"counts", TORSOR_SOURCE_DIR + std::string(robot), "--base", "floating", "--json",
                                           "--kernels", "inverse_dynamics", "--without", without});
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      return nlohmann::json::parse(outcome.out).at("kernels").at("inverse_dynamics").at("total").get<int>();
    };
    const int all = operations("");
    for (const char* pass : {"reframing", "regrouping", "off_axis", "length_unit"}) {
      EXPECT_LE(all, operations(pass)) << robot << " without " << pass;
    }
  }
}

TEST(TorsorTool, TellsWhatIsWrongOnOneLine) {
  const auto expect = [](const Outcome& outcome, int code, const std::string& message) {
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "torsor: " + message + "\n");
  };
  expect(torsor_tool({"list", "nowhere.urdf"}), 3, "cannot read 'nowhere.urdf': does the file exist?");
  expect(torsor_tool({"list", "/tmp"}), 3, "cannot read '/tmp': it is a folder; name a file in it");
  expect(torsor_tool({"list"}), 2, "FILE is required; see --help");
  expect(torsor_tool({"list", ur5, "--base", "bolted"}), 2, "unknown base 'bolted' in --base: use fixed or floating");
  expect(torsor_tool({"list", ur5, "--gravity", "9.81"}), 2, "--gravity takes three numbers, X,Y,Z, and got '9.81'");
  expect(torsor_tool({"list", ur5, "--angle-tolerance", "1"}), 2,
         "--angle-tolerance is an angle in rad between 0 and 0.1: multiples of pi/12 are 0.26 apart");
  expect(torsor_tool({"list", ur5, "--initial", "j9=1"}), 2,
         "unknown name 'j9' in --initial: the state of 'ur5' has j0, j0', j1, j1', j2, j2', j3, j3', j4, j4', j5, j5'");
  expect(torsor_tool({"list", ur5, "--initial", "j0=up"}), 2,
         "--initial j0: cannot read \"up\" as a number: write a decimal such as -1.5e-3 or a quotient such as 3/4");
  expect(torsor_tool({"list", arm, "--points", "hand"}), 2,
         "unknown link 'hand' in --points: the robot has base, carriage, rod");
  expect(torsor_tool({"list", arm, "--armature", "turn=1,turn=2"}), 2,
         "--armature names the joint 'turn' twice: give it one number");
  expect(torsor_tool({"list", arm, "--friction", "turn=1,turn=1"}), 2,
         "--friction names the joint 'turn' twice: give it one number");
  EXPECT_EQ(torsor_tool({"counts", ur5, "--kernels", "speed"}).code, 2);
}

TEST(TorsorTool, TakesNoOptionForASceneFile) {
  const Outcome outcome = torsor_tool({"list", "--output=lost.cpp"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err.find("lost.cpp"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace torsor::torsor_program_test
