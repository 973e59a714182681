// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes by quaternions over long motions without torques. TORSOR_LONG_TESTS: a million turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "generated/torque_free_body.hpp"
#include "tests/long_tests.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace tumbling_body_test {
namespace {

using namespace torsor::runtime;
using Body = torque_free_body::Mechanism<double>;

TEST(Quaternions, KeepNormAndPhaseThroughTheLockOfEulerAngles) {
  // Free turn about the axis of greatest inertia, which moves the two others through every attitude between: Euler
  // angles about z x z lock twice a revolution when the turn is about x. ω stays, the attitude is
  // (cos ωt/2, sin ωt/2 n).
  const double revolutions = 100, omega = 2 * std::numbers::pi;
  const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  const auto motion = equations_of_motion<Body>(Body::Parameters{3.0, 2.0, 1.0});
  StateVector<Body> y{1, 0, 0, 0, omega, 0, 0};
  const auto result = integrate(motion, y, 0, revolutions, method);
  ASSERT_TRUE(result) << describe(result);
  // After whole revolutions the quaternion is ±1; each step of some a tenth of a turn may lose the tolerance in phase.
  EXPECT_NEAR(std::abs(y[0]), 1.0, 1e-15);
  EXPECT_NEAR(y[1], 0.0, 1e-12 * 20 * revolutions);
  EXPECT_NEAR(y[2], 0.0, 1e-12);
}

/// A body with J = diag(3, 2, 1) kg m², started at one turn a second about an axis between those of greatest and least
/// inertia, near the separatrix: it tumbles. By Jacobi's elliptic functions of λt, k (Landau-Lifshitz, Mechanics, 37),
///   ω = (ω_1 dn, -b sn, ω_3 cn),   λ² = (J1 - J2)(L² - 2 E J3)/(J1 J2 J3),
///   k² = (J2 - J3)(2 E J1 - L²)/((J1 - J2)(L² - 2 E J3)),
/// and the moment of momentum J ω stays in space.
class TumblingBody {
 public:
  static constexpr std::array<double, 3> J{3.0, 2.0, 1.0};

  static std::array<double, 3> angular_velocity() {
    const double part = 2 * std::numbers::pi / std::hypot(1.0, 1.7);
    return {part, 0.0, 1.7 * part};
  }
  static StateVector<Body> start() {
    const auto w = angular_velocity();
    return {1, 0, 0, 0, w[0], w[1], w[2]};
  }
  /// The time in which ω_2 goes from zero to zero, ω_3 changes sign and ω_1 comes back.
  static double half_period() {
    const auto w = angular_velocity();
    double L2 = 0.0, E2 = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      L2 += J[i] * J[i] * w[i] * w[i];
      E2 += J[i] * w[i] * w[i];
    }
    const double rate = std::sqrt((J[0] - J[1]) * (L2 - E2 * J[2]) / (J[0] * J[1] * J[2]));
    const double modulus = std::sqrt((J[1] - J[2]) * (E2 * J[0] - L2) / ((J[0] - J[1]) * (L2 - E2 * J[2])));
    return 2 * std::comp_ellint_1(modulus) / rate;
  }
  /// q J ω q*, in space.
  static std::array<double, 3> moment_of_momentum(const StateVector<Body>& y) {
    const double w = y[0], a = y[1], b = y[2], c = y[3];
    const std::array<double, 3> l{J[0] * y[4], J[1] * y[5], J[2] * y[6]};
    return {(1 - 2 * (b * b + c * c)) * l[0] + 2 * (a * b - w * c) * l[1] + 2 * (a * c + w * b) * l[2],
            2 * (a * b + w * c) * l[0] + (1 - 2 * (a * a + c * c)) * l[1] + 2 * (b * c - w * a) * l[2],
            2 * (a * c - w * b) * l[0] + 2 * (b * c + w * a) * l[1] + (1 - 2 * (a * a + b * b)) * l[2]};
  }
};

/// `local` is what a step may lose of each component, relative to the larger of it and 1.
template <class Method>
void expect_to_tumble(const Method& method, double local) {
  const auto motion = equations_of_motion<Body>(Body::Parameters{3.0, 2.0, 1.0});
  const double half_period = TumblingBody::half_period();
  const int halves = torsor::wanted(40, 2 * static_cast<int>(5e5 / half_period));
  StateVector<Body> y = TumblingBody::start();
  const auto before = TumblingBody::moment_of_momentum(y), velocity = TumblingBody::angular_velocity();
  double norm = 0.0, space = 0.0, least = 1.0;
  const auto result = integrate(motion, y, 0, halves * half_period, method, [&](double, const StateVector<Body>& s) {
    norm = std::max(norm, std::abs(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3] - 1));
    const auto now = TumblingBody::moment_of_momentum(s);
    for (std::size_t i = 0; i < 3; ++i) space = std::max(space, std::abs(now[i] - before[i]));
    least = std::min(least, s[6] / velocity[2]);
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(norm, 4 * 2.3e-16);
  EXPECT_LT(least, -0.9);  // it has turned over
  // Losses of steps add up. Of q, four components of `local`, they turn the moment, of up to 17 kg m²/s, by twice as
  // much; of ω they are `local` times 2π, times J.
  const double steps = static_cast<double>(result.statistics.accepted), lost = steps * local;
  EXPECT_LT(space, lost * (17 * 2 * 2 + 3 * 2 * std::numbers::pi));
  if (torsor::wanted(false, true)) return;  // in phase errors grow with the square of the time
  // ω' is below 60 rad/s²; and a loss in ω, growing with the steps, changes the rate by as great a part.
  const double time = halves * half_period, late = 60 * lost * time;
  EXPECT_NEAR(y[4], velocity[0], late);
  EXPECT_NEAR(y[5], 0.0, late);
  EXPECT_NEAR(y[6], velocity[2], late);
}

TEST(Quaternions, CarryATumblingBodyWhoseMomentStaysInSpace) {
  // A million turns in the long form.
  expect_to_tumble(
      DormandPrince853{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12, .step_limit = 1'000'000'000}, 1e-12);
  expect_to_tumble(Taylor{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13, .step_limit = 1'000'000'000},
                   1e-13);
  // Steps of a twentieth of a turn: order 12 leaves roundings.
  expect_to_tumble(GaussCollocation<6>{.step = 0.05}, 8 * 2.3e-16);
}

}  // namespace
}  // namespace tumbling_body_test
