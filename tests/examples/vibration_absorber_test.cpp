// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/vibration_absorber.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "torsor/runtime/small_motions/forced_response.hpp"
#include "torsor/runtime/small_motions/steady_states.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

#include "torsor/generator/printing/print_equations.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::vibration_absorber_test {
namespace {

using namespace torsor::runtime;
using Absorber = vibration_absorber::Mechanism<double>;

// The values of the scene.
constexpr double M1 = 10.0, M2 = 1.0, M3 = 0.1, R = 0.02, g = 9.81, K = 1000.0, X0 = 0.1;
constexpr double tuned = 0.0981, omega = 10.0;
constexpr double mass = M1 + M2 + M3;
constexpr double rounding = 1.1e-16;
constexpr double pi = std::numbers::pi;

Absorber::Precomputed absorber(double d, double speed = omega) {
  Absorber::Parameters parameters = Absorber::default_parameters();
  parameters.d = d;
  parameters.omega = speed;
  return Absorber::precompute(parameters);
}

Absorber::Linearisation linearised(const Absorber::Precomputed& precomputed, const Absorber::State& state) {
  Absorber::Linearisation linear{};
  EXPECT_EQ(Absorber::linearisation(precomputed, state, {}, {}, {}, linear), torsor::Status::ok);
  return linear;
}

Absorber::State rest_at(double X, double theta, double time = 0.0) {
  Absorber::State state{};
  state.time = time;
  state.q = {X, theta};
  return state;
}

// M w'' + K w = F(t) about (Xi, theta_i), with the misprints of the course corrected. Ten roundings of each entry's
// largest term.
TEST(VibrationAbsorber, HasTheLinearisedMatricesOfTheCourse) {
  for (const double d : {tuned, 0.15}) {
    for (const double theta : {-2.0, -0.3, 0.0, 0.4, 1.5, 3.0}) {
      const double Xi = 0.1 + 0.05 * theta, time = 0.7 + theta / 7.0;
      const auto linear = linearised(absorber(d), rest_at(Xi, theta, time));
      const double coupling = M2 * d * std::cos(theta);
      const std::array<double, 4> M{mass, coupling, coupling, M2 * d * d};
      const std::array<double, 4> stiffness{K, 0.0, 0.0, M2 * g * d * std::cos(theta)};
      const std::array<double, 2> F{-K * (Xi - X0) + M3 * R * omega * omega * std::sin(omega * time),
                                    -M2 * g * d * std::sin(theta)};
      const double scale_F = K * (std::abs(Xi) + X0) + M3 * R * omega * omega * (1.0 + omega * std::abs(time));
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(linear.M[i], M[i], 10 * rounding * mass) << i;
        EXPECT_NEAR(linear.K[i], stiffness[i], 10 * rounding * (i == 0 ? K : M2 * g * d)) << i;
        EXPECT_EQ(linear.C[i], 0.0) << i;
      }
      EXPECT_NEAR(linear.F[0], F[0], 10 * rounding * scale_F);
      EXPECT_NEAR(linear.F[1], F[1], 10 * rounding * M2 * g * d);
    }
  }
}

// (M1+M2+M3) X'' + M2 d (theta'' cos - theta'^2 sin) - M3 R omega^2 sin(omega t) = -K (X - X0)
// M2 d (d theta'' + X'' cos) = -M2 g d sin(theta)
TEST(VibrationAbsorber, ObeysTheTwoEquationsOfLagrange) {
  for (int i = 0; i < 20; ++i) {
    Absorber::State s = rest_at(0.1 + 0.03 * i, -2.0 + 0.31 * i, 0.11 * i);
    s.v = {0.4 - 0.1 * i, -3.0 + 0.5 * i};
    const Absorber::Accelerations a{1.5 - 0.3 * i, 2.0 + 0.7 * i};
    const double d = 0.08 + 0.01 * i, sine = std::sin(s.q.theta), cosine = std::cos(s.q.theta);
    Absorber::GeneralizedForces residual{};
    Absorber::inverse_dynamics(absorber(d), s, a, {}, residual);
    const double force = mass * a.X + M2 * d * (a.theta * cosine - s.v.theta * s.v.theta * sine) -
                         M3 * R * omega * omega * std::sin(omega * s.time) + K * (s.q.X - X0);
    const double torque = M2 * d * (d * a.theta + a.X * cosine) + M2 * g * d * sine;
    // Twenty roundings of the largest terms: K X below 700 N, M2 g d below 3 N m.
    EXPECT_NEAR(residual.X, force, 20 * rounding * 700);
    EXPECT_NEAR(residual.theta, torque, 20 * rounding * 6);
  }
}

