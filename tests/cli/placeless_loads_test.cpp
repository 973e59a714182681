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
#include "torsor/generator/expression/piecewise.hpp"
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
    JointFriction friction{.friction = Expression(Number::rational(3, 10))};
    if (frame.index != weight.index) friction.radius = metres("0.02");
    scene.joint_friction("journal", frame, friction);
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

std::string error_about(const std::string& what, const std::string& reason) {
  return "the friction 'journal' is in proportion to what its joint transmits across its axis, and how much of that the " +
         what + " adds is not said: " + reason +
         "; give a rope or a gear by no_slip, a loop by closure, a spring or a force between points, the reaction of a "
         "constraint by reaction, or the bound of a dry_friction";
}

void refused(const std::string& what, const Change& change) {
  EXPECT_EQ(error_of(change), error_about(what, "a formula that ties joints has no place in space"));
}

TEST(PlacelessLoads, OfAFormulaThatTiesJointsAreRefused) {
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
  refused("dry friction 'rope'", [](Pulley& p) {
    p.scene.dry_friction("rope", p.y + p.r * p.th, {.bound = 2 * newton});
  });
  refused("reflected inertia 'rope'", [](Pulley& p) {
    p.scene.reflected_inertia("rope", p.th + p.u, Expression::quantity("1", "kg m^2"));
  });
  // The weight goes down by a law of time, and the rope turns the pulley.
  refused("constraint 'rope'", [](Pulley& p) {
    p.scene.drive(p.y, -Expression::quantity("0.1", "m/s^2") * pow(p.scene.time(), 2));
    rope(p);
  });
}

// Nothing that a slack rope does at some states says what it does when it is taut.
TEST(PlacelessLoads, OfARopeThatIsSlackSomewhereAreRefused) {
  refused("action 'rope'", [](Pulley& q) { q.scene.spring("rope", max(-q.y - q.r * q.th, 0), stiffness); });
  refused("action 'rope'", [](Pulley& q) {
    q.scene.spring("rope", max(q.u + q.th - 5, 0), Expression::quantity("3", "N m/rad"));
  });
  refused("action 'rope'", [](Pulley& q) {
    q.scene.force_function("rope", -stiffness * pow(max(-q.y - q.r * q.th, 0), 2) / 2);
  });
  refused("action 'rope'", [](Pulley& q) {
    q.scene.spring("rope", piecewise({{q.y < metres("-3"), q.y + q.r * q.th}}, q.y), stiffness);
  });
  refused("action 'rope'", [](Pulley& q) {  // no number at the states looked at
    q.scene.force_function("rope", newton * metres("1") * sqrt(-q.th - q.u));
  });
  refused("action 'rope'", [](Pulley& q) {  // the weight comes down by a law of time
    q.scene.drive(q.y, -Expression::quantity("0.1", "m/s^2") * pow(q.scene.time(), 2));
    q.scene.spring("rope", max(-q.y - q.r * q.th, 0), stiffness);
  });
  EXPECT_EQ(error_of([](Pulley& q) {
              q.scene.spring("buffer", max(-q.th - 2, 0), Expression::quantity("3", "N m/rad"));
              q.scene.spring("beside", max(-q.y - q.r * q.u, 0), stiffness);
            }),
            "");
}

// A hand pulls a rope that is wound on the pulley, or a brake shoe rubs on its rim: both bear on the journal.
TEST(PlacelessLoads, OfALengthAlongAJointThatTurnsAreRefused) {
  const auto by_unit = [](const std::string& what, const Change& change, FrameHandle Pulley::*rubs = &Pulley::pulley) {
    EXPECT_EQ(error_of(change, rubs),
              error_about(what, "a formula in another unit than the joint that it moves, as that of a rope pulled by hand, "
                                "has no place in space"));
  };
  const Change pulled = [](Pulley& p) { p.scene.generalised_force("hand", p.r * p.th, -30 * newton); };
  by_unit("action 'hand'", pulled);
  by_unit("action 'coil'", [](Pulley& p) { p.scene.spring("coil", max(p.r * p.th, 0), stiffness); });
  by_unit("dry friction 'shoe'", [](Pulley& p) { p.scene.dry_friction("shoe", p.r * p.th, {.bound = 2 * newton}); });
  by_unit("constraint 'rope'", [](Pulley& p) {
    p.scene.nonholonomic("rope", p.r * rate(p.th) - Expression::quantity("1", "m/s"));
  });
  // What the weight carries is pulled as well; what it does not carry is not.
  by_unit("action 'hand'", [](Pulley& p) { p.scene.generalised_force("hand", p.r * p.u, -30 * newton); }, &Pulley::weight);
  EXPECT_EQ(error_of(pulled, &Pulley::weight), "");
}

// A force function of where a point is pulls at that point.
TEST(PlacelessLoads, OfAMeasuredPlaceAreRefused) {
  const auto trap = [](FrameHandle Pulley::*body, std::size_t component) {
    return [body, component](Pulley& p) {
      const PointHandle point = p.scene.point("P", p.*body, {0, metres("0.3"), p.r});
      p.scene.force_function("trap", -stiffness * pow(p.scene.position(point, "ground")[component], 2) / 2);
    };
  };
  const std::string error = error_about("action 'trap'", "a formula of a measured position or velocity works at a point that it "
                                                         "does not name");
  EXPECT_EQ(error_of(trap(&Pulley::pulley, 0)), error);
  EXPECT_EQ(error_of(trap(&Pulley::arm, 1), &Pulley::weight), error);  // across the slide: along the arm's angle alone
  EXPECT_EQ(error_of(trap(&Pulley::arm, 1)), "");                      // between what the pulley does not carry
}

TEST(PlacelessLoads, OfJointsThatOneCoordinateMovesAreRefused) {
  const std::string error = error_of([](Pulley& p) {
    const FrameHandle other = p.scene.prismatic("other", p.scene.ground(), axis::z, -p.r * p.th);
    p.scene.body("other", other, Inertia::point(kilograms("1")));
  });
  EXPECT_NE(error.find("one coordinate moves that joint together with others"), std::string::npos) << error;
}

// A motor, a spring or a stop in the joint bears on nothing across its axis; forces between bodies on one side of it do not
// either.
TEST(PlacelessLoads, InTheJointOrOnOneSideOfItAreNone) {
  for (const auto& [name, change] : std::vector<std::pair<const char*, Change>>{
           {"motor", [](Pulley& p) { p.scene.motor("drive", p.th); }},
           {"geared motor", [](Pulley& p) { p.scene.motor("drive", 7 * p.th); }},
           {"spring", [](Pulley& p) { p.scene.spring("coil", p.th, Expression::quantity("3", "N m/rad")); }},
           {"law",
            [](Pulley& p) { p.scene.holonomic("turn", p.th - Expression::quantity("2", "rad/s") * p.scene.time()); }},
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
              p.scene.spring("rope", {.a = p.scene.point("a", p.pulley, {p.r, 0, 0}),
                                      .b = p.scene.point("b", p.weight, {0, 0, 0}),
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
