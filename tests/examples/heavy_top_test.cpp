// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/heavy_top.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "torsor/generator/verification/real_scalar_traits.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/decompositions.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::heavy_top_test {
namespace {

using namespace torsor::runtime;
using torsor::Real;
template <class Scalar>
using Top = heavy_top::Mechanism<Scalar>;
using State = StateVector<Top<double>>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14};
constexpr double spin = 150.0, pi = std::numbers::pi;

// Independent truth: unit quaternions in quadruple precision (energy kept to 1e-26). R(q) is the matrix from the body's
// axes to the ground's.
struct Attitude {
  double time;
  std::array<const char*, 4> q;
  std::array<const char*, 3> centre;
};
constexpr std::array<Attitude, 3> truth{{
    {0.2,
     {"-0.708279152974312562108796855", "0.438781088126581897370189638", "0.545728396145417673414642772",
      "0.0893997528240050104623756681"},
     {"0.605550561377119770136150239", "0.598957681794919157684825780", "-0.523983027430003184780596595"}},
    {1.0,
     {"0.732943980679663718147283556", "-0.278285719337612678518396944", "0.531824611334162617923441777",
      "-0.320176142736249281409048241"},
     {"0.173343964098386042591966115", "0.640088592070568782860591998", "-0.748490791133581309483597679"}},
    {2.0,
     {"0.122947135041533467104251575", "-0.491079892550027014699044678", "0.350430030343620961839020263",
      "-0.787986887550485669324173959"},
     {"-0.150416822745641759810030831", "-0.724165591636895650748554397", "-0.673022269560444096050221047"}},
}};

/// Column by column.
template <class Scalar>
std::array<Scalar, 9> rotation(const Scalar& w, const Scalar& x, const Scalar& y, const Scalar& z) {
  const Scalar one(1), two(2);
  return {one - two * (y * y + z * z), two * (x * y + w * z),       two * (x * z - w * y),
          two * (x * y - w * z),       one - two * (x * x + z * z), two * (y * z + w * x),
          two * (x * z + w * y),       two * (y * z - w * x),       one - two * (x * x + y * y)};
}

template <class Scalar>
typename Top<Scalar>::Kinematics kinematics(const typename Top<Scalar>::State& state) {
  typename Top<Scalar>::Kinematics result{};
  Top<Scalar>::kinematics(Top<Scalar>::precompute({}), state, result);
  return result;
}

/// Angular velocity along an axis of the body.
template <class Scalar>
Scalar body_rate(const typename Top<Scalar>::Kinematics& at, std::size_t axis) {
  const auto& R = at.top_rotation;
  const auto& omega = at.top_angular_velocity;
  return R[3 * axis] * omega[0] + R[3 * axis + 1] * omega[1] + R[3 * axis + 2] * omega[2];
}

// The truth is written with 27 digits, the angles with 40: some ten units of the former's last digit.
TEST(HeavyTop, HasACommittedReferenceThatAgreesWithQuaternionsTo25Digits) {
  const auto row = examples::reference_digits("heavy_top", "0.2");
  ASSERT_EQ(row.size(), 6U);
  Top<Real>::State state{};
  for (int i = 0; i < 3; ++i) {
    state.q[i] = row[static_cast<std::size_t>(i)];
    state.v[i] = row[static_cast<std::size_t>(i + 3)];
  }
  const auto at = kinematics<Real>(state);
  const auto& [time, q, centre] = truth[0];
  const auto expected = rotation(Real::parse(q[0]), Real::parse(q[1]), Real::parse(q[2]), Real::parse(q[3]));
  for (std::size_t i = 0; i < 9; ++i) EXPECT_LE(examples::distance(at.top_rotation[i], expected[i]), 1e-26) << i;
  for (std::size_t i = 0; i < 3; ++i) examples::expect_digits(at.top_position[i], centre[i], 1e-26, "centre");
  examples::expect_digits(body_rate<Real>(at, 0), "-2.69159091214340862135129869", 5e-26, "w_x");
  examples::expect_digits(body_rate<Real>(at, 1), "150", 1e-36, "w_y");
  examples::expect_digits(body_rate<Real>(at, 2), "4.91726098989399441714576226", 5e-26, "w_z");
}

