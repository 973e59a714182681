// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/extrapolation.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/base/error_of.hpp"

namespace torsor::extrapolation_test {
namespace {

using Vector = std::vector<Real>;

Real decimal(const char* text) { return Real::parse(text, 60); }
Real place(int digits) { return Real(Number(10).pow(-digits), 60); }

using testing_errors::error_of;

Vector oscillator(const Real&, const Vector& y) { return {y[1], -y[0]}; }

/// Two point masses 1 on massless rods of length 1, g = 9.81, absolute angles from the downward vertical. With
/// d = θ1 − θ2 Lagrange's equations read 2θ̈1 + θ̈2 cos d = −ω2² sin d − 2g sin θ1, θ̈1 cos d + θ̈2 = ω1² sin d − g sin θ2.
Vector double_pendulum(const Real&, const Vector& y) {
  const Real g(Number::rational(981, 100), Real::working_digits());
  Real sine, cosine;
  sincos(y[0] - y[1], sine, cosine);
  const Real first = -(y[3] * y[3] * sine) - (g + g) * sin(y[0]);
  const Real second = y[2] * y[2] * sine - g * sin(y[1]);
  const Real determinant = Real(2) - cosine * cosine;
  return {y[2], y[3], (first - cosine * second) / determinant, (second + second - cosine * first) / determinant};
}

TEST(Extrapolation, FollowsTheHarmonicOscillatorTo45Digits) {
  ExtrapolationOptions options;
  options.tolerance_digits = 48;
  options.work_digits = 65;
  const std::vector<Real> times{decimal("0.5"), decimal("3"), decimal("10")};
  const auto states = integrate({oscillator, {Real(0), Real(1)}}, times, options);
  ASSERT_EQ(states.size(), times.size());
  for (std::size_t index = 0; index < times.size(); ++index) {
    // Some tens of steps of local error below 1e-48 (and in truth that of one order more): below 1e-45 together.
    EXPECT_LT(abs(states[index][0] - sin(times[index])), place(45));
    EXPECT_LT(abs(states[index][1] - cos(times[index])), place(45));
  }
}

TEST(Extrapolation, ReturnsToItsStartBackwards) {
  ExtrapolationOptions options;
  options.tolerance_digits = 40;
  const Real start = decimal("2"), end = decimal("-1");
  const auto states = integrate({oscillator, {sin(start), cos(start)}, start}, {start, decimal("0"), end}, options);
  EXPECT_EQ(states[0][0], sin(start).with_digits(options.work_digits));
  EXPECT_LT(abs(states[1][0]), place(37));
  EXPECT_LT(abs(states[2][0] - sin(end)), place(37));
  EXPECT_LT(abs(states[2][1] - cos(end)), place(37));
}

TEST(Extrapolation, ErrsLessWithATighterTolerance) {
  // y' = 2ty, y = exp t²: the right-hand side depends on both arguments.
  const auto f = [](const Real& t, const Vector& y) { return Vector{(t + t) * y[0]}; };
  const Real e = decimal("2.71828182845904523536028747135266249775724709369995957496697");
  Real previous;
  for (const int digits : {10, 20, 30, 40}) {
    ExtrapolationOptions options;
    options.tolerance_digits = digits;
    const Real error = abs(integrate({f, {Real(1)}}, {Real(1)}, options)[0][0] - e);
    EXPECT_LT(error, place(digits - 2)) << digits;  // a few steps, each amplified by at most e
    if (digits > 10) {
      EXPECT_LT(error, previous);
    }
    previous = error;
  }
}

TEST(Extrapolation, MeetsTheReferenceOfTheDoublePendulum) {
  ExtrapolationOptions options;
  options.tolerance_digits = 40;
  const auto solution = integrate_converged({double_pendulum, {decimal("2"), decimal("2.5"), Real(0), Real(0)}},
                                            {decimal("0.5"), decimal("1")}, options);
  // An independent computation (mpmath, 50 digits, two orders agreeing to 2e-37), printed to 30 decimals.
  const Vector expected{decimal("-0.083860420405000849725678156866"), decimal("-1.31309645061392503987080693396"),
                        decimal("-4.64791767807525574632648678289"), decimal("-4.39024103608530359320551716559")};
  for (std::size_t index = 0; index < expected.size(); ++index) {
    EXPECT_LT(abs(solution.values[1][index] - expected[index]), place(29)) << index;  // half its last decimal is 5e-30
  }
  // The reference ends at its 30th digit; beyond it, two integrations of different order and tolerance agree. The error
  // grows 8.5-fold in this second and the looser run aims at 1e-37.
  EXPECT_GE(solution.worst_agreed_digits, 35);
  EXPECT_GE(solution.agreed_digits[0], solution.worst_agreed_digits);
  // Energy −2g cos θ1 − g cos θ2 + ω1² + ω2²/2 + ω1 ω2 cos(θ1 − θ2), by hand, at the start and at the end: independent
  // of the reference and good to all 35 digits (gradient of some 30 times 1e-38).
  const auto energy = [](const Vector& y) {
    const Real g(Number::rational(981, 100), 60);
    return y[2] * y[2] + y[3] * y[3] / Real(2) + y[2] * y[3] * cos(y[0] - y[1]) -
           g * (cos(y[0]) + cos(y[0]) + cos(y[1]));
  };
  const Real start = energy({decimal("2"), decimal("2.5"), Real(0), Real(0)});
  EXPECT_LT(abs(energy(solution.values[1]) - start), place(35));
  EXPECT_LT(abs(start - decimal("16.0240198015703533754089510373")), place(27));
}

TEST(Extrapolation, CountsAgreeingDigitsPerTime) {
  ExtrapolationOptions options;
  options.tolerance_digits = 20;
  options.work_digits = 40;
  const auto solution = integrate_converged({oscillator, {Real(0), Real(1)}}, {Real(0), Real(1)}, options);
  EXPECT_EQ(solution.agreed_digits[0], 40);  // the initial state itself: no difference at all
  EXPECT_LT(solution.agreed_digits[1], 40);  // two orders do not agree to the last bit
  EXPECT_GE(solution.agreed_digits[1], 16);
  EXPECT_EQ(solution.worst_agreed_digits, solution.agreed_digits[1]);
}

/// y' = c with another c in each run: (1, 2) and (1 + 3e-10, 2 + 3e-10) at t = 1. They share what 3e-10 leaves of each:
/// nine digits of 1 and of 2, and as far as both agree, nine.
TEST(Extrapolation, CountsTheDigitsThatTwoRunsShare) {
  int runs = 0;
  const DifferentialEquation different = [&runs](const Real& t, const Vector& y) {
    if (t.is_zero()) ++runs;  // a run evaluates its start once
    const Real slope = runs == 1 ? Real(1) : decimal("1.0000000003");
    return Vector(y.size(), slope);
  };
  const ConvergedSolution solution = integrate_converged({different, {Real(0), Real(1)}}, {Real(1)}, {});
  ASSERT_EQ(runs, 2);
  EXPECT_EQ(solution.shared_digits[0], (std::vector<int>{9, 9}));
  EXPECT_EQ(solution.agreed_digits[0], 9);
  EXPECT_EQ(solution.worst_agreed_digits, 9);
}

TEST(Extrapolation, StopsAtASingularityAndNamesTheTime) {
  // y' = y² from 1 is 1/(1 − t): no solution at t = 1.
  const auto f = [](const Real&, const Vector& y) { return Vector{y[0] * y[0]}; };
  ExtrapolationOptions options;
  options.columns = 6;
  options.tolerance_digits = 10;
  options.work_digits = 25;
  options.maximum_step_count = 2000;
  const std::string message = error_of([&] { integrate({f, {Real(1)}}, {Real(2)}, options); });
  EXPECT_NE(message.find("stops at t = 1.0000000: the step has become "), std::string::npos) << message;
}

TEST(Extrapolation, ShortensAStepThatLeavesTheDomain) {
  // y' = −√y (1 + y) from 1, y = tan²(π/4 − t/2): a long trial step makes y negative, where the root is not a number.
  int undefined_count = 0;
  const auto f = [&undefined_count](const Real&, const Vector& y) {
    const Vector slope{-(sqrt(y[0]) * (Real(1) + y[0]))};
    if (slope[0].is_nan()) ++undefined_count;
    return slope;
  };
  ExtrapolationOptions options;
  options.tolerance_digits = 15;
  options.work_digits = 40;
  const Real end = decimal("1.5");
  const Real y = integrate({f, {Real(1)}}, {end}, options)[0][0];
  const Real angle = Real::pi(60) / Real(4) - end / Real(2);
  const Real tangent = sin(angle) / cos(angle);
  EXPECT_LT(abs(y - tangent * tangent), place(13));  // a contracting equation, a few steps of 1e-15
  EXPECT_GT(undefined_count, 0);
}

TEST(Extrapolation, NamesTheTimeWhereTheRightHandSideIsUndefined) {
  const auto f = [](const Real& t, const Vector&) { return Vector{sqrt(Real(1) - t)}; };
  EXPECT_EQ(error_of([&] { integrate({f, {Real(0)}, decimal("1.5")}, {decimal("2")}, {}); }),
            "the extrapolation integration stops at t = 1.5000000: the right-hand side is not a number");
  // From inside, the integration ends at the border.
  const std::string message = error_of([&] { integrate({f, {Real(0)}}, {decimal("2")}, {}); });
  EXPECT_EQ(message.substr(0, 54), "the extrapolation integration stops at t = 1.0000000: ") << message;
}

TEST(Extrapolation, RefusesWhatMakesNoSense) {
  const auto run = [](const std::vector<Real>& times, ExtrapolationOptions options) {
    return error_of([&] { integrate({oscillator, {Real(0), Real(1)}}, times, options); });
  };
  EXPECT_EQ(run({Real(2), Real(1)}, {}),
            "the time 1.0000000 comes after 2.0000000 in the list of times: order them away from the initial time");
  EXPECT_NE(run({Real(-1), Real(1)}, {}), "no error");
  ExtrapolationOptions options;
  options.columns = 1;
  EXPECT_EQ(run({Real(1)}, options), "an extrapolation with 1 columns is not offered: ask for 3 to 40");
  options = {};
  options.work_digits = 30;
  EXPECT_NE(run({Real(1)}, options).find("a tolerance of 40 digits cannot be met"), std::string::npos);
  options = {};
  options.maximum_step_count = 2;
  EXPECT_NE(run({Real(100)}, options).find("the limit of 2 steps is reached"), std::string::npos);
  EXPECT_NE(error_of([] {
              integrate({[](const Real&, const Vector&) { return Vector{Real(1)}; }, {Real(0), Real(0)}}, {Real(1)}, {});
            }).find("returned 1 derivatives for a state of 2"),
            std::string::npos);
  EXPECT_TRUE(run({}, {}) == "no error");
}

}  // namespace
}  // namespace torsor::extrapolation_test
