// SPDX-License-Identifier: GPL-3.0-or-later
// Every integrator, and the solution of the equations of motion, at the ends of their ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/numerics/linear_solve.hpp"

namespace stress_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 2>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// q'' = -k q - c q³: an oscillator, and where c is not zero one that overflows from 1e103 on.
struct Spring {
  static constexpr bool second_order = true, accelerations_depend_on_velocities = false;
  double k = 1.0, c = 0.0;
  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -k * y[0] - c * y[0] * y[0] * y[0]};
    return Evaluation::ok;
  }
  Evaluation jets(double t, const State& y, std::span<State> a) const noexcept {
    a[0] = y;
    (*this)(t, y, a[1]);
    for (std::size_t n = 2; n < a.size(); ++n) {
      double cube = 0.0;
      for (std::size_t i = 0; i < n && c != 0.0; ++i) {
        for (std::size_t j = 0; i + j < n; ++j) cube += a[i][0] * a[j][0] * a[n - 1 - i - j][0];
      }
      a[n] = {a[n - 1][1] / static_cast<double>(n), (-k * a[n - 1][0] - c * cube) / static_cast<double>(n)};
    }
    return Evaluation::ok;
  }
};

/// Calls check(name, method) with each method, at this tolerance or with this step.
template <class Check>
void with_every_method(double relative, double absolute, double step, const Check& check) {
  const auto adaptive = [&](auto method) {
    method.relative_tolerance = relative;
    method.absolute_tolerance = absolute;
    method.step_limit = 100'000;
    return method;
  };
  check("Dormand-Prince 5(4)", adaptive(DormandPrince54{}));
  check("Dormand-Prince 8(5,3)", adaptive(DormandPrince853{}));
  check("Taylor", adaptive(Taylor{}));
  check("Radau IIA", adaptive(RadauIia5{}));
  check("Runge-Kutta 4", RungeKutta4{.step = step});
  check("midpoint", Midpoint{.step = step});
  check("Stoermer-Verlet", StoermerVerlet{.step = step});
  check("Gauss", GaussCollocation<3>{.step = step});
  check("Gauss, Newton", GaussCollocation<3, StageSolver::newton>{.step = step});
}

TEST(EveryIntegrator, RefusesStatesAndTimesThatAreNoNumbers) {
  with_every_method(1e-9, 1e-9, 0.1, [](const std::string& name, const auto& method) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite}) {
      for (const std::size_t i : {0U, 1U}) {
        State y{1.0, 0.0};
        y[i] = bad;
        EXPECT_EQ(integrate(Spring{}, y, 0, 1, method).status, IntegrationStatus::invalid_options) << name;
      }
      State y{1.0, 0.0};
      EXPECT_EQ(integrate(Spring{}, y, 0, bad, method).status, IntegrationStatus::invalid_options) << name;
      EXPECT_EQ(y, (State{1.0, 0.0})) << name;
    }
  });
}

TEST(EveryIntegrator, ReportsWhatOverflowsAndLeavesTheLastGoodState) {
  // The cube of 1e150 is infinite at once; from 1e100 only what the step reaches is.
  with_every_method(1e-9, 1e-9, 0.1, [](const std::string& name, const auto& method) {
    for (const double size : {1e150, 1e100}) {
      State y{size, size};
      const auto result = integrate(Spring{.k = 1.0, .c = 1.0}, y, 0, 1, method);
      EXPECT_NE(result.status, IntegrationStatus::reached_end) << name << " " << size;
      EXPECT_TRUE(all_finite(y)) << name << " " << size;
    }
  });
}

// The oscillator is linear: from a state s times as large the motion is s times as large, if the tolerance is too.
TEST(EveryIntegrator, IsRightAtStatesOfAnySize) {
  for (const double size : {1e150, 1e-150, 1e-290}) {
    with_every_method(1e-9, 1e-9 * size, 0.01, [size](const std::string& name, const auto& method) {
      State y{size, 0.0};
      const auto result = integrate(Spring{}, y, 0, 3, method);
      ASSERT_TRUE(result) << name << " " << size << ": " << describe(result);
      // 1e-9 a step, three hundred at most; the midpoint rule's phase, h²/6 a second.
      EXPECT_NEAR(y[0] / size, std::cos(3.0), 1e-9 * 300 + 3 * 0.01 * 0.01 / 6) << name << " " << size;
      EXPECT_NEAR(y[1] / size, -std::sin(3.0), 1e-9 * 300 + 3 * 0.01 * 0.01 / 6) << name << " " << size;
    });
  }
}

