// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"

namespace taylor_test {
namespace {

using namespace torsor::runtime;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Simple pendulum, L = 1, g = 9.81, with its recurrences by hand: for s = sin θ, c = cos θ,
/// k s_k = Σ j θ_j c_(k-j), k c_k = -Σ j θ_j s_(k-j); (k + 1) θ_(k+1) = ω_k, (k + 1) ω_(k+1) = -g s_k.
template <class Scalar>
struct Pendulum {
  using Vector = std::array<Scalar, 2>;
  static constexpr Scalar g = Scalar(9.81L);

  Evaluation operator()(Scalar, const Vector& y, Vector& rate) const noexcept {
    rate = {y[1], -g * std::sin(y[0])};
    return Evaluation::ok;
  }
  Evaluation jets(Scalar, const Vector& y, std::span<Vector> c) const noexcept {
    std::array<Scalar, 31> s{}, cosine{};
    c[0] = y;
    s[0] = std::sin(y[0]);
    cosine[0] = std::cos(y[0]);
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      for (std::size_t j = 1; j <= k; ++j) {
        const Scalar part = static_cast<Scalar>(j) / static_cast<Scalar>(k) * c[j][0];
        s[k] += part * cosine[k - j];
        cosine[k] -= part * s[k - j];
      }
      c[k + 1] = {c[k][1] / static_cast<Scalar>(k + 1), -g * s[k] / static_cast<Scalar>(k + 1)};
    }
    return Evaluation::ok;
  }
};

/// y = t^9, whose coefficients at t = 0 vanish up to order 8: y' = 9 t^8.
struct NinthPower {
  using Vector = std::array<double, 1>;
  Evaluation operator()(double t, const Vector&, Vector& rate) const noexcept {
    rate[0] = 9.0 * std::pow(t, 8);
    return Evaluation::ok;
  }
  Evaluation jets(double t, const Vector& y, std::span<Vector> c) const noexcept {
    double binomial = 1.0;
    c[0] = y;
    for (std::size_t k = 1; k < c.size(); ++k) {
      binomial *= static_cast<double>(10 - static_cast<int>(k)) / static_cast<double>(k);
      c[k][0] = k <= 9 ? binomial * std::pow(t, 9 - static_cast<int>(k)) : 0.0;
    }
    return Evaluation::ok;
  }
};

// From (2, 0) at t = 10 (Jacobi's elliptic functions, 50 digits).
constexpr std::array<long double, 2> pendulum_end{0.015728632141428118626277592909L, 5.27089879322982860518148735035L};

template <class Scalar>
double distance_from_end(const std::array<Scalar, 2>& y) {
  return static_cast<double>(std::max(std::abs(y[0] - pendulum_end[0]), std::abs(y[1] - pendulum_end[1])));
}

Taylor of_tolerance(double tolerance) { return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance}; }

TEST(Taylor, MeetsItsToleranceAtEveryOrderOfMagnitude) {
  // Ten seconds of errors of a tolerance ε (1 + |y|), |y| up to 6.3, amplified by κ = 17.
  for (int digits = 3; digits <= 15; ++digits) {
    const double tolerance = std::pow(10.0, -digits);
    std::array<double, 2> y{2.0, 0.0};
    const auto result = integrate(Pendulum<double>(), y, 0, 10, of_tolerance(tolerance));
    EXPECT_TRUE(result) << describe(result);
    EXPECT_LT(distance_from_end(y), 10 * 7.3 * 17 * tolerance);
    // One for each attempt, and one more for each whose slopes disagree.
    EXPECT_GE(result.statistics.calls, 1 + result.statistics.accepted + 2 * result.statistics.rejected);
    if (digits < 14) {
      EXPECT_EQ(result.statistics.calls, 1 + result.statistics.accepted + 2 * result.statistics.rejected);
    }
  }
}

