// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/dynamics/all_checks.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::friction_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

// Values of fifty digits: an identity holds to 1e-45.
constexpr double exact = 1e-45;

Expression gravity() { return Expression::quantity("9.81", "m/s^2"); }
const Real g = Real(Number::rational(981, 100), 50);

/// A block on a smooth or rough plane, gravity along -z and along x as on a slope of 3 in 5.
struct BlockOnASlope : Block {
  BlockOnASlope() {
    scene.gravity({gravity() * 3 / 5, 0, -gravity() * 4 / 5});
    name_the_normal_force();
  }
};

TEST(SlidingFriction, IsFTimesTheNormalForceAgainstTheSlipWhateverItsSpeed) {
  // T = −f N G/|G|: without the division a faster block would be braked more.
  BlockOnASlope it;
  it.slide(0.25_r, {rate(it.x), rate(it.y), 0});
  const Equations equations(it.scene);
  const Real normal = Real(2) * g * rational(4, 5);
  for (const long speed : {1L, 7L}) {
    NamedState here(equations, {{"x'", Real(3 * speed)}, {"y'", Real(-4 * speed)}});
    const ForwardSolution& forward = equations.forward();
    EXPECT_LT(relative_difference(here(forward.multipliers[0]), normal), exact);  // N = n21 · R(2 → 1) ≥ 0
    EXPECT_LT(relative_difference(here(forward.accelerations[0]),
                                  g * rational(3, 5) - rational(1, 4) * normal / Real(2) * rational(3, 5)),
              exact);
    EXPECT_LT(relative_difference(here(forward.accelerations[1]), rational(1, 4) * normal / Real(2) * rational(4, 5)),
              exact);
    EXPECT_LT(relative_difference(here(equations.power()), -rational(1, 4) * normal * Real(5 * speed)), exact);
  }
  expect_all_checks(it.scene);
}

TEST(SlidingFriction, DampsWhatIsAcrossTheSlipWhenLinearised) {
  // −∂T_x/∂x' = f N y'²/|G|³ and −∂T_x/∂y' = −f N x' y'/|G|³ for T = −f N G/|G|.
  BlockOnASlope it;
  it.slide(0.25_r, {rate(it.x), rate(it.y), 0});
  const Equations equations(it.scene);
  const Linearisation linear = linearisation(equations);
  NamedState here(equations, {{"x'", Real(3)}, {"y'", Real(-4)}, {"N", Real(7)}});
  EXPECT_LT(relative_difference(here(linear.C[0][0]), rational(7, 4) * rational(16, 125)), exact);
  EXPECT_LT(relative_difference(here(linear.C[0][1]), rational(7, 4) * rational(12, 125)), exact);
}

TEST(SlidingFriction, OfAKnownDirectionTakesADirectionOfAnyLength) {
  for (const bool doubled : {false, true}) {
    BlockOnASlope it;
    const Triple direction{doubled ? 2 : 1, 0, 0};
    it.slide(0.5_r, direction);
    const Equations equations(it.scene);
    NamedState here(equations, {{"x'", Real(3)}});
    EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), g * rational(1, 5)), exact);
    EXPECT_TRUE(here(equations.forward().accelerations[1]).is_zero());
  }
}

TEST(SlidingFriction, FailsTheConditionsOfPainleveByName) {
  BlockOnASlope it;
  it.slide(0.25_r, axis::x);
  const PainleveReport report = painleve(Equations(it.scene));
  EXPECT_EQ(report.failing_conditions, std::vector<std::string>{"'slide' has no force function"});
  ASSERT_EQ(report.first_integrals.size(), 1U);  // nothing acts across
  EXPECT_EQ(report.first_integrals[0].name, "momentum_y");
}

