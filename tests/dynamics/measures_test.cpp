// SPDX-License-Identifier: GPL-3.0-or-later
// What formulas ask of the motion: attitudes, directions, positions, velocities.
#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/verification/check.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/all_checks.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::measures_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

// Values of fifty digits: an identity holds to 1e-45.
constexpr double exact = 1e-45;

/// A free body on a table that turns and slides by a law of time, with an arm on the body.
struct Carried {
  Scene scene;
  Expression table_angle, phi, x, y, z;
  AttitudeHandle e;
  FrameHandle table, body, arm;
  PointHandle tip;
  explicit Carried(const std::string& name = "carried") : scene(name) {
    table_angle = scene.coordinate("table_angle", "rad");
    x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
    e = scene.attitude("e");
    phi = scene.coordinate("phi", "rad");
    const Rotation tilt = Rotation::about(0, 2);
    table = scene.revolute("table", scene.ground(), {1, 2, 2}, table_angle, {{metres("0.3"), 0, metres("1")}, tilt});
    body = scene.free("body", table, {x, y, z}, e);
    arm = scene.revolute("arm", body, axis::y, phi, {{metres("0.2"), metres("0.5"), 0}, {}});
    tip = scene.point("tip", arm, {metres("0.7"), 0, metres("-0.1")});
    scene.body("disc", table,
               Inertia::general({.mass = kilograms("3"), .xx = moment("1"), .yy = moment("2"), .zz = moment("2.5")}));
    scene.body(
        "body", body,
        Inertia::general({.mass = kilograms("2"), .xx = moment("0.4"), .yy = moment("0.5"), .zz = moment("0.6")}));
    scene.body("stick", arm, Inertia::point(kilograms("0.5")).at({metres("0.4"), 0, 0}));
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  }
  Expression newtons() const { return Expression::quantity("3", "N"); }
};

/// Both scenes' bias at the same random states.
void expect_same_bias(const Scene& one, const Scene& other) {
  const WorkingDigits precision(60);
  const Equations first(one), second(other);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const RandomState state(one, seed);
    const auto by_name = [&](const Equations& equations) {
      return [&state, &equations, &first](const SymbolPointer& symbol) {
        if (symbol->kind == SymbolKind::pi) return Real::pi();
        const std::vector<SymbolPointer> own = equations.model().positions(), theirs = first.model().positions();
        for (std::size_t i = 0; i < own.size(); ++i) {
          if (own[i] == symbol) return state.in_real()(theirs[i]);
        }
        for (int i = 0; i < first.model().unknown_count(); ++i) {
          const auto k = static_cast<std::size_t>(i);
          if (equations.model().coordinates()[k].v == symbol) return state.in_real()(first.model().coordinates()[k].v);
        }
        throw Error("no value for " + symbol->name);
      };
    };
    Evaluator<Real> here(first.program(), by_name(first)), there(second.program(), by_name(second));
    for (std::size_t i = 0; i < first.bias().size(); ++i) {
      EXPECT_LT(relative_difference(here(first.bias()[i]), there(second.bias()[i])), exact) << i;
    }
  }
}

TEST(MeasuredDirection, IsThatOfTheFramesAxis) {
  Scene scene = pendulum();
  const Triple along = scene.direction("arm", axis::y, "ground");
  const Equations equations(scene);
  NamedState here(equations, {{"theta", rational(3, 7)}});
  EXPECT_LT(relative_difference(here(equations.program().lower(along[0])), -sin(rational(3, 7))), exact);
  EXPECT_LT(relative_difference(here(equations.program().lower(along[1])), cos(rational(3, 7))), exact);
  EXPECT_TRUE(equations.program().lower(along[2]).is_zero());
}

TEST(MeasuredPosition, ChangesAtTheVelocityOfAPointOfTheBody) {
  Carried it;
  for (const char* seen_from : {"ground", "table", "body"}) {
    const Triple place = it.scene.position(it.tip, seen_from);
    const Triple velocity = it.scene.velocity(it.tip, it.arm, seen_from, seen_from);
    const Equations equations(it.scene);
    const RandomState state(it.scene, 7);
    Evaluator<Real> here(equations.program(), state.in_real());
    for (std::size_t i = 0; i < 3; ++i) {
      // Differentiation of the place in the program, against the sum over the joints.
      const Real rate_of_place = here(equations.program().lower(rate(place[i])));
      EXPECT_LT(relative_difference(rate_of_place, here(equations.program().lower(velocity[i]))), exact) << seen_from;
    }
  }
}

