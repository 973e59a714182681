// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace integrators_test {
namespace {

using namespace torsor::runtime;
template <class Scalar>
using State = std::array<Scalar, 2>;
using Pendulum = mechanisms::Pendulum<double>;

// Simple pendulum, L = 1, g = 9.81, at t = 10 (Jacobi's elliptic functions, 50 digits).
struct ExactPendulum {
  State<double> start, end;
};
constexpr ExactPendulum from_2{{2.0, 0.0}, {0.015728632141428118626277592909, 5.27089879322982860518148735035}};
constexpr ExactPendulum from_3{{3.0, 0.0}, {2.92505567569992899294223819154, 0.511695384717739449073636895502}};
constexpr ExactPendulum from_3_1{{3.1, 0.0}, {-3.09881762720456050589592630089, -0.0312777391569662771380990750397}};
constexpr ExactPendulum turning{{0.0, 7.0}, {48.2812067152479105558856219509, 4.63645599159167132330989005395}};

template <class A, class B>
double distance(const A& a, const B& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return largest;
}

template <class Scalar, class Method>
State<Scalar> end_of(const ExactPendulum& exact, const Method& method) {
  State<Scalar> y{static_cast<Scalar>(exact.start[0]), static_cast<Scalar>(exact.start[1])};
  const auto result = integrate(equations_of_motion<mechanisms::Pendulum<Scalar>>(), y, Scalar(0), Scalar(10), method);
  EXPECT_TRUE(result) << describe(result);
  return y;
}

template <class Method>
double observed_order(Method (*method)(double), double step) {
  const double coarse = distance(end_of<double>(from_2, method(step)), from_2.end);
  const double fine = distance(end_of<double>(from_2, method(step / 2)), from_2.end);
  return std::log2(coarse / fine);
}

// Unit steps of the length given: the tolerance is so loose that only the largest step limits.
DormandPrince54 dormand_prince_of_step(double h) {
  return {.relative_tolerance = 1e3, .absolute_tolerance = 1.0, .first_step = h, .largest_step = h};
}

// |∂y(10)/∂y(0)| in the largest norm, by central differences of 1e-5 (their own error, 1e-10 × third derivatives, is
// far below the factor this is used with).
double amplification(const ExactPendulum& exact) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    ExactPendulum up = exact, down = exact;
    up.start[i] += 1e-5;
    down.start[i] -= 1e-5;
    const DormandPrince54 sharp{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
    largest = std::max(largest, distance(end_of<double>(up, sharp), end_of<double>(down, sharp)) / 2e-5);
  }
  return largest;
}

// The next term of the error expansion changes the observed order by O(h); at these steps, found by halving further, by
// less than 0.2. An order wrong by one would be off by 1.
TEST(Midpoint, HasOrderTwo) {
  EXPECT_NEAR(observed_order<Midpoint>([](double h) { return Midpoint{.step = h}; }, 1.0 / 1024), 2.0, 0.2);
}

TEST(RungeKutta4, HasOrderFour) {
  EXPECT_NEAR(observed_order<RungeKutta4>([](double h) { return RungeKutta4{.step = h}; }, 1.0 / 512), 4.0, 0.2);
}

TEST(DormandPrince54, HasOrderFive) {
  EXPECT_NEAR(observed_order<DormandPrince54>(dormand_prince_of_step, 1.0 / 128), 5.0, 0.2);
}

// y' = y cos t, y = e^(sin t), from 0 to 1. Every stage has a time of its own, which an autonomous system does not
// show: a wrong one leaves order 1. Steps and the tolerance of 0.2 as above.
template <class Method>
double observed_order_in_time(Method (*method)(double), double step) {
  const auto growth = [](double t, const State<double>& y, State<double>& rate) noexcept {
    rate = {y[0] * std::cos(t), 0.0};
    return Evaluation::ok;
  };
  const auto error = [&](double h) {
    State<double> y{1.0, 0.0};
    EXPECT_TRUE(integrate(growth, y, 0.0, 1.0, method(h)));
    return std::abs(y[0] - std::exp(std::sin(1.0)));
  };
  return std::log2(error(step) / error(step / 2));
}

TEST(Integrators, KeepTheirOrderWhereTimeActs) {
  EXPECT_NEAR(observed_order_in_time<Midpoint>([](double h) { return Midpoint{.step = h}; }, 1.0 / 64), 2.0, 0.2);
  EXPECT_NEAR(observed_order_in_time<RungeKutta4>([](double h) { return RungeKutta4{.step = h}; }, 1.0 / 32), 4.0, 0.2);
  EXPECT_NEAR(observed_order_in_time<DormandPrince54>(dormand_prince_of_step, 1.0 / 16), 5.0, 0.2);
}

