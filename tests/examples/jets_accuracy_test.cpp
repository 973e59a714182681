// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel `jets` of committed headers at all orders that the integrators take: run on CLN's numbers it solves the
// equations of motion, and in double it stays near that.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <tuple>
#include <type_traits>

#include "generated/double_pendulum.hpp"
#include "generated/heavy_top.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/torque_free_body.hpp"
#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/verification/real_scalar_traits.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/verification/right_to_rounding.hpp"

namespace torsor::jets_accuracy_test {
namespace {

using namespace torsor::runtime;

constexpr int order = 30;

template <class Scalar>
Scalar exactly(double value) {
  if constexpr (std::is_same_v<Scalar, Real>) {
    return Real::from_double(value);
  } else {
    return value;
  }
}

template <class M>
using Coefficients = std::array<StateVector<M>, order + 1>;

/// A mechanism at the same numbers on any scalar.
template <template <class> class Mechanism, class Scalar>
struct Motion {
  using M = Mechanism<Scalar>;
  using Vector = StateVector<M>;

  explicit Motion(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.5F, 1.5F);
    for (Scalar& value : start) value = exactly<Scalar>(uniform(random));
    typename M::Parameters parameters = M::default_parameters();
    const auto in_double = Mechanism<double>::default_parameters();
    for (int i = 0; i < M::parameter_count; ++i) parameters[i] = exactly<Scalar>(in_double[i]);
    precomputed = M::precompute(parameters);
  }

  Coefficients<M> jets() const {
    Coefficients<M> c;
    EXPECT_EQ(M::jets(precomputed, unpack<M>(exactly<Scalar>(0.0), start), NoInputs<M>()({}), order, c.data()),
              Status::ok);
    return c;
  }

  Vector rates(const Scalar& t, const Vector& y) const {
    const typename M::State state = unpack<M>(t, y);
    typename M::Accelerations a{};
    typename M::Multipliers lambda{};
    EXPECT_EQ(M::forward_dynamics(precomputed, state, NoInputs<M>()(state), a, lambda), Status::ok);
    Vector rates;
    write_coordinate_rates<M>(precomputed, state, rates);
    for (std::size_t i = 0; i < velocities_of<M>; ++i) rates[coordinates_of<M> + i] = a[static_cast<int>(i)];
    return rates;
  }

  Vector start;
  typename M::Precomputed precomputed;
};

template <std::size_t size>
double largest(const std::array<Real, size>& values) {
  double most = 0;
  for (const Real& value : values) most = std::max(most, abs(value).to_double());
  return most;
}

/// The natural sizes of coefficients, C ρ^-k: 1/ρ is the fastest growth over ten orders, up to the last, and size k
/// what the last four of orders up to k make of it, since single coefficients may nearly vanish.
struct NaturalSizes {
  template <std::size_t size>
  explicit NaturalSizes(const std::array<std::array<Real, size>, order + 1>& c) {
    for (std::size_t k = 0; k <= order; ++k) norm[k] = largest(c[k]);
    for (std::size_t k = order - 9; k <= order; ++k) {
      if (norm[k - 10] > 0) inverse_radius = std::max(inverse_radius, std::pow(norm[k] / norm[k - 10], 0.1));
    }
  }
  double operator[](std::size_t k) const {
    double natural = 0;
    for (std::size_t j = k > 4 ? k - 3 : 1; j <= k; ++j) {
      natural = std::max(natural, norm[j] * std::pow(inverse_radius, static_cast<double>(k - j)));
    }
    return natural;
  }

  std::array<double, order + 1> norm{};
  double inverse_radius = 0;
};

/// y_29, the polynomial of degree 29, put into the equations of motion at h = 1e-10 ρ: what is left, y_29' - f(y_29),
/// is -30 c_30 h^29 and, smaller by 1e-10 times what f turns c_30 into (some 1/ρ) and the growth to c_31, the next
/// term.
template <template <class> class Mechanism>
void expect_solved(unsigned seed) {
  const WorkingDigits precision(10 * order + 40);
  const Motion<Mechanism, Real> motion(seed);
  const auto c = motion.jets();
  const NaturalSizes natural(c);
  const Real h = Real::from_double(1e-10 / natural.inverse_radius);
  constexpr std::size_t size = std::tuple_size_v<typename Motion<Mechanism, Real>::Vector>;
  std::array<Real, size> y = c[order - 1], slope{};
  for (std::size_t k = order - 1; k-- > 0;) {
    for (std::size_t i = 0; i < size; ++i) {
      slope[i] = slope[i] * h + y[i];
      y[i] = y[i] * h + c[k][i];
    }
  }
  const auto f = motion.rates(h, y);
  const double scale = order * natural[order];
  for (std::size_t i = 0; i < size; ++i) {
    const Real left = (slope[i] - f[i]) / pow(h, order - 1) + Real(order) * c[order][i];
    EXPECT_LT(abs(left).to_double(), 10 * 1e-10 * scale) << "seed " << seed << ", component " << i;
  }
}

/// A rounding of a constant or of a sine moves ρ and so changes coefficient k by k times its part: ten of them.
template <template <class> class Mechanism>
void expect_near(unsigned seed) {
  const WorkingDigits precision(60);
  const auto exact = Motion<Mechanism, Real>(seed).jets();
  const auto fast = Motion<Mechanism, double>(seed).jets();
  const NaturalSizes natural(exact);
  testing_rounding::RightToRounding check(testing_rounding::unit_of<double>);
  for (std::size_t k = 1; k <= order; ++k) {
    const double size = static_cast<double>(k) * natural[k];
    for (std::size_t i = 0; i < exact[k].size(); ++i) {
      check.entry("order " + std::to_string(k) + ", component " + std::to_string(i), fast[k][i], exact[k][i], size, 10);
    }
  }
  EXPECT_TRUE(check) << "seed " << seed << ": " << check;
}

template <template <class> class Mechanism>
void expect_right() {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    expect_solved<Mechanism>(seed);
    expect_near<Mechanism>(seed);
  }
}

TEST(JetsUpToOrder30, AreThoseOfTheDoublePendulum) { expect_right<double_pendulum::Mechanism>(); }
TEST(JetsUpToOrder30, AreThoseOfTheHeavyTop) { expect_right<heavy_top::Mechanism>(); }
TEST(JetsUpToOrder30, AreThoseOfTheRollingHoop) { expect_right<rolling_hoop::Mechanism>(); }
TEST(JetsUpToOrder30, AreThoseOfTheTorqueFreeBody) { expect_right<torque_free_body::Mechanism>(); }

}  // namespace
}  // namespace torsor::jets_accuracy_test
