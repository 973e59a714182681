// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "generated/double_pendulum.hpp"
#include "generated/flyball_governor.hpp"
#include "tests/long_tests.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace structure_preserving_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 2>;
using Pendulum = mechanisms::Pendulum<double>;

// Simple pendulum from 2 rad at rest, L = 1, g = 9.81, at t = 10 (Jacobi's elliptic functions, 50 digits).
constexpr State pendulum_end{0.015728632141428118626277592909, 5.27089879322982860518148735035};

// A million steps where TORSOR_LONG_TESTS is set.
std::int64_t many_steps(std::int64_t in_short) {
  return torsor::wanted<std::int64_t>(in_short, 1'000'000);
}

template <class Method>
double pendulum_error(const Method& method) {
  State y{2.0, 0.0};
  const auto result = integrate(equations_of_motion<Pendulum>(), y, 0.0, 10.0, method);
  EXPECT_TRUE(result) << describe(result);
  return std::max(std::abs(y[0] - pendulum_end[0]), std::abs(y[1] - pendulum_end[1]));
}

// Largest |E - E(0)| / (g L) over the steps, and the last.
struct EnergyErrors {
  double largest = 0.0, last = 0.0;
};
template <class Method>
EnergyErrors pendulum_energy(const Method& method, std::int64_t steps) {
  const auto energy = [](const State& y) { return y[1] * y[1] / (2.0 * 9.81) - std::cos(y[0]); };
  State y{2.0, 0.0};
  EnergyErrors errors;
  const double start = energy(y);
  const auto watch = [&](double, const State& at) {
    errors.last = std::abs(energy(at) - start);
    errors.largest = std::max(errors.largest, errors.last);
  };
  const auto result =
      integrate(equations_of_motion<Pendulum>(), y, 0.0, static_cast<double>(steps) * method.step, method, watch);
  EXPECT_TRUE(result) << describe(result);
  return errors;
}

template <std::size_t stages>
void expect_collocation_conditions() {
  const auto& g = gauss_coefficients<double, stages>;
  // Sums of at most six terms of size 1, each rounded a few times.
  const double rounding = 1e-15;
  for (std::size_t power = 1; power <= 2 * stages; ++power) {
    const double p = static_cast<double>(power);
    double quadrature = 0.0;
    for (std::size_t j = 0; j < stages; ++j) quadrature += g.b[j] * std::pow(g.c[j], p - 1.0);
    EXPECT_NEAR(quadrature, 1.0 / p, rounding) << stages << " stages, B(" << power << ")";
    for (std::size_t i = 0; i < stages && power <= stages; ++i) {
      double integral = 0.0, ahead = 0.0;
      for (std::size_t j = 0; j < stages; ++j) {
        integral += g.a[i][j] * std::pow(g.c[j], p - 1.0);
        ahead += g.ahead[i][j] * std::pow(g.c[j], p - 1.0);
      }
      EXPECT_NEAR(integral, std::pow(g.c[i], p) / p, rounding) << stages << " stages, C(" << power << ")";
      // The extrapolation magnifies: its rows have entries up to some ten thousand.
      EXPECT_NEAR(ahead, std::pow(1.0 + g.c[i], p - 1.0), 1e-10) << stages << " stages, power " << power;
    }
  }
  long double weights = -1.0L;
  for (std::size_t i = 0; i < stages; ++i) {
    weights += static_cast<long double>(g.b[i]);
    weights += static_cast<long double>(g.b_rest[i]);
    for (std::size_t j = 0; j < stages; ++j) {  // what makes the method symplectic
      EXPECT_NEAR(g.b[i] * g.a[i][j] + g.b[j] * g.a[j][i], g.b[i] * g.b[j], rounding);
    }
  }
  EXPECT_LE(std::abs(weights), 1e-18L * stages);  // roundings of the longer type
}

TEST(GaussCoefficients, MeetTheConditionsOfCollocation) {
  expect_collocation_conditions<1>();
  expect_collocation_conditions<2>();
  expect_collocation_conditions<3>();
  expect_collocation_conditions<4>();
  expect_collocation_conditions<5>();
  expect_collocation_conditions<6>();
}

TEST(GaussCoefficients, AreThoseOfTheBook) {  // Hairer-Lubich-Wanner, table II.1.1
  const auto& g = gauss_coefficients<double, 2>;
  const double r = std::sqrt(3.0) / 6.0;
  EXPECT_NEAR(g.c[0], 0.5 - r, 1e-16);
  EXPECT_NEAR(g.a[0][1], 0.25 - r, 1e-16);
  EXPECT_NEAR(g.a[1][0], 0.25 + r, 1e-16);
  EXPECT_EQ(g.b[0], 0.5);
}

