// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "runtime/integration/dormand_prince_54.hpp"
#include "runtime/integration/integrate.hpp"
#include "runtime/status.hpp"

namespace examples {

/// Where a motion has come at t1; a failure of the integration fails the test.
template <class Motion, class Vector, class Method>
[[nodiscard]] Vector state_at(const Motion& motion, Vector y, double t0, double t1, const Method& method) {
  const auto result = torsor::runtime::integrate(motion, y, t0, t1, method);
  EXPECT_TRUE(result) << torsor::runtime::describe(result);
  return y;
}

/// How much the flow from t0 to t1 amplifies errors of the state: the largest column norm of dy(t1)/dy(t0), by central
/// differences. With steps of 1e-5 and a motion known to 1e-12 the columns are right to 1e-7 and to the square of the
/// step times third derivatives: two digits are all that is asked of them.
template <class Motion>
[[nodiscard]] double amplification(const Motion& motion, const typename Motion::Vector& y, double t0, double t1) {
  constexpr double step = 1e-5;
  constexpr torsor::runtime::DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  double largest = 0.0;
  for (std::size_t column = 0; column < y.size(); ++column) {
    auto before = y, after = y;
    before[column] -= step;
    after[column] += step;
    before = state_at(motion, before, t0, t1, precise);
    after = state_at(motion, after, t0, t1, precise);
    double square = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) square += std::pow((after[i] - before[i]) / (2.0 * step), 2);
    largest = std::fmax(largest, std::sqrt(square));
  }
  return largest;
}

template <std::size_t size>
[[nodiscard]] double largest_difference(const std::array<double, size>& a, const std::array<double, size>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) largest = std::fmax(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace examples