/// A ladder of 3 kg and 4 m between a rough floor and a rough wall, its foot slipping away: N1, N2 and the motion by
/// Newton and Euler for the isolated ladder.
TEST(SlidingFriction, OnTwoContactsGivesTheMotionOfNewtonAndEuler) {
  Scene scene("ladder");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression theta = scene.coordinate("theta", "rad");  // from the floor, the foot away from the wall
  const FrameHandle center =
      scene.prismatic("center", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y);
  const FrameHandle ladder = scene.revolute("ladder", center, -axis::z, theta);
  scene.body("ladder", ladder, Inertia::rod(kilograms("3"), metres("4"), 0));
  scene.gravity({0, -gravity(), 0});
  const PointHandle foot = scene.point("foot", ladder, {metres("2"), 0, 0});
  const PointHandle top = scene.point("top", ladder, {metres("-2"), 0, 0});
  const ConstraintHandle floor = scene.holonomic("floor", y - metres("2") * sin(theta));
  const ConstraintHandle wall = scene.holonomic("wall", x - metres("2") * cos(theta));
  scene.reaction(floor, "N1", {.body = ladder, .contact = foot, .direction = axis::y, .axes = scene.ground()});
  scene.reaction(wall, "N2", {.body = ladder, .contact = top, .direction = axis::x, .axes = scene.ground()});
  scene.sliding_friction(
      "on_floor", floor,
      {.coefficient = 0.3_r, .body = ladder, .point = foot, .direction = axis::x, .axes = scene.ground()});
  scene.sliding_friction(
      "on_wall", wall,
      {.coefficient = 0.2_r, .body = ladder, .point = top, .direction = -axis::y, .axes = scene.ground()});
  const Equations equations(scene);
  const Real angle = rational(4, 5);
  const Real turning = rational(-2, 3);  // the foot slips out: θ decreases
  const Real s = sin(angle);
  const Real c = cos(angle);
  NamedState here(equations, {{"x", Real(2) * c},
                              {"y", Real(2) * s},
                              {"theta", angle},
                              {"x'", Real(-2) * s * turning},
                              {"y'", Real(2) * c * turning},
                              {"theta'", turning}});
  // Unknowns ẍ, ÿ, θ̈, N1, N2. Forces: floor (−f1 N1, N1) at (2c, −2s), wall (N2, f2 N2) at (−2c, 2s), from G. The
  // ladder turns clockwise by θ, so that J θ̈ is minus the moment about z.
  const Real f1 = rational(3, 10);
  const Real f2 = rational(1, 5);
  const Real inertia = Real(3) * Real(16) / Real(12);
  const Real moment1 = Real(2) * c + Real(2) * s * -f1;    // x F_y − y F_x for N1 = 1
  const Real moment2 = -(Real(2) * c) * f2 - Real(2) * s;  // for N2 = 1
  const Real w = turning * turning;
  std::vector<Real> matrix(25, Real(0));
  const auto entry = [&matrix](int row, int column) -> Real& {
    return matrix[static_cast<std::size_t>(row + 5 * column)];
  };
  std::vector<Real> right(5, Real(0));
  entry(0, 0) = Real(3);
  entry(0, 3) = f1;
  entry(0, 4) = Real(-1);
  entry(1, 1) = Real(3);
  entry(1, 3) = Real(-1);
  entry(1, 4) = -f2;
  right[1] = Real(-3) * g;
  entry(2, 2) = inertia;
  entry(2, 3) = moment1;
  entry(2, 4) = moment2;
  entry(3, 1) = Real(1);  // ÿ = 2 c θ̈ − 2 s θ̇²
  entry(3, 2) = Real(-2) * c;
  right[3] = Real(-2) * s * w;
  entry(4, 0) = Real(1);  // ẍ = −2 s θ̈ − 2 c θ̇²
  entry(4, 2) = Real(2) * s;
  right[4] = Real(-2) * c * w;
  const std::vector<Real> expected = solve_dense(matrix, right);
  const ForwardSolution& forward = equations.forward();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(relative_difference(here(forward.accelerations[i]), expected[i]), 1e-44) << i;
  }
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_LT(relative_difference(here(forward.multipliers[j]), expected[3 + j]), 1e-44) << j;
    EXPECT_GT(expected[3 + j], Real(0));
  }
  // Power of friction: −f1 N1 V(foot) − f2 N2 V(top), both slips forwards.
  const Real power = -f1 * expected[3] * (Real(-4) * s * turning) - f2 * expected[4] * (Real(-4) * c * turning);
  EXPECT_LT(relative_difference(here(equations.power()), power), 1e-44);
  scene.initial(x, metres("2"));
  expect_all_checks(scene);
}

