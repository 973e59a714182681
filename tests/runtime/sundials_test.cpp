// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/sundials/sundials.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "generated/flyball_governor.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace sundials_test {
namespace {

using namespace torsor::runtime;
using Governor = flyball_governor::Mechanism<double>;

template <class Method>
Method with_tolerance(double tolerance) {
  Method method;
  method.relative_tolerance = method.absolute_tolerance = tolerance;
  return method;
}
Cvode adams(double tolerance) {
  Cvode method = with_tolerance<Cvode>(tolerance);
  method.multistep = Cvode::Multistep::adams;
  return method;
}

// Pendulum from 2 rad at t = 10 (Jacobi's elliptic functions); the flow amplifies by some 60.
template <class Method>
void expect_pendulum(const Method& method, double allowed) {
  std::array<double, 2> y{2.0, 0.0};
  int seen = 0;
  double last = 0.0;
  const auto watch = [&](double t, const std::array<double, 2>&) {
    ++seen;
    last = t;
  };
  const auto result = integrate(equations_of_motion<mechanisms::Pendulum<double>>(), y, 0, 10, method, watch);
  ASSERT_TRUE(result) << describe(result);
  EXPECT_EQ(result.time, 10.0);
  EXPECT_EQ(last, 10.0);
  EXPECT_EQ(seen, result.statistics.accepted + 1);
  EXPECT_GT(result.statistics.calls, result.statistics.accepted);
  EXPECT_NEAR(y[0], 0.015728632141428118626277592909, allowed);
  EXPECT_NEAR(y[1], 5.27089879322982860518148735035, allowed);
}

// SUNDIALS controls the error of each step: a thousand of them add up, amplified by 60 at most.
TEST(Sundials, MeetsEllipticFunctionsWithEachIntegrator) {
  expect_pendulum(adams(1e-11), 1e-11 * 1000 * 60);
  expect_pendulum(with_tolerance<Cvode>(1e-11), 1e-11 * 4000 * 60);
  expect_pendulum(with_tolerance<ArkodeExplicit>(1e-11), 1e-11 * 1000 * 60);
  expect_pendulum(with_tolerance<ArkodeImplicit>(1e-11), 1e-11 * 1000 * 60);
}

// The pendulum from 2 rad at rest passes the vertical after a quarter of its period, K(sin 1)/√g, at √(2 g (1 - cos
// 2)).
template <class Method>
void expect_event(const Method& method, double allowed) {
  std::array<double, 2> y{2.0, 0.0};
  int told = 0;
  const auto vertical = stop_at([](double, const std::array<double, 2>& s) { return s[0]; });
  const auto result = integrate_with_events(equations_of_motion<mechanisms::Pendulum<double>>(), y, 0, 10, method,
                                            Events(vertical), [&](const auto&) { ++told; });
  ASSERT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  EXPECT_EQ(told, 1);
  EXPECT_NEAR(result.time, std::comp_ellint_1(std::sin(1.0)) / std::sqrt(9.81), allowed);
  EXPECT_NEAR(y[0], 0.0, allowed);  // a step up to there is solved anew for each time tried, as well as the tolerance
  EXPECT_NEAR(y[1], -std::sqrt(2 * 9.81 * (1 - std::cos(2.0))), 10 * allowed);
}
TEST(Sundials, LocatesEventsOnStepsOfEachIntegrator) {
  // Some hundred steps within the tolerance; a speed of 5 changes by up to 10 a second.
  expect_event(adams(1e-8), 1e-8 * 300);
  expect_event(with_tolerance<Cvode>(1e-8), 1e-8 * 1000);
  expect_event(with_tolerance<ArkodeExplicit>(1e-8), 1e-8 * 300);
  expect_event(with_tolerance<ArkodeImplicit>(1e-8), 1e-8 * 300);
}

// Governor at t = 1 in quadruple precision: psi, s, two beta, spin, s', two beta'.
constexpr std::array<double, 8> governor_at_1{5.58634696586900543,     5.01420922379567650e-01, 5.21833301625546231e-01,
                                              5.21833301625546231e-01, 6.27112574187655479,     -1.2215149289772891e-01,
                                              1.40885579479526918e-01, 1.40885579479526918e-01};
template <class Method>
Statistics expect_governor(const Method& method, double allowed) {
  const auto motion = equations_of_motion<Governor>();
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, method);
  EXPECT_TRUE(result) << describe(result);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(y[i], governor_at_1[i], allowed) << i;
  return result.statistics;
}

TEST(Sundials, TakesTheGeneratedJacobianOfAStiffMechanism) {
  const Statistics statistics = expect_governor(with_tolerance<Cvode>(1e-9), 1e-6);
  EXPECT_GT(statistics.jacobians, 0);
  EXPECT_GE(statistics.decompositions, statistics.jacobians);
  // By explicit steps, limited to 3 / 2e4 s by stability, 1 s would cost 4e4 calls.
  EXPECT_LT(statistics.calls, 5000);
  expect_governor(with_tolerance<ArkodeImplicit>(1e-9), 1e-6);
}

TEST(Sundials, SolvesTheImplicitFormOfAStiffMechanism) { expect_governor(with_tolerance<Ida>(1e-9), 1e-6); }

