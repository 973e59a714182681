// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/steady_states.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <limits>
#include <stdexcept>
#include <string>

#include "torsor/runtime/small_motions/cyclic_reduction.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "tests/runtime/static_mechanisms.hpp"

namespace steady_states_test {
namespace {

using namespace torsor::runtime;
using namespace mechanisms;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi, g = gravity<double>;
constexpr double rounding = 1e-13;  // Newton's last step on equations of the size of 10

const CoordinateBox turn{VectorXd::Constant(1, -pi + 0.1), VectorXd::Constant(1, pi + 0.1), {0}};

StateSearch<ArmPendulum> equilibria(double omega, double arm = 0.0) {
  return find_equilibria<ArmPendulum>(ArmPendulum::precompute({omega, arm, 0.0}), turn);
}

StabilityReport verdict(double omega, const FoundState<ArmPendulum>& s) {
  return stability(linearised_at<ArmPendulum>(ArmPendulum::precompute({omega, 0.0, 0.0}), s), true);
}

// Bead on a vertical hoop, R = 1: the bottom is left at omega = sqrt(g/R) for cos(theta0) = g / omega².
TEST(Equilibria, OfABeadOnATurningHoopBranchAtItsCriticalSpeed) {
  const auto slow = equilibria(2.0);
  ASSERT_EQ(slow.found.size(), 2U);
  EXPECT_NEAR(slow.found[0].state.q[0], 0.0, rounding);
  EXPECT_NEAR(slow.found[1].state.q[0], pi, rounding);
  EXPECT_EQ(verdict(2.0, slow.found[0]).verdict, Stability::stable);
  EXPECT_EQ(verdict(2.0, slow.found[1]).verdict, Stability::unstable);
  const auto fast = equilibria(5.0);
  ASSERT_EQ(fast.found.size(), 4U);
  EXPECT_NEAR(fast.found[0].state.q[0], -1.167556903805042963872909, rounding);
  EXPECT_NEAR(fast.found[2].state.q[0], 1.167556903805042963872909, rounding);
  EXPECT_EQ(verdict(5.0, fast.found[0]).verdict, Stability::stable);
  EXPECT_EQ(verdict(5.0, fast.found[1]).verdict, Stability::unstable);  // the bottom
  EXPECT_EQ(verdict(5.0, fast.found[2]).verdict, Stability::stable);
  EXPECT_EQ(verdict(5.0, fast.found[3]).verdict, Stability::unstable);
  EXPECT_TRUE(fast.failures.empty());
}

TEST(Equilibria, OfABeadOnATurningHoopHaveThePublishedFrequencies) {
  const auto frequency = [](double omega, const FoundState<ArmPendulum>& s) {
    return natural_modes(linearised_at<ArmPendulum>(ArmPendulum::precompute({omega, 0, 0}), s)).angular_frequency(0);
  };
  EXPECT_NEAR(frequency(5.0, equilibria(5.0).found[2]), 4.598973363697598107670683, rounding);
  EXPECT_NEAR(frequency(2.0, equilibria(2.0).found[0]), 2.410394158638789930968615, rounding);
}

// At the critical speed the three roots are one, where the second order of −(U + T0) vanishes.
TEST(Equilibria, AtTheCriticalSpeedAreNotIsolatedAndNobodyConcludes) {
  const double critical = std::sqrt(g);
  const auto search = equilibria(critical);
  ASSERT_EQ(search.found.size(), 2U);
  EXPECT_NEAR(search.found[0].state.q[0], 0.0, 1e-3);
  EXPECT_FALSE(search.found[0].isolated);
  EXPECT_TRUE(search.found[1].isolated);
  FoundState<ArmPendulum> bottom = search.found[0];
  bottom.state.q[0] = 0.0;
  const StabilityReport report = verdict(critical, bottom);
  EXPECT_EQ(report.verdict, Stability::cannot_conclude);
  EXPECT_NE(report.reason.find("Lejeune-Dirichlet"), std::string::npos);
  EXPECT_NE(report.reason.find("Liapunov"), std::string::npos);
}

// Hinged away from the axis: tan θ = ω² (a + sin θ) / g. Two equilibria below the fold, four above it; counted here by
// the changes of sign of the equation over a fine grid.
TEST(Equilibria, OfAPendulumOnATurningArmAreAsManyAsItsEquationHas) {
  const double arm = 0.3;
  int counts[2] = {0, 0};
  for (const double omega : {1.0, 2.0, 3.0, 4.0, 4.5, 5.0, 7.0}) {
    const auto equation = [omega, arm](double theta) {
      return g * std::sin(theta) - omega * omega * (arm + std::sin(theta)) * std::cos(theta);
    };
    std::size_t expected = 0;
    for (int k = 0; k < 100000; ++k) {
      const double theta = -pi + 0.1 + 2 * pi * k / 100000.0;
      expected += (equation(theta) < 0) != (equation(theta + 2 * pi / 100000.0) < 0);
    }
    const auto search = equilibria(omega, arm);
    EXPECT_EQ(search.found.size(), expected) << omega;
    for (const auto& s : search.found) EXPECT_NEAR(equation(s.state.q[0]), 0.0, 1e-12 * (g + omega * omega));
    ++counts[expected == 4U];
  }
  EXPECT_GT(counts[0], 0);
  EXPECT_GT(counts[1], 0);
}

TEST(Equilibria, WithFrictionAreAsymptoticallyStable) {
  const auto precomputed = ArmPendulum::precompute({2.0, 0.0, 0.1});
  const auto search = find_equilibria<ArmPendulum>(precomputed, turn);
  EXPECT_EQ(stability(linearised_at<ArmPendulum>(precomputed, search.found[0]), true).verdict,
            Stability::asymptotically_stable);
}

// x = 0, y = ∓1 with the tension as multiplier: g − λ y = 0.
TEST(Equilibria, WithAMultiplierComeWithTheReaction) {
  using OnCircle = LinearisedPointOnCurve<Circle>;
  const CoordinateBox box{Vector2d(-1.5, -1.5), Vector2d(1.5, 1.5)};
  const auto search = find_equilibria<OnCircle>({}, box);
  ASSERT_EQ(search.found.size(), 2U);
  const auto& top = search.found[search.found[0].state.q[1] > 0 ? 0 : 1];
  const auto& bottom = search.found[search.found[0].state.q[1] > 0 ? 1 : 0];
  EXPECT_NEAR(bottom.state.q[0], 0.0, 1e-11);
  EXPECT_NEAR(bottom.state.q[1], -1.0, 1e-11);
  EXPECT_NEAR(bottom.multipliers[0], -g, 1e-9);
  EXPECT_NEAR(top.multipliers[0], g, 1e-9);
  EXPECT_TRUE(top.isolated && bottom.isolated);
  const LinearSystem small = linearised_at<OnCircle>({}, bottom);
  ASSERT_EQ(small.size(), 1);  // the pendulum itself: g/L
  EXPECT_NEAR(natural_modes(small).squared_frequencies(0), g, 1e-9);
  EXPECT_EQ(stability(small, true).verdict, Stability::stable);
  EXPECT_EQ(stability(linearised_at<OnCircle>({}, top), true).verdict, Stability::unstable);
}

// y = x⁴ − x²: rest at x = 0 and ± sqrt(1/2); ω² = g y''/(1 + y'²) = 4 g in the valleys.
TEST(Equilibria, OnADoubleWellAreThreeByDifferencesAsByDerivatives) {
  const CoordinateBox box{Vector2d(-2, -2), Vector2d(2, 2)};
  const auto by_differences = find_equilibria<PointOnCurve<DoubleWell>>({}, box);
  const auto search = find_equilibria<LinearisedPointOnCurve<DoubleWell>>({}, box);
  ASSERT_EQ(search.found.size(), 3U);
  ASSERT_EQ(by_differences.found.size(), 3U);
  const double expected[3] = {-std::sqrt(0.5), 0.0, std::sqrt(0.5)};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(search.found[k].state.q[0], expected[k], 1e-11);
    EXPECT_NEAR(by_differences.found[k].state.q[0], expected[k], 1e-11);
    EXPECT_NEAR(search.found[k].multipliers[0], g, 1e-9);
  }
  const auto system = linearised_at<LinearisedPointOnCurve<DoubleWell>>({}, search.found[2]);
  EXPECT_NEAR(natural_modes(system).squared_frequencies(0), 4 * g, 1e-8);
}

// Both multipliers carry the weight in any shares: with the second at zero the rests are points again.
TEST(Equilibria, UnderAConstraintThatRepeatsAnotherAreIsolated) {
  const CoordinateBox box{Vector2d(-2, -2), Vector2d(2, 2)};
  const auto search = find_equilibria<TwiceOnCurve<DoubleWell>>({}, box);
  ASSERT_EQ(search.found.size(), 3U);
  for (const auto& rest : search.found) {
    EXPECT_TRUE(rest.isolated);
    EXPECT_NEAR(rest.multipliers[0], g, 1e-9);
    EXPECT_EQ(rest.multipliers[1], 0.0);
  }
}

// With the force u on the slider, x (4 − ψ'²) = u at the rate ψ'; the friction of the turn asks for c ψ'.
TEST(SteadyMotions, HaveTheCyclicRateThatWasGivenAndTheEffortThatKeepsIt) {
  const auto precomputed = TurningSlider::precompute({0.5});
  TurningSlider::State state{};
  state.v[1] = 1.5;
  const CoordinateBox box{VectorXd::Constant(1, -3), VectorXd::Constant(1, 3)};
  const auto search =
      find_steady_motions<TurningSlider>(precomputed, {.state = state, .cyclic = {1}, .inputs = {{3.5}}}, box);
  ASSERT_EQ(search.found.size(), 1U);
  EXPECT_NEAR(search.found[0].state.q[0], 3.5 / (4 - 1.5 * 1.5), rounding);
  EXPECT_EQ(search.found[0].state.v[1], 1.5);
  EXPECT_NEAR(search.found[0].efforts[1], 0.75, rounding);
  EXPECT_EQ(search.found[0].efforts[0], 0.0);
}

// The rate that holds the slider at x = 1: ψ'² = 4 − u/x, the friction being carried by the motor of the turn.
TEST(States, MayAskForVelocities) {
  const auto precomputed = TurningSlider::precompute({0.0});
  StateProblem<TurningSlider> problem;
  problem.state.q[0] = 1.0;
  problem.inputs[0] = 3.0;
  problem.velocities = {1};
  problem.lower = VectorXd::Constant(1, -5);
  problem.upper = VectorXd::Constant(1, 5);
  const auto search = find_states<TurningSlider>(precomputed, problem);
  ASSERT_EQ(search.found.size(), 2U);
  EXPECT_NEAR(search.found[0].state.v[1], -1.0, rounding);
  EXPECT_NEAR(search.found[1].state.v[1], 1.0, rounding);
}

TEST(States, RefuseBoundsAndIndicesThatDoNotFit) {
  StateProblem<TurningSlider> problem;
  problem.coordinates = {0};
  EXPECT_THROW((void)find_states<TurningSlider>(TurningSlider::precompute({0}), problem), std::invalid_argument);
  problem.coordinates = {2};
  problem.lower = problem.upper = VectorXd::Constant(1, 1);
  EXPECT_THROW((void)find_states<TurningSlider>(TurningSlider::precompute({0}), problem), std::invalid_argument);
  FoundState<LinearisedPointOnCurve<Circle>> moving;
  moving.state.q[1] = -1.0;
  moving.state.v[0] = 1.0;
  EXPECT_THROW((void)linearised_at<LinearisedPointOnCurve<Circle>>({}, moving), std::invalid_argument);
}

/// θ'' + 10 sin θ = u, without the kernel `linearisation`: the kernel that there is knows no u.
struct PushedPendulum : mechanisms::Contract<1, 0> {
  static constexpr int input_count = 1;
  using Inputs = mechanisms::Values<double, 1>;
  static void inverse_dynamics(const Precomputed&, const State& s, const Accelerations& a, const Multipliers&,
                               GeneralizedForces& r) noexcept {
    r[0] = a[0] + 10 * std::sin(s.q[0]);
  }
};
TEST(States, RefuseInputsThatNoKernelTakes) {
  const CoordinateBox box{VectorXd::Constant(1, -1), VectorXd::Constant(1, 1)};
  RestConditions<PushedPendulum> rest;
  EXPECT_EQ(find_equilibria<PushedPendulum>({}, box, rest).found.size(), 1U);
  rest.inputs[0] = 5.0;
  EXPECT_THROW((void)find_equilibria<PushedPendulum>({}, box, rest), std::invalid_argument);
  StateProblem<PushedPendulum> problem;
  problem.coordinates = {0};
  problem.lower = box.lower;
  problem.upper = box.upper;
  problem.inputs[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)find_states<PushedPendulum>({}, problem), std::invalid_argument);
}