// Steps where the next terms of the error change the order seen by less than 0.2; an order lower by two, as for the
// next method, would be off by 2. The fifth and sixth are taken where 12 and 10 orders fit between rounding and
// divergence, over a factor in the step that is less than 2.
template <int stages>
void expect_order(double step, double ratio, double slack) {
  const double coarse = pendulum_error(GaussCollocation<stages>{.step = step});
  const double fine = pendulum_error(GaussCollocation<stages>{.step = step / ratio});
  EXPECT_NEAR(std::log(coarse / fine) / std::log(ratio), 2.0 * stages, slack) << stages << " stages";
}
TEST(GaussCollocation, HasTwiceTheOrderOfItsStages) {
  expect_order<1>(1.0 / 64, 2.0, 0.2);
  expect_order<2>(1.0 / 16, 2.0, 0.2);
  expect_order<3>(1.0 / 16, 2.0, 0.2);
  expect_order<4>(1.0 / 16, 2.0, 0.2);
  expect_order<6>(0.5, 2.0, 1.0);
}

TEST(GaussCollocation, MeetsEllipticFunctionsToRoundings) {
  // 160 steps of order 12 and length 1/16; the flow amplifies by some 60 (twice the period's shear over 10 s).
  EXPECT_LT(pendulum_error(GaussCollocation<6>{.step = 1.0 / 16}), 60 * 2.2e-16);
}

TEST(GaussCollocation, HoldsTheEnergyToTheLastBits) {
  // Order 6 with h = 0.01 errs by 1e-13 in the energy, periodically; what rounding adds walks at random, sqrt(n) h
  // eps of the exchanged 1.4 g L: below the energy's own rounding for a million steps.
  const EnergyErrors errors = pendulum_energy(GaussCollocation<3>{.step = 0.01}, many_steps(20'000));
  EXPECT_LT(errors.largest, 2e-13);
}

TEST(GaussCollocation, KeepsQuadraticFirstIntegrals) {
  // Euler's equations of a free body, moments 1, 2 and 4: y = J ω; |y|² and the energy are quadratic.
  const auto body = [](double, const std::array<double, 3>& y, std::array<double, 3>& dydt) noexcept {
    const std::array<double, 3> w{y[0], y[1] / 2, y[2] / 4};
    dydt = {y[1] * w[2] - y[2] * w[1], y[2] * w[0] - y[0] * w[2], y[0] * w[1] - y[1] * w[0]};
    return Evaluation::ok;
  };
  const auto moment = [](const std::array<double, 3>& y) { return y[0] * y[0] + y[1] * y[1] + y[2] * y[2]; };
  const auto energy = [](const std::array<double, 3>& y) { return y[0] * y[0] + y[1] * y[1] / 2 + y[2] * y[2] / 4; };
  std::array<double, 3> y{0.1, 2.0, -0.3};
  const double moment_before = moment(y), energy_before = energy(y);
  ASSERT_TRUE(integrate(body, y, 0.0, 1000.0, GaussCollocation<2>{.step = 0.1}));
  // Steps as coarse as these err by 1e-4 in the motion itself, but by roundings alone in both integrals, which walk at
  // random by eps of their size in each of the 10⁴ steps: sqrt(10⁴) eps, three times.
  EXPECT_NEAR(moment(y), moment_before, 300 * 2.2e-16 * moment_before);
  EXPECT_NEAR(energy(y), energy_before, 300 * 2.2e-16 * energy_before);
}

TEST(GaussCollocation, MeetsTheReferenceOfTheDoublePendulum) {
  // Reference by extrapolation in 50 digits at t = 2; the start's roundings and the steps' are amplified by 17, and
  // order 12 with h = 1/100 leaves less than that.
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  const std::array<double, 4> truth{-2.92203223590754080983208427967, 0.117385172202614548573850887057,
                                    0.910779554993410739453434226877, 4.42695187390119794989340053402};
  for (const double step : {0.01, -0.01}) {
    auto y = motion.initial();
    ASSERT_TRUE(integrate(motion, y, 0.0, 2.0, GaussCollocation<6>{.step = 0.01}));
    if (step < 0) {  // and back to the start, the method being symmetric
      ASSERT_TRUE(integrate(motion, y, 2.0, 0.0, GaussCollocation<6>{.step = 0.01}));
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], motion.initial()[i], 17 * 17 * 1e-15);
    } else {
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], truth[i], 17 * 4 * 2.2e-16 * 5) << i;
    }
  }
}

