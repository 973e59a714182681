// SPDX-License-Identifier: GPL-3.0-or-later
// How long the steps of the adaptive methods are, against theory. Along z' = i z, a rotation, the weighted error of a
// step is the same wherever it begins, so that a step control settles at one length, which these tests compute from the
// tableau in complex numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/steps/accumulated_state.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/step_control.hpp"

namespace step_lengths_test {
namespace {

using namespace torsor::runtime;
using Complex = std::complex<double>;
constexpr Complex i{0.0, 1.0};

constexpr auto rotation = [](double, const std::array<double, 2>& z, std::array<double, 2>& rate) noexcept {
  rate = {-z[1], z[0]};
  return Evaluation::ok;
};

/// |E5|² h / sqrt((|E5|² + |E3|²/100) 2) in units of the tolerance, from |z| = 1 (Hairer-Nørsett-Wanner I, (10.17)).
double error_853(double h, double tolerance) {
  using T = DormandPrinceTableau853;
  std::array<Complex, T::slopes> k{i};
  const auto combined = [&](std::size_t row) {
    Complex sum = 0.0;
    for (std::size_t j = 0; j < T::slopes; ++j) sum += static_cast<double>(T::weights[row][j]) * k[j];
    return sum;
  };
  for (std::size_t row = 0; row < 11; ++row) k[row + 1] = i * (1.0 + h * combined(row));
  Complex third = combined(T::solution);
  for (std::size_t j = 0; j < 3; ++j) third -= static_cast<double>(T::third_order[j]) * k[T::third_order_slopes[j]];
  const double e5 = std::norm(combined(T::fifth_order)) / (tolerance * tolerance);
  const double e3 = std::norm(third) / (tolerance * tolerance);
  return h * e5 / std::sqrt(2 * (e5 + 0.01 * e3));
}

/// |difference of the embedded solutions| / (tolerance sqrt 2) (Hairer-Nørsett-Wanner I, II.4 (4.11)).
double error_54(double h, double tolerance) {
  using T = DormandPrinceTableau<double>;
  const Complex k1 = i, k2 = i * (1.0 + h * (T::a21 * k1)), k3 = i * (1.0 + h * (T::a31 * k1 + T::a32 * k2)),
                k4 = i * (1.0 + h * (T::a41 * k1 + T::a42 * k2 + T::a43 * k3)),
                k5 = i * (1.0 + h * (T::a51 * k1 + T::a52 * k2 + T::a53 * k3 + T::a54 * k4)),
                k6 = i * (1.0 + h * (T::a61 * k1 + T::a62 * k2 + T::a63 * k3 + T::a64 * k4 + T::a65 * k5)),
                k7 = i * (1.0 + h * (T::a71 * k1 + T::a73 * k3 + T::a74 * k4 + T::a75 * k5 + T::a76 * k6));
  const Complex e = h * (T::e1 * k1 + T::e3 * k3 + T::e4 * k4 + T::e5 * k5 + T::e6 * k6 + T::e7 * k7);
  return std::abs(e) / (tolerance * std::sqrt(2.0));
}

/// The step at which the error is this one; it grows with the step below 1.
template <class Error>
double length_of(const Error& error, double tolerance, double wanted) {
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (error(middle, tolerance) < wanted ? low : high) = middle;
  }
  return low;
}

/// Steps over 3000 rad: of two hundred turns of the control at most ten steps belong to the start and the end.
template <class Method>
void expect_steps(Method method, double length) {
  std::array<double, 2> z{1.0, 0.0};
  const double end = 3000.0;
  const auto result = integrate(rotation, z, 0.0, end, method);
  ASSERT_TRUE(result) << describe(result);
  const auto steps = static_cast<double>(result.statistics.accepted);
  EXPECT_NEAR(steps, end / length, 10 + 0.002 * steps);
  EXPECT_LE(result.statistics.rejected, 5);
}

TEST(StepLengths, Of853SettleWhereTheErrorIsTheSafetyToTheEighth) {
  // h ← 0.8 h / err^(1/8) stays where err = 0.8^8.
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    expect_steps(DormandPrince853{.relative_tolerance = 0.0, .absolute_tolerance = tolerance},
                 length_of(error_853, tolerance, std::pow(0.8, 8)));
  }
}

TEST(StepLengths, Of54SettleWhereTheProportionalIntegralControlDoes) {
  // h ← 0.9 h err^-0.17 err'^0.04 stays where err^0.13 = 0.9 (Hairer-Wanner II, IV.2 (2.43c) with β = 0.04).
  for (const double tolerance : {1e-5, 1e-8}) {
    expect_steps(DormandPrince54{.relative_tolerance = 0.0, .absolute_tolerance = tolerance},
                 length_of(error_54, tolerance, std::pow(0.9, 1 / 0.13)));
  }
}