// U has its stationary points where R is diagonal: the identity and the half turns about the three axes. Each is found
// once although the opposite quaternion says the same.
TEST(Equilibria, OfABodyWithAQuaternionAreItsFourAttitudes) {
  const CoordinateBox box{-VectorXd::Ones(4), VectorXd::Ones(4)};
  const auto search = find_equilibria<HeldBody>({}, box);
  ASSERT_EQ(search.found.size(), 4U);
  bool seen[4] = {false, false, false, false};
  for (const auto& s : search.found) {
    EXPECT_TRUE(s.isolated);
    for (int i = 0; i < 4; ++i) {
      if (std::abs(s.state.q[i]) < 0.5) continue;
      EXPECT_NEAR(s.state.q[i], 1.0, 1e-11);
      seen[i] = true;
    }
  }
  EXPECT_TRUE(seen[0] && seen[1] && seen[2] && seen[3]);
}

LinearSystem turning_slider(double rate) {
  StateProblem<TurningSlider> problem;
  problem.state.v[1] = rate;
  problem.coordinates = {0};
  problem.supplied = {1};
  problem.inputs[0] = 3.0;
  problem.lower = VectorXd::Constant(1, -10);
  problem.upper = VectorXd::Constant(1, 10);
  const auto precomputed = TurningSlider::precompute({0.0});
  const auto search = find_states<TurningSlider>(precomputed, problem);
  EXPECT_EQ(search.found.size(), 1U);
  return linearised_at<TurningSlider>(precomputed, search.found[0], problem.inputs);
}

