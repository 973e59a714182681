// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity in the wrong unit is refused by the name of its object, never by a definition's.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/action_units.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::scene_units_test {
namespace {

struct Mechanism {
  Scene scene{"mechanism"};
  Expression x = scene.coordinate("x", "m"), phi = scene.coordinate("phi", "rad");
  Expression mass = scene.parameter("some_mass", "kg", 2), length = scene.parameter("some_length", "m", 2);
  Expression force = scene.parameter("some_force", "N", 1);
  FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  FrameHandle arm = scene.revolute("arm", slide, axis::z, phi);
  PointHandle A = scene.point("A", scene.ground(), {0, 0, 0}), B = scene.point("B", arm, {length, 0, 0});
  ConstraintHandle floor = scene.point_in_plane("floor", B, scene.ground());
};

struct Wrong {
  std::function<void(Mechanism&)> give;
  std::string message;
};

void expect_refused(const std::vector<Wrong>& all) {
  for (const Wrong& wrong : all) {
    Mechanism it;
    try {
      wrong.give(it);
      for (const ActionContent& action : it.scene.content().actions) require_action_units(action);
      ADD_FAILURE() << "not refused: " << wrong.message;
    } catch (const UnitError& error) {
      EXPECT_EQ(error.what(), wrong.message);
    }
  }
}

TEST(QuantityUnits, OfActionsAreRefusedByTheNameOfTheActionAndTheQuantity) {
  expect_refused({
      {[](Mechanism& m) {
         m.scene.gravity({0, m.mass, 0});
       },
       "a component of the gravity is some_mass [kg] and must be in m/s^2"},
      {[](Mechanism& m) { m.scene.spring("hinge", m.x, m.mass); },
       "the stiffness of the spring 'hinge' on x [m] is some_mass [kg] and must be in N/m"},
      {[](Mechanism& m) { m.scene.spring("hinge", m.phi, m.force / m.length); },
       "the stiffness of the spring 'hinge' on phi [1] is some_force/some_length [N/m] and must be in N m"},
      {[](Mechanism& m) { m.scene.spring("hinge", m.x, m.force / m.length, m.mass); },
       "the rest of the spring 'hinge' on x [m] is some_mass [kg] and must be in m"},
      {[](Mechanism& m) { m.scene.damper("oil", m.x, m.force); },
       "the damping of the damper 'oil' on x [m] is some_force [N] and must be in N s/m"},
      {[](Mechanism& m) { m.scene.spring("rod", {.a = m.A, .b = m.B, .stiffness = m.force}); },
       "the stiffness of the spring 'rod' is some_force [N] and must be in N/m"},
      {[](Mechanism& m) {
         m.scene.spring("rod", {.a = m.A, .b = m.B, .stiffness = m.force / m.length, .rest = m.mass});
       },
       "the rest length of the spring 'rod' is some_mass [kg] and must be in m"},
      {[](Mechanism& m) { m.scene.damper("oil", m.A, m.B, m.force); },
       "the damping of the damper 'oil' is some_force [N] and must be in N s/m"},
      {[](Mechanism& m) {
         m.scene.force("push", {.body = m.arm, .point = m.B, .components = {m.mass, 0, 0}, .axes = m.scene.ground()});
       },
       "a component of the force 'push' is some_mass [kg] and must be in N"},
      {[](Mechanism& m) {
         m.scene.torque("twist", m.arm, {m.force, 0, 0}, m.scene.ground());
       },
       "a component of the torque 'twist' is some_force [N] and must be in N m"},
      {[](Mechanism& m) {
         m.scene.sliding_friction("rub", m.floor,
                                  {.coefficient = m.x / m.length,
                                   .body = m.arm,
                                   .point = m.B,
                                   .direction = {m.length, m.mass, 0},
                                   .axes = m.scene.ground()});
       },
       "the direction of the friction 'rub' has components of different units, some_length [m] and some_mass [kg]: "
       "give all in one"},
  });
}

TEST(QuantityUnits, OfGeometryAreRefusedByTheNameOfWhatIsPlaced) {
  expect_refused({
      {[](Mechanism& m) {
         m.scene.point("P", m.arm, {1, 0, 0});
       },
       "a component of the point 'P' is 1 [1] and must be in m: write quantity(\"1\", \"m\")"},
      {[](Mechanism& m) {
         m.scene.point("P", m.arm, {1, m.length, 2});
       },
       "a component of the point 'P' is 1 [1], another is 2 [1] and must be in m: write quantity(\"1\", \"m\")"},
      {[](Mechanism& m) {
         m.scene.disc_contact("P", {.frame = m.arm, .axis = axis::y, .radius = m.mass, .plane = m.scene.ground()});
       },
       "the radius of the disc at 'P' is some_mass [kg] and must be in m"},
      {[](Mechanism& m) { m.scene.sphere_contact("P", m.arm, 1, m.scene.ground()); },
       "the radius of the sphere at 'P' is 1 [1] and must be in m: write quantity(\"1\", \"m\")"},
      {[](Mechanism& m) {
         m.scene.weld("hand", m.arm, {{m.mass, 0, 0}});
       },
       "a component of the origin of the frame 'hand' is some_mass [kg] and must be in m"},
      {[](Mechanism& m) {
         m.scene.revolute("hand", m.arm, axis::z, m.phi, {{1, 0, 0}});
       },
       "a component of the origin of the joint 'hand' is 1 [1] and must be in m: write quantity(\"1\", \"m\")"},
      {[](Mechanism& m) {
         m.scene.revolute("hand", m.arm, {m.length, 0, 0}, m.phi);
       },
       "a component of the axis of the joint 'hand' is some_length [m] and must be in plain numbers"},
      {[](Mechanism& m) {
         m.scene.no_slip("roll",
                         {.body = m.arm, .contact = m.B, .direction = {m.length, 0, 0}, .axes = m.scene.ground()});
       },
       "a component of the direction of the constraint 'roll' is some_length [m] and must be in plain numbers"},
      {[](Mechanism& m) {
         m.scene.closure("close", m.A, m.B, {m.length, 0, 0});
       },
       "a component of the direction of the constraint 'close' is some_length [m] and must be in plain numbers"},
      {[](Mechanism& m) {
         m.scene.reaction(m.floor, "N",
                          {.body = m.arm, .contact = m.B, .direction = {m.length, 0, 0}, .axes = m.scene.ground()});
       },
       "a component of the direction of the reaction 'N' is some_length [m] and must be in plain numbers"},
  });
}

TEST(QuantityUnits, LetZeroPassWhateverItsUnit) {
  Mechanism it;
  it.scene.gravity({0, 0, 0});
  it.scene.spring("hinge", it.x, 0, 0);
  it.scene.point("P", it.arm, {0, 0, 0});
  for (const ActionContent& action : it.scene.content().actions) EXPECT_NO_THROW(require_action_units(action));
}

}  // namespace
}  // namespace torsor::scene_units_test
