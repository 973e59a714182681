// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace integration_failures_test {
namespace {

using namespace torsor::runtime;
using One = std::array<double, 1>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Function>
auto scalar_system(Function f) {
  return [f](double t, const One& y, One& dydt) noexcept {
    dydt[0] = f(t, y[0]);
    return Evaluation::ok;
  };
}

const auto decay = scalar_system([](double, double y) { return -y; });

template <class Method>
class EveryMethod : public testing::Test {
 public:
  static Method method() {
    if constexpr (requires { Method{}.step; })
      return Method{.step = 0.01};
    else
      return Method{};
  }
};
using Methods = testing::Types<Midpoint, RungeKutta4, DormandPrince54, DormandPrince853, GaussCollocation<2>,
                               GaussCollocation<2, StageSolver::newton>, RadauIia5>;
TYPED_TEST_SUITE(EveryMethod, Methods);

TYPED_TEST(EveryMethod, ReportsADerivativeThatIsNotANumberAndKeepsTheLastGoodState) {
  One y{1.0};
  const auto system = scalar_system([](double t, double value) { return t > 0.5 ? nan : -value; });
  const auto result = integrate(system, y, 0, 1, this->method());
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::not_finite);
  EXPECT_LE(result.time, 0.5);
  EXPECT_GT(result.time, 0.4);
  EXPECT_NEAR(y[0], std::exp(-result.time), 1e-5);  // midpoint: h²/6 × t = 1e-5 / 1.2 at h = 0.01
}

TYPED_TEST(EveryMethod, ReportsASingularModelAtTheStart) {
  One y{1.0};
  const auto system = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 0.0;
    return Evaluation::singular;
  };
  const auto result = integrate(system, y, 0, 1, this->method());
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
  EXPECT_EQ(result.time, 0.0);
  EXPECT_EQ(y[0], 1.0);
  EXPECT_EQ(result.statistics.accepted, 0);
}

TYPED_TEST(EveryMethod, RefusesTimesAndStatesThatAreNotFinite) {
  for (const double end : {nan, infinity}) {
    One y{1.0};
    EXPECT_EQ(integrate(decay, y, 0, end, this->method()).status, IntegrationStatus::invalid_options);
  }
  One y{nan};
  EXPECT_EQ(integrate(decay, y, 0, 1, this->method()).status, IntegrationStatus::invalid_options);
}

TYPED_TEST(EveryMethod, NoticesAStateThatOverflowsWhereTheModelWouldForgiveIt) {
  // The slope is finite everywhere, at infinity zero: only a look at the state itself sees that it overflowed. It begins
  // within a fixed step of the largest number, not within half of one, and steps that a tolerance keeps short come there too.
  const auto system = scalar_system([](double, double y) { return std::isfinite(y) ? 1e308 : 0.0; });
  One y{1.79e308};
  const auto result = integrate(system, y, 0, 10, this->method());
  EXPECT_FALSE(result);
  EXPECT_TRUE(std::isfinite(y[0]));
}

/// Stands still, and its projection loses the state.
struct Lost {
  Evaluation operator()(double, const One&, One& dydt) const noexcept {
    dydt[0] = 0.0;
    return Evaluation::ok;
  }
  void project(One& y) const noexcept { y[0] = nan; }
};

TYPED_TEST(EveryMethod, NoticesAProjectionThatLosesTheState) {
  One y{1.0};
  EXPECT_FALSE(integrate(Lost{}, y, 0, 1, this->method()));
  EXPECT_EQ(y[0], 1.0);
}

TYPED_TEST(EveryMethod, StopsWhenTheObserverSaysSo) {
  One y{1.0};
  int seen = 0;
  const auto result = integrate(decay, y, 0, 1, this->method(), [&](double, const One&) { return ++seen < 3; });
  EXPECT_EQ(result.status, IntegrationStatus::stopped_by_observer);
  EXPECT_EQ(seen, 3);
  EXPECT_EQ(result.statistics.accepted, 2);  // the first call is that of the start
}

TEST(DormandPrince54, EndsBeforeAnEscapeInFiniteTime) {
  // y' = y², y = 1/(1 - t): no solution at t = 2, and none may be invented.
  One y{1.0};
  const auto result = integrate(scalar_system([](double, double v) { return v * v; }), y, 0, 2, DormandPrince54{});
  EXPECT_FALSE(result);
  EXPECT_NEAR(result.time, 1.0, 1e-6);  // the tolerance 1e-9 moves the pole by some 1e-9 of the time
}

TEST(DormandPrince54, FindsItsWayBackFromStagesOutsideTheModel) {
  // Defined for y >= 0 only; a first step of 100 leaves the domain at once.
  const auto system = [](double, const One& y, One& dydt) noexcept {
    dydt[0] = -y[0];
    return y[0] < 0.0 ? Evaluation::not_finite : Evaluation::ok;
  };
  One y{1.0};
  const auto result = integrate(system, y, 0, 5, DormandPrince54{.first_step = 4.9});
  EXPECT_TRUE(result) << describe(result);
  EXPECT_GT(result.statistics.rejected, 0);
  EXPECT_NEAR(y[0], std::exp(-5.0), 5e-9);  // 5 s at a relative tolerance of 1e-9 of values up to 1, not amplified
}

