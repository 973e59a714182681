// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/constraints/constraint_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generated/rolling_hoop_contact_forces.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace constraint_reading_test {
namespace {

using namespace torsor::runtime;
using Hoop = rolling_hoop_contact_forces::Mechanism<double>;

/// Unit masses on q, with constraints of the form that `Rows` gives: value(q), rows of A, b = 0. At rest or not.
template <class Rows>
struct Tied : mechanisms::Contract<Rows::n, Rows::m> {
  using Base = mechanisms::Contract<Rows::n, Rows::m>;
  using typename Base::Constraints, typename Base::State, typename Base::GeneralizedForces, typename Base::Precomputed;
  static constexpr std::size_t n = Rows::n, m = Rows::m;
  static void mass_matrix(const Precomputed&, const State&, std::array<double, n * n>& mass) noexcept {
    mass.fill(0);
    for (std::size_t i = 0; i < n; ++i) mass[i * (n + 1)] = 1;
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {}; }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    Rows::rows(s.q, c);
    for (std::size_t i = 0; i < m; ++i) {
      c.rate[i] = 0;
      for (std::size_t j = 0; j < n; ++j) c.rate[i] += c.jacobian[j * m + i] * s.v[static_cast<int>(j)];
      c.gamma[i] = Rows::gamma(s.q, s.v, i);
    }
  }
};

/// A length x, an angle φ that x rolls with, an angle a, and a pair of gears: x' = φ' + 1e-4 a' (rolling), θ with a by
/// f = θ + 1e-4 a², and two gears g = 2 h.
struct Rolling {
  static constexpr int n = 5, m = 3;
  template <class Q, class C>
  static void rows(const Q& q, C& c) noexcept {
    c.value = {q[1] + 1e-4 * q[2] * q[2], 0, q[3] - 2 * q[4]};
    c.jacobian = {0, 1, 0, 1, -1, 0, 2e-4 * q[2], -1e-4, 0, 0, 0, 1, 0, 0, -2};
  }
  template <class Q, class V>
  static double gamma(const Q&, const V& v, std::size_t i) noexcept {
    return i == 0 ? 2e-4 * v[2] * v[2] : 0;
  }
};
using RollingBody = Tied<Rolling>;

TEST(ConstraintKinds, TellHolonomicConstraintsAndCoordinatesThatTurn) {
  const auto pre = Hoop::precompute(Hoop::default_parameters());
  const auto hoop = ConstraintKinds<Hoop>::at(pre, 0, pack<Hoop>(Hoop::initial_state()));
  EXPECT_EQ(hoop.holonomic, (std::array<bool, 3>{false, false, true}));
  EXPECT_FALSE(hoop.turns[2]);  // z, a length
  EXPECT_TRUE(hoop.turns[4]);   // theta, an angle
  const auto kinds = ConstraintKinds<RollingBody>::at({}, 0, {});
  EXPECT_EQ(kinds.holonomic, (std::array<bool, 3>{true, false, true}));
  // A turn of either gear moves the other: neither may be taken for an angle modulo a turn.
  EXPECT_FALSE(kinds.turns[3]);
  EXPECT_FALSE(kinds.turns[4]);
}

TEST(Projection, LeavesRollingOutOfTheSearchForPositions) {
  // At x = 20 the share of x in a correction of 1e-15 is lost in its rounding. With rolling held as well, a would have
  // to move by 1e4 times the residual.
  for (const double off : {1e-15, 1e-13, 1e-9}) {
    StateVector<RollingBody> y{20, off - 1e-8, 1e-2, 0.5, 0.25, 0, 0, 0, 0, 0};
    const auto before = y;
    EXPECT_EQ(project_on_constraints<RollingBody>({}, 0, y).evaluation, Evaluation::ok);
    EXPECT_EQ(y[0], before[0]);
    EXPECT_NEAR(y[2], before[2], 2e-4 * 1e-2 * off + 1e-18);  // its slope over that of θ, and half an ulp of 1e-2
    EXPECT_NEAR(y[1], -1e-8, 4e-24 + 2e-4 * 1e-2 * 2e-6 * off);
  }
}