// At x = 3/(4 − ψ'²). At the rate ψ' the stiffness is 4 − ψ'²; at the momentum p = (1 + x²) ψ' it is the second
// derivative of 2x² − 3x + p²/(2(1 + x²)): 4 − ψ'² (1 − 3x²)/(1 + x²).
TEST(CyclicReduction, IsThatOfTheReducedPotential) {
  const double rate = 1.5, x = 3.0 / (4.0 - rate * rate);
  const LinearSystem whole = turning_slider(rate);
  EXPECT_EQ(stability_by_eigenvalues(whole).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_lejeune_dirichlet(whole).verdict, Stability::cannot_conclude);
  const LinearSystem at_rate = reduced_at_constant_rate(whole, {1});
  const LinearSystem at_momentum = reduced_at_constant_momentum(whole, {1});
  EXPECT_NEAR(at_rate.K(0, 0), 4 - rate * rate, rounding);
  EXPECT_NEAR(at_momentum.K(0, 0), 4 - rate * rate * (1 - 3 * x * x) / (1 + x * x), rounding);
  EXPECT_EQ(at_momentum.M(0, 0), 1.0);
  EXPECT_EQ(at_momentum.C(0, 0), 0.0);
  EXPECT_EQ(stability(at_momentum, true).verdict, Stability::stable);
  // Faster than the spring holds, the slider stays where the force draws it as long as the momentum is kept.
  EXPECT_EQ(stability(reduced_at_constant_rate(turning_slider(2.2), {1}), true).verdict, Stability::unstable);
  EXPECT_EQ(stability(reduced_at_constant_momentum(turning_slider(2.2), {1}), true).verdict, Stability::stable);
}

