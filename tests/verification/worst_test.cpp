// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/worst.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace torsor::worst_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

double worst_of(std::initializer_list<double> errors) {
  double worst = 0;
  for (const double error : errors) {
    if (is_worse(error, worst)) worst = error;
  }
  return worst;
}

TEST(IsWorse, KeepsTheLargest) {
  EXPECT_EQ(worst_of({1, 3, 2}), 3);
  EXPECT_EQ(worst_of({1, infinite, 2}), infinite);
}

TEST(IsWorse, KeepsANanForGood) {
  EXPECT_TRUE(std::isnan(worst_of({nan, 0})));
  EXPECT_TRUE(std::isnan(worst_of({0, nan, 0})));
  EXPECT_TRUE(std::isnan(worst_of({1, nan, infinite, 2})));
}

}  // namespace
}  // namespace torsor::worst_test