TEST(DormandPrince54, InterpolatesWithLocalErrorOfOrderFive) {
  // y' = y cos t, y = e^(sin t). One step from an exact value: h^6 at its end, h^5 inside (an interpolant of order 4).
  const auto system = [](double t, const std::array<double, 1>& y, std::array<double, 1>& dydt) noexcept {
    dydt[0] = y[0] * std::cos(t);
    return Evaluation::ok;
  };
  const auto exact = [](double t) { return std::exp(std::sin(t)); };
  const double start = 0.3;
  const auto errors_of = [&](double h) {
    State<double> errors{};
    const auto compare = [&](const DenseStep<double, 1>& step) {
      for (int i = 1; i < 10; ++i) {
        const double t = step.start + h * i / 10;
        errors[0] = std::max(errors[0], std::abs(step(t)[0] - exact(t)));
      }
      errors[1] = std::abs(step(step.end)[0] - exact(step.end));
    };
    std::array<double, 1> y{exact(start)};
    EXPECT_TRUE(integrate(system, y, start, start + h, dormand_prince_of_step(h), compare));
    return errors;
  };
  const State<double> coarse = errors_of(0.1), fine = errors_of(0.05);
  EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 5.0, 0.3);
  EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 6.0, 0.3);
}

TEST(DormandPrince54, MatchesEllipticFunctions) {
  // Local extrapolation leaves a step of length h an error h below its tolerance ε (1 + |y|), so that 10 s add up to
  // 10 ε (1 + max |y|), amplified by κ on the way; rounding, 1e-16 a step for some 3,000 steps, is far below.
  const double tolerance = 1e-12;
  for (const ExactPendulum& exact : {from_2, from_3, from_3_1, turning}) {
    const double scale = 1.0 + std::max(std::abs(exact.end[0]), 7.0);
    const double bound = 10.0 * tolerance * scale * amplification(exact);
    const auto y =
        end_of<double>(exact, DormandPrince54{.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
    EXPECT_LT(distance(y, exact.end), bound) << "start " << exact.start[0] << " " << exact.start[1];
  }
}

TEST(DormandPrince54, KeepsTheErrorProportionalToTheTolerance) {
  const auto error_at = [](double tolerance) {
    return distance(
        end_of<double>(from_2, DormandPrince54{.relative_tolerance = tolerance, .absolute_tolerance = tolerance}),
        from_2.end);
  };
  // A thousand times smaller; a factor 2 either way is left for the steps, which are whole.
  const double ratio = error_at(1e-8) / error_at(1e-11);
  EXPECT_GT(ratio, 500.0);
  EXPECT_LT(ratio, 2000.0);
}

TEST(Integrate, PromisesNotToThrowWhenTheModelAndTheObserverDo) {
  const auto motion = equations_of_motion<Pendulum>();
  State<double> y = from_2.start;
  const auto quiet = [](double, const State<double>&) noexcept {};
  const auto loud = [](double, const State<double>&) {};
  static_assert(noexcept(integrate(motion, y, 0, 1, DormandPrince54{}, quiet)));
  static_assert(!noexcept(integrate(motion, y, 0, 1, DormandPrince54{}, loud)));
  EXPECT_THROW((void)integrate(motion, y, 0, 1, DormandPrince54{}, [](double, const State<double>&) { throw 1; }), int);
}

TEST(Integrate, WorksInFloat) {
  // Rounding of a float, 6e-8 × |y| up to 7 a step, as a random walk of 1,000 steps (× 32), amplified by κ = 17 and
  // doubled: 5e-4. The methods' own errors at these settings are 6e-6 and 2e-4 (measured in double).
  EXPECT_LT(distance(end_of<float>(from_2, RungeKutta4{.step = 0.01}), from_2.end), 5e-4);
  EXPECT_LT(distance(end_of<float>(from_2, DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6}),
                     from_2.end),
            5e-4);
}

TEST(Integrate, StartsAFloatFarFromTimeZero) {
  // At t = 1000 the clock of a float ticks in 6e-5: a start at rest must not fall through a first step of 1e-6.
  auto motion = equations_of_motion<mechanisms::Pendulum<float>>();
  State<float> y{0.0F, 0.0F};
  const auto result = integrate(motion, y, 1000.0F, 1001.0F, DormandPrince54{1e-5, 1e-5});
  EXPECT_TRUE(result) << describe(result);
}

TEST(Integrate, HitsTheEndExactlyInBothDirections) {
  const auto motion = equations_of_motion<Pendulum>();
  const auto check = [&](double t0, double t1, const auto& method) {
    State<double> y{2.0, 0.0};
    double last = t0;
    const auto result = integrate(motion, y, t0, t1, method, [&](double t, const State<double>&) { last = t; });
    EXPECT_TRUE(result) << describe(result);
    EXPECT_EQ(result.time, t1);
    EXPECT_EQ(last, t1);
  };
  for (const auto& [t0, t1] : {State<double>{0.1, 0.7}, {0.0, 1.0 / 3.0}, {0.7, 0.1}, {0.3, -12.34567}}) {
    check(t0, t1, Midpoint{.step = 0.1});
    check(t0, t1, RungeKutta4{.step = 0.07});
    check(t0, t1, DormandPrince54{});
    check(t0, t1, DormandPrince54{.first_step = 1e-3, .largest_step = 0.0123});
  }
}

TEST(Integrate, TakesTheStepsThatTheIntervalHolds) {
  const auto steps_of = [](auto start, auto end, double step) {
    using Scalar = decltype(start);
    State<Scalar> y{Scalar(1), Scalar(0)};
    return integrate(equations_of_motion<mechanisms::Pendulum<Scalar>>(), y, start, end, Midpoint{.step = step})
        .statistics.accepted;
  };
  EXPECT_EQ(steps_of(0.0, 0.3, 0.1), 3);
  EXPECT_EQ(steps_of(0.0F, 0.3F, 0.1), 3);  // 0.3F is above 0.3: no fourth step for a rounding
  EXPECT_EQ(steps_of(0.0, 0.31, 0.1), 4);
  EXPECT_EQ(steps_of(2.0, 2.0, 0.1), 0);
}

TEST(Integrate, ComesBackToTheStartWhenTimeRunsBackwards) {
  const auto motion = equations_of_motion<Pendulum>();
  const DormandPrince54 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  State<double> y = from_2.start;
  ASSERT_TRUE(integrate(motion, y, 0, 10, method));
  ASSERT_TRUE(integrate(motion, y, 10, 0, method));
  // Twice the bound of one way (see MatchesEllipticFunctions), κ = 17: 2 × 10 × 1e-12 × 8 × 17.
  EXPECT_LT(distance(y, from_2.start), 2.8e-9);
}

TEST(Integrate, CountsWhatItDid) {
  const auto motion = equations_of_motion<Pendulum>();
  std::int64_t calls = 0;
  const auto counting = [&](double t, const State<double>& y, State<double>& dydt) {
    ++calls;
    return motion(t, y, dydt);
  };
  State<double> y = from_2.start;
  const auto fixed = integrate(counting, y, 0, 1, RungeKutta4{.step = 0.01});
  EXPECT_EQ(fixed.statistics.calls, 400);
  EXPECT_EQ(fixed.statistics.accepted, 100);
  EXPECT_EQ(calls, 400);

  calls = 0;
  const auto adaptive = integrate(counting, y, 0, 10, DormandPrince54{.relative_tolerance = 1e-6, .first_step = 1.0});
  const Statistics& s = adaptive.statistics;
  EXPECT_EQ(s.calls, calls);
  EXPECT_GT(s.rejected, 0);                               // the first step is far too long
  EXPECT_EQ(s.calls, 1 + 6 * (s.accepted + s.rejected));  // the last stage is the next first one
}

TEST(IntegrateThrough, GivesTheStatesOfOneRunAtEachTime) {
  const auto motion = equations_of_motion<Pendulum>();
  const DormandPrince54 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  std::vector<double> times;
  for (int i = 0; i <= 100; ++i) times.push_back(0.1 * i);
  times.back() = 10.0;
  std::vector<double> seen;
  State<double> y = from_2.start;
  const auto result =
      integrate_through(motion, y, 0.0, times, method, [&](double t, const State<double>&) { seen.push_back(t); });
  EXPECT_TRUE(result);
  EXPECT_EQ(seen, times);
  EXPECT_LT(distance(y, from_2.end), 1.4e-9);  // 10 × 1e-12 × 8 × 17, as above

  // The hundred stops cost at most one cut step each: the step length survives them.
  State<double> z = from_2.start;
  const auto direct = integrate(motion, z, 0, 10, method);
  EXPECT_LE(result.statistics.accepted, direct.statistics.accepted + 100);
}

}  // namespace
}  // namespace integrators_test