// Seen from a frame that is welded to a body, turned and at another place: R' (p - o) with the weld's R and o.
TEST(MeasuredPosition, IsSeenFromTheOriginAndAlongTheAxesOfItsFrame) {
  Carried it;
  const Rotation turned = Rotation::about(0, 5) * Rotation::about(2, 4);
  const std::array<Expression, 3> origin{metres("0.4"), metres("-0.3"), metres("0.6")};
  it.scene.weld("shelf", it.body, {.origin = {origin[0], origin[1], origin[2]}, .rotation = turned});
  const Triple from_body = it.scene.position(it.tip, it.body), from_shelf = it.scene.position(it.tip, "shelf");
  const Triple moving = it.scene.velocity(it.tip, it.arm, it.body, "table"),
               along_shelf = it.scene.velocity(it.tip, it.arm, "shelf", "table");
  const Equations equations(it.scene);
  const RandomState state(it.scene, 11);
  Evaluator<Real> here(equations.program(), state.in_real());
  const auto number = [&](const Expression& formula) { return here(equations.program().lower(formula)); };
  for (int i = 0; i < 3; ++i) {
    Real place(0), velocity(0);
    for (int k = 0; k < 3; ++k) {
      const auto j = static_cast<std::size_t>(k);
      const Real entry(turned(k, i), 50);
      place += entry * (number(from_body[j]) - number(origin[j]));
      velocity += entry * number(moving[j]);
    }
    EXPECT_LT(relative_difference(number(from_shelf[static_cast<std::size_t>(i)]), place), exact) << i;
    EXPECT_LT(relative_difference(number(along_shelf[static_cast<std::size_t>(i)]), velocity), exact) << i;
  }
}

// What a formula is made of tells where it may stand.
TEST(MeasuredVectors, AreMadeOfPositionsAndVelocitiesOfRates) {
  Carried it;
  const SymbolPointer& x = it.x.as_symbol();
  const Triple place = it.scene.position(it.tip, "table"),
               velocity = it.scene.velocity(it.tip, it.arm, "table", "table"),
               turning = it.scene.angular_velocity(it.arm, "body", "body");
  EXPECT_TRUE(place[0].depends_on(x));
  EXPECT_FALSE(place[0].depends_on(x->rate));
  EXPECT_FALSE(place[0].depends_on(it.table_angle.as_symbol()));  // both ends are on the table
  EXPECT_TRUE(velocity[0].depends_on(x->rate));
  EXPECT_TRUE(turning[0].depends_on(it.phi.as_symbol()->rate));
  EXPECT_FALSE(turning[0].depends_on(x->rate));
}

TEST(MeasuredAngularVelocity, TurnsTheAxesThatItIsOf) {
  // d(n)/dt in the reference = Ω ∧ n for each axis n of the frame.
  Carried it;
  const Triple omega = it.scene.angular_velocity(it.arm, "table", "table");
  const std::array<Triple, 3> axes{it.scene.direction(it.arm, axis::x, "table"), it.scene.direction(it.arm, axis::y, "table"),
                                   it.scene.direction(it.arm, axis::z, "table")};
  const Equations equations(it.scene);
  const RandomState state(it.scene, 3);
  Evaluator<Real> here(equations.program(), state.in_real());
  const auto number = [&](const Expression& formula) { return here(equations.program().lower(formula)); };
  for (const Triple& n : axes) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Real turned = number(omega[j]) * number(n[k]) - number(omega[k]) * number(n[j]);
      EXPECT_LT(relative_difference(number(rate(n[i])), turned), exact);
    }
  }
}