// 1e-13 of rounding and truncation grow with the motion. The spin turns through 300 rad in 3,500 steps; an angle of that
// size would be rounded to 3e-14 at each, so it is kept within a turn, and the rates' 150 rad/s are known to 3e-14 after
// each step: hence 1e-12 of them.
TEST(HeavyTop, MeetsTheQuaternionsInDouble) {
  const auto motion = equations_of_motion<Top<double>>();
  const auto within = angles_within_a_turn(motion, std::array<std::size_t, 1>{2});
  State y = motion.initial();
  double t = 0.0;
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (const Attitude& at : truth) {
    y = examples::state_at(within, y, t, at.time, precise);
    t = at.time;
    const auto number = [](const char* text) { return Real::parse(text).to_double(); };
    const auto found = kinematics<double>(unpack<Top<double>>(t, y));
    const double allowed = 1e-13 * growth.until(t);
    const auto expected = rotation(number(at.q[0]), number(at.q[1]), number(at.q[2]), number(at.q[3]));
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(found.top_rotation[i], expected[i], allowed) << i << " at " << t;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.top_position[i], number(at.centre[i]), allowed);
    EXPECT_NEAR(body_rate<double>(found, 1), spin, 1e-12 * spin);
  }
}

// Analytic: the axis passes within 7.2e-7 rad of straight down and comes back to the horizontal; the inclination has
// the period 0.74520694761675... s, so that the axis begins each horizontal at rest again.
TEST(HeavyTop, ComesBackToTheHorizontalAfterAPeriodAndNeverNearsItsSingularAttitude) {
  const auto motion = equations_of_motion<Top<double>>();
  State y = motion.initial();
  constexpr double period = 0.7452069476167690557273115;
  double lowest = 0.0, steepest = 0.0;
  for (int i = 0; i < 2; ++i) {
    const auto result = integrate(motion, y, i * period, (i + 1) * period, precise, [&](double t, const State& now) {
      const auto at = kinematics<double>(unpack<Top<double>>(t, now));
      lowest = std::fmin(lowest, at.top_position[2]);
      steepest = std::fmax(steepest, std::abs(std::sin(now[1])));
    });
    ASSERT_TRUE(result) << describe(result);
    // The height is stationary there: an error of 1e-11 s or rad shows with its square.
    EXPECT_NEAR(kinematics<double>(unpack<Top<double>>(0.0, y)).top_position[2], 0.0, 1e-11);
  }
  EXPECT_LT(lowest, -0.99999);
  EXPECT_LT(steepest, 0.9);  // |x1 . y3|, 1 where the angles are singular
}

// A sleeping top is stable above 2 sqrt(A' m g l) / C = 202.0138609105820738508741 rad/s, A' about the fixed point.
// Just below, the unstable root is C/(2A') sqrt(202.0139² - spin²) = 0.036 1/s at 202.00; above, roots have real part
// zero, computed to sqrt(rounding times their size squared) near the double root, some 1e-6.
TEST(HeavyTop, SleepsUprightAboveItsCriticalSpin) {
  const auto growth = [](double spin_rate) {
    Top<double>::State upright{};
    upright.q = {pi / 2.0, pi / 6.0, 0.0};  // y3 along z0 in the slanted axes
    upright.v.gamma = spin_rate;
    EXPECT_NEAR(kinematics<double>(upright).top_position[2], 1.0, 1e-15);
    Top<double>::Linearisation linear{};
    EXPECT_EQ(Top<double>::linearisation(Top<double>::precompute({}), upright, {}, {}, {}, linear), torsor::Status::ok);
    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> A(linear.A.data());
    // gamma is cyclic: without its row and column, and without its rate's, which stays as it is.
    Eigen::Matrix4d reduced;
    constexpr std::array<int, 4> kept{0, 1, 3, 4};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        reduced(i, j) = A(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
    }
    return torsor::runtime::eigenpairs(reduced).values.real().maxCoeff();
  };
  constexpr double critical = 202.0138609105820738508741;
  for (const double below : {150.0, 201.0, 202.0}) {
    EXPECT_NEAR(growth(below), 0.46875 / (2.0 * 15.234375) * std::sqrt(critical * critical - below * below), 1e-6);
  }
  for (const double above : {202.03, 203.0, 300.0}) EXPECT_LT(growth(above), 1e-6) << above;
}