// Denormal numbers have no relative precision left: an absolute error of some of their units remains, or a status.
TEST(EveryIntegrator, KeepsDenormalStatesFinite) {
  with_every_method(1e-9, 1e-12, 0.01, [](const std::string& name, const auto& method) {
    for (const double size : {1e-310, 5e-324}) {
      State y{size, -size};
      const auto result = integrate(Spring{}, y, 0, 3, method);
      EXPECT_TRUE(result) << name << " " << size << ": " << describe(result);
      EXPECT_TRUE(all_finite(y)) << name;
      EXPECT_LT(std::max(std::abs(y[0]), std::abs(y[1])), 1e-300) << name;
    }
  });
}

struct Swing {
  static constexpr bool second_order = true, accelerations_depend_on_velocities = false;
  double L;
  /// θ' = ω, ω' = -g/L s with s' = c ω and c' = -s ω, s and c the sine and the cosine of θ.
  Evaluation jets(double, const State& y, std::span<State> a) const noexcept {
    std::array<double, Taylor::largest_order + 1> s{std::sin(y[0])}, c{std::cos(y[0])};
    a[0] = y;
    for (std::size_t n = 1; n < a.size(); ++n) {
      const double over = 1.0 / static_cast<double>(n);
      for (std::size_t k = 0; k < n; ++k) {
        s[n] += over * c[n - 1 - k] * a[k][1];
        c[n] -= over * s[n - 1 - k] * a[k][1];
      }
      a[n] = {over * a[n - 1][1], -over * 9.81 / L * s[n - 1]};
    }
    return Evaluation::ok;
  }
  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -9.81 / L * std::sin(y[0])};
    return Evaluation::ok;
  }
};
// A pendulum of any length is the same in its own time, t √(g/L).
TEST(EveryIntegrator, TakesLengthsFromMicrometresToThousandsOfKilometres) {
  // From 2 rad at rest, θ is zero after a quarter of the period, √(L/g) K(sin 1), and its rate -2 sin 1 √(g/L).
  for (const double L : {1e-6, 1e-3, 1e3, 1e6}) {
    const double unit = std::sqrt(L / 9.81), quarter = unit * std::comp_ellint_1(std::sin(1.0));
    const auto expect = [&](const auto& method, double allowed) {
      State y{2.0, 0.0};
      const auto result = integrate(Swing{L}, y, 0, quarter, method);
      ASSERT_TRUE(result) << L << ": " << describe(result);
      EXPECT_NEAR(y[0], 0.0, allowed) << L;
      EXPECT_NEAR(y[1] * unit, -2 * std::sin(1.0), allowed) << L;
    };
    // Tolerances are per unit of each component; the smaller of the two sizes, 1 and 1/unit, sets the scale. A hundred
    // steps, growing less than ten times.
    const double tolerance = 1e-11 * std::min(1.0, 1.0 / unit), allowed = 1e-11 * 100 * 10;
    expect(DormandPrince54{.relative_tolerance = 1e-11, .absolute_tolerance = tolerance}, allowed);
    expect(DormandPrince853{.relative_tolerance = 1e-11, .absolute_tolerance = tolerance}, allowed);
    expect(Taylor{.relative_tolerance = 1e-11, .absolute_tolerance = tolerance}, allowed);
    expect(RadauIia5{.relative_tolerance = 1e-11, .absolute_tolerance = tolerance}, allowed);
    expect(GaussCollocation<4>{.step = quarter / 30}, allowed);
    // Order 2: θ is wrong by (h/unit)²/24 times the time of 2 in that unit, times rates of 2.
    expect(StoermerVerlet{.step = quarter / 300}, std::pow(2.0 / 300, 2) / 24 * 2 * 2 * 2);
    // In its own time the swing y' = f has |f| ≤ 2 and derivatives of f below 1, takes 2.08 < 2.1, and an error grows
    // by exp 2.1 at most. A step of the midpoint method errs by h³ |f''(f,f)/24 + f'f'f/6| ≤ h³/2, one of order 4 by
    // h⁵: its nine coefficients have the norm 0.0145 (Dormand & Prince 1980), the differentials are below 2⁴.
    const double h = 2.1 / 300, growth = 2.1 * std::exp(2.1);
    expect(Midpoint{.step = quarter / 300}, h * h / 2 * growth);
    expect(RungeKutta4{.step = quarter / 300}, std::pow(h, 4) * growth);
  }
}