TEST(MeasuredVelocity, GivesTheDragThatTheActionGives) {
  Carried one("one"), other("other");
  const Expression c = Expression::quantity("0.7", "N s/m"), turn = Expression::quantity("0.3", "N m s");
  one.scene.drag("drag", {.body = one.arm, .point = one.tip, .coefficient = c, .relative_to = one.table});
  one.scene.rotational_drag("turn", one.arm, turn, one.table);
  const Triple v = other.scene.velocity(other.tip, other.arm, "ground", other.table);
  other.scene.force_between("drag", {.a = other.arm,
                                     .b = other.table,
                                     .point = other.tip,
                                     .components = {-c * v[0], -c * v[1], -c * v[2]},
                                     .axes = "ground"});
  const Triple omega = other.scene.angular_velocity("arm", "body", "table");
  other.scene.torque_between(
      "turn",
      {.a = "arm", .b = "table", .components = {-turn * omega[0], -turn * omega[1], -turn * omega[2]}, .axes = "body"});
  expect_same_bias(one.scene, other.scene);
  expect_all_checks(other.scene);
}

TEST(AttitudeComponents, StandInForceFunctions) {
  // U = k e_z² of a body that only turns, by an attitude or by two angles: the work is the same.
  Scene scene("magnet");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle body = scene.spherical("body", scene.ground(), e);
  scene.body("body", body,
             Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("2"), .zz = moment("2.5")}));
  const auto components = scene.attitude_components(e);
  const Expression k = Expression::quantity("5", "J");
  scene.force_function("field", k * pow(components[3], 2) + k * components[0] * components[1]);
  // ∂/∂ω_i turns e by e ∘ (0, n_i)/2: of e_z that is ½ (-y, x, w), of e_w e_x ½ (w² - x², -w z - x y, w y - x z).
  const Equations equations(scene);
  const Real w = rational(1, 2), x = rational(-1, 2), y = rational(1, 2), z = rational(1, 2);
  NamedState here(equations, {{"e_w", w}, {"e_x", x}, {"e_y", y}, {"e_z", z}});
  const auto bias = [&](std::size_t i) { return -here(equations.bias()[i]); };
  EXPECT_LT(relative_difference(bias(0), Real(5) * (-(z * y) + rational(1, 2) * (w * w - x * x))), exact);
  EXPECT_LT(relative_difference(bias(1), Real(5) * (z * x + rational(1, 2) * (-(w * z) - x * y))), exact);
  EXPECT_LT(relative_difference(bias(2), Real(5) * (z * w + rational(1, 2) * (w * y - x * z))), exact);
  expect_all_checks(scene);
}

/// A ball is steered by the spin of its carrier: everything at once, checked by the second derivation.
TEST(MeasuredVectors, StandInEveryKindOfFormula) {
  Carried it;
  const auto components = it.scene.attitude_components(it.e);
  const Triple up = it.scene.direction(it.body, axis::z, "ground");
  const Triple tip = it.scene.position(it.tip, "ground");
  const Triple omega = it.scene.angular_velocity(it.body, it.body);
  it.scene.force_function("spring", -Expression::quantity("4", "N/m") * pow(tip[2], 2) / 2);
  it.scene.generalised_force("steer", up[0], Expression::quantity("2", "N m s") * omega[1] * components[0]);
  it.scene.motor("winch", tip[0]);
  it.scene.holonomic("level", it.x - it.y * up[2] + Expression::quantity("0.2", "m") * up[0]);
  it.scene.nonholonomic("blade", rate(it.phi) + omega[2] * up[2] - 2 * rate(it.table_angle));
  it.scene.initial(it.x, 0);
  expect_all_checks(it.scene);
}

TEST(MeasuredVectors, DisplaceJointsAndDriveCoordinates) {
  // A follower rides on the height of the pendulum's tip: by its displacement, and by a law of the same height.
  const auto follower = [](bool by_measure) {
    Scene scene("follower");
    const Expression theta = scene.coordinate("theta", "rad");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, theta);
    scene.body("bob", arm, Inertia::point(kilograms("2")).at({0, metres("-1.5"), 0}));
    const PointHandle tip = scene.point("tip", arm, {0, metres("-1.5"), 0});
    const Expression height = by_measure ? scene.position(tip, "ground")[1] : -metres("1.5") * cos(theta);
    scene.body("ride", scene.prismatic("follower", scene.ground(), axis::y, height), Inertia::point(kilograms("1")));
    const Expression lift = scene.coordinate("lift", "m");
    scene.drive(lift, by_measure ? pow(scene.direction(arm, axis::x, "ground")[0], 2) * metres("2")
                                 : pow(cos(theta), 2) * metres("2"));
    scene.body("lifted", scene.prismatic("lifted", scene.ground(), axis::x, lift), Inertia::point(kilograms("3")));
    scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
    return scene;
  };
  expect_same_bias(follower(true), follower(false));
  expect_all_checks(follower(true));
}

