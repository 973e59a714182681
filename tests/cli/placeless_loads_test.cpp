// SPDX-License-Identifier: GPL-3.0-or-later
// What works on a formula has no place in space: friction in proportion to what a joint transmits cannot know what it adds.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::placeless_loads_test {
namespace {

Expression metres(const char* number) { return Expression::quantity(number, "m"); }
Expression kilograms(const char* number) { return Expression::quantity(number, "kg"); }

/// A pulley of 0.1 m turns by th in a journal that rubs; a weight beside it moves by y. An arm on the weight turns by u.
struct Pulley {
  Scene scene{"pulley", ""};
  Expression th = scene.coordinate("th", "rad"), y = scene.coordinate("y", "m"), u = scene.coordinate("u", "rad");
  Expression r = scene.parameter("r", "m", metres("0.1"));
  FrameHandle pulley = scene.revolute("pulley", scene.ground(), axis::y, th);
  FrameHandle weight = scene.prismatic("weight", scene.ground(), axis::z, y, {.origin = {r, 0, metres("-1")}});
  FrameHandle arm = scene.revolute("arm", weight, axis::x, u);

  Pulley() {
    scene.body("pulley", pulley, Inertia::disk(kilograms("2"), r, 1));
    scene.body("weight", weight, Inertia::point(kilograms("5")));
    scene.body("arm", arm, Inertia::point(kilograms("1")).at({0, metres("0.3"), 0}));
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  }
  void rub(const FrameHandle& frame) {
    scene.joint_friction("journal", frame, {.friction = Expression(Number::rational(3, 10)), .radius = metres("0.02")});
  }
};

using Change = std::function<void(Pulley&)>;

std::string error_of(const Change& change, FrameHandle Pulley::*rubs = &Pulley::pulley) {
  Pulley made;
  try {
    change(made);
    made.rub(made.*rubs);
    static_cast<void>(bearing_reactions(Equations(made.scene)));
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

const Expression stiffness = Expression::quantity("2000", "N/m"), newton = Expression::quantity("1", "N");

const Change rope = [](Pulley& p) { p.scene.holonomic("rope", p.y + p.r * p.th); };

TEST(PlacelessLoads, OfAFormulaThatTiesJointsAreRefused) {
  const auto refused = [](const std::string& what, const Change& change) {
    EXPECT_EQ(error_of(change),
              "the friction 'journal' is in proportion to what its joint transmits across its axis, and how much of that the " + what +
                  " adds is not said: a formula that ties joints has no place in space; give a rope or a gear by no_slip, a loop by "
                  "closure, a spring or a force between points, the reaction of a constraint by reaction, or the bound of a "
                  "dry_friction");
  };
  refused("constraint 'rope'", rope);
  refused("constraint 'rope'", [](Pulley& p) {
    p.scene.nonholonomic("rope", rate(p.y) + p.r * rate(p.th));
  });
  refused("action 'rope'", [](Pulley& p) { p.scene.spring("rope", p.y + p.r * p.th, stiffness); });
  refused("action 'rope'", [](Pulley& p) {
    p.scene.damper("rope", p.y + p.r * p.th, Expression::quantity("3", "N s/m"));
  });
  refused("action 'rope'", [](Pulley& p) { p.scene.generalised_force("rope", p.y + p.r * p.th, -30 * newton); });
  refused("action 'rope'", [](Pulley& p) { p.scene.force_function("rope", -stiffness * pow(p.y + p.r * p.th, 2) / 2); });
  refused("action 'rope'", [](Pulley& p) { p.scene.motor("rope", p.y + p.r * p.th); });
  refused("dry friction 'rope'", [](Pulley& p) { p.scene.dry_friction("rope", p.y + p.r * p.th, {.bound = 2 * newton}); });
  refused("reflected inertia 'rope'", [](Pulley& p) {
    p.scene.reflected_inertia("rope", p.th + p.u, Expression::quantity("1", "kg m^2"));
  });
  // The weight goes down by a law of time, and the rope turns the pulley.
  refused("constraint 'rope'", [](Pulley& p) {
    p.scene.drive(p.y, -Expression::quantity("0.1", "m/s^2") * pow(p.scene.time(), 2));
    rope(p);
  });
}

TEST(PlacelessLoads, OfJointsThatOneCoordinateMovesAreRefused) {
  const std::string error = error_of([](Pulley& p) {
    const FrameHandle other = p.scene.prismatic("other", p.scene.ground(), axis::z, -p.r * p.th);
    p.scene.body("other", other, Inertia::point(kilograms("1")));
  });
  EXPECT_NE(error.find("one coordinate moves that joint together with others"), std::string::npos) << error;
}

// A motor, a spring or a stop in the joint bears on nothing across its axis; forces between bodies on one side of it do not either.
TEST(PlacelessLoads, InTheJointOrOnOneSideOfItAreNone) {
  for (const auto& [name, change] : std::vector<std::pair<const char*, Change>>{
           {"motor", [](Pulley& p) { p.scene.motor("drive", p.th); }},
           {"geared motor", [](Pulley& p) { p.scene.motor("drive", 7 * p.th); }},
           {"spring", [](Pulley& p) { p.scene.spring("coil", p.th, Expression::quantity("3", "N m/rad")); }},
           {"law", [](Pulley& p) { p.scene.holonomic("turn", p.th - Expression::quantity("2", "rad/s") * p.scene.time()); }},
           {"stop", [](Pulley& p) { p.scene.stop(p.th, -1, 1, {}); }},
           {"rotor", [](Pulley& p) { p.scene.reflected_inertia("motor", p.th, Expression::quantity("1", "kg m^2")); }},
           {"beside", [](Pulley& p) { p.scene.spring("beside", p.y + p.r * p.u, stiffness); }},
           {"driven", [](Pulley& p) { p.scene.drive(p.y, Expression::quantity("0.1", "m/s") * p.scene.time()); }},
           {"reaction", [](Pulley& p) {
              const ConstraintHandle tie = p.scene.holonomic("rope", p.y + p.r * p.th);
              const PointHandle at = p.scene.point("at", p.weight, {0, 0, 0});
              p.scene.reaction(tie, "pull", {.body = p.weight, .contact = at, .direction = axis::z, .axes = p.scene.ground(),
                                             .other = p.pulley});
            }},
           {"points", [](Pulley& p) {
              p.scene.spring("rope", {.a = p.scene.point("a", p.pulley, {p.r, 0, 0}), .b = p.scene.point("b", p.weight, {0, 0, 0}),
                                      .stiffness = stiffness, .rest = metres("1")});
            }},
       }) {
    EXPECT_EQ(error_of(change), "") << name;
  }
  // The arm's journal is on the weight: a rope from the pulley to the weight does not bear on it, one to the arm may.
  EXPECT_EQ(error_of(rope, &Pulley::arm), "");
  EXPECT_NE(error_of([](Pulley& p) { p.scene.holonomic("rope", p.y + p.r * p.th + p.r * p.u); }, &Pulley::arm), "");
}

}  // namespace
}  // namespace torsor::placeless_loads_test