TEST(Taylor, HasTheOrderAskedFor) {
  // Steps limited from above only, a tolerance that never rejects: the error is proportional to h^order.
  const auto error_of = [](int order, double h) {
    std::array<long double, 2> y{2.0L, 0.0L};
    const Taylor method{
        .relative_tolerance = 1e9, .absolute_tolerance = 1.0, .order = order, .first_step = h, .largest_step = h};
    EXPECT_TRUE(integrate(Pendulum<long double>(), y, 0.0L, 10.0L, method));
    return distance_from_end(y);
  };
  for (const int order : {4, 6, 9}) {
    EXPECT_NEAR(std::log2(error_of(order, 1.0 / 64) / error_of(order, 1.0 / 128)), order, 0.35) << order;
  }
}

TEST(Taylor, RefusesAStepForWhichAllCoefficientsVanish) {
  // At t = 0 all coefficients up to order 8 are zero and say nothing against one step to the end.
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    std::array<double, 1> y{0.0};
    Taylor method = of_tolerance(tolerance);
    method.order = 8;
    const auto result = integrate(NinthPower(), y, 0, 1, method);
    EXPECT_TRUE(result) << describe(result);
    EXPECT_GT(result.statistics.rejected, 0);
    // At most 100 steps with a local error of twice the tolerance each.
    EXPECT_LE(result.statistics.accepted, 100);
    EXPECT_NEAR(y[0], 1.0, 200 * tolerance);
  }
}

TEST(Taylor, GivesTheStateInsideAStepToItsTolerance) {
  const double tolerance = 1e-10;
  // The same motion in many short steps; its own error is 1e-13 × 10 × 17.
  std::array<double, 2> y{2.0, 0.0}, z = y;
  std::array<std::array<double, 2>, 101> sharp{};
  std::size_t row = 0, steps = 0;
  const auto keep = [&](double, const std::array<double, 2>& state) noexcept { sharp[row++] = state; };
  std::array<double, 101> times{};
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 0.1 * static_cast<double>(i);
  ASSERT_TRUE(integrate_through(Pendulum<double>(), z, 0, times, of_tolerance(1e-14), keep));
  double largest = 0.0;
  const auto compare = [&](double t, const std::array<double, 2>& state) noexcept {
    const auto i = static_cast<std::size_t>(std::lround(10.0 * t));
    for (std::size_t k = 0; k < 2; ++k) largest = std::max(largest, std::abs(state[k] - sharp[i][k]));
    ++steps;
  };
  ASSERT_TRUE(integrate(Pendulum<double>(), y, 0, 10, of_tolerance(tolerance), EquallySpaced(0.0, 0.1, compare)));
  EXPECT_EQ(steps, 101U);
  EXPECT_LT(largest, 10 * 7.3 * 17 * tolerance);
}

TEST(Taylor, ComesBackWhenTimeRunsBackwards) {
  std::array<double, 2> y{2.0, 0.0};
  ASSERT_TRUE(integrate(Pendulum<double>(), y, 0, 10, of_tolerance(1e-13)));
  ASSERT_TRUE(integrate(Pendulum<double>(), y, 10, 0, of_tolerance(1e-13)));
  EXPECT_LT(std::max(std::abs(y[0] - 2.0), std::abs(y[1])), 2 * 10 * 7.3 * 17 * 1e-13);
}

TEST(Taylor, RestsInOneStep) {
  std::array<double, 2> y{0.0, 0.0};
  const auto result = integrate(Pendulum<double>(), y, 0, 1000, of_tolerance(1e-12));
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(result.statistics.accepted, 1);
  EXPECT_EQ(y[0], 0.0);
}

TEST(Taylor, RefusesUnusableOptions) {
  for (const int order : {-1, 3, 31}) {
    std::array<double, 2> y{2.0, 0.0};
    EXPECT_EQ(integrate(Pendulum<double>(), y, 0, 1, Taylor{.order = order}).status,
              IntegrationStatus::invalid_options);
  }
  std::array<double, 2> y{2.0, infinity};
  EXPECT_EQ(integrate(Pendulum<double>(), y, 0, 1, Taylor{}).status, IntegrationStatus::invalid_options);
}