// Where the axis lies along x1 alpha and gamma turn about one line and M has no inverse. Passing that at a distance, or
// starting near it and going through: right to what the tolerance allows, forwards and back, or a status that says so.
TEST(HeavyTop, PassesTheLockOfItsAnglesRightlyOrSaysThatItCannot) {
  const auto motion = equations_of_motion<Top<double>>();
  const DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10, .step_limit = 4'000};
  const auto integrals = [&](const State& y) {
    Top<double>::FirstIntegrals result{};
    Top<double>::first_integrals(motion.precomputed(), unpack<Top<double>>(0.0, y), result);
    return result;
  };
  int passed = 0, refused = 0;
  for (const double aside : {0.5, 5e-2, 5e-3, 0.0}) {  // rate about x1 while beta runs to the lock
    for (const double distance : {0.2, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 0.0}) {
      const State start{0.4, pi / 2.0 - distance, 0.0, aside, 2.0, 0.5};
      const auto before = integrals(start);
      State y = start;
      double terms = 0.0, fastest = 0.0;
      const auto result = integrate(motion, y, 0.0, 0.4, method, [&](double, const State& now) {
        for (std::size_t i = 3; i < 6; ++i) fastest = std::fmax(fastest, std::abs(now[i]));
        // Of T, moments of 15.2 across the axis, about O, and 0.47 along it, which may cancel near the lock.
        const double across = 8.0 * (now[3] * now[3] + now[4] * now[4]);
        terms = std::fmax(terms, across + 0.24 * std::pow(std::abs(now[3]) + std::abs(now[5]), 2));
      });
      EXPECT_TRUE(std::isfinite(y[0] + y[1] + y[2] + y[3] + y[4] + y[5]));
      if (!result) {
        ++refused;
        EXPECT_LE(distance, 1e-3) << aside;
        continue;
      }
      ++passed;
      // Each step may change a rate by 1e-10 (1 + rate).
      const double local = 1e-10 * static_cast<double>(result.statistics.accepted);
      const auto after = integrals(y);
      EXPECT_NEAR(after.energy, before.energy, 2.0 * local * (terms + 15.0)) << aside << " " << distance;
      EXPECT_NEAR(after.momentum_gamma, before.momentum_gamma, local * 0.47 * 2.0 * (fastest + 1.0));
      ASSERT_TRUE(integrate(motion, y, 0.4, 0.0, method)) << aside << " " << distance;
      // Errors grow with the rates on the way back to the lock.
      const double allowed = 2.0 * local * (fastest + 1.0) * (fastest + 1.0);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(y[i], start[i], allowed) << aside << " " << distance;
    }
  }
  EXPECT_GT(passed, 4);
  EXPECT_GT(refused, 4);
}

TEST(HeavyTop, ObeysTheEnergyTheorem) {
  const auto motion = equations_of_motion<Top<double>>();
  Top<double>::Energy energy{};
  Top<double>::energy(motion.precomputed(), Top<double>::initial_state(), {}, energy);
  EXPECT_NEAR(energy.kinetic - energy.force_function, 5435.69679086554688, 10 * 1.1e-16 * 5436);
  const auto balance = examples::energy_balance<Top<double>>(motion, 2.0, 1e-13);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-4);
  EXPECT_GT(balance.exchanged, 100.0);
}

}  // namespace
}  // namespace torsor::heavy_top_test