TEST(VibrationAbsorber, PrintsItsEquationsAsAPersonWritesThem) {
  const std::string text = torsor::print_equations(vibration_absorber_scene(), torsor::Format::text, {});
  for (const std::string line :
       {"X:  (M1 + M2 + M3) X'' + M2 d cos(theta) theta'' - M2 d sin(theta) theta'^2 - M3 R omega^2 sin(omega t) = "
        "-K (X - X0)\n",
        "theta:  M2 d^2 theta'' + M2 d cos(theta) X'' = -M2 g d sin(theta)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "is missing from\n" << text;
  }
}

/// Squares of the eigenvalues of the state matrix A = [0 1; B 0] of a rest: those of B, the smaller first.
std::array<double, 2> squared_eigenvalues(const Absorber::Linearisation& linear) {
  const auto& A = linear.A;  // 4 x 4, column by column
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (i >= 2 && j < 2) continue;
      EXPECT_EQ(A[i + 4 * j], j == i + 2 ? 1.0 : 0.0);
    }
  }
  const double half_trace = (A[2] + A[7]) / 2.0, determinant = A[2] * A[7] - A[3] * A[6];
  const double root = std::sqrt(half_trace * half_trace - determinant);
  return {half_trace - root, half_trace + root};
}

/// Roots s = w^2 of det(K - s M) with cos(theta) = +-1: M2 d^2 ((K - s m)(+-g / d - s) - s^2 M2) = 0.
std::array<double, 2> squared_frequencies(double d, double cosine) {
  const double a = mass - M2, b = -(K + mass * cosine * g / d), c = K * cosine * g / d;
  const double root = std::sqrt(b * b - 4.0 * a * c);
  return {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};
}

// Squares up to 300 from entries up to 1e4, whose products cancel to some 1e4 of 1e5 at the worst.
constexpr double square_tolerance = 100 * 300 * rounding;

TEST(VibrationAbsorber, HangsStablyAndOscillatesWithItsTwoModes) {
  for (const double d : {tuned, 0.15}) {
    const auto linear = linearised(absorber(d), rest_at(X0, 0.0));
    EXPECT_NEAR(linear.F[0], 0.0, K * X0 * rounding);
    EXPECT_EQ(linear.F[1], 0.0);
    const auto found = squared_eigenvalues(linear);
    const auto expected = squared_frequencies(d, 1.0);
    EXPECT_LT(found[1], 0.0);  // all eigenvalues are imaginary: stable
    EXPECT_NEAR(found[0], -expected[1], square_tolerance);
    EXPECT_NEAR(found[1], -expected[0], square_tolerance);
  }
}

TEST(VibrationAbsorber, StandsUnstablyUpsideDown) {
  const auto linear = linearised(absorber(tuned), rest_at(X0, pi));
  // The double nearest pi misses it by 1.2e-16.
  EXPECT_NEAR(linear.F[1], 0.0, 2 * M2 * g * tuned * rounding);
  const auto found = squared_eigenvalues(linear);
  const auto expected = squared_frequencies(tuned, -1.0);
  EXPECT_GT(found[1], 1.0);  // a real positive eigenvalue: unstable
  EXPECT_NEAR(found[1], -expected[0], square_tolerance);
  EXPECT_NEAR(found[0], -expected[1], square_tolerance);
}

