// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/turning_slot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::turning_slot_test {
namespace {

using namespace torsor::runtime;
using torsor::Real;
using Slot = turning_slot::Mechanism<double>;
using Vector = StateVector<Slot>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene.
constexpr double m = 2.0, g = 9.81, rounding = 1.1e-16;

// r = r0 cosh wt + g/(2 w²) (sin wt - sinh wt) along the slot, w = 2 rad/s, and its rate.
struct Exact {
  const char *time, *r, *rate;
};
constexpr std::array<Exact, 3> exact{{{"0.5", "0.362303648822593444019563037985", "-1.28411265809897125290888465456"},
                                      {"1", "-1.45131375993559885509267129695", "-6.62052464116745409101965065429"},
                                      {"1.5", "-7.07753972196409710153958909387", "-17.1010227151476613123759667857"}}};

// Written with 30 digits.
TEST(TurningSlot, HasACommittedReferenceThatAgreesWithTheExactMotionTo28Digits) {
  for (const Exact& at : exact) {
    const auto row = examples::reference_digits("turning_slot", at.time);
    ASSERT_EQ(row.size(), 4U);
    Real sine, cosine;
    torsor::sincos(Real(2) * Real::parse(at.time), sine, cosine);
    examples::expect_digits(row[0] * cosine + row[1] * sine, at.r, 1e-28, "r");
    examples::expect_digits(row[1] * cosine - row[0] * sine, "0", 1e-38, "across");
    examples::expect_digits(row[2] * cosine + row[3] * sine, at.rate, 1e-27, "r'");
  }
}

TEST(TurningSlot, MeetsTheExactMotionInDouble) {
  const auto motion = projected(equations_of_motion<Slot>());
  Vector y = motion.initial();
  double t = 0.0;
  for (const Exact& at : exact) {
    const double end = std::stod(at.time);
    y = examples::state_at(motion, y, t, end, precise);
    t = end;
    const auto s = unpack<Slot>(t, y);
    const double cosine = std::cos(2.0 * t), sine = std::sin(2.0 * t);
    // Errors of 1e-13 (1 + |y|), |y| below 20, in some hundred steps; what a motion grows by is exp(2 t), at most 20.
    constexpr double allowed = 1e-13 * 21 * 100 * 20;
    EXPECT_NEAR(s.q.x * cosine + s.q.y * sine, std::stod(at.r), allowed);
    EXPECT_NEAR(s.v.x * cosine + s.v.y * sine, std::stod(at.rate), allowed);
    EXPECT_NEAR(s.q.y * cosine - s.q.x * sine, 0.0, 40 * rounding * 10);
  }
}

// r'' = w² r - g sin wt along the slot, and across it N = m (2 w r' + g cos wt): at any rate, time, place and speed.
TEST(TurningSlot, HasTheAccelerationAndTheForceOfRelativeMotion) {
  for (int i = 0; i < 30; ++i) {
    const double omega = 0.5 + 0.2 * i, t = 0.3 * i, r = 2.0 - 0.17 * i, rate = 0.25 * i - 3.0;
    const double c = std::cos(omega * t), s = std::sin(omega * t);
    Slot::State state{};
    state.time = t;
    state.q = {r * c, r * s};
    state.v = {rate * c - r * omega * s, rate * s + r * omega * c};
    const auto motion = equations_of_motion<Slot>({.omega = omega});
    Slot::Accelerations found{};
    Slot::Multipliers slot{};
    ASSERT_EQ(motion.accelerations(state, found, slot), Evaluation::ok);
    // Thirty roundings of accelerations below 150 m/s², and the angle's of 60 rad.
    constexpr double tolerance = (30 + 60) * 150 * rounding;
    EXPECT_NEAR(found.x * c + found.y * s, -g * s, tolerance);  // r'' - w² r
    EXPECT_NEAR(found.y * c - found.x * s, 2.0 * omega * rate, tolerance);
    EXPECT_NEAR(slot.N, m * (2.0 * omega * rate + g * c), m * tolerance);
  }
}

// Its force is across the slot, and the slot moves there at w r: that is the power which T - U takes up.
TEST(TurningSlot, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Slot>(
      equations_of_motion<Slot>(), 1.5, 1e-12,
      [](const Slot::State& s, const Slot::Accelerations&, const Slot::Multipliers& slot) {
        const double c = std::cos(2.0 * s.time), n = std::sin(2.0 * s.time);
        return slot.N * (s.v.y * c - s.v.x * n);
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 100.0);
}

}  // namespace
}  // namespace torsor::turning_slot_test