/// A parallelogram whose base and coupler differ by a rounding.
struct RoundedLengths : mechanisms::FourBar {
  static constexpr std::array<double, 2> crank{0.3, 0.3}, base{0, 0.3}, coupler{0, 0.1 + 0.2};
};
TEST(Projection, LeavesAStateAloneWhoseResidualsAreRounding) {
  // 0.1 + 0.2 - 0.3 = 5.6e-17: less than a rounding of the lengths, whatever the angles are.
  using M = mechanisms::CrankLoop<RoundedLengths>;
  for (const double angle : {0.0, 1e-12, 1e-7}) {
    StateVector<M> y{angle, angle, 0, 1e-3, 1e-3, 0};
    M::Constraints c{};
    M::constraints({}, unpack<M>(0.0, y), c);
    ASSERT_NE(c.value[0], 0.0);
    const auto before = y;
    const auto result = project_on_constraints<M>({}, 0, y);
    EXPECT_EQ(result.evaluation, Evaluation::ok);
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(y, before);
  }
}

TEST(Projection, CorrectsOnlyTheVelocitiesThatAreOff) {
  // Rolling at 4.6 m/s is off by one rounding of it, θ' by 1e-12: a' and x' keep their bits.
  StateVector<RollingBody> y{0, 0, 0, 0, 0, 4.6, 1e-12, std::nextafter(46000.0, 1e5), 1, 0.5};
  const auto before = y;
  ASSERT_EQ(project_on_constraints<RollingBody>({}, 0, y).evaluation, Evaluation::ok);
  EXPECT_NEAR(y[6], 0, 1e-27);
  EXPECT_EQ(y[8], before[8]);
  EXPECT_EQ(y[9], before[9]);
  // x' and a' take of 1e-12 what keeps them rolling: half each by the masses, over slopes of 1 and 1e-4.
  EXPECT_NEAR(y[5], before[5], 2e-12);
  EXPECT_NEAR(y[7], before[7], 1.5e-11);
}

/// Two rows of which the second says 1e-7 of something new.
struct NearlyTwice {
  static constexpr int n = 2, m = 2;
  template <class Q, class C>
  static void rows(const Q& q, C& c) noexcept {
    c.value = {q[0], q[0] + 1e-7 * (q[1] - 1)};
    c.jacobian = {1, 1, 0, 1e-7};
  }
  template <class Q, class V>
  static double gamma(const Q&, const V&, std::size_t) noexcept {
    return 0;
  }
};
TEST(Projection, RefusesCorrectionsThatGrow) {
  // 1e-4 at first, which sees one row; then 1, ten thousand times as much, to please the other.
  using M = Tied<NearlyTwice>;
  StateVector<M> y{1e-4, 0, 0, 0};
  const auto before = y;
  EXPECT_EQ(project_on_constraints<M>({}, 0, y).evaluation, Evaluation::singular);
  EXPECT_EQ(y, before);
}

/// A crank of 0.3 m against a table that rises as 5 t²: f = 0.3 sin θ - z, and z = 5 t² + t.
struct RisingTable : mechanisms::Contract<2, 2> {
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c.value = {0.3 * std::sin(s.q[0]) - s.q[1], s.q[1] - (5 * s.time + 1) * s.time};
    c.jacobian = {0.3 * std::cos(s.q[0]), 0, -1, 1};
    c.rate = {c.jacobian[0] * s.v[0] - s.v[1], s.v[1] - 10 * s.time - 1};
    c.gamma = {-0.3 * std::sin(s.q[0]) * s.v[0] * s.v[0], -10};
  }
};
TEST(ConstraintReading, CountsNoAccelerationThatTimeBringsAmongTheLengths) {
  // |∂²f/∂θ²| = 0.3 |sin θ|: the table's 10 m/s² are none.
  const double angle = 1.2;
  const StateVector<RisingTable> y{angle, 0.2, 0, 0};
  const auto kinds = ConstraintKinds<RisingTable>::at({}, 0.4, y);
  ASSERT_TRUE(kinds.turns[0]);
  ASSERT_FALSE(kinds.turns[1]);
  const auto lengths = ConstraintReading<RisingTable>::lengths({}, kinds, 0.4, y);
  EXPECT_NEAR(lengths[0], 0.3 * std::sin(angle), 1e-16);
  EXPECT_EQ(lengths[1], 0.0);
}

TEST(Projection, SeesWhatIsNotFiniteInACoordinateThatNoConstraintHas) {
  for (std::size_t i = 0; i < 10; ++i) {
    StateVector<RollingBody> y{};
    y[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(project_on_constraints<RollingBody>({}, 0, y).evaluation, Evaluation::not_finite) << i;
    y[i] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(project_on_constraints<RollingBody>({}, 0, y).evaluation, Evaluation::not_finite) << i;
  }
}

}  // namespace
}  // namespace constraint_reading_test
