// SPDX-License-Identifier: GPL-3.0-or-later
// What --ground, --friction and --limits make of an MJCF file; gaps as MuJoCo's own search for contacts has them.
#include <gtest/gtest.h>

#ifdef TORSOR_WITH_MUJOCO

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>

#include <mujoco/mujoco.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/mujoco_reader.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/cli/motion_table.hpp"
#include "tests/cli/tool_runner.hpp"

namespace torsor::mjcf_contacts_test {
namespace {

using testing_programs::Outcome;
using testing_programs::table;

Outcome torsor(const std::vector<std::string>& words) { return testing_programs::torsor_tool(words, read_with_mujoco); }

std::string written(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name + ".xml";
  std::ofstream(path) << text;
  return path;
}

/// A stone that may fly, with one geom, above a plane that is tilted and off the origin.
std::string stone(const std::string& geom) {
  return written("stone_" + geom.substr(0, geom.find(' ')),
                 R"(<mujoco><worldbody>
<geom name="slope" type="plane" size="1 1 1" pos="0.3 -0.2 0.1" euler="20 0 0" margin="50"/>
<body name="stone" pos="0 0 9"><freejoint name="flight"/><inertial pos="0 0 0" mass="2" diaginertia="0.3 0.4 0.5"/>
<geom name="skin" type=")" + geom.substr(0, geom.find(' ')) +
                     "\" size=\"" + geom.substr(geom.find(' ') + 1) + R"(" pos="0.1 0.05 -0.2" euler="30 -45 60" margin="50"/>
</body></worldbody></mujoco>)");
}

MjcfOptions touching(std::vector<std::string> bodies) {
  MjcfOptions options;
  options.ground.named = std::move(bodies);
  return options;
}

std::vector<std::string> contact_names(const std::string& path, const MjcfOptions& options) {
  const ImportedMjcf imported = mjcf_scene(read_with_mujoco(path), options);
  Program program(Model::resolver(imported.scene, {}));
  std::vector<std::string> names;
  for (const ContactRows& contact : contact_rows(Model(imported.scene, program))) names.push_back(contact.name);
  return names;
}

class GroundOfMjcf : public testing::TestWithParam<const char*> {};

TEST_P(GroundOfMjcf, IsAsFarAsMujocoFinds) {
  const std::string path = stone(GetParam());
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(mj_loadXML(path.c_str(), nullptr, error.data(), 1000), mj_deleteModel);
  ASSERT_TRUE(model) << error.data();
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
  const ImportedMjcf imported = mjcf_scene(read_with_mujoco(path), touching({"stone"}));
  const SceneContent& content = imported.scene.content();
  Program program(Model::resolver(imported.scene, {}));
  const std::vector<ContactRows> contacts = contact_rows(Model(imported.scene, program));
  ASSERT_FALSE(contacts.empty());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 50; ++n) {
    for (int k = 0; k < 7; ++k) data->qpos[k] = uniform(random) + (k == 2 ? 5 : 0);
    mj_normalizeQuat(model.get(), data->qpos);
    mj_forward(model.get(), data.get());
    double found = std::numeric_limits<double>::infinity();
    for (int c = 0; c < data->ncon; ++c) found = std::min(found, static_cast<double>(data->contact[c].dist));
    std::map<const Symbol*, double> values;
    for (std::size_t k = 0; k < 3; ++k) values[content.coordinates[k].q.get()] = data->qpos[k];
    for (std::size_t k = 0; k < 4; ++k) values[content.attitudes[0].symbols->e[k].get()] = data->qpos[3 + k];
    Evaluator<Real> here(program, [&](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi(50);
      const auto given = values.find(symbol.get());
      return given == values.end() ? initial_value(content, symbol) : Real(from_double(given->second), 50);
    });
    double gap = std::numeric_limits<double>::infinity();
    for (const ContactRows& contact : contacts) gap = std::min(gap, here(contact.gap).to_double());
    EXPECT_NEAR(gap, found, 1e-13) << n;  // roundings of lengths of some metres in MuJoCo
  }
}
INSTANTIATE_TEST_SUITE_P(Geoms, GroundOfMjcf,
                         testing::Values("sphere 0.2", "box 0.3 0.2 0.1", "cylinder 0.2 0.3", "capsule 0.2 0.3", "ellipsoid 0.3 0.2 0.1"),
                         [](const auto& of) { return std::string(of.param).substr(0, std::string(of.param).find(' ')); });

TEST(GroundOfMjcfFiles, IsThePlaneOfTheOriginWhereTheFileHasNone) {
  const std::string path = written("lonely", R"(<mujoco><worldbody><body name="ball" pos="0 0 2"><freejoint/>
<geom name="one" size="0.5"/><geom name="two" pos="1 0 0" size="0.5"/></body></worldbody></mujoco>)");
  EXPECT_EQ(contact_names(path, touching({"ball"})), (std::vector<std::string>{"ball_ground_1", "ball_ground_2"}));
}

// In free fall from 2 - 0.5 m; the plane of the file would be met 1 m higher.
TEST(GroundOfMjcfFiles, IsMetAtTheHeightOfThePlane) {
  const std::string path = written("fall", R"(<mujoco><option gravity="0 0 -10"/><worldbody><geom type="plane" pos="0 0 1" size="1 1 1"/>
<body name="ball" pos="0 0 2"><joint name="z" type="slide" axis="0 0 1"/><geom size="0.5" mass="3"/></body></worldbody></mujoco>)");
  const Outcome outcome = torsor({"simulate", path, "--ground", "ball", "--to", "1", "--step", "0.5", "--no-motors"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("# Event: impact of ball_ground at t = 0.316227766"), std::string::npos) << outcome.out;
}

// A block of 2 kg slides against 3 N from 6 m/s: 4 s and 12 m; a bound of 6 N from the command line halves both.
TEST(FrictionOfMjcf, BrakesASlide) {
  const std::string path = written("block", R"(<mujoco><worldbody><body><joint name="x" type="slide" axis="1 0 0" frictionloss="3"/>
<geom size="0.1" mass="2"/></body></worldbody></mujoco>)");
  for (const auto& [word, way] : {std::pair("file", 12.0), std::pair("x=6", 6.0), std::pair("file,x=6", 6.0)}) {
    const Outcome outcome =
        torsor({"simulate", path, "--friction", word, "--to", "5", "--step", "5", "--no-motors", "--initial", "x'=6"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(table(outcome.out).end("x"), way, 1e-13) << outcome.out;
  }
  EXPECT_NE(torsor({"list", path}).err.find("frictionloss of joints acts with --friction file only: x (3)"), std::string::npos);
}

// Names made for joints without one are those of no other.
TEST(FrictionOfMjcf, ActsOnTheJointOfThatNameAlone) {
  const std::string path = written("unnamed", R"(<mujoco><worldbody><body name="C"><joint axis="1 0 0"/><joint axis="0 1 0"/>
<inertial pos="0.1 0 0" mass="1" diaginertia="1 1 1"/><body name="D"><joint name="C_joint" axis="0 0 1"/>
<inertial pos="0.1 0 0" mass="1" diaginertia="1 1 1"/></body></body></worldbody></mujoco>)");
  std::vector<std::string> names;
  for (const MjcfJoint& joint : read_with_mujoco(path).joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"C_joint_2", "C_joint_3", "C_joint"}));
  MjcfOptions options;
  options.friction = {{"C_joint", Number(2)}};
  EXPECT_EQ(contact_names(path, options).size(), 1U);
}

// A tendon over two slides, length x - y: of two blocks of 2 kg and 1 kg at 3 and 0 m/s the slip ends after 1 s, at 2 m/s, since
// 2 N take 1 m/s² from the one and give 2 m/s² to the other.
TEST(FrictionOfMjcf, BrakesATendon) {
  const std::string path = written("tied", R"(<mujoco><option gravity="0 0 0"/><worldbody>
<body><joint name="x" type="slide" axis="1 0 0"/><geom size="0.1" mass="2"/></body>
<body pos="0 1 0"><joint name="y" type="slide" axis="1 0 0"/><geom size="0.1" mass="1"/></body></worldbody>
<tendon><fixed name="band" frictionloss="2"><joint joint="x" coef="1"/><joint joint="y" coef="-1"/></fixed></tendon></mujoco>)");
  const Outcome outcome =
      torsor({"simulate", path, "--friction", "file", "--to", "2", "--step", "1", "--no-motors", "--initial", "x'=3"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const testing_programs::MotionTable motion = table(outcome.out);
  EXPECT_NEAR(motion.end("x'"), 2, 1e-13);
  EXPECT_NEAR(motion.end("y'"), 2, 1e-13);
  EXPECT_NEAR(motion.end("x") - motion.end("y"), 1.5, 1e-13);
  EXPECT_NE(torsor({"list", path}).err.find("frictionloss of tendons acts with --friction file only: band (2)"), std::string::npos);
}

TEST(LimitsOfMjcf, AreStopsWhereTheyAreAskedFor) {
  const std::string path = written("drawer", R"(<mujoco><worldbody><body><joint name="x" type="slide" axis="1 0 0" range="-0.5 1.5" limited="true"/>
<geom size="0.1" mass="2"/></body></worldbody></mujoco>)");
  EXPECT_TRUE(contact_names(path, {}).empty());
  MjcfOptions options;
  options.limits = true;
  EXPECT_EQ(contact_names(path, options), (std::vector<std::string>{"x_lower", "x_upper"}));
  const Outcome outcome = torsor({"simulate", path, "--limits", "--to", "2", "--step", "1", "--no-motors", "--initial", "x'=1"});
  EXPECT_NE(outcome.out.find("# Event: impact of x_upper at t = 1.5 s, energy lost 1 J"), std::string::npos) << outcome.out;
}

// Each flag takes its own contacts away, `constraint` all of them: MuJoCo's documentation of <flag>.
TEST(FlagsOfMjcf, TakeContactsAway) {
  const auto names = [](const std::string& flag) {
    const std::string path = written("flags", "<mujoco><option><flag " + flag + R"(/></option><worldbody>
<body><joint name="x" type="slide" axis="1 0 0" frictionloss="3" range="-1 1" limited="true"/><geom size="0.1"/></body>
<body pos="0 1 0"><joint name="y" type="slide" axis="1 0 0"/><geom size="0.1"/></body></worldbody>
<tendon><fixed name="band" frictionloss="2"><joint joint="x" coef="1"/><joint joint="y" coef="-1"/></fixed></tendon></mujoco>)");
    MjcfOptions options;
    options.limits = options.friction_of_file = true;
    return contact_names(path, options);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(""), (Names{"x_lower", "x_upper", "x_dry_friction", "band_dry_friction"}));
  EXPECT_EQ(names("frictionloss=\"disable\""), (Names{"x_lower", "x_upper"}));
  EXPECT_EQ(names("limit=\"disable\""), (Names{"x_dry_friction", "band_dry_friction"}));
  EXPECT_EQ(names("constraint=\"disable\""), Names());
  for (const char* flag : {"contact", "constraint"}) {
    const std::string path = written("untouched", std::string("<mujoco><option><flag ") + flag + R"(="disable"/></option><worldbody>
<body name="ball" pos="0 0 1"><freejoint/><geom size="0.1"/></body></worldbody></mujoco>)");
    const Outcome outcome = torsor({"list", path, "--ground", "ball"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("has no geom that takes part in contacts"), std::string::npos) << outcome.err;
  }
}

TEST(NumbersOfMjcf, ThatAreNoneNameTheirObject) {
  const auto refused = [](const std::string& inside, const std::string& message) {
    const std::string path = written("numbers", "<mujoco><worldbody>" + inside + "</worldbody></mujoco>");
    const Outcome outcome = torsor({"list", path});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("numbers.xml: " + message + "; give finite numbers"), std::string::npos) << outcome.err;
  };
  const std::string ball = "<geom size=\"0.1\"/></body>";
  refused("<body><joint name=\"x\" stiffness=\"nan\"/>" + ball, "joint x: stiffness is nan");
  refused("<body><joint name=\"x\" damping=\"inf\"/>" + ball, "joint x: damping is inf");
  refused("<body name=\"b\" pos=\"0 nan 0\"><joint name=\"x\"/>" + ball, "body b: its place is nan");
  refused("<body name=\"b\"><joint name=\"x\"/><site name=\"s\" pos=\"0 inf 0\"/>" + ball, "site s: its place is inf");
}

TEST(PointsOfMjcf, AreThoseNamedOrAll) {
  const std::string path = written("points", R"(<mujoco><worldbody><body name="a"><joint name="x"/><geom size="0.1"/>
<site name="s"/><body name="b"><joint name="y" axis="0 1 0"/><geom size="0.1"/></body></body></worldbody>
<keyframe><key name="home" qpos="1 2"/></keyframe></mujoco>)");
  const auto points = [&path](std::vector<std::string> named) {
    MjcfOptions options;
    options.points = std::move(named);
    std::vector<std::string> names;
    const ImportedMjcf imported = mjcf_scene(read_with_mujoco(path), options);
    for (const PointContent& point : imported.scene.content().points) names.push_back(point.name);
    return names;
  };
  EXPECT_EQ(points({"all"}), (std::vector<std::string>{"a_origin", "b_origin"}));
  EXPECT_EQ(points({"s", "b"}), (std::vector<std::string>{"s_origin", "b_origin"}));
  EXPECT_THROW(points({"all", "b"}), UsageError);
  const Outcome outcome = torsor({"generate", path, "--kernels", "energy", "-o", "-"});
  EXPECT_NE(outcome.out.find("keyframe home: the start is that of the bodies' places, and of --initial"), std::string::npos);
}

TEST(ContactsOfMjcf, SayWhatIsMissing) {
  const std::string path = written("faults", R"(<mujoco><asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/></asset><worldbody>
<geom name="floor" type="plane" size="1 1 1"/><geom name="table" size="0.1"/>
<body name="shell" pos="0 0 3"><joint name="z" type="slide" axis="0 0 1"/><geom type="mesh" mesh="m" mass="1"/></body>
<body name="ghost" pos="0 0 3"><joint name="y" type="ball"/><geom size="1" contype="0" conaffinity="0" mass="1"/></body>
</worldbody></mujoco>)");
  const auto refused = [&path](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> words{"list", path};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = torsor(words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  };
  refused({"--ground", "shell"}, "of the body 'shell' in --ground is of the type mesh: a sphere, box, cylinder, capsule");
  refused({"--ground", "ghost"}, "the body 'ghost' in --ground does not move, or has no geom that takes part in contacts");
  refused({"--ground", "shel"}, "the body 'shel' in --ground is unknown: did you mean 'shell'");
  refused({"--ground", "shell,shell"}, "--ground names the body 'shell' twice: name it once");
  refused({"--friction", "y=1"}, "unknown joint 'y' in --friction: ");
  refused({"--friction", "z=-1"}, "--friction of the joint 'z' is -1; it is never negative");
}

}  // namespace
}  // namespace torsor::mjcf_contacts_test

#endif
