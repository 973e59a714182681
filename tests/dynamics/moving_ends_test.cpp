// SPDX-License-Identifier: GPL-3.0-or-later
// Springs, dampers and attractions that end on points which move in their frames.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/selected_actions.hpp"
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::moving_ends_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

// Values of fifty digits: an identity of a few terms of the size of one holds to 1e-45.
constexpr double exact = 1e-45;

Expression stiffness() { return Expression::quantity("7", "N/m"); }
Expression damping() { return Expression::quantity("3", "N s/m"); }

/// A rod that turns about z and a bead that slides along it; P is where the bead is: a point of the bead, or one of the
/// rod that moves there.
struct RodAndBead {
  Scene scene{"rod_and_bead"};
  Expression theta = scene.coordinate("theta", "rad"), s = scene.coordinate("s", "m");
  FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, theta, {{metres("0.2"), 0, 0}});
  FrameHandle bead = scene.prismatic("bead", rod, axis::x, s);
  explicit RodAndBead(bool of_bead) {
    scene.body("rod", rod, Inertia::rod(kilograms("2"), metres("1"), 0));
    scene.body("bead", bead, Inertia::point(kilograms("0.5")));
    scene.point("O", scene.ground(), {metres("1"), metres("-0.5"), 0});
    if (of_bead) {
      scene.point("P", bead, {0, 0, 0});
    } else {
      scene.point("P", rod, {s, 0, 0});
    }
  }
};

const Point state{{"theta", rational(4, 5)},  {"s", rational(2, 3)},     {"x", rational(2, 3)},     {"y", rational(5, 7)},
                  {"theta'", rational(3, 8)}, {"s'", rational(-7, 5)},   {"x'", rational(1, 4)},    {"y'", rational(-3, 7)},
                  {"theta''", rational(1, 3)}, {"s''", rational(-2, 5)}, {"x''", rational(1, 7)},   {"y''", rational(3, 5)},
                  {"spin", rational(1, 9)},   {"spin'", rational(5, 3)}, {"spin''", rational(2, 7)}, {"t", rational(4, 3)}};

/// Forces, power and force function of both scenes are the same.
void expect_same(const Scene& one, const Scene& other) {
  const Equations a(one), b(other);
  NamedState at_a(a, state), at_b(b, state);
  const auto same = [&](const Value& x, const Value& y, const std::string& what) {
    const Real first = at_a(x), second = at_b(y);
    EXPECT_LT(abs(first - second).to_double(), exact) << what << " " << first.to_double() << " " << second.to_double();
  };
  for (std::size_t i = 0; i < a.inverse_dynamics().size(); ++i) {
    same(a.inverse_dynamics()[i], b.inverse_dynamics()[i], "inverse dynamics");
    same(a.forward().accelerations[i], b.forward().accelerations[i], "acceleration");
  }
  same(a.power(), b.power(), "power");
  same(a.actions().spring_force_function, b.actions().spring_force_function, "force function");
}

void expect_all_checks(const Scene& scene) {
  for (const CheckResult& result : check_scene(scene, {})) {
    EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst << " of " << result.bound;
  }
}

using Add = std::function<void(Scene&)>;

const std::vector<Add>& mutual_actions() {
  static const std::vector<Add> all{
      [](Scene& s) { s.spring("spring", {.a = s.point("O"), .b = s.point("P"), .stiffness = stiffness()}); },
      [](Scene& s) {
        s.spring("spring", {.a = s.point("P"), .b = s.point("O"), .stiffness = stiffness(), .rest = metres("0.3")});
      },
      [](Scene& s) { s.damper("damper", s.point("O"), s.point("P"), damping()); },
      [](Scene& s) { s.gravitation("pull", s.point("O"), s.point("P"), Expression::quantity("2", "N m^2")); }};
  return all;
}

TEST(MovingEnds, OfASliderActLikeThoseOfTheBodyThere) {
  const WorkingDigits precision(60);
  for (const Add& add : mutual_actions()) {
    RodAndBead of_body(true), moving(false);
    add(of_body.scene);
    add(moving.scene);
    expect_same(of_body.scene, moving.scene);
    EXPECT_EQ(painleve(Equations(of_body.scene)).first_integrals.size(),
              painleve(Equations(moving.scene)).first_integrals.size());
    expect_all_checks(moving.scene);
  }
}

TEST(MovingEnds, HaveThePowerOfTheirActions) {
  const WorkingDigits precision(60);
  for (const Add& add : mutual_actions()) {
    RodAndBead of_body(true), moving(false);
    add(of_body.scene);
    add(moving.scene);
    const Equations a(of_body.scene), b(moving.scene);
    const std::string name = name_of(moving.scene.content().actions[0]);
    NamedState at_a(a, state), at_b(b, state);
    const Real expected = at_a(action_power(a, name, "ground"));
    EXPECT_GT(abs(expected).to_double(), 1e-3);
    EXPECT_LT(relative_difference(at_b(action_power(b, name, "ground")), expected), exact);
  }
}