TEST(DormandPrince54, ReportsItsStepLimit) {
  One y{1.0};
  const auto result = integrate(decay, y, 0, 1000, DormandPrince54{.step_limit = 7});
  EXPECT_EQ(result.status, IntegrationStatus::too_many_steps);
  EXPECT_EQ(result.statistics.accepted + result.statistics.rejected, 7);
}

TEST(DormandPrince54, RefusesUnusableOptions) {
  const DormandPrince54 unusable[] = {
      {.relative_tolerance = -1e-6},
      {.relative_tolerance = nan},
      {.relative_tolerance = 1e-17},
      {.absolute_tolerance = -1.0},
      {.absolute_tolerance = nan},
      {.relative_tolerance = 0.0, .absolute_tolerance = 0.0},
      {.first_step = -1.0},
      {.largest_step = nan},
      {.step_limit = 0},
  };
  for (const DormandPrince54& options : unusable) {
    One y{1.0};
    EXPECT_EQ(integrate(decay, y, 0, 1, options).status, IntegrationStatus::invalid_options);
    EXPECT_EQ(y[0], 1.0);
  }
}

TEST(DormandPrince54, RefusesAToleranceBelowThePrecisionOfFloat) {
  std::array<float, 1> y{1.0F};
  const auto system = [](float, const std::array<float, 1>& v, std::array<float, 1>& dydt) noexcept {
    dydt[0] = -v[0];
    return Evaluation::ok;
  };
  EXPECT_EQ(integrate(system, y, 0.0F, 1.0F, DormandPrince54{}).status, IntegrationStatus::invalid_options);
}

TEST(DormandPrince54, TreatsAComponentThatStaysZeroUnderAPurelyRelativeTolerance) {
  std::array<double, 2> y{1.0, 0.0};
  const auto system = [](double, const std::array<double, 2>& v, std::array<double, 2>& dydt) noexcept {
    dydt = {-v[0], 0.0};
    return Evaluation::ok;
  };
  const auto result =
      integrate(system, y, 0, 1, DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 0.0});
  EXPECT_TRUE(result) << describe(result);
  EXPECT_NEAR(y[0], std::exp(-1.0), 1e-9);
}

TEST(FixedStep, RefusesUnusableSteps) {
  for (const double step : {0.0, -0.1, nan, infinity}) {
    One y{1.0};
    EXPECT_EQ(integrate(decay, y, 0, 1, RungeKutta4{.step = step}).status, IntegrationStatus::invalid_options);
  }
}

TEST(FixedStep, RefusesAStepBelowTheResolutionOfTime) {
  One y{1.0};
  EXPECT_EQ(integrate(decay, y, 0, 1, Midpoint{.step = 1e-300}).status, IntegrationStatus::step_too_small);
  EXPECT_EQ(integrate(decay, y, 1e9, 1e9 + 1e-3, Midpoint{.step = 1e-8}).status, IntegrationStatus::step_too_small);
}

TEST(Describe, SaysWhatHappenedAndWhatToDo) {
  One y{1.0};
  const auto result = integrate(decay, y, 0, 1000, DormandPrince54{.step_limit = 7});
  const std::string text = describe(result);
  EXPECT_NE(text.find("raise it or loosen the tolerances"), std::string::npos) << text;
  EXPECT_NE(text.find("after 7 steps"), std::string::npos) << text;
}

// A double pendulum from rest, to a relative tolerance alone: velocities are zero at first, and have no scale.
template <class Method>
void expect_motion_from_rest(double error) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  auto loose = motion.initial(), exact = loose;
  loose[2] = loose[3] = exact[2] = exact[3] = 0;
  Method method{.relative_tolerance = 1e-9};
  method.absolute_tolerance = 0;
  const auto result = integrate(motion, loose, 0, 1, method);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_LT(result.statistics.accepted, 1000);
  ASSERT_TRUE(integrate(motion, exact, 0, 1, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}));
  for (std::size_t i = 0; i < loose.size(); ++i) EXPECT_NEAR(loose[i], exact[i], error) << i;
}
TEST(AdaptiveMethods, StartFromRestWithoutAnAbsoluteTolerance) {
  expect_motion_from_rest<DormandPrince54>(1e-7);
  expect_motion_from_rest<DormandPrince853>(1e-7);
  expect_motion_from_rest<RadauIia5>(1e-7);
  expect_motion_from_rest<Taylor>(1e-7);
}

// u' = u/1000, x' = 1 - cos(20 t): x is zero at first, and so is its slope.
template <class Method>
void expect_start_without_a_slope() {
  const auto system = [](double t, const std::array<double, 2>& y, std::array<double, 2>& dydt) noexcept {
    dydt = {1e-3 * y[0], 1 - std::cos(20 * t)};
    return Evaluation::ok;
  };
  for (const double first_step : {0.0, 0.1}) {
    std::array<double, 2> y{1, 0};
    Method method{.relative_tolerance = 1e-8};
    method.absolute_tolerance = 0;
    method.first_step = first_step;
    const auto result = integrate(system, y, 0, 1, method);
    EXPECT_TRUE(result) << describe(result);
    EXPECT_NEAR(y[1], 1 - std::sin(20.0) / 20, 1e-6) << first_step;
  }
}
TEST(AdaptiveMethods, WeighWhatStartsWithoutASlope) {
  expect_start_without_a_slope<DormandPrince54>();
  expect_start_without_a_slope<DormandPrince853>();
  expect_start_without_a_slope<RadauIia5>();
}

}  // namespace
}  // namespace integration_failures_test
