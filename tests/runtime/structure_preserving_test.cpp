// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "generated/double_pendulum.hpp"
#include "generated/flyball_governor.hpp"
#include "runtime/gauss_collocation.hpp"
#include "runtime/mechanism.hpp"
#include "runtime/stoermer_verlet.hpp"
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
  return std::getenv("TORSOR_LONG_TESTS") != nullptr ? 1'000'000 : in_short;
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
  const auto solved = integrate(motion, y, 0.0, 0.5, GaussCollocation<6, StageSolver::newton>{.step = 0.004});
  ASSERT_TRUE(solved) << describe(solved);
  // Quadruple precision at t = 0.5 (6 and 8 stages agree to 16 digits). The forces of the damper, 4e4 v, carry the
  // roundings of rates of 1e4 m/s² and more into each step: 1e-13 is what double attains.
  const std::array<double, 8> truth{2.80767948836790160,     7.43249424786325721e-01, 2.59491381543413121e-01,
                                    2.59491381543413121e-01, 5.10341542197153529,     5.21197801583734170e-02,
                                    -5.3905218498742472e-02, -5.3905218498742472e-02};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(y[i], truth[i], 4e-13) << i;
  EXPECT_GT(solved.statistics.jacobians, 0);
  EXPECT_EQ(solved.statistics.jacobians, solved.statistics.decompositions);
  EXPECT_LT(solved.statistics.jacobians, solved.statistics.accepted);
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