// A measured place has the rates of what moves it: a condition on velocities takes them, a law of a coordinate does not.
TEST(MeasuredVectors, HaveRatesWhereVelocitiesMayStand) {
  const Expression second = Expression::quantity("1", "s");
  Carried it;
  it.scene.drive(it.table_angle, Expression::quantity("2", "rad/s") * it.scene.time());
  const PointHandle rim = it.scene.point("rim", it.table, {metres("1"), 0, 0});
  const Triple tip = it.scene.position(it.tip, "ground"), driven = it.scene.position(rim, "ground");
  const Triple omega = it.scene.angular_velocity(it.arm, it.table);
  Scene level = it.scene, follower = it.scene, moved = it.scene, twice = it.scene;
  level.nonholonomic("level", rate(level.position(it.tip, "table")[2]));
  expect_all_checks(level);
  const auto follow = [&second](Scene& scene, const Expression& law) {
    const Expression follows = scene.coordinate("follows", "m");
    scene.body("ride", scene.prismatic("ride", scene.ground(), axis::x, follows), Inertia::point(kilograms("1")));
    scene.drive(follows, second * law);
    return error_of([&] { validate(scene); });
  };
  EXPECT_EQ(follow(moved, rate(driven[0])), "no error");  // a formula of time
  EXPECT_EQ(follow(follower, rate(tip[0])),
            "the law of coordinate 'follows' depends on the velocity 'phi'' through d/dt(position(tip, ground).x): give a "
            "formula of coordinates, time and parameters");
  twice.nonholonomic("twice", rate(omega[1]));
  EXPECT_EQ(error_of([&] { validate(twice); }).substr(0, 58), "the constraint 'twice' depends on the acceleration 'phi'''");
}

TEST(MeasuredVectors, AreRefusedWhereTheyAreNotKnown) {
  Carried it;
  const Expression height = it.scene.position(it.tip, "ground")[2];
  const Expression speed = it.scene.velocity(it.tip, it.arm, "ground")[2];
  EXPECT_NE(error_of<SceneError>([&] { it.scene.initial(it.x, height); }).find("known on a motion only"), std::string::npos);
  EXPECT_NE(error_of<SceneError>([&] { it.scene.parameter("p", "m", height); }).find("'p'"), std::string::npos);
  EXPECT_NE(error_of<SceneError>([&] { it.scene.direction("arn", axis::x, "ground"); }).find("arn"), std::string::npos);
  EXPECT_NE(error_of<UnitError>([&] { it.scene.direction("arm", {height, 0, 0}, "ground"); }).find("plain number"),
            std::string::npos);
  // The table turns by what its own motion is measured with.
  EXPECT_NE(error_of<SceneError>([&] { it.scene.drive(it.phi, height / metres("1")); }).find("'phi' itself"),
            std::string::npos);
  Scene scene = it.scene;
  scene.holonomic("late", height + Expression::quantity("1", "s") * speed);
  EXPECT_NE(error_of<SceneError>([&] { validate(scene); }).find("depends on the velocity"), std::string::npos);
}

TEST(MeasuredVectors, DoNotHideReleasedCoordinates) {
  Scene scene("held");
  const Expression theta = scene.coordinate("theta", "rad"), shift = scene.released_coordinate("shift", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, shift);
  const FrameHandle arm = scene.revolute("arm", slide, axis::z, theta);
  scene.body("bob", arm, Inertia::point(kilograms("2")).at({0, metres("-1.5"), 0}));
  const PointHandle tip = scene.point("tip", arm, {0, metres("-1.5"), 0});
  Scene other = scene;
  scene.generalised_force("pull", scene.position(tip, "ground")[0], Expression::quantity("1", "N"));
  EXPECT_NE(error_of<SceneError>([&] { validate(scene); }).find("names the released coordinate 'shift'"), std::string::npos);
  other.generalised_force("pull", other.position(tip, slide)[0],
                          Expression::quantity("1", "N"));  // does not contain it
  EXPECT_EQ(error_of([&] { validate(other); }), "no error");
}

}  // namespace
}  // namespace torsor::measures_test