/// A circular orbit in metres and seconds: x = r cos νt, y = r sin νt, with coefficients by the closed form.
struct Orbit {
  using Vector = std::array<double, 4>;
  static constexpr double radius = 1e11, speed = 3e4, frequency = speed / radius;

  static Evaluation jets(double, const Vector& y, std::span<Vector> c) noexcept {
    c[0] = y;
    // (x, v)' = (v, -ν² x) on the circle
    for (std::size_t k = 1; k < c.size(); ++k) {
      for (std::size_t i = 0; i < 2; ++i) {
        c[k][i] = c[k - 1][i + 2] / static_cast<double>(k);
        c[k][i + 2] = -frequency * frequency * c[k - 1][i] / static_cast<double>(k);
      }
    }
    return Evaluation::ok;
  }
  Evaluation operator()(double t, const Vector& y, Vector& rate) const noexcept {
    std::array<Vector, 2> c;
    (void)jets(t, y, c);
    rate = c[1];
    return Evaluation::ok;
  }
};

/// A pendulum, and beside it an angle that turns at a rate of 1 and that nothing depends on.
struct PendulumAndWheel {
  using Vector = std::array<double, 3>;
  static Evaluation jets(double t, const Vector& y, std::span<Vector> c) noexcept {
    std::array<std::array<double, 2>, 31> pendulum;
    (void)Pendulum<double>().jets(t, {y[0], y[2]}, std::span(pendulum).first(c.size()));
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = {pendulum[k][0], k == 1 ? 1.0 : 0.0, pendulum[k][1]};
    c[0] = y;
    return Evaluation::ok;
  }
  Evaluation operator()(double, const Vector& y, Vector& rate) const noexcept {
    rate = {y[2], 1.0, -Pendulum<double>::g * std::sin(y[0])};
    return Evaluation::ok;
  }
};

/// y' = sin t, which comes back to where it was from -t to t.
struct ToAndFro {
  using Vector = std::array<double, 1>;
  static Evaluation jets(double t, const Vector& y, std::span<Vector> c) noexcept {
    const std::array<double, 4> slopes{std::sin(t), std::cos(t), -std::sin(t), -std::cos(t)};
    double factorial = 1.0;
    c[0] = y;
    for (std::size_t k = 1; k < c.size(); ++k) {
      factorial *= static_cast<double>(k);
      c[k][0] = slopes[(k - 1) % 4] / factorial;
    }
    return Evaluation::ok;
  }
  Evaluation operator()(double t, const Vector&, Vector& rate) const noexcept {
    rate[0] = std::sin(t);
    return Evaluation::ok;
  }
};

/// A system whose second and third coefficient in one component are off.
template <class S>
struct WithFault : S {
  std::size_t component = 0;
  double second = 0.0, third = 0.0;
  Evaluation jets(double t, const typename S::Vector& y, std::span<typename S::Vector> c) const noexcept {
    (void)S::jets(t, y, c);
    if (c.size() > 2) c[2][component] += second;
    if (c.size() > 3) c[3][component] += third;
    return Evaluation::ok;
  }
};

/// One step over the whole interval is right without the fault, and refused with it.
template <class S>
void expect_fault_found(const WithFault<S>& faulty, const typename S::Vector& start, double from, double to) {
  const Taylor method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12, .order = 18, .first_step = to - from};
  typename S::Vector y = start;
  const auto right = integrate(static_cast<const S&>(faulty), y, from, to, method);
  EXPECT_TRUE(right) << describe(right);
  EXPECT_EQ(right.statistics.accepted, 1);
  EXPECT_EQ(right.statistics.rejected, 0);
  y = start;
  EXPECT_GT(integrate(faulty, y, from, to, method).statistics.rejected, 0);
}

