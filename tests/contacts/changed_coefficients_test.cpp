// SPDX-License-Identifier: GPL-3.0-or-later
// Masses, forces and laws of contact that change between two pieces of a motion.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tests/contacts/told_motion.hpp"

namespace changed_coefficients_test {
namespace {

using namespace told_motion;

/// A block over a floor, z upward, pulled along it: q = (x, z).
struct Block {
  static constexpr std::size_t nq = 2, nv = 2, contacts = 1;
  double m = 1, F = 10, f = 0.3, e = 0.5;
  int tangents = 1;
  [[nodiscard]] ContactRule rule(int) const { return {.tangents = tangents, .friction = f, .restitution = e}; }
  [[nodiscard]] Evaluation read(double, const std::array<double, 4>& y, ContactReading& r) const {
    r.M.setIdentity();
    r.M *= m;
    r.F << F, -m * g;
    r.gap[0] = y[1];
    r.J << 0, 1, 1, 0;
    r.w << y[3], y[2];
    r.drift.setZero();
    return Evaluation::ok;
  }
  void coordinate_rates(double, const std::array<double, 4>& y, std::array<double, 2>& rates) const { rates = {y[2], y[3]}; }
};

/// Its motion, whose block may be changed.
struct Moved {
  Block block{};
  const ContactMechanismOf<Block> mechanism{block};
  std::array<double, 4> y{};
  IgnoreSteps none{};
  ContactRun<4, 1, DormandPrince853, IgnoreSteps> run{mechanism, y, precise, {}, none};
};

// The acceleration of a piece is F/m - f g from its first evaluation on: before, the first one of a step was that of the piece before,
// and a speed was off by 1e-10. Two pieces of about ten steps leave ten roundings.
TEST(ChangedCoefficients, OfMassForceAndFrictionActFromTheStartOfAPiece) {
  for (const double sign : {1.0, -1.0}) {
    Moved moved{.block = {.F = sign * 10}};
    double speed = 0, end = 0;
    ASSERT_TRUE(moved.run.start(0));
    const auto expect = [&] {
      ASSERT_TRUE(moved.run.advance(end += 1)) << describe(moved.run.result().status);
      speed += std::abs(moved.block.F) / moved.block.m - moved.block.f * g;
      EXPECT_NEAR(moved.y[2], sign * speed, 2e-14 * (1 + speed)) << end;
    };
    expect();
    moved.block.m = 2;
    expect();
    moved.block.F = sign * 2;
    expect();
    moved.block.f = 0.5;
    expect();
    moved.block.f = 0;
    expect();
    moved.block.f = 0.1;
    expect();
  }
}

// What slid without friction has a direction from the rule on that rubs.
TEST(ChangedCoefficients, OfFrictionActAgainstASlipThatHadNone) {
  Moved moved{.block = {.F = 0, .f = 0}};
  moved.y = {0, 0, -3, 0};
  ASSERT_TRUE(moved.run.start(0) && moved.run.advance(1));
  moved.block.F = 10;  // it turns round in the piece before
  ASSERT_TRUE(moved.run.advance(2));
  moved.block.f = 0.1;
  ASSERT_TRUE(moved.run.advance(3));
  EXPECT_NEAR(moved.y[2], 17 - 0.1 * g, 1e-13);
}

TEST(ChangedCoefficients, OfFrictionLetABlockGoAndHoldIt) {
  Moved moved{.block = {.F = 2}};
  ASSERT_TRUE(moved.run.start(0) && moved.run.advance(1));
  EXPECT_EQ(moved.y[2], 0);
  moved.block.f = 0.1;
  ASSERT_TRUE(moved.run.advance(2));
  EXPECT_NEAR(moved.y[2], 2 - 0.1 * g, 1e-14);
  moved.block.f = 0.5;  // it stops within 0.35 s
  ASSERT_TRUE(moved.run.advance(3));
  EXPECT_EQ(moved.y[2], 0);
  moved.block.f = 0;  // nothing holds it
  ASSERT_TRUE(moved.run.advance(4));
  EXPECT_NEAR(moved.y[2], 2, 1e-14);
}

TEST(ChangedCoefficients, OfRestitutionAreThoseOfTheNextImpact) {
  Moved moved{.block = {.F = 0, .f = 0}};
  moved.y = {0, 1, 0, 0};
  ASSERT_TRUE(moved.run.start(0) && moved.run.advance(0.5));
  const double falls = std::sqrt(2 / g), speed = g * falls, second = falls + speed / g;
  moved.block.e = 0.9;
  ASSERT_TRUE(moved.run.advance(1));
  const double since = 1 - second;
  EXPECT_NEAR(moved.y[1], 0.45 * speed * since - g * since * since / 2, 1e-13);
}

TEST(ChangedCoefficients, ThatCannotBeEndTheMotion) {
  const auto ends = [](const auto& change) {
    Moved moved;
    ASSERT_TRUE(moved.run.start(0) && moved.run.advance(1));
    change(moved.block);
    EXPECT_FALSE(moved.run.advance(2));
    EXPECT_EQ(moved.run.result().status, ContactStatus::invalid_rule);
    EXPECT_EQ(moved.run.result().time, 1);
  };
  ends([](Block& block) { block.f = -1; });
  ends([](Block& block) { block.e = std::numeric_limits<double>::quiet_NaN(); });
  ends([](Block& block) { block.tangents = 2; });
}

}  // namespace
}  // namespace changed_coefficients_test
