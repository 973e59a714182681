// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <tuple>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "torsor/runtime/status.hpp"

namespace examples {

/// Where a motion has come at t1; a failure of the integration fails the test.
template <class Motion, class Vector, class Method>
[[nodiscard]] Vector state_at(const Motion& motion, Vector y, double t0, double t1, const Method& method) {
  const auto result = torsor::runtime::integrate(motion, y, t0, t1, method);
  EXPECT_TRUE(result) << torsor::runtime::describe(result);
  return y;
}

/// How much the flow from t0 amplifies errors of the state, at times that grow: the largest column norm of dy(t)/dy(t0), by
/// central differences. With steps of 1e-5 and a motion known to 1e-12 the columns are right to 1e-7 and to the square of
/// the step times third derivatives: two digits are all that is asked of them.
template <class Motion, class Method = torsor::runtime::DormandPrince54>
class Amplification {
 public:
  using Vector = typename Motion::Vector;

  Amplification(const Motion& motion, const typename Motion::Vector& y, double t0,
                const Method& method = {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12})
      : motion_(motion), method_(method), t_(t0) {
    for (std::size_t column = 0; column < y.size(); ++column) {
      before_[column] = after_[column] = y;
      before_[column][column] -= step;
      after_[column][column] += step;
    }
  }

  [[nodiscard]] double until(double t) {
    double largest = 0.0;
    for (std::size_t column = 0; column < before_.size(); ++column) {
      Vector &before = before_[column], &after = after_[column];
      before = state_at(motion_, before, t_, t, method_);
      after = state_at(motion_, after, t_, t, method_);
      double square = 0.0;
      for (std::size_t i = 0; i < before.size(); ++i) square += std::pow((after[i] - before[i]) / (2.0 * step), 2);
      largest = std::fmax(largest, std::sqrt(square));
    }
    t_ = t;
    return largest;
  }

 private:
  static constexpr double step = 1e-5;
  const Motion& motion_;
  Method method_;
  double t_;
  std::array<Vector, std::tuple_size_v<Vector>> before_, after_;
};

/// From t0 to t1 alone.
template <class Motion>
[[nodiscard]] double amplification(const Motion& motion, const typename Motion::Vector& y, double t0, double t1) {
  return Amplification<Motion>(motion, y, t0).until(t1);
}

template <std::size_t size>
[[nodiscard]] double largest_difference(const std::array<double, size>& a, const std::array<double, size>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) largest = std::fmax(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// How far a motion may be from its committed reference: an error times what the flow amplifies it by. Where the flow
/// forgets errors, those of the last steps are left: it is then taken to amplify them by one at least.
struct ReferenceBound {
  double error;
  double least_amplification = 0.0;
  double tolerance = 1e-14;  ///< of a step
};

template <class Motion>
void expect_reference(const Motion& motion, const std::string& name, const ReferenceBound& bound) {
  using namespace torsor::runtime;
  using Vector = typename Motion::Vector;
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/" + name + ".reference.csv");
  const DormandPrince54 method{.relative_tolerance = bound.tolerance, .absolute_tolerance = bound.tolerance};
  Amplification<Motion> growth(motion, motion.initial(), 0.0);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const double time = reference.times[row];
    const Vector end = state_at(motion, motion.initial(), 0.0, time, method);
    const double by = std::fmax(bound.least_amplification, growth.until(time));
    EXPECT_LE(largest_difference(end, reference.template state<std::tuple_size_v<Vector>>(row)), bound.error * by)
        << name << " at t = " << time;
  }
}

/// States and accelerations of a mechanism without constraints, each number within 2.
template <class M>
struct Sample {
  typename M::State state{};
  typename M::Accelerations a{};
};

template <class M>
std::array<Sample<M>, 50> random_samples(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  std::array<Sample<M>, 50> all{};
  for (Sample<M>& sample : all) {
    for (int i = 0; i < M::velocity_count; ++i) {
      sample.state.q[i] = uniform(random);
      sample.state.v[i] = uniform(random);
      sample.a[i] = uniform(random);
    }
  }
  return all;
}

}  // namespace examples