// Faults that change h y' by 2 to 3e4 times what is allowed. Rounding changes these slopes by a few parts of 1e16 of
// themselves, whatever the other components' units and sizes.
TEST(Taylor, FindsAFaultOfAVelocityBesideAPositionOfAstronomicalSize) {
  // 2 c_2 h² = 1e-6 m/s of 19 × 1e-12 × 3e4 m/s allowed
  expect_fault_found(WithFault<Orbit>{{}, 3, 5e-17}, {Orbit::radius, 0.0, 0.0, Orbit::speed}, 0.0, 1e5);
}
TEST(Taylor, FindsAFaultOfAPendulumBesideAnAngleThatIsWoundUp) {
  // 2 c_2 h² = 8e-11 rad/s of at most 19 × 1e-12 (1 + 9.81 × 0.1) rad/s allowed
  expect_fault_found(WithFault<PendulumAndWheel>{{}, 2, 4e-11 / 0.01}, {2.0, 1e6, 0.0}, 0.0, 0.1);
}
TEST(Taylor, FindsAFaultOfASlopeWhereTheStateIsBackWhereItWas) {
  // (2 c_2 + 3 c_3 h) h = -1e-6 of 19 × 1e-12 × 1.9 allowed, while the state moves by 5e-10.
  const double end = 0.5 + 1e-9;
  expect_fault_found(WithFault<ToAndFro>{{}, 0, 1e-6, -1e-6}, {-std::cos(0.5)}, -0.5, end);
}

TEST(Taylor, DoesNotHoldTheRoundingOfAWoundAngleAgainstASlope) {
  // A million turns are known to 5e-10 rad, and the slopes that depend on them to 5e-9: fifty times what is allowed.
  std::array<double, 2> near{2.0, 0.0}, far{2.0 + 2e6 * 3.14159265358979324, 0.0};
  const Taylor method{.relative_tolerance = 0.0, .absolute_tolerance = 1e-12, .order = 18};
  const auto expected = integrate(Pendulum<double>(), near, 0, 10, method).statistics;
  const auto result = integrate(Pendulum<double>(), far, 0, 10, method);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_LE(result.statistics.accepted, expected.accepted + 2);
  EXPECT_LE(result.statistics.rejected, expected.rejected + 2);
}