/// Two beads on one rod, tied to each other: both ends move on one rigid body.
TEST(MovingEnds, MayBothBelongToOneBody) {
  const WorkingDigits precision(60);
  const auto make = [](bool of_beads) {
    RodAndBead it(of_beads);
    const Expression x = it.scene.coordinate("x", "m");
    const FrameHandle second = it.scene.prismatic("second", it.rod, axis::x, x, {{0, metres("0.3"), 0}});
    it.scene.body("second", second, Inertia::point(kilograms("1.5")));
    if (of_beads) {
      it.scene.point("Q", second, {0, 0, 0});
    } else {
      it.scene.point("Q", it.rod, {x, metres("0.3"), 0});
    }
    it.scene.spring(
        "tie", {.a = it.scene.point("P"), .b = it.scene.point("Q"), .stiffness = stiffness(), .rest = metres("0.1")});
    it.scene.damper("oil", it.scene.point("P"), it.scene.point("Q"), damping());
    return it.scene;
  };
  expect_same(make(true), make(false));
}

/// An end that a law of time moves: U = −½ k (s − 0.3 cos 2t)² along the slide, and a damper that feels the law's rate.
TEST(MovingEnds, MayFollowALawOfTime) {
  const WorkingDigits precision(60);
  const auto make = [](bool by_points) {
    Scene scene("shaken");
    const Expression x = scene.coordinate("x", "m");
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
    scene.body("mass", slide, Inertia::point(kilograms("2")));
    const Expression law = metres("0.3") * cos(Expression::quantity("2", "rad/s") * scene.time());
    if (by_points) {
      scene.point("A", scene.ground(), {law, 0, 0});
      scene.point("B", slide, {0, 0, 0});
      scene.spring("spring", {.a = scene.point("A"), .b = scene.point("B"), .stiffness = stiffness()});
      scene.damper("damper", scene.point("A"), scene.point("B"), damping());
    } else {
      scene.spring("spring", x - law, stiffness());
      scene.damper("damper", x - law, damping());
    }
    return scene;
  };
  expect_same(make(true), make(false));
}

/// A disc in the plane x, z, on a slide, a lift and a hinge about y. Its lowest point is (x, 0, z − r) however it spins:
/// U = −½ k ((x − 1)² + (z + 1/2 − r)²).
TEST(MovingEnds, OfADiscFollowItsLowestPoint) {
  const WorkingDigits precision(60);
  const auto make = [](bool by_points) {
    Scene scene("disc");
    const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("y", "m"), spin = scene.coordinate("spin", "rad");
    const FrameHandle lift = scene.prismatic("lift", scene.prismatic("slide", scene.ground(), axis::x, x), axis::z, z);
    const FrameHandle disc = scene.revolute("disc", lift, axis::y, spin);
    scene.body("disc", disc, Inertia::disk(kilograms("2"), metres("0.4"), 1));
    if (by_points) {
      scene.point("A", scene.ground(), {metres("1"), 0, metres("-0.5")});
      scene.spring("spring",
                   {.a = scene.disc_contact(
                        "P", {.frame = disc, .axis = axis::y, .radius = metres("0.4"), .plane = scene.ground()}),
                    .b = scene.point("A"),
                    .stiffness = stiffness()});
    } else {
      const Expression along = x - metres("1"), up = z + metres("0.1");
      scene.force_function("spring", -stiffness() * (along * along + up * up) / 2);
    }
    return scene;
  };
  expect_same(make(true), make(false));
  expect_all_checks(make(true));
}

TEST(MovingEnds, AreRefusedWhereTheirMotionIsNotKnown) {
  const auto refusal = [](const Add& add) -> std::string {
    RodAndBead it(true);
    add(it.scene);
    try {
      Equations(it.scene).actions();
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(refusal([](Scene& s) {
              const Expression v(s.content().coordinates[1].v);
              s.point("M", "rod", {v * Expression::quantity("1", "s"), 0, 0});
              s.spring("odd", {.a = s.point("M"), .b = s.point("O"), .stiffness = stiffness()});
            }),
            "spring 'odd' is attached to point 'M', whose place depends on more than coordinates, time and parameters: "
            "give its components as formulas of those");
  EXPECT_EQ(refusal([](Scene& s) {
              const Expression r = s.released_coordinate("r", "m");
              s.prismatic("held", "rod", axis::y, r);
              s.point("M", "rod", {r, 0, 0});
              s.spring("odd", {.a = s.point("M"), .b = s.point("O"), .stiffness = stiffness()});
            }),
            "spring 'odd' names the released coordinate 'r', which its joint holds at zero: write it without, or between "
            "points");
}

TEST(MovingEnds, HaveNoShareOnOneBodyThatIsKnown) {
  RodAndBead it(false);
  it.scene.spring("spring", {.a = it.scene.point("O"), .b = it.scene.point("P"), .stiffness = stiffness()});
  const Equations equations(it.scene);
  EXPECT_THROW(selected_actions(equations.model(), {{"spring"}, {"rod"}}), SceneError);
  EXPECT_NO_THROW(selected_actions(equations.model(), {{"spring"}, {}}));
}

}  // namespace
}  // namespace torsor::moving_ends_test
