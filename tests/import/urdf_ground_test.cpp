// SPDX-License-Identifier: GPL-3.0-or-later
// Links that touch the ground, and limits of joints as stops.
#include <algorithm>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_ground_test {
namespace {

using namespace testing_urdf;

std::string with_collision(const std::string& link, const std::string& collision) {
  const std::size_t end = link.rfind("</link>");
  return link.substr(0, end) + "<collision>" + collision + "</collision></link>";
}

const std::string ball = "<geometry><sphere radius=\"0.05\"/></geometry>";
const std::string hopper =
    with_collision(link("trunk"), "<origin xyz=\"0 0 0.1\" rpy=\"0 1.5707963267948966 0\"/><geometry><cylinder radius=\"0.1\" "
                                  "length=\"0.4\"/></geometry>") +
    with_collision(link("foot"), ball) + with_collision(link("box"), "<geometry><box size=\"0.2 0.1 0.04\"/></geometry>") +
    with_collision(link("shell"), "<geometry><mesh filename=\"shell.stl\"/></geometry>") + link("bare") +
    joint("leg", "prismatic", "trunk", "foot",
          "<origin xyz=\"0 0 -0.5\"/><axis xyz=\"0 0 1\"/><limit lower=\"-0.1\" upper=\"0.2\" effort=\"9\" velocity=\"9\"/>") +
    joint("tail", "revolute", "trunk", "box", "<axis xyz=\"0 1 0\"/>") + joint("a", "fixed", "trunk", "shell", "") +
    joint("b", "fixed", "trunk", "bare", "");

UrdfOptions floating(std::vector<std::string> ground, bool limits = false) {
  UrdfOptions options;
  options.base = UrdfBase::floating;
  options.ground.named = std::move(ground);
  options.limits = limits;
  options.initial = {{"trunk_z", "2"}};
  return options;
}

std::vector<ContactRows> contacts_of(const Scene& scene) {
  Program program(Model::resolver(scene, {}));
  return contact_rows(Model(scene, program));
}

TEST(UrdfGround, IsTouchedBySpheresCornersAndRims) {
  const Scene scene = read(hopper, floating({"foot", "box", "trunk"}));
  std::vector<std::string> names;
  for (const ContactRows& contact : contacts_of(scene)) {
    names.push_back(contact.name);
    EXPECT_EQ(contact.tangents(), 2U);
  }
  ASSERT_EQ(names.size(), 11U);
  EXPECT_EQ(names[0], "foot_ground");
  EXPECT_EQ(names[1], "box_ground_1");
  EXPECT_EQ(names[8], "box_ground_8");
  EXPECT_EQ(names[9], "trunk_ground_top");
  EXPECT_EQ(names[10], "trunk_ground_base");
  validate(scene);  // none starts below the ground
}

// Gaps at the start: the foot's centre at 1.5 m, the box's corners at 2 -+ 0.02 m, the cylinder along x at 2.1 m.
TEST(UrdfGround, IsAsFarAsTheFileSays) {
  const Scene scene = read(hopper, floating({"foot", "box", "trunk"}));
  Program program(Model::resolver(scene, {}));
  const std::vector<ContactRows> contacts = contact_rows(Model(scene, program));
  Evaluator<Real> start(program, [&scene](const SymbolPointer& symbol) { return initial_value(scene.content(), symbol); });
  EXPECT_NEAR(start(contacts[0].gap).to_double(), 1.45, 1e-14);
  EXPECT_NEAR(start(contacts[1].gap).to_double(), 1.98, 1e-14);
  EXPECT_NEAR(start(contacts[8].gap).to_double(), 2.02, 1e-14);
  EXPECT_NEAR(start(contacts[9].gap).to_double(), 2.0, 1e-14);
  EXPECT_NEAR(start(contacts[10].gap).to_double(), 2.0, 1e-14);
}

/// A trunk that floats, with one <collision> box.
std::string box_robot(const std::string& origin) {
  return with_collision(link("trunk"), origin + "<geometry><box size=\"2 0.2 0.4\"/></geometry>") + link("arm") +
         joint("turn", "revolute", "trunk", "arm", "<axis xyz=\"0 1 0\"/><limit effort=\"1\" velocity=\"1\"/>");
}

// A quarter of a turn about y: the long edge stands upright, and the lowest corner is 1 m below the centre.
TEST(UrdfGround, IsTouchedByShapesThatAQuaternionTurns) {
  for (const char* origin : {"<origin quat_xyzw=\"0 0.70710678118654752 0 0.70710678118654752\"/>",
                             "<origin rpy=\"0 1.5707963267948966 0\"/>"}) {
    const Scene scene = read(box_robot(origin), floating({"trunk"}));
    Program program(Model::resolver(scene, {}));
    Evaluator<Real> start(program, [&scene](const SymbolPointer& symbol) { return initial_value(scene.content(), symbol); });
    double lowest = 9;
    for (const ContactRows& contact : contact_rows(Model(scene, program))) {
      lowest = std::min(lowest, start(contact.gap).to_double());
    }
    EXPECT_NEAR(lowest, 1.0, 1e-14) << origin;
  }
}

// What a picture may pass over decides a motion where a shape touches.
TEST(UrdfGround, RefusesShapesWhosePlaceIsNotPlain) {
  for (const char* origin :
       {"<origin rpy=\"0 0 0\" quat_xyzw=\"0 0 0 1\"/>", "<origin quat_xyzw=\"0 0 0 0\"/>",
        "<origin quat=\"1 0 0 0\"/>", "<orign rpy=\"1 0 0\"/>", "<origin xyz=\"0 0 1\"/><origin xyz=\"0 0 2\"/>",
        "<geometry><sphere radius=\"1\"/></geometry>"}) {
    EXPECT_NO_THROW(read(box_robot(origin), floating({}))) << origin;
    EXPECT_THROW(read(box_robot(origin), floating({"trunk"})), FileError) << origin;
  }
}

TEST(UrdfGround, RefusesALinkThatIsLeftOut) {
  const std::string lonely = hopper + "<link name=\"marker\"><collision>" + ball + "</collision></link>";
  EXPECT_NO_THROW(read(lonely, floating({"foot"})));
  try {
    read(lonely, floating({"marker"}));
    ADD_FAILURE() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("the link 'marker' in --ground belongs to no part that moves and is left out"),
              std::string::npos)
        << error.what();
  }
}

TEST(UrdfGround, LimitsAreStopsWhereTheyAreAskedFor) {
  EXPECT_TRUE(contacts_of(read(hopper, floating({}))).empty());
  const std::vector<ContactRows> stops = contacts_of(read(hopper, floating({}, true)));
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0].name, "leg_lower");
  EXPECT_EQ(stops[1].name, "leg_upper");
}

template <class Refusal>
void expect_refused(const UrdfOptions& options, const std::string& message) {
  try {
    read(hopper, options);
    ADD_FAILURE() << "accepted; expected: " << message;
  } catch (const Refusal& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(UrdfGround, RefusesWhatCannotTouchAPlane) {
  expect_refused<FileError>(floating({"shell"}), "the <collision> of the link 'shell' is no sphere, box or cylinder");
  expect_refused<UsageError>(floating({"bare"}), "the link 'bare' in --ground has no <collision>");
  expect_refused<UsageError>(floating({"fot"}), "the link 'fot' in --ground is unknown: did you mean 'foot'");
  expect_refused<UsageError>(floating({"foot", "foot"}), "--ground names the link 'foot' twice");
}

}  // namespace
}  // namespace torsor::urdf_ground_test
