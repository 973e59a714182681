// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "generated/torque_free_body.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"
#include "torsor/runtime/steps/narrow_system.hpp"
#include "tests/runtime/mechanisms.hpp"

// Compensated sums of the state, and derivatives narrower than the state.
namespace accuracy_of_sums_test {
namespace {

using namespace torsor::runtime;

TEST(CompensatedSums, KeepRoundingFromAddingUp) {
  // 2^15 steps of a tolerance far below rounding: y = 1 + Σ of terms that lose 1e-17 to 1e-16 each in a plain sum, a
  // random walk of some 180 × 3e-17 to 1e-16; compensated, the end is right to the rounding of y itself, 2.3e-16, and
  // that of the increments, 2^-53 × |y - 1| relative to each, at most.
  const auto system = [](double t, const std::array<double, 1>&, std::array<double, 1>& rate) noexcept {
    rate[0] = std::cos(t);
    return Evaluation::ok;
  };
  const auto error_of = [&](bool compensated) {
    std::array<double, 1> y{1.0};
    const DormandPrince853 method{
        .relative_tolerance = 1e-9, .first_step = 0x1p-15, .largest_step = 0x1p-15, .compensated = compensated};
    EXPECT_TRUE(integrate(system, y, 0, 1, method));
    return std::abs(static_cast<double>(static_cast<long double>(y[0]) - 1.0L - std::sin(1.0L)));
  };
  EXPECT_GT(error_of(false), 1e-15);
  EXPECT_LE(error_of(true), 2.3e-16);
}

TEST(CompensatedSums, KeepRoundingOfFixedStepsFromAddingUp) {
  // As above, with 2^16 steps; the method's own error is h^4/2880 = 2e-23.
  const auto system = [](double t, const std::array<double, 1>&, std::array<double, 1>& rate) noexcept {
    rate[0] = std::cos(t);
    return Evaluation::ok;
  };
  const auto error_of = [&](bool compensated) {
    std::array<double, 1> y{1.0};
    EXPECT_TRUE(integrate(system, y, 0, 1, RungeKutta4{.step = 0x1p-16, .compensated = compensated}));
    return std::abs(static_cast<double>(static_cast<long double>(y[0]) - 1.0L - std::sin(1.0L)));
  };
  EXPECT_GT(error_of(false), 1e-15);
  EXPECT_LE(error_of(true), 2.3e-16);
}

// Largest error of the pendulum's energy over g L, from 2 rad at rest, in 10^5 steps of 1e-3.
template <class Scalar, class System>
double energy_error(const System& system) {
  std::array<Scalar, 2> y{Scalar(2), Scalar(0)};
  double largest = 0.0;
  const auto watch = [&](Scalar, const std::array<Scalar, 2>& state) noexcept {
    const double angle = static_cast<double>(state[0]), rate = static_cast<double>(state[1]);
    largest = std::max(largest, std::abs(rate * rate / 2 / 9.81 - std::cos(angle) + std::cos(2.0)));
  };
  EXPECT_TRUE(integrate(system, y, Scalar(0), Scalar(100), RungeKutta4{.step = 1e-3}, watch));
  return largest;
}

TEST(NarrowSystem, KeepsTheStateBeyondItsOwnPrecision) {
  const auto in_float = equations_of_motion<mechanisms::Pendulum<float>>();
  // In float rounding moves the state by 3e-8 |v|, at most 1.6e-7, a step, E/(g L) by |v| 1.6e-7/9.81 = 8e-8, 10^5
  // times at random: 3e-5. With the state in double it is h |f| 3e-8 = 3e-10, and 5e-8 in all.
  EXPECT_GT(energy_error<float>(in_float), 3e-6);
  EXPECT_LT(energy_error<double>(narrow_system<float>(in_float)), 5e-7);
}

TEST(NarrowSystem, RefusesATolerancePastItsNoise) {
  const auto motion = narrow_system<float>(equations_of_motion<mechanisms::Pendulum<float>>());
  const auto status_of = [&](const auto& method) {
    std::array<double, 2> y{2.0, 0.0};
    return integrate(motion, y, 0, 10, method).status;
  };
  EXPECT_EQ(status_of(DormandPrince54{1e-7, 1e-7}), IntegrationStatus::invalid_options);
  EXPECT_EQ(status_of(DormandPrince853{1e-9, 1e-9}), IntegrationStatus::invalid_options);
  EXPECT_EQ(status_of(DormandPrince54{1e-6, 1e-6}), IntegrationStatus::reached_end);
}

/// Stands still; its projection, in float, takes the state to 1 or, from below zero, finds no way.
struct KeptAtOne {
  Evaluation operator()(float, const std::array<float, 1>&, std::array<float, 1>& rate) const noexcept {
    rate[0] = 0.0F;
    return Evaluation::ok;
  }
  [[nodiscard]] Evaluation project(float, std::array<float, 1>& y) const noexcept {
    if (y[0] < 0.0F) return Evaluation::singular;
    y[0] = 1.0F;
    return Evaluation::ok;
  }
};

TEST(NarrowSystem, PassesOnAProjectionThatTakesTheTime) {
  const auto motion = narrow_system<float>(KeptAtOne{});
  std::array<double, 1> y{1.25};  // a float, and so its way to 1
  EXPECT_TRUE(integrate(motion, y, 0, 1, RungeKutta4{.step = 0.5}));
  EXPECT_EQ(y[0], 1.0);
  y[0] = -1.25;
  const auto result = integrate(motion, y, 0, 1, RungeKutta4{.step = 0.5});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
}

/// Grows as y' = y, with two Taylor coefficients; its projection leaves a state as it is.
struct GrowsInFloat {
  Evaluation operator()(float, const std::array<float, 1>& y, std::array<float, 1>& rate) const noexcept {
    rate = y;
    return Evaluation::ok;
  }
  Evaluation jets(float, const std::array<float, 1>& y, std::span<std::array<float, 1>> c) const noexcept {
    for (auto& coefficient : c) coefficient = y;
    return Evaluation::ok;
  }
  [[nodiscard]] Evaluation project(float, std::array<float, 1>&) const noexcept { return Evaluation::ok; }
};

// 1 + 2^-40 is no float.
TEST(NarrowSystem, LeavesTheStateItsDigits) {
  const auto motion = narrow_system<float>(GrowsInFloat{});
  const std::array<double, 1> fine{1.0 + 0x1p-40};
  std::array<double, 1> y = fine;
  EXPECT_EQ(motion.project(0.0, y), Evaluation::ok);
  EXPECT_EQ(y, fine);
  std::array<std::array<double, 1>, 2> c;
  EXPECT_EQ(motion.jets(0.0, fine, std::span<std::array<double, 1>>(c)), Evaluation::ok);
  EXPECT_EQ(c[0], fine);
  EXPECT_EQ(c[1][0], 1.0);
}

TEST(NarrowSystem, MeetsATolerancePossibleForIt) {
  // From 2 rad at t = 10 (Jacobi's elliptic functions); 10 s of 1e-6 (1 + |y|), |y| to 6.3, amplified by κ = 17.
  const auto motion = narrow_system<float>(equations_of_motion<mechanisms::Pendulum<float>>());
  std::array<double, 2> y{2.0, 0.0};
  EXPECT_TRUE(integrate(motion, y, 0, 10, DormandPrince54{1e-6, 1e-6}));
  EXPECT_LT(std::max(std::abs(y[0] - 0.015728632141428118), std::abs(y[1] - 5.270898793229829)), 10 * 7.3 * 17e-6);
}

/// x'' = -10^6 (x' + x): after its first microseconds x is exp(-t), to 1e-6.
struct Stiff {
  template <class Number>
  Evaluation operator()(const Number&, const std::array<Number, 2>& y, std::array<Number, 2>& rate) const noexcept {
    rate = {y[1], Number(-1e6) * y[1] - Number(1e6) * y[0]};
    return Evaluation::ok;
  }
};

template <class System>
JacobianMatrix<double, 2> jacobian_of(const System& system, const std::array<double, 2>& y) {
  CheckedSystem<const System, double, 2> f(system);
  std::array<double, 2> slope{};
  JacobianMatrix<double, 2> J{};
  EXPECT_TRUE(f(0.0, y, slope) && evaluate_jacobian(f, 0.0, y, slope, J));
  return J;
}

// Differences of what is computed in float are taken over steps that float sees: 0.1 % of 10^6, not zeros and noise.
TEST(NarrowSystem, HasAJacobianByDifferencesOfItsOwn) {
  const JacobianMatrix<double, 2> J = jacobian_of(narrow_system<float>(Stiff{}), {1.3, -0.7});
  EXPECT_NEAR(J[0], 0.0, 1e-3);
  EXPECT_NEAR(J[1], -1e6, 1e3);
  EXPECT_NEAR(J[2], 1.0, 1e-3);
  EXPECT_NEAR(J[3], -1e6, 1e3);
  const auto within = angles_within_a_turn(narrow_system<float>(Stiff{}), std::array<std::size_t, 0>{});
  EXPECT_EQ(jacobian_of(within, {1.3, -0.7}), J);
}

TEST(NarrowSystem, TakesTheStepsOfAnImplicitMethodThatDoubleTakes) {
  const RadauIia5 method{.relative_tolerance = 1e-5, .absolute_tolerance = 1e-5};
  std::array<double, 2> y{1.0, 0.0}, narrow = y;
  const auto in_double = integrate(Stiff{}, y, 0, 5, method);
  const auto in_float = integrate(narrow_system<float>(Stiff{}), narrow, 0, 5, method);
  ASSERT_TRUE(in_double && in_float);
  EXPECT_LT(in_float.statistics.accepted, 2 * in_double.statistics.accepted);
  EXPECT_NEAR(narrow[0], std::exp(-5.0), 1e-5);
}

/// y' = -y with a Jacobian of its own, which counts as such: twice the true one.
struct DoublesItsSlope {
  Evaluation operator()(float, const std::array<float, 1>& y, std::array<float, 1>& rate) const noexcept {
    rate[0] = -y[0];
    return Evaluation::ok;
  }
  Evaluation jacobian(float, const std::array<float, 1>&, std::array<float, 1>& J) const noexcept {
    J[0] = -2.0F;
    return Evaluation::ok;
  }
};

TEST(NarrowSystem, PassesOnAJacobian) {
  const auto motion = narrow_system<float>(DoublesItsSlope{});
  std::array<double, 1> J{};
  EXPECT_EQ(motion.jacobian(0.0, std::array<double, 1>{1.0}, J), Evaluation::ok);
  EXPECT_EQ(J[0], -2.0);
}

// Unit quaternions under every method with compensated sums: the norm stays within a few roundings.
template <class Motion, class Method>
double norm_error(const Motion& motion, const Method& method) {
  auto y = equations_of_motion<torque_free_body::Mechanism<double>>().initial();
  double largest = 0.0;
  const auto watch = [&](double, const auto& state) noexcept {
    double square = 0.0;
    for (std::size_t i = 0; i < 4; ++i) square += state[i] * state[i];
    largest = std::max(largest, std::abs(square - 1.0));
  };
  EXPECT_TRUE(integrate(motion, y, 0.0, 20.0, method, watch));
  return largest;
}

TEST(Quaternions, KeepTheirNormUnderEveryExplicitMethod) {
  // The scale is right to 1.5 roundings, each product to half of one: 2^-53 × (2 × 1.5 + 4) for the sum of the squares.
  // Compensated sums leave corrections below four roundings of a component undone: up to 2 × 4 × 2^-52 more for two.
  constexpr double rounded = 7 * 0x1p-53, undone = rounded + 16 * 0x1p-52;
  const auto motion = equations_of_motion<torque_free_body::Mechanism<double>>();
  EXPECT_LE(norm_error(motion, DormandPrince853{}), rounded);
  EXPECT_LE(norm_error(motion, Taylor{}), rounded);
  EXPECT_LE(norm_error(motion, RungeKutta4{.step = 0.01}), rounded);
  EXPECT_LE(norm_error(motion, DormandPrince853{.compensated = true}), undone);
  EXPECT_LE(norm_error(motion, Taylor{.compensated = true}), undone);
  const auto narrow = narrow_system<float>(equations_of_motion<torque_free_body::Mechanism<float>>());
  EXPECT_LE(norm_error(narrow, DormandPrince54{1e-6, 1e-6}), rounded);
}

}  // namespace
}  // namespace accuracy_of_sums_test