TEST(SlidingFriction, BetweenTwoBodiesLeavesTheirMomentum) {
  // A block slides on a plank that slides on a smooth floor; s is the block's place on the plank.
  Scene scene("block_on_plank");
  const Expression x = scene.coordinate("x", "m");
  const Expression s = scene.coordinate("s", "m");
  const Expression h = scene.coordinate("h", "m");
  const FrameHandle plank = scene.prismatic("plank", scene.ground(), axis::x, x);
  const FrameHandle block = scene.prismatic("block", scene.prismatic("on_plank", plank, axis::x, s), axis::z, h);
  scene.body("plank", plank, Inertia::point(kilograms("5")));
  scene.body("block", block, Inertia::point(kilograms("2")));
  scene.gravity({0, 0, -gravity()});
  scene.point("I", block, {0, 0, 0});
  const ConstraintHandle contact = scene.holonomic("contact", h);
  scene.reaction(contact, "N",
                 {.body = block, .contact = scene.point("I"), .direction = axis::z, .axes = plank, .other = plank});
  scene.sliding_friction("rub", contact,
                         {.coefficient = 0.4_r,
                          .body = block,
                          .point = scene.point("I"),
                          .direction = axis::x,
                          .axes = plank,
                          .other = plank});
  const Equations equations(scene);
  NamedState here(equations, {{"x'", Real(1)}, {"s'", Real(3)}});
  // Block: 2 (ẍ + s̈) = −0.4 · 2 g; plank: 5 ẍ = +0.4 · 2 g.
  const Real plank_acceleration = rational(4, 25) * g;
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), plank_acceleration), exact);
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[1]), -rational(2, 5) * g - plank_acceleration),
            exact);
  EXPECT_LT(relative_difference(here(equations.power()), -rational(2, 5) * Real(2) * g * Real(3)), exact);
  EXPECT_TRUE(identically_zero(equations.constraints()[0].column[0]));
  const PainleveReport report = painleve(equations);
  ASSERT_EQ(report.first_integrals.size(), 1U);
  EXPECT_EQ(report.first_integrals[0].name, "momentum_x");
  expect_all_checks(scene);
}

TEST(RollingResistance, SlowsARollingDiskByItsLengthTimesTheNormalForce) {
  Scene scene("rolling_disk");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  const FrameHandle center =
      scene.prismatic("center", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y);
  const FrameHandle disk = scene.revolute("disk", center, -axis::z, phi);
  scene.body("disk", disk, Inertia::disk(kilograms("4"), metres("0.5"), 2));
  scene.gravity({0, -gravity(), 0});
  const PointHandle contact = scene.point("I", center, {0, metres("-0.5"), 0});
  const ConstraintHandle floor = scene.holonomic("floor", y);
  scene.reaction(floor, "N", {.body = disk, .contact = contact, .direction = axis::y, .axes = scene.ground()});
  scene.no_slip("rolling", {.body = disk, .contact = contact, .direction = axis::x, .axes = scene.ground()});
  scene.rolling_resistance("resistance", floor,
                           {.length = metres("0.01"), .body = disk, .direction = -axis::z, .axes = scene.ground()});
  const Equations equations(scene);
  NamedState here(equations, {{"x'", Real(1)}, {"phi'", Real(2)}});
  // (m + J/R²) ẍ = −h N/R with N = m g: ẍ = −(2/3) (h/R) g.
  const Real expected = -rational(2, 3) * rational(1, 50) * g;
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), expected), exact);
  EXPECT_LT(relative_difference(here(equations.power()), -rational(1, 100) * Real(4) * g * Real(2)), exact);
  expect_all_checks(scene);
}

TEST(SpinningResistance, SlowsASpinningDiskByItsLengthTimesTheNormalForce) {
  Scene scene("spinning_disk");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const FrameHandle disk = scene.revolute("disk", scene.prismatic("lift", scene.ground(), axis::z, z), axis::z, psi);
  scene.body("disk", disk, Inertia::disk(kilograms("4"), metres("0.5"), 2));
  scene.gravity({0, 0, -gravity()});
  scene.point("I", disk, {0, 0, 0});
  const ConstraintHandle floor = scene.holonomic("floor", z);
  scene.reaction(floor, "N", {.body = disk, .contact = scene.point("I"), .direction = axis::z, .axes = scene.ground()});
  // Spinning backwards: sign(P12) n = −z.
  scene.spinning_resistance("resistance", floor,
                            {.length = metres("0.02"), .body = disk, .direction = -axis::z, .axes = scene.ground()});
  const Equations equations(scene);
  NamedState here(equations, {{"psi'", Real(-6)}});
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[1]),
                                rational(1, 50) * Real(4) * g / (Real(4) * rational(1, 8))),
            exact);
  EXPECT_LT(here(equations.power()), Real(0));
}