TEST(GaussCollocation, NeedsNewtonsMethodWhereTheMechanismIsStiff) {
  // A damper's root at -2e4 1/s against steps of 4e-3 s: substitution diverges by h a λ = 10 a sweep.
  const auto motion = equations_of_motion<flyball_governor::Mechanism<double>>();
  auto y = motion.initial();
  const auto diverged = integrate(motion, y, 0.0, 0.5, GaussCollocation<6>{.step = 0.004});
  EXPECT_EQ(diverged.status, IntegrationStatus::no_convergence);
  EXPECT_EQ(y, motion.initial());
  const auto solved = integrate(motion, y, 0.0, 10.0, GaussCollocation<6, StageSolver::newton>{.step = 0.005});
  ASSERT_TRUE(solved) << describe(solved);
  // Quadruple precision at t = 10 (6 and 8 stages agree to 16 digits). Springs and dampers of 8e5 N/m and 4e4 Ns/m turn
  // roundings of lengths and rates (5e-17 m, 1e-16 m/s) into forces of 4e-11 N and more, on some kilograms over 10 s;
  // psi is 56.
  const std::array<double, 8> truth{5.59354099091023787e+01, 6.19622917061365658e-01, 3.90073701844645080e-01,
                                    3.90073701844645080e-01, 5.54820362265492658,     -7.4760335416433246e-01,
                                    8.08467051345577400e-01, 8.08467051345577400e-01};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(y[i], truth[i], 2e-12) << i;
  EXPECT_GT(solved.statistics.jacobians, 0);
  EXPECT_EQ(solved.statistics.jacobians, solved.statistics.decompositions);
  EXPECT_LT(solved.statistics.jacobians, solved.statistics.accepted);
}

/// A unit mass on a spring from the origin, rest length 1, in the plane under gravity.
struct ElasticPendulum {
  static constexpr bool second_order = true;
  double stiffness;
  Evaluation operator()(double, const std::array<double, 4>& y, std::array<double, 4>& dydt) const noexcept {
    const double r = std::hypot(y[0], y[1]), pull = -stiffness * (r - 1) / r;
    dydt = {y[2], y[3], pull * y[0], pull * y[1] - 9.81};
    return Evaluation::ok;
  }
};
TEST(GaussCollocation, ResolvesTheFastModeOfTheElasticPendulum) {
  // Frequencies of 1e2 and 1e4 1/s against 3 1/s, at t = 2 to 25 digits. A rounding of r becomes an acceleration of
  // k eps, and a velocity of ws eps per period, summed at random over ws t / 2 pi periods; the phase itself, 2 ws,
  // is known to its roundings, times the fast velocity of g/ws.
  struct Case {
    double stiffness, step, allowed;
    std::array<double, 4> truth;
  };
  const std::array<Case, 2> cases{{{1e4,
                                    1.0 / 200,
                                    1e-13,
                                    {0.78716337934128783673767423, -0.61969057482201185317075261,
                                     2.1477596957501236496262230, 2.7408659966747509639371353}},
                                   {1e8,
                                    1e-4,
                                    1e4 * 2.2e-16 * 60,
                                    {0.79356556126269921386207737, -0.60848505169155606162579651,
                                     2.1024423862766915008686121, 2.7419353602363155999197867}}}};
  for (const Case& at : cases) {
    std::array<double, 4> y{1, 0, 0, 0};
    const auto result = integrate(ElasticPendulum{at.stiffness}, y, 0, 2, GaussCollocation<6>{.step = at.step});
    ASSERT_TRUE(result) << describe(result);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], at.truth[i], at.allowed) << at.stiffness << " " << i;
  }
}

TEST(GaussCollocation, HoldsTheEnergyInFloatToo) {
  // The error of a step, seen in the first 20 s, and roundings of the accelerations, which compensation cannot give
  // back: n = 2·10⁴ steps of h eps g with eps = 6e-8 move the energy at random by sqrt(n) h eps v, some 1.7e-6 g L.
  // Without compensation roundings of v itself would move it by sqrt(n) eps v²/(g L), 3e-5.
  std::array<float, 2> y{2.0F, 0.0F};
  const auto energy = [](const std::array<float, 2>& at) {
    return static_cast<double>(at[1]) * static_cast<double>(at[1]) / (2 * 9.81) - std::cos(static_cast<double>(at[0]));
  };
  const double start = energy(y);
  double first = 0.0, late = 0.0;
  const auto watch = [&](float t, const std::array<float, 2>& at) {
    double& largest = t < 20.0F ? first : late;
    largest = std::max(largest, std::abs(energy(at) - start));
  };
  const auto motion = equations_of_motion<mechanisms::Pendulum<float>>();
  const auto result = integrate(motion, y, 0.0F, 1000.0F, GaussCollocation<2>{.step = 0.05}, watch);
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(late, first + 3 * 1.7e-6);
}