TEST(StepLengths, FollowTheSizeOfTheStateWithARelativeTolerance) {
  // A state a million times as long, a tolerance relative to it: the same steps. Components pass through zero, where a
  // relative tolerance alone would ask for too much: the absolute one is scaled too.
  const auto steps_of = [](double size) {
    std::array<double, 2> z{size, 0.0};
    const auto result = integrate(rotation, z, 0.0, 300.0,
                                  DormandPrince853{.relative_tolerance = 1e-9, .absolute_tolerance = size * 1e-9});
    EXPECT_TRUE(result) << describe(result);
    return result.statistics.accepted;
  };
  EXPECT_EQ(steps_of(1.0), steps_of(0x1p20));
}

// The same rotation about (1024, 1024): each component is within a thousandth of 1024, so that a relative tolerance ε
// is an absolute one of 1024 ε, to as much. Steps grow with its eighth root.
TEST(StepLengths, CountComponentsByTheirSize) {
  constexpr double centre = 1024.0, relative = 1e-9, end = 3000.0;
  const auto about = [](double, const std::array<double, 2>& z, std::array<double, 2>& rate) noexcept {
    rate = {centre - z[1], z[0] - centre};
    return Evaluation::ok;
  };
  std::array<double, 2> z{centre + 1.0, centre};
  const auto result =
      integrate(about, z, 0.0, end, DormandPrince853{.relative_tolerance = relative, .absolute_tolerance = 0.0});
  ASSERT_TRUE(result) << describe(result);
  const double steps = end / length_of(error_853, centre * relative, std::pow(0.8, 8));
  EXPECT_NEAR(static_cast<double>(result.statistics.accepted), steps, 10 + 0.002 * steps);
}

// Along z' = i ω z from 1 with an absolute tolerance ε, norms are d0 = 1/(ε √2), d1 = ω d0, d2 = ω² d0, exactly since f
// is linear, and h = (0.01/max(d1, d2))^(1/order) below 100 · 0.01/ω (Hairer-Nørsett-Wanner I, II.4 (4.14)).
TEST(StartingStep, TakesTheSteeperOfSlopeAndBend) {
  struct {
    double omega;
    bool operator()(double, const std::array<double, 2>& z, std::array<double, 2>& rate) const noexcept {
      rate = {-omega * z[1], omega * z[0]};
      return true;
    }
  } turning{0.0};
  for (const double omega : {10.0, 0.1}) {
    for (const int order : {4, 5, 8}) {
      turning.omega = omega;
      const double tolerance = 1e-6;
      const std::array<double, 2> y{1.0, 0.0}, slope{0.0, omega};
      const StepsAhead<double, 2> ahead{.range = {0.0, -1e3, 1e3}, .y = y, .tolerances = {0.0, tolerance}};
      const double h = starting_step(turning, ahead, slope, order);
      const double steepest = std::max(omega, omega * omega) / (tolerance * std::sqrt(2.0));
      // Some ten roundings of the norms, under a root.
      EXPECT_NEAR(h, std::pow(0.01 / steepest, 1.0 / order), 1e-14 * h);
    }
  }
}

// A state that settles by one part of 2^`bits` in its only component.
struct Settling {
  int bits;
  bool settle(float, std::array<float, 1>& y) const noexcept {
    y[0] += std::ldexp(y[0], -bits);
    return true;
  }
};

// 1024 increments of a quarter of a rounding, each tried twice: 1 + 2^-15, which float holds.
TEST(AccumulatedState, ForgetsWhatARefusedStepLost) {
  std::array<float, 1> y{1.0F};
  AccumulatedState<float, 1> state(y, true);
  for (int k = 0; k < 1024; ++k) {
    state.propose({0x3p-25F});  // which loses a rounding too
    state.propose({0x1p-25F});
    state.accept();
  }
  EXPECT_EQ(y[0], 1.0F + 0x1p-15F);
}

TEST(AccumulatedState, IsMovedByMoreThanRoundingsWhereSumsAreCompensated) {
  for (const bool compensated : {false, true}) {
    for (const int bits : {23, 10}) {
      std::array<float, 1> y{1.0F};
      AccumulatedState<float, 1> state(y, compensated);
      state.propose({0x1p-25F});
      const Settling settling{bits};
      EXPECT_TRUE(state.settle(settling, 0.0F));
      EXPECT_EQ(state.next()[0], compensated && bits == 23 ? 1.0F : 1.0F + std::ldexp(1.0F, -bits));
    }
  }
}

// Knuth's exact sum in both halves: state + increment = sum + rest, seen exactly because double holds any such sum of
// floats. Increments above and below the state, of both signs.
TEST(CompensatedState, KeepsExactlyWhatASumLoses) {
  std::uint32_t draw = 1;
  for (int k = 0; k < 20000; ++k) {
    const auto next = [&] {
      draw = draw * 1664525U + 1013904223U;
      return static_cast<float>(static_cast<std::int32_t>(draw)) * 0x1p-31F;
    };
    const float state = next(), increment = std::ldexp(next(), k % 25 - 12);
    CompensatedState<float, 1> compensated;
    const float sum = compensated.add(0, state, increment);
    EXPECT_EQ(sum, state + increment);
    EXPECT_EQ(static_cast<double>(sum) + static_cast<double>(compensated.rest[0]),
              static_cast<double>(state) + static_cast<double>(increment));
  }
}

}  // namespace
}  // namespace step_lengths_test