TEST(Taylor, ReportsCoefficientsThatAreNotFinite) {
  const auto failing = [] {
    struct Failing : NinthPower {
      Evaluation jets(double t, const Vector& y, std::span<Vector> c) const noexcept {
        (void)NinthPower::jets(t, y, c);
        if (t > 0.5) c[1][0] = infinity;
        return Evaluation::ok;
      }
    };
    return Failing();
  }();
  std::array<double, 1> y{0.0};
  const auto result = integrate(failing, y, 0, 1, Taylor{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::not_finite);
  EXPECT_LE(result.time, 0.5);
  EXPECT_GT(result.time, 0.49);
}

// At rest with both rods horizontal: coefficients of orders divisible by 4 nearly vanish. Never a wrong answer.
template <class Method>
void expect_end_of_horizontal_rods(Method method, double tolerance) {
  using Mechanism = double_pendulum::Mechanism<double>;
  // At t = 20, by extrapolation of order 32 with 72 digits; κ = 9.4e5, the largest ∂y_i(20)/∂y_j(0).
  constexpr std::array<double, 4> end{0.7487609755149033159515944895772, -25.8324619988856107490477082164,
                                      4.078003969273397255604108576893, 2.779889455355823245354899486589};
  const auto motion = equations_of_motion<Mechanism>();
  std::array<double, 4> y{1.5707963267948966, 1.5707963267948966, 0.0, 0.0};
  method.relative_tolerance = tolerance;
  method.absolute_tolerance = tolerance;
  const auto result = integrate(motion, y, 0, 20, method);
  EXPECT_TRUE(result) << describe(result);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(std::abs(y[i] - end[i]), 100 * tolerance * 9.4e5) << tolerance;
  Mechanism::Energy e{};
  Mechanism::energy(motion.precomputed(), unpack<Mechanism>(0.0, y), {}, e);
  // It is zero at the start: a part of what the fall can give, 3 m g l.
  EXPECT_LE(std::abs(e.kinetic - e.force_function), 1e4 * tolerance * 3 * 9.81) << tolerance;
}

TEST(Taylor, IsNotFooledByADoublePendulumReleasedWithHorizontalRods) {
  for (int digits = 3; digits <= 15; ++digits) {
    for (const int order : {0, 8, 12, 15, 16, 20, 24}) {
      expect_end_of_horizontal_rods(Taylor{.order = order}, std::pow(10.0, -digits));
    }
  }
}

TEST(DormandPrince, AreNotFooledByADoublePendulumReleasedWithHorizontalRods) {
  for (int digits = 3; digits <= 15; ++digits) {
    expect_end_of_horizontal_rods(DormandPrince54{}, std::pow(10.0, -digits));
    expect_end_of_horizontal_rods(DormandPrince853{}, std::pow(10.0, -digits));
  }
}

// Largest relative error of the double pendulum's energy over 100 s from (2, 2.5), where the lower rod turns over.
double energy_error(const Taylor& method) {
  using Mechanism = double_pendulum::Mechanism<double>;
  const auto motion = equations_of_motion<Mechanism>();
  const auto energy = [&](const std::array<double, 4>& state) {
    Mechanism::Energy e{};
    Mechanism::energy(motion.precomputed(), unpack<Mechanism>(0.0, state), {}, e);
    return e.kinetic - e.force_function;
  };
  std::array<double, 4> y{2.0, 2.5, 0.0, 0.0};
  const double first = energy(y);
  double largest = 0.0;
  const auto within = angles_within_a_turn(motion, std::array<std::size_t, 2>{0, 1});
  const auto result = integrate(within, y, 0, 100, method, [&](double, const std::array<double, 4>& state) {
    largest = std::max(largest, std::abs(energy(state) / first - 1.0));
    EXPECT_LE(std::max(std::abs(state[0]), std::abs(state[1])), 3.1415926535897936);
  });
  EXPECT_TRUE(result) << describe(result);
  return largest;
}

// The series itself, without a method that would make up for wrong coefficients by short steps: each coefficient takes
// all convolutions below it.
TEST(TaylorCoefficients, AreThoseOfTheMotionOfADoublePendulum) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  using Vector = std::array<double, 4>;
  const Vector start{1.1, -0.4, 2.0, -3.0};
  constexpr int order = 14;
  std::array<Vector, order + 1> c{};
  ASSERT_EQ(motion.jets(0.0, start, std::span<Vector>(c)), Evaluation::ok);
  for (const double h : {0.015, -0.015}) {
    Vector y = start, sum = c[order];
    ASSERT_TRUE(integrate(motion, y, 0, h, DormandPrince853{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14}));
    for (int k = order; k-- > 0;) {
      for (std::size_t i = 0; i < 4; ++i) sum[i] = sum[i] * h + c[static_cast<std::size_t>(k)][i];
    }
    // The last term kept is below a rounding of the state; the reference takes some steps at 1e-14 of numbers to 4.
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(std::abs(c[order][i] * std::pow(h, order)), 1e-15);
      EXPECT_NEAR(sum[i], y[i], 10 * 1e-14 * 4) << i << " at " << h;
    }
  }
}

TEST(Taylor, KeepsTheEnergyOfAChaoticMotionToRounding) {
  // Some 4,000 steps whose errors of 1e-15 in y change E by up to |v| 1e-15 = 1e-14 each, with either sign:
  // sqrt(4000) × 1e-14 / 16 = 4e-14.
  EXPECT_LT(energy_error({.relative_tolerance = 0.0, .absolute_tolerance = 1e-15, .compensated = true}), 4e-14);
}

}  // namespace
}  // namespace taylor_test