/// Amplitudes of (X - X0, theta) in the steady motion of the linearised equations.
std::array<double, 2> steady_amplitude(double d) {
  const auto linear = linearised(absorber(d), rest_at(X0, 0.0, pi / (2.0 * omega)));
  std::array<double, 4> a{};
  for (std::size_t i = 0; i < 4; ++i) a[i] = linear.K[i] - omega * omega * linear.M[i];
  const double determinant = a[0] * a[3] - a[1] * a[2];
  return {(a[3] * linear.F[0] - a[2] * linear.F[1]) / determinant,
          (a[0] * linear.F[1] - a[1] * linear.F[0]) / determinant};
}

// At omega^2 = g / d the pendulum balances the unbalance: X stands still and M2 d theta = -M3 R.
TEST(VibrationAbsorber, KeepsTheSupportStillWhenTuned) {
  const auto still = steady_amplitude(tuned);
  // g d - omega^2 d^2 cancels to two roundings of g d M2, which the determinant's other term, (omega^2 M2 d)^2,
  // divides.
  const double coupling = omega * omega * M2 * tuned;
  EXPECT_NEAR(still[0], 0.0, 4 * rounding * M2 * g * tuned * M3 * R * omega * omega / (coupling * coupling));
  EXPECT_NEAR(still[1], -M3 * R / (M2 * tuned), 20 * rounding);
  EXPECT_GT(std::abs(steady_amplitude(0.15)[0]), 1e-3);
}

double largest_displacement(double d) {
  Absorber::Parameters parameters = Absorber::default_parameters();
  parameters.d = d;
  const auto amplitude = steady_amplitude(d);
  StateVector<Absorber> y{X0, 0.0, omega * amplitude[0], omega * amplitude[1]};
  double largest = 0.0;
  const auto result = integrate(
      equations_of_motion<Absorber>(parameters), y, 0.0, 10.0,
      DormandPrince54{.relative_tolerance = 1e-10, .largest_step = 0.01},
      [&](double, const StateVector<Absorber>& state) { largest = std::max(largest, std::abs(state[0] - X0)); });
  EXPECT_TRUE(result) << describe(result);
  return largest;
}

// The full equations leave what linearisation neglects: theta^2 = 4e-4 of the forces, so some 1e-3 of the motion.
TEST(VibrationAbsorber, KeepsTheSupportStillInTheFullMotionToo) {
  const double detuned = largest_displacement(0.15);
  EXPECT_NEAR(detuned, std::abs(steady_amplitude(0.15)[0]), 0.01 * detuned);
  EXPECT_LT(largest_displacement(tuned), 0.01 * detuned);
}

// The answers by the runtime's search, without being told where the rests are.
TEST(VibrationAbsorber, RestsHangingOrUpsideDownAndNowhereElse) {
  for (const double d : {tuned, 0.15}) {
    const auto precomputed = absorber(d, 0.0);
    const CoordinateBox box{Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 5.0), {1}};
    const auto search = find_equilibria<Absorber>(precomputed, box);
    ASSERT_EQ(search.found.size(), 2U);
    for (const auto& rest : search.found) {
      EXPECT_NEAR(rest.state.q.X, X0, 1e-13);
      EXPECT_TRUE(rest.isolated);
      EXPECT_LE(rest.residual, 1e-12);
    }
    const auto& hanging = search.found[std::cos(search.found[0].state.q.theta) > 0.0 ? 0 : 1];
    const auto& upright = search.found[std::cos(search.found[0].state.q.theta) > 0.0 ? 1 : 0];
    EXPECT_NEAR(hanging.state.q.theta, 0.0, 1e-12);
    EXPECT_NEAR(upright.state.q.theta, pi, 1e-12);
    const LinearSystem about_hanging = linearised_at<Absorber>(precomputed, hanging);
    const LinearSystem about_upright = linearised_at<Absorber>(precomputed, upright);
    EXPECT_EQ(stability_by_lejeune_dirichlet(about_hanging).verdict, Stability::stable);
    EXPECT_EQ(stability_by_eigenvalues(about_hanging).verdict, Stability::cannot_conclude);
    EXPECT_EQ(stability_by_routh(about_hanging).verdict, Stability::cannot_conclude);
    EXPECT_EQ(stability_by_lejeune_dirichlet(about_upright).verdict, Stability::cannot_conclude);
    EXPECT_EQ(stability_by_eigenvalues(about_upright).verdict, Stability::unstable);
    EXPECT_EQ(stability_by_routh(about_upright).verdict, Stability::unstable);
    // The equations linearised where the search stopped, within 1e-12 rad: squares to 1e-10 and their own roundings.
    const NaturalModes modes = natural_modes(about_hanging);
    const auto squares = squared_frequencies(d, 1.0);
    EXPECT_NEAR(modes.squared_frequencies(0), squares[0], 1e-10);
    EXPECT_NEAR(modes.squared_frequencies(1), squares[1], 1e-10);
  }
}

