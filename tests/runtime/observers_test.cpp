// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/integration/observers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/midpoint.hpp"

namespace observers_test {
namespace {

using namespace torsor::runtime;
using One = std::array<double, 1>;

const auto growth = [](double, const One& y, One& dydt) noexcept {
  dydt[0] = y[0];
  return Evaluation::ok;
};

struct Log {
  std::vector<double> times, values;
  void operator()(double t, const One& y) {
    times.push_back(t);
    values.push_back(y[0]);
  }
};

TEST(EquallySpaced, SamplesTheInterpolantAtEveryMultipleBothEndsIncluded) {
  Log log;
  EquallySpaced observer(0.0, 0.1, log);
  One y{1.0};
  ASSERT_TRUE(integrate(growth, y, 0, 0.3, DormandPrince54{}, observer));  // 3 × 0.1 exceeds 0.3 by a rounding
  ASSERT_EQ(log.times.size(), 4U);
  EXPECT_EQ(log.times.front(), 0.0);
  EXPECT_EQ(log.times.back(), 0.3);
  for (std::size_t i = 0; i < log.times.size(); ++i) {
    // Steps of some 0.03 at a tolerance of 1e-9; the interpolant's own error h^5/5!/10 is 2e-11.
    EXPECT_NEAR(log.values[i], std::exp(log.times[i]), 1e-9);
  }
}

TEST(EquallySpaced, SamplesBackwards) {
  Log log;
  EquallySpaced observer(1.0, 0.25, log);
  One y{std::exp(1.0)};
  ASSERT_TRUE(integrate(growth, y, 1, 0, DormandPrince54{}, observer));
  EXPECT_EQ(log.times, (std::vector<double>{1.0, 0.75, 0.5, 0.25, 0.0}));
  EXPECT_NEAR(log.values[2], std::exp(0.5), 3e-9);  // tolerance 1e-9 × values up to e
}

TEST(EquallySpaced, SkipsTimesBeforeTheStart) {
  Log log;
  EquallySpaced observer(0.0, 0.5, log);
  One y{1.0};
  ASSERT_TRUE(integrate(growth, y, 0.75, 2, DormandPrince54{}, observer));
  EXPECT_EQ(log.times, (std::vector<double>{1.0, 1.5, 2.0}));
}

TEST(EquallySpaced, StopsTheIntegrationRatherThanLoopOnAnIntervalOfZero) {
  Log log;
  EquallySpaced observer(0.0, 0.0, log);
  One y{1.0};
  EXPECT_EQ(integrate(growth, y, 0, 1, DormandPrince54{}, observer).status, IntegrationStatus::stopped_by_observer);
}

TEST(EquallySpaced, SamplesAnEndAtZero) {
  // -0.3 + 3 * 0.1 is 5.6e-17 in double: a rounding of 0.3 beyond the end.
  for (const double start : {-0.3, -0.7, -0.6}) {
    Log log;
    EquallySpaced observer(start, 0.1, log);
    One y{1.0};
    ASSERT_TRUE(integrate(growth, y, start, 0.0, DormandPrince54{}, observer));
    EXPECT_EQ(log.times.size(), static_cast<std::size_t>(std::lround(-start / 0.1)) + 1) << start;
    EXPECT_NEAR(log.times.back(), 0.0, 1.2e-16) << start;
  }
}

TEST(Every, StopsTheIntegrationRatherThanDivideByZero) {
  for (const int count : {0, -3}) {
    Log log;
    Every observer(count, log);
    One y{1.0};
    EXPECT_EQ(integrate(growth, y, 0, 1, Midpoint{.step = 0.125}, observer).status,
              IntegrationStatus::stopped_by_observer);
    EXPECT_TRUE(log.times.empty());
  }
}

TEST(Every, PassesOnTheStartAndEveryNthStep) {
  Log log;
  Every observer(4, log);
  One y{1.0};
  ASSERT_TRUE(integrate(growth, y, 0, 1, Midpoint{.step = 0.125}, observer));
  EXPECT_EQ(log.times, (std::vector<double>{0.0, 0.5, 1.0}));
}

}  // namespace
}  // namespace observers_test