struct Mixed {
  static constexpr bool second_order = true;
  double r;
  Evaluation operator()(double, const std::array<double, 4>& y, std::array<double, 4>& dydt) const noexcept {
    const double slow = y[0] + y[1], fast = y[0] - y[1], fast_rate = y[2] - y[3];
    const double pull = -slow, push = -r * fast - 2 * std::sqrt(r) * fast_rate;
    dydt = {y[2], y[3], (pull + push) / 2, (pull - push) / 2};
    return Evaluation::ok;
  }
};
// A slow and a damped stiff mode, ratio of stiffness r, mixed by a turn of 45°: the slow motion is cos t, the fast one
// dies out, e^(-√r t)(1 + √r t) where damping is critical.
TEST(RadauIia5, TakesRatiosOfStiffnessUpToAHundredMillion) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max(), most = 0;
  for (const double r : {1e4, 1e6, 1e8}) {
    std::array<double, 4> y{1.0, 0.0, 0.0, 0.0};  // slow 1, fast 1
    const auto result =
        integrate(Mixed{r}, y, 0, 10, RadauIia5{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9});
    ASSERT_TRUE(result) << r << ": " << describe(result);
    const double steps = static_cast<double>(result.statistics.accepted);
    EXPECT_NEAR(y[0] + y[1], std::cos(10.0), 1e-9 * 2 * steps) << r;
    EXPECT_NEAR(y[2] + y[3], -std::sin(10.0), 1e-9 * 2 * steps) << r;
    EXPECT_NEAR(y[0] - y[1], 0.0, 1e-9) << r;
    least = std::min(least, result.statistics.accepted);
    most = std::max(most, result.statistics.accepted);
  }
  EXPECT_LT(most, 2 * least);  // the stiffness costs the transient only
}

// A unit ball turned about two axes a small angle e apart: M = (1, cos e; cos e, 1), 1 - cos² e = sin² e. The error of
// a backward stable solution is cond(M) ε = 4 ε/e²; where M has lost its rank to rounding it says so.
TEST(SolveDynamics, TakesNearlyParallelAxesOrSaysThatTheyAreParallel) {
  bool refused = false;
  for (int power = 1; power <= 12; ++power) {
    const double e = std::pow(10.0, -power), c = std::cos(e);
    const std::array<double, 4> mass{1.0, c, c, 1.0};
    std::array<double, 2> a{};
    const Evaluation evaluation = solve_dynamics(mass, std::array<double, 2>{1.0, 0.0}, a);
    if (evaluation == Evaluation::ok) {
      EXPECT_FALSE(refused) << "an angle smaller than one that was refused";
      const long double wide = c, rest = (1.0L - wide) * (1.0L + wide);  // exact for this matrix
      const double first = static_cast<double>(1.0L / rest), second = static_cast<double>(-wide / rest);
      EXPECT_NEAR(a[0], first, 16 * epsilon / static_cast<double>(rest) * first) << e;
      EXPECT_NEAR(a[1], second, 16 * epsilon / static_cast<double>(rest) * first) << e;
    } else {
      EXPECT_EQ(evaluation, Evaluation::singular);
      EXPECT_LE(e, 1e-7);
      refused = true;
    }
  }
  EXPECT_TRUE(refused);
}

// A mass r hung from a mass 1: M = (1 + r, r c; r c, r), det = r (1 + r s²), s and c of the angle between.
TEST(SolveDynamics, TakesMassRatiosFromTrillionthsToTrillions) {
  for (int power = -12; power <= 12; ++power) {
    for (const double angle : {0.1, 0.8, 1.5}) {
      const double r = std::pow(10.0, power), c = std::cos(angle);
      const std::array<double, 4> mass{1.0 + r, r * c, r * c, r};
      std::array<double, 2> a{};
      ASSERT_EQ(solve_dynamics(mass, std::array<double, 2>{1.0, r}, a), Evaluation::ok) << power;
      // Of the very numbers in the matrix; scaled to a unit diagonal its condition is 2/(1 - c² r/(1 + r)).
      const long double m11 = mass[0], m12 = mass[1], m22 = mass[3], det = m11 * m22 - m12 * m12;
      const double first = static_cast<double>((m22 - m12 * m22) / det);
      const double second = static_cast<double>((m11 * m22 - m12) / det);
      const double condition = 2 / (1 - c * c * r / (1 + r)), size = std::max(std::abs(first), std::abs(second));
      EXPECT_NEAR(a[0], first, 16 * epsilon * condition * std::max(size, 1.0)) << power << " " << angle;
      EXPECT_NEAR(a[1], second, 16 * epsilon * condition * std::max(size, 1.0)) << power << " " << angle;
    }
  }
}