TEST(SlidingFriction, ReportsPainlevesParadoxByAPivotThatIsNotPositive) {
  // A rod of length 2 l slides on its foot, at θ from the floor: A M⁻¹ B = (1 + 3 cosθ (cosθ − f sinθ))/m.
  Scene scene("sliding_rod");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression f = scene.parameter("f", "1");
  const FrameHandle center =
      scene.prismatic("center", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y);
  const FrameHandle rod = scene.revolute("rod", center, axis::z, theta);
  scene.body("rod", rod, Inertia::rod(kilograms("3"), metres("2"), 0));
  scene.gravity({0, -gravity(), 0});
  scene.point("foot", rod, {metres("-1"), 0, 0});
  const ConstraintHandle floor = scene.holonomic("floor", y - metres("1") * sin(theta));
  scene.reaction(floor, "N",
                 {.body = rod, .contact = scene.point("foot"), .direction = axis::y, .axes = scene.ground()});
  scene.sliding_friction(
      "rub", floor,
      {.coefficient = f, .body = rod, .point = scene.point("foot"), .direction = axis::x, .axes = scene.ground()});
  const Equations equations(scene);
  const auto pivot = [&](const Real& friction, const Real& angle) {
    NamedState here(equations, {{"theta", angle}, {"y", sin(angle)}, {"f", friction}});
    const Real c = cos(angle);
    const Real s = sin(angle);
    const Real value = here(equations.forward().pivots.back().pivot);
    EXPECT_LT(relative_difference(value, (Real(1) + Real(3) * c * (c + friction * s)) / Real(3)), exact);
    return value;
  };
  EXPECT_GT(pivot(Real(2), Real(1)), Real(0));                         // dragged behind
  EXPECT_LT(pivot(Real(2), rational(-11, 10) + Real::pi()), Real(0));  // pushed before it: jams for f > 4/3
}

TEST(Friction, RefusesWhatIsNoContact) {
  const auto refusal = [](const auto& add) {
    BlockOnASlope it;
    return error_of([&] {
      add(it);
      Equations(it.scene).constraints();
    });
  };
  EXPECT_EQ(refusal([](Block& it) {
              const ConstraintHandle angle = it.scene.holonomic("angle", it.z / metres("1"));
              it.scene.sliding_friction("rub", angle,
                                        {.coefficient = 0.1_r,
                                         .body = it.block,
                                         .point = it.contact,
                                         .direction = axis::x,
                                         .axes = it.scene.ground()});
            }),
            "friction 'rub' needs the normal force of its contact, and the multiplier of constraint 'angle' is in "
            "kg m^2 s^-2: write the constraint as a distance [m], or as a velocity along the normal");
  EXPECT_EQ(refusal([](Block& it) {
              it.scene.sliding_friction("rub", it.floor,
                                        {.coefficient = 0.1_r,
                                         .body = it.block,
                                         .point = it.contact,
                                         .direction = {0, 0, 0},
                                         .axes = it.scene.ground()});
            }),
            "the direction of friction 'rub' is the null vector: give the direction of the relative motion");
  EXPECT_EQ(
      refusal([](Block& it) {
        it.scene.rolling_resistance(
            "rub", it.floor,
            {.length = metres("0.1"), .body = it.block, .direction = axis::x, .axes = it.block, .other = it.block});
      }),
      "friction 'rub' acts between two frames of one rigid body: nothing slips there");
  EXPECT_EQ(refusal([](Block& it) {
              it.scene.sliding_friction("rub", it.floor,
                                        {.coefficient = metres("0.1"),
                                         .body = it.block,
                                         .point = it.contact,
                                         .direction = axis::x,
                                         .axes = it.block});
            }),
            "the coefficient of the friction 'rub' is 1/10 [m] and must be in plain numbers");
  EXPECT_EQ(
      refusal([](Block& it) {
        it.scene.sliding_friction(
            "rub", ConstraintHandle{7},
            {.coefficient = 0.1_r, .body = it.block, .point = it.contact, .direction = axis::x, .axes = it.block});
      }),
      "friction 'rub' is tied to constraint number 7, which belongs to another scene");
}

}  // namespace
}  // namespace torsor::friction_test
