// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that steps are made of, each by itself: interpolants, the polynomial through a guard, the clock, and what
// runs do at the times of their steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "torsor/runtime/events/step_scan.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/steps/gauss_step.hpp"
#include "torsor/runtime/steps/step_clock.hpp"
#include "torsor/runtime/steps/step_polynomial.hpp"
#include "torsor/runtime/steps/taylor_rule.hpp"
#include "torsor/runtime/steps/whole_step.hpp"

namespace steps_test {
namespace {

using namespace torsor::runtime;
using One = std::array<double, 1>;

constexpr double cubic(double t) { return 2.0 - 3.0 * t + 0.5 * t * t + 1.5 * t * t * t; }
constexpr double slope_of_cubic(double t) { return -3.0 + t + 4.5 * t * t; }

// The one cubic through two states and two slopes is the cubic itself, forwards and backwards. Values up to 40 from
// terms up to as much: some ten roundings of 40.
TEST(HermiteStep, IsTheCubicOfBothEnds) {
  for (const double from : {-1.0, 3.0}) {
    const double to = 2.0 - from;
    const One y{cubic(from)}, next{cubic(to)}, slope{slope_of_cubic(from)}, last{slope_of_cubic(to)};
    const HermiteStep<double, 1> step{from, to, y, next, slope, last};
    const GaussStep<double, 1, 1> gauss(from, to, y, next, slope, {}, last);
    for (const double t : {-1.0, -0.3, 0.0, 1.1, 2.7, 3.0}) {
      EXPECT_NEAR(step(t)[0], cubic(t), 1e-13) << t;
      EXPECT_NEAR(gauss(t)[0], cubic(t), 1e-13) << t;
    }
  }
}

using Polynomial = StepPolynomial<double>;
template <class Function>
Polynomial through(const Function& function) {
  Polynomial::Values values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = function(Polynomial::places[i]);
  return Polynomial(values);
}

// With the roots 0.1, 0.3, 0.5, 0.7, 0.9 and others outside, and its derivative by the product rule. The coefficients
// of Bernstein's form grow to some hundred times the values (see step_polynomial.hpp): 1e-13 of these.
template <std::size_t degree>
void expect_exact(const std::array<double, degree>& roots) {
  const auto value = [&](double x) {
    double product = 1.0;
    for (const double root : roots) product *= x - root;
    return product;
  };
  const auto slope = [&](double x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < degree; ++k) {
      double product = 1.0;
      for (std::size_t j = 0; j < degree; ++j) product *= j == k ? 1.0 : x - roots[j];
      sum += product;
    }
    return sum;
  };
  const Polynomial polynomial = through(value);
  // The last two Chebyshev coefficients, which tell that nothing is missing, are those of degrees 7 and 8.
  EXPECT_EQ(polynomial.resolved(), degree <= 6);
  const double rounding = 1e-13 * polynomial.largest();
  for (double x = 0.0; x <= 1.0; x += 0.01) {
    EXPECT_NEAR(polynomial.value(x), value(x), rounding);
    EXPECT_NEAR(polynomial.slope(x), slope(x), 16 * rounding);  // differences of coefficients, times eight
    EXPECT_GE(value(x), polynomial.least() - rounding);
  }
  // Descartes: as many sign changes as roots inside, or some even number more.
  const int changes = polynomial.sign_changes(1.0, 0.0);
  EXPECT_GE(changes, 5);
  EXPECT_EQ(changes % 2, 1);
  EXPECT_EQ(polynomial.sign_changes(-1.0, 0.0), changes);
}

TEST(StepPolynomial, IsAPolynomialOfDegreeEightItself) {
  expect_exact<6>({0.1, 0.3, 0.5, 0.7, 0.9, -1.0});
  expect_exact<8>({0.1, 0.3, 0.5, 0.7, 0.9, -1.0, 2.0, 3.0});
}

// What it says of itself where it is not the function: no difference is larger.
TEST(StepPolynomial, KnowsHowFarItIsFromAFunction) {
  const auto expect = [](const auto& function) {
    const Polynomial polynomial = through(function);
    double largest = 0.0;
    for (double x = 0.0; x <= 1.0; x += 0.001) largest = std::max(largest, std::abs(polynomial.value(x) - function(x)));
    EXPECT_GT(largest, 1e-12);
    EXPECT_GE(polynomial.error(), largest);
    EXPECT_FALSE(polynomial.resolved());
    // Above zero only where it is by more than that.
    EXPECT_FALSE(polynomial.stays_above(1.0, polynomial.error() / 2 - polynomial.least()));
    EXPECT_TRUE(polynomial.stays_above(1.0, polynomial.error() * 2 - polynomial.least()));
  };
  for (const int degree : {9, 10, 11}) {
    expect([degree](double x) { return std::cos(degree * std::acos(std::clamp(2 * x - 1, -1.0, 1.0))); });
  }
  expect([](double x) { return std::exp(5 * x); });
  expect([](double x) { return std::abs(x - 0.3); });
}

// y = 1 + h c_1 + ... with c_k = k: the polynomial and its slope at h, summed from the other end.
TEST(TaylorPolynomial, IsSummedWithItsSlope) {
  std::array<One, 7> c;
  for (std::size_t k = 0; k < c.size(); ++k) c[k][0] = static_cast<double>(k);
  for (const double h : {0.5, -1.5}) {
    One increment, slope;
    evaluate_taylor(c, h, increment, slope);
    double sum = 0.0, of_slope = 0.0, power = 1.0;
    for (int k = 1; k <= 6; ++k) {
      of_slope += k * k * power;
      power *= h;
      sum += k * power;
    }
    EXPECT_DOUBLE_EQ(increment[0], sum);
    EXPECT_DOUBLE_EQ(slope[0], of_slope);
  }
}

// Coefficients a^k of a pole at 1/a, from 1 with an absolute tolerance ε: h = 0.95 ε^(1/(p+1))/a (see Taylor).
TEST(TaylorRule, TakesTheStepAtWhichTheNextTermMeetsTheTolerance) {
  for (const int order : {4, 10, 20}) {
    for (const double a : {0.25, 3.0}) {
      TaylorRule<double, 1> rule(order);
      rule.start({1.0}, {0.0, 1e-8});
      const auto coefficients = [a](std::size_t k) { return One{std::pow(a, static_cast<double>(k))}; };
      const double h = rule.first(coefficients, StepRange<double>{0.0, 1e9, 1e9});
      EXPECT_NEAR(h, 0.95 * std::pow(1e-8, 1.0 / (order + 1)) / a, 1e-13 * h);
    }
  }
}

// A defect of 1e-12 where sixteen roundings of the slope are 3.6e-15, of a state a thousand times as large or not.
TEST(TaylorRule, HoldsADefectAgainstAStepWhateverTheStatesSize) {
  TaylorRule<double, 1> rule(9);
  rule.start({1.0}, {0.0, 1e-13});
  const double defect = (1.0 + 1e-12) - 1.0, rounding = 16 * 0x1p-52 * (1.0 + 1e-12);
  const One of_polynomial{1.0 + 1e-12}, of_equations{1.0}, none{0.0};
  const EndSlopes<double, 1> slopes{.polynomial = of_polynomial, .equations = of_equations, .noise = none};
  for (const double state : {1.0, 1e3}) {
    const double error = rule.disagreement(1.0, slopes, {state}, {state});
    EXPECT_NEAR(error, (defect - rounding) / (10 * 1e-13), 1e-12);
  }
}

// A step cut to a tenth by the end of an interval, with an error that would let it grow two times: the next is as long
// as was planned.
TEST(StepControl, RemembersWhatWasPlannedBeforeTheEnd) {
  StepControl<double, DormandPrince54::Gains> control;
  EXPECT_EQ(control.longer(0.1, 0.01, 1.0, false), 1.0);
  EXPECT_LE(control.longer(0.1, 0.01, 0.1, true), 0.1);  // none grows after a refusal
}

TEST(StepClock, GoesExactlyAsFarAsItSays) {
  StepClock<double> clock(0.25);
  clock.result.time = 1e6;
  clock.length = 0.1;
  ASSERT_TRUE(clock.plan(1e6 + 1, 10));
  EXPECT_EQ(clock.h, clock.t_next - 1e6);
  EXPECT_NE(clock.h, 0.1);  // which is no difference of two numbers of this size
  clock.keep(0.7);
  EXPECT_EQ(clock.length, 0.25);  // the longest allowed
  EXPECT_EQ(clock.result.time, clock.t_next);
  clock.length = 0.895;
  ASSERT_TRUE(clock.plan(1e6 + 1, 10));  // 0.9 is left: one step, to the end itself
  EXPECT_EQ(clock.t_next, 1e6 + 1);
  EXPECT_FALSE(clock.plan(1e6 + 1, 1));  // one was kept
  EXPECT_EQ(clock.result.status, IntegrationStatus::too_many_steps);
}

// q'' = cos t from v = 1: v(t_n) = 1 + h (1/2 + Σ cos t_k + cos(t_n)/2) = 1 + h/2 sin(t_n)/tan(h/2), a sum of
// Lagrange's. Compensated, the end is right to half a last place of v, 1.1e-16, and to what cos rounds, 2.2e-16 × 0.84
// at most; a plain sum of 2^16 steps walks 256 × 6e-17 away.
struct PulledInTime {
  static constexpr bool second_order = true;
  Evaluation operator()(double t, const std::array<double, 2>& y, std::array<double, 2>& rate) const noexcept {
    rate = {y[1], std::cos(t)};
    return Evaluation::ok;
  }
};
TEST(CompensatedSums, KeepRoundingOfStoermerVerletFromAddingUp) {
  std::array<double, 2> y{0.0, 1.0};
  const double h = 0x1p-16;
  ASSERT_TRUE(integrate(PulledInTime{}, y, 0.0, 1.0, StoermerVerlet{.step = h}));
  const long double half = static_cast<long double>(h) / 2;
  const long double change = half * std::sin(1.0L) / std::tan(half);
  EXPECT_LE(std::abs(static_cast<double>(static_cast<long double>(y[1]) - 1.0L - change)), 4e-16);
}

// A driven coordinate: project writes its value for the time that it is told.
struct Driven {
  static constexpr bool second_order = true;
  Evaluation operator()(double, const std::array<double, 2>& y, std::array<double, 2>& rate) const noexcept {
    rate = {y[1], -y[0]};
    return Evaluation::ok;
  }
  Evaluation project(double t, std::array<double, 2>& y) const noexcept {
    y[1] = t;
    return Evaluation::ok;
  }
};
TEST(Settling, HappensAtTheTimeOfTheState) {
  const auto expect = [](const auto& method) {
    std::array<double, 2> y{1.0, 0.0};
    EXPECT_TRUE(integrate(Driven{}, y, 0.0, 1.0, method,
                          [](double t, const std::array<double, 2>& at) { EXPECT_EQ(at[1], t); }));
  };
  // With steps of powers of two the time of a state is its start and its length.
  expect(DormandPrince54{.relative_tolerance = 1e3, .first_step = 0.125, .largest_step = 0.125});
  expect(DormandPrince853{.relative_tolerance = 1e3, .first_step = 0.125, .largest_step = 0.125});
  expect(Midpoint{.step = 0.125});
  expect(RungeKutta4{.step = 0.125});
  expect(GaussCollocation<2>{.step = 0.125});
  expect(StoermerVerlet{.step = 0.125});
}

constexpr auto growing = [](double t, const One&, One& rate) noexcept {
  rate[0] = t;
  return t < 0.55 ? Evaluation::ok : Evaluation::singular;
};

TEST(FixedStep, TakesTimesThatRoundingDoesNotAddUpIn) {
  std::vector<double> times;
  const auto always = [](double, const One&, One& rate) noexcept {
    rate[0] = 1.0;
    return Evaluation::ok;
  };
  One y{0.0};
  EXPECT_TRUE(
      integrate(always, y, 0.0, 100.0, RungeKutta4{.step = 0.1}, [&](double t, const One&) { times.push_back(t); }));
  ASSERT_EQ(times.size(), 1001U);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_EQ(times[k], static_cast<double>(k) * 0.1);
}

TEST(FixedStep, CountsTheStepsOfAllIntervalsAgainstItsLimit) {
  const std::vector<double> times{0.1, 0.2, 0.3, 0.4, 0.5};
  One y{0.0};
  const auto result =
      integrate_through(growing, y, 0.0, times, RungeKutta4{.step = 0.05, .step_limit = 7}, [](double, const One&) {});
  EXPECT_EQ(result.status, IntegrationStatus::too_many_steps);
  EXPECT_EQ(result.statistics.accepted, 6);  // of two more only one would be left
  EXPECT_EQ(result.time, 0.3);
}

TEST(IntegrateThrough, ShowsNoTimeThatWasNotReached) {
  const std::vector<double> times{0.2, 0.4, 0.6, 0.8};
  std::vector<double> seen;
  One y{0.0};
  const auto result = integrate_through(growing, y, 0.0, times, RungeKutta4{.step = 0.1},
                                        [&](double t, const One&) { seen.push_back(t); });
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(seen, (std::vector<double>{0.2, 0.4}));
}

TEST(RepeatedStep, IsNoNumberWhereTheModelFailsInside) {
  const auto fails_later = [](double t, const std::array<double, 1>&, std::array<double, 1>& rate) noexcept {
    rate[0] = 2.0;
    return t > 0.5 ? Evaluation::singular : Evaluation::ok;
  };
  const RungeKutta4 method{.step = 0.125};
  const std::array<double, 1> first{1.0}, last{3.0};
  std::int64_t calls = 0;
  const RepeatedStep<decltype(fails_later), RungeKutta4, double, 1> step{fails_later, method, 0.0, 1.0, first, last,
                                                                         calls};
  EXPECT_EQ(step(0.0), first);
  EXPECT_EQ(step(1.0), last);
  EXPECT_EQ(step(0.25)[0], 1.5);
  EXPECT_EQ(calls, 8);
  EXPECT_TRUE(std::isnan(step(0.75)[0]));
}

// Below zero, but within the band, until 0.6; above until 0.9: there it leaves, and not at the start nor at 0.6.
TEST(FirstDeparture, IsTheLastZeroBeforeTheValueBeyondTheBand) {
  const auto guard = [](double t) { return (t - 0.6) * (0.9 - t) * (0.01 + t * t); };
  for (const bool backwards : {false, true}) {
    const auto f = [&](double t) { return guard(backwards ? 1 - t : t); };
    const double start = backwards ? 1.0 : 0.0, end = 1.0 - start, zero = backwards ? 1 - 0.9 : 0.9;
    Polynomial::Values values;
    for (std::size_t j = 0; j < Polynomial::samples; ++j) {
      values[j] = f(start + static_cast<double>(Polynomial::places[j]) * (end - start));
    }
    const auto departure = first_departure<double>(f, {.start = start, .end = end, .band = 0.025, .values = values});
    ASSERT_TRUE(departure.found && departure.finite);
    // The slope is 0.25: a rounding of the three factors there is four of the time.
    EXPECT_NEAR(departure.before, zero, 16 * std::numeric_limits<double>::epsilon());
    EXPECT_NEAR(departure.after, zero, 16 * std::numeric_limits<double>::epsilon());
  }
}

// A foot that starts at rest on the ground, with rounding of 1e-17, and falls: where it leaves the band is buried in its
// noise, and every shortest part of that stretch was looked at once (22,528 values, five times over).
TEST(FirstDeparture, IsTheStartForWhatFallsOutOfNoise) {
  std::size_t calls = 0;
  const auto f = [&](double t) {
    ++calls;
    const double since = t - 0.159;
    return -500 * since * since - 1e-17 * (2 + std::sin(1e15 * t));
  };
  const double start = 0.159, end = 0.159168;
  Polynomial::Values values;
  for (std::size_t j = 0; j < Polynomial::samples; ++j) {
    values[j] = f(start + static_cast<double>(Polynomial::places[j]) * (end - start));
  }
  calls = 0;
  const auto departure = first_departure<double>(f, {.start = start, .end = end, .band = 1e-14, .values = values});
  ASSERT_TRUE(departure.found && departure.finite);
  EXPECT_EQ(departure.before, start);
  EXPECT_EQ(departure.after, start);
  EXPECT_EQ(calls, 0U);
}

}  // namespace
}  // namespace steps_test