TEST(CyclicReduction, RefusesWhatIsNotCyclic) {
  const LinearSystem whole = turning_slider(1.0);
  EXPECT_THROW((void)reduced_at_constant_momentum(whole, {0}), std::invalid_argument);
  EXPECT_THROW((void)reduced_at_constant_rate(whole, {2}), std::invalid_argument);
  EXPECT_THROW((void)reduced_at_constant_rate(whole, {0, 1}), std::invalid_argument);
  // A force along the cyclic coordinate 1, or by it, of each kind.
  const auto expect_refused = [&](Eigen::MatrixXd LinearSystem::*matrix, int i, int j) {
    LinearSystem changed = whole;
    (changed.*matrix)(i, j) = 0.1;
    EXPECT_THROW((void)reduced_at_constant_momentum(changed, {1}), std::invalid_argument) << i << ", " << j;
  };
  expect_refused(&LinearSystem::C, 1, 1);
  expect_refused(&LinearSystem::K, 1, 1);
  expect_refused(&LinearSystem::K, 0, 1);
  expect_refused(&LinearSystem::K, 1, 0);
  // A constant one, which nothing balances; what rounding leaves of a balance is none.
  LinearSystem pushed = whole;
  pushed.F(1) = 1e-14;
  EXPECT_NO_THROW((void)reduced_at_constant_momentum(pushed, {1}));
  pushed.F(1) = 0.1;
  try {
    (void)reduced_at_constant_momentum(pushed, {1});
    ADD_FAILURE() << "the momentum grows";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("cyclic coordinate 1"), std::string::npos) << error.what();
  }
}