TEST(SolveDynamics, ReportsWhatIsNoNumberOrNoMass) {
  std::array<double, 2> a{};
  const std::array<double, 2> force{1.0, 1.0};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite}) {
    EXPECT_EQ(solve_dynamics(std::array<double, 4>{bad, 0.0, 0.0, 1.0}, force, a), Evaluation::not_finite);
    EXPECT_EQ(solve_dynamics(std::array<double, 4>{1.0, bad, bad, 1.0}, force, a), Evaluation::not_finite);
    EXPECT_EQ(solve_dynamics(std::array<double, 4>{1.0, 0.0, 0.0, 1.0}, std::array<double, 2>{bad, 0.0}, a),
              Evaluation::not_finite);
  }
  EXPECT_EQ(solve_dynamics(std::array<double, 4>{0.0, 0.0, 0.0, 1.0}, force, a), Evaluation::singular);
  EXPECT_EQ(solve_dynamics(std::array<double, 4>{1.0, 1.0, 1.0, 1.0}, force, a), Evaluation::singular);
  EXPECT_EQ(solve_dynamics(std::array<double, 4>{-1.0, 0.0, 0.0, 1.0}, force, a), Evaluation::singular);
}

TEST(EveryIntegrator, KeepsItsToleranceUnderEveryRounding) {
  with_every_method(1e-10, 1e-10, 0.01, [](const std::string& name, const auto& method) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      State y{1.0, 0.0}, nearest = y;
      std::fesetround(mode);
      const auto result = integrate(Spring{}, y, 0, 10, method);
      std::fesetround(FE_TONEAREST);
      ASSERT_TRUE(result) << name << ": " << describe(result);
      ASSERT_TRUE(integrate(Spring{}, nearest, 0, 10, method));
      // A thousand steps, each to the tolerance or to some ulps of a side.
      const double allowed = name.find("Dormand") == 0 || name == "Taylor" || name == "Radau IIA" ? 1e-7 : 1e-11;
      EXPECT_NEAR(y[0], nearest[0], allowed) << name;
      EXPECT_NEAR(y[1], nearest[1], allowed) << name;
    }
  });
}

// A state that grows from 1e-6 to 1e6 against an absolute tolerance of 1e-9: the order follows it.
TEST(Taylor, ChoosesItsOrderAnewWhereTheStateHasOutgrownIt) {
  struct Growth {
    Evaluation operator()(double, const std::array<double, 1>& y, std::array<double, 1>& dydt) const noexcept {
      dydt[0] = y[0];
      return Evaluation::ok;
    }
    Evaluation jets(double, const std::array<double, 1>& y, std::span<std::array<double, 1>> c) const noexcept {
      c[0] = y;
      for (std::size_t k = 1; k < c.size(); ++k) c[k][0] = c[k - 1][0] / static_cast<double>(k);
      return Evaluation::ok;
    }
  };
  std::array<double, 1> y{1e-6};
  std::size_t first = 0, last = 0, least = 100, most = 0;
  const double end = std::log(1e12);
  const auto result = integrate(Growth{}, y, 0, end, Taylor{.relative_tolerance = 0.0, .absolute_tolerance = 1e-9},
                                [&](const auto& step) requires requires { step.coefficients(); } {
                                  last = step.coefficients().size() - 1;
                                  first = first == 0 ? last : first;
                                  least = std::min(least, last);
                                  most = std::max(most, last);
                                });
  ASSERT_TRUE(result) << describe(result);
  // 1 - 0.55 ln of 1e-9/1e-6 is 4.8, of 1e-9/1e6 20; four less is left as it is.
  EXPECT_EQ(first, 6U);
  EXPECT_GE(last, 16U);
  EXPECT_EQ(least, first);
  EXPECT_EQ(most, last);
  // An error of 1e-9 made at the size y grows to 1e-9 · 1e6/y: at the start, by 1e12.
  EXPECT_NEAR(y[0], 1e6, 1e-9 * 1e12 * 2);
}

}  // namespace
}  // namespace stress_test