TEST(GaussCollocation, SolvesStagesByDifferencesWhereTheSystemHasNoJacobian) {
  // y' = -λ (y - cos t) - sin t, y = cos t, λ = 1e6, steps of 0.05 (Prothero-Robinson). The stages are of order 3 and
  // the weights carry λ: the error stays near the stages' h⁴/(4! 16), not at h⁶.
  const auto system = [](double t, const std::array<double, 1>& y, std::array<double, 1>& dydt) noexcept {
    dydt[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t);
    return Evaluation::ok;
  };
  std::array<double, 1> y{1.0};
  const auto result = integrate(system, y, 0.0, 2.0, GaussCollocation<3, StageSolver::newton>{.step = 0.05});
  ASSERT_TRUE(result) << describe(result);
  EXPECT_NEAR(y[0], std::cos(2.0), 40 * std::pow(0.05, 4) / 24 / 16);
}

TEST(StoermerVerlet, HasOrderTwo) {
  const double coarse = pendulum_error(StoermerVerlet{.step = 1.0 / 128});
  const double fine = pendulum_error(StoermerVerlet{.step = 1.0 / 256});
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

TEST(StoermerVerlet, KeepsTheEnergyWithinThePublishedBoundForEver) {
  // 2.653e-4 for h = 0.01 over a million steps; the first swing already reaches it.
  const EnergyErrors errors = pendulum_energy(StoermerVerlet{.step = 0.01}, many_steps(30'000));
  EXPECT_NEAR(errors.largest, 2.653e-4, 1e-7);
}

TEST(StoermerVerlet, RefusesAccelerationsThatDependOnVelocities) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  for (const double both : {0.7, 0.0}) {
    // With the rods aligned no term in the velocities is left at the start: the places about it tell.
    std::array<double, 4> y{both, both, 0.0, 0.0};
    const auto result = integrate(motion, y, 0.0, 1.0, StoermerVerlet{.step = 0.01});
    EXPECT_EQ(result.status, IntegrationStatus::unsuitable_model);
    EXPECT_EQ(result.statistics.accepted, 0);
  }
}

/// A force that depends on velocities wherever the second and the fourth coordinate differ.
struct Coupled {
  static constexpr bool second_order = true;
  Evaluation operator()(double, const std::array<double, 8>& y, std::array<double, 8>& dydt) const noexcept {
    dydt = {y[4], y[5], y[6], y[7], 0, (y[1] - y[3]) * y[4] * y[4], 0, 0};
    return Evaluation::ok;
  }
};
TEST(StoermerVerlet, LooksWhereAllCoordinatesDiffer) {
  std::array<double, 8> y{0, 0, 0, 0, 1, 0, 0, 0};
  EXPECT_EQ(integrate(Coupled{}, y, 0.0, 1.0, StoermerVerlet{.step = 0.01}).status, IntegrationStatus::unsuitable_model);
}

/// A damper that is switched on.
struct DampedLater {
  static constexpr bool second_order = true;
  double since = 0.0, until = 1e9;
  Evaluation operator()(double t, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -4.0 * y[0] - (t >= since && t < until ? y[1] : 0.0)};
    return Evaluation::ok;
  }
};
TEST(StoermerVerlet, RefusesADamperThatIsSwitchedOnLater) {
  for (const auto& [since, steps] : {std::pair{0.005, 1}, std::pair{0.995, 128}, std::pair{1.5, 192}}) {
    State y{1.0, 0.0};
    const auto result = integrate(DampedLater{since}, y, 0.0, 3.0, StoermerVerlet{.step = 0.01});
    EXPECT_EQ(result.status, IntegrationStatus::unsuitable_model) << since;
    EXPECT_EQ(result.statistics.accepted, steps) << since;
  }
  State y{1.0, 0.0};
  const auto undamped = integrate(DampedLater{4.0}, y, 0.0, 3.0, StoermerVerlet{.step = 0.01});
  ASSERT_TRUE(undamped);
  // One at the start, 2 x 3 to try it, and 2 after 1, 2, 4, ..., 256 steps and after 192.
  EXPECT_EQ(undamped.statistics.calls, 300 + 1 + 6 + 2 * (9 + 1));
}

struct SaysItself {
  static constexpr bool second_order = true;
  static constexpr bool accelerations_depend_on_velocities = true;
  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -y[0]};
    return Evaluation::ok;
  }
};
TEST(StoermerVerlet, BelievesASystemThatSaysWhatItDependsOn) {
  State y{1.0, 0.0};
  const auto result = integrate(SaysItself{}, y, 0.0, 1.0, StoermerVerlet{.step = 0.01});
  EXPECT_EQ(result.status, IntegrationStatus::unsuitable_model);
  EXPECT_EQ(result.statistics.calls, 0);
}

}  // namespace
}  // namespace structure_preserving_test