// Between the resonances X vanishes at omega² = g / d, whatever the masses and the spring.
TEST(VibrationAbsorber, HasItsAntiresonanceAtThePendulumsOwnFrequency) {
  for (const double d : {tuned, 0.15}) {
    FoundState<Absorber> rest;
    rest.state = rest_at(X0, 0.0);
    const LinearSystem system = linearised_at<Absorber>(absorber(d), rest);
    const std::vector<double> still = antiresonances(system, Eigen::Vector2d(1.0, 0.0), 0);
    ASSERT_EQ(still.size(), 1U);
    EXPECT_NEAR(still[0], std::sqrt(g / d), 1e-12);
    const auto squares = squared_frequencies(d, 1.0);
    EXPECT_LT(squares[0], still[0] * still[0]);
    EXPECT_GT(squares[1], still[0] * still[0]);
    const auto amplitude = FrequencyResponse(system, Eigen::Vector2cd(1.0, 0.0))(still[0]);
    ASSERT_TRUE(amplitude);
    EXPECT_LE(std::abs((*amplitude)(0)), 1e-15);
  }
}

// The course's P_X begins with M1 X'' although its T holds all three masses; with M_11 = M1 alone the fast mode would
// lie where it does not.
TEST(VibrationAbsorber, MovesAllThreeMassesWithItsSupport) {
  FoundState<Absorber> rest;
  rest.state = rest_at(X0, 0.0);
  LinearSystem printed = linearised_at<Absorber>(absorber(tuned), rest);
  const double right = natural_modes(printed).squared_frequencies(1);
  printed.M(0, 0) = M1;
  EXPECT_NEAR(right, squared_frequencies(tuned, 1.0)[1], square_tolerance);
  EXPECT_GT(std::abs(natural_modes(printed).squared_frequencies(1) - right), 1.0);
}

// The motor that keeps the rotor's speed gives the torque M3 R (X'' cos φ + g sin φ), by the moment of the unbalance's
// inertia about the axle.
TEST(VibrationAbsorber, ObeysTheEnergyTheorem) {
  const auto motion = equations_of_motion<Absorber>();
  const auto motor = [](const Absorber::State& s, const Absorber::Accelerations& a, const auto&) {
    const double turned = omega * s.time;
    return omega * M3 * R * (a.X * std::cos(turned) + g * std::sin(turned));
  };
  const auto balance = examples::energy_balance<Absorber>(motion, 5.0, 1e-10, motor);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_GT(balance.work, 1e4 * balance.allowed);
}

// Steps of 1.5 ms whose local errors, below 1e-14 (1 + |y|), and roundings add up; the flow amplifies them little.
TEST(VibrationAbsorber, MeetsItsCommittedReference) {
  examples::expect_reference(equations_of_motion<Absorber>(), "vibration_absorber", {.error = 1e-13});
}

}  // namespace
}  // namespace torsor::vibration_absorber_test