/// The governor whose residual's Jacobian must be found by differences.
struct GovernorByDifferences : Governor {
  static void residual_jacobian() = delete;
};
static_assert(HasResidualJacobian<Governor> && !HasResidualJacobian<GovernorByDifferences>);
TEST(Sundials, TakesTheGeneratedJacobianOfTheImplicitForm) {
  const Statistics given = expect_governor(with_tolerance<Ida>(1e-9), 1e-6);
  const auto motion = equations_of_motion<GovernorByDifferences>();
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, with_tolerance<Ida>(1e-9));
  ASSERT_TRUE(result) << describe(result);
  const Statistics& differences = result.statistics;
  EXPECT_GT(given.jacobians, 0);
  // Differences cost a call for each of eight unknowns; half of that is left for steps that differ.
  EXPECT_LT(given.calls, differences.calls - 4 * differences.jacobians);
}

/// The Cartesian pendulum of A01 with the kernel `inverse_dynamics`.
struct CartesianPendulum : mechanisms::CartesianPendulum<double> {
  static void inverse_dynamics(const Precomputed&, const State& s, const Accelerations& a, const Multipliers& lambda,
                               GeneralizedForces& r) noexcept {
    r[0] = a[0] - lambda[0] * s.q[0];
    r[1] = a[1] + 9.81 - lambda[0] * s.q[1];
  }
};
TEST(Sundials, CarriesTheMultipliersAsUnknowns) {
  const auto motion = equations_of_motion<CartesianPendulum>();
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, with_tolerance<Ida>(1e-10));
  ASSERT_TRUE(result) << describe(result);
  // The angle from the downward vertical, from -pi/2, at t = 1, by an independent integration of one angle.
  std::array<double, 2> angle{-std::acos(0.0), 0.0};
  ASSERT_TRUE(integrate(equations_of_motion<mechanisms::Pendulum<double>>(), angle, 0, 1, adams(1e-12)));
  EXPECT_NEAR(y[0], std::sin(angle[0]), 1e-7);
  EXPECT_NEAR(y[1], -std::cos(angle[0]), 1e-7);
}

TEST(Sundials, LocatesEventsOfTheImplicitForm) {
  // From the horizontal at rest: the vertical after K(sin π/4)/√g.
  const auto motion = equations_of_motion<CartesianPendulum>();
  auto y = motion.initial();
  const auto vertical = stop_at([](double, const auto& s) { return s[0]; });
  const auto result = integrate_with_events(motion, y, 0, 1, with_tolerance<Ida>(1e-10), Events(vertical));
  ASSERT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  EXPECT_NEAR(result.time, std::comp_ellint_1(std::sqrt(0.5)) / std::sqrt(9.81), 1e-7);
  EXPECT_NEAR(y[1], -1.0, 1e-7);
}

TEST(Sundials, GoesThroughGivenTimesAndBackwards) {
  const std::array<double, 3> times{0.5, 1.0, 2.0};
  std::array<double, 2> y{2.0, 0.0};
  std::size_t seen = 0;
  const auto motion = equations_of_motion<mechanisms::Pendulum<double>>();
  const auto result = integrate_through(motion, y, 0.0, times, adams(1e-10), [&](double t, const auto&) {
    EXPECT_EQ(t, times[seen]);
    ++seen;
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_EQ(seen, 3U);
  ASSERT_TRUE(integrate(motion, y, 2.0, 0.0, adams(1e-10)));
  EXPECT_NEAR(y[0], 2.0, 1e-7);
}

template <class Method>
void expect_first_steps_in_both_directions() {
  using One = std::array<double, 1>;
  const auto decays = [](double, const One& y, One& dydt) noexcept {
    dydt[0] = -y[0];
    return Evaluation::ok;
  };
  Method method = with_tolerance<Method>(1e-9);
  method.first_step = 1e-6;
  for (const double end : {1.0, -1.0}) {
    One y{1.0};
    const auto result = integrate(decays, y, 0, end, method);
    EXPECT_TRUE(result) << describe(result) << ", to " << end;
    EXPECT_NEAR(y[0], std::exp(-end), 1e-4);
  }
  method.first_step = -1e-6;
  One y{1.0};
  EXPECT_EQ(integrate(decays, y, 0, -1, method).status, IntegrationStatus::invalid_options);
}

TEST(Sundials, TakesAFirstStepInEitherDirection) {
  expect_first_steps_in_both_directions<Cvode>();
  expect_first_steps_in_both_directions<ArkodeExplicit>();
  expect_first_steps_in_both_directions<ArkodeImplicit>();
}

TEST(Sundials, ReportsFailures) {
  using One = std::array<double, 1>;
  const auto fails = [](double t, const One& y, One& dydt) noexcept {
    dydt[0] = t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : -y[0];
    return Evaluation::ok;
  };
  One y{1.0};
  auto result = integrate(fails, y, 0, 1, Cvode{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::not_finite);
  EXPECT_LE(result.time, 0.5);
  EXPECT_NEAR(y[0], std::exp(-result.time), 1e-6);
  y = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(integrate(fails, y, 0, 1, Cvode{}).status, IntegrationStatus::invalid_options);
  y = {1.0};
  EXPECT_EQ(integrate(fails, y, 0, 1, with_tolerance<Cvode>(-1.0)).status, IntegrationStatus::invalid_options);
  ArkodeExplicit short_of_breath;
  short_of_breath.step_limit = 3;
  EXPECT_EQ(integrate(fails, y, 0, 0.4, short_of_breath).status, IntegrationStatus::too_many_steps);
  y = {1.0};
  const auto singular = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 0.0;
    return Evaluation::singular;
  };
  result = integrate(singular, y, 0, 1, Cvode{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
  result = integrate(fails, y, 0, 1, adams(1e-9), [](double t, const One&) { return t < 0.1; });
  EXPECT_EQ(result.status, IntegrationStatus::stopped_by_observer);
}

}  // namespace
}  // namespace sundials_test