// Three equal masses between walls, the first two tied: 2 u'' + 2 u - w = 0, w'' + 2 w - u = 0, so that the squared
// frequencies are (3 ± √3)/2, whether the tie is told once or more often.
TEST(MotionOnConstraints, CountsConstraintsThatRepeatOthersOnce) {
  const LinearSystem whole{MatrixXd::Identity(3, 3), MatrixXd::Zero(3, 3),
                           (MatrixXd(3, 3) << 2, -1, 0, -1, 2, -1, 0, -1, 2).finished(), VectorXd::Zero(3)};
  const MatrixXd more = (MatrixXd(3, 3) << 1, -1, 0, -3, 3, 0, 0, 0, 0).finished();
  for (const int rows : {1, 2, 3}) {
    const LinearSystem tied = on_constraints(whole, more.topRows(rows));
    ASSERT_EQ(tied.size(), 2) << rows;
    const NaturalModes modes = natural_modes(tied);
    EXPECT_NEAR(modes.squared_frequencies(0), (3 - std::sqrt(3.0)) / 2, 1e-14);
    EXPECT_NEAR(modes.squared_frequencies(1), (3 + std::sqrt(3.0)) / 2, 1e-14);
  }
  EXPECT_THROW((void)on_constraints(whole, MatrixXd::Identity(3, 3)), std::invalid_argument);
}

// Motions e^{st} a: with P(s) = M s² + C s + K the cyclic coordinate is -P_cn a/P_cc, so that what is left is the Schur
// complement P_nn - P_nc P_cn/P_cc, at any s but 0. Entries of the size of 10, of some ten operations.
TEST(CyclicReduction, LeavesWhatEliminationLeaves) {
  LinearSystem whole;
  whole.M = (MatrixXd(3, 3) << 2.0, 0.3, 0.5, 0.3, 1.5, -0.4, 0.5, -0.4, 1.2).finished();
  whole.C = (MatrixXd(3, 3) << 0.2, 0.7, 0.9, -0.6, 0.1, -0.8, -1.1, 0.35, 0.0).finished();
  whole.K = (MatrixXd(3, 3) << 4.0, 0.6, 0.0, 0.5, 3.0, 0.0, 0.0, 0.0, 0.0).finished();
  whole.F = VectorXd::Zero(3);
  const LinearSystem left = reduced_at_constant_momentum(whole, {2});
  for (const double s : {0.7, -1.3, 2.1}) {
    const MatrixXd P = whole.M * s * s + whole.C * s + whole.K, Q = left.M * s * s + left.C * s + left.K;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(Q(i, j), P(i, j) - P(i, 2) * P(2, j) / P(2, 2), 1e-14 * 10) << s;
    }
  }
}

}  // namespace
}  // namespace steady_states_test
