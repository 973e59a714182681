// SPDX-License-Identifier: GPL-3.0-or-later
// Units are a matter of writing: in others, of constraints or of coordinates, the same ones are independent, and the same
// motion follows. Units here are powers of two, so that not a bit may change.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "generated/rolling_hoop.hpp"
#include "torsor/runtime/constraints/consistent_state.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace units_of_constraints_test {
namespace {

using namespace torsor::runtime;
constexpr double pi = std::numbers::pi;

/// 2^e, from 1e-6 to 1e6 for e from -20 to 20.
constexpr double power_of_two(int e) { return e < 0 ? power_of_two(e + 1) / 2 : e > 0 ? 2 * power_of_two(e - 1) : 1; }

/// A mechanism with every other constraint written in another unit.
template <class M, int exponent>
struct RowsInUnits : M {
  static constexpr std::size_t m = static_cast<std::size_t>(M::multiplier_count);
  static constexpr double unit(std::size_t i) { return i % 2 == 0 ? power_of_two(exponent) : 1.0; }
  static void constraints(const typename M::Precomputed& p, const typename M::State& s,
                          typename M::Constraints& c) noexcept {
    M::constraints(p, s, c);
    for (std::size_t i = 0; i < m; ++i) {
      for (double* const value : {&c.value[i], &c.rate[i], &c.gamma[i]}) *value *= unit(i);
      for (std::size_t j = 0; j < c.jacobian.size() / m; ++j) c.jacobian[j * m + i] *= unit(i);
    }
  }
};

/// A crank of r = 2^exponent m and a rod as long on a slider: θ, ψ, x with r cos θ + r cos ψ = x, r sin θ = r sin ψ. At
/// θ = ψ = π/2 the second condition vanishes as a whole: the rod may go on with the slider at rest, or the slider with
/// the rod. Written in the coordinates θ, ψ, and x in a unit of its own.
template <int exponent, int unit_of_slider = 0>
struct EqualSlider : mechanisms::Contract<3, 2> {
  static constexpr double r = power_of_two(exponent), unit = power_of_two(unit_of_slider);
  static State initial_state() noexcept { return at(1.0, 1.5); }
  static State at(double angle, double rate) noexcept {
    return {0.0, {{angle, angle, 2 * r * std::cos(angle) / unit}}, {{rate, rate, -2 * r * std::sin(angle) * rate / unit}}};
  }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 9>& mass) noexcept {
    mass = {r * r, 0, 0, 0, r * r / 4, 0, 0, 0, unit * unit};
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {}; }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    const double st = std::sin(s.q[0]), ct = std::cos(s.q[0]), sp = std::sin(s.q[1]), cp = std::cos(s.q[1]);
    c.value = {r * ct + r * cp - unit * s.q[2], r * st - r * sp};
    c.jacobian = {-r * st, r * ct, -r * sp, -r * cp, -unit, 0};
    const double w = s.v[0], p = s.v[1];
    c.rate = {-r * st * w - r * sp * p - unit * s.v[2], r * ct * w - r * cp * p};
    c.gamma = {-r * ct * w * w - r * cp * p * p, -r * st * w * w + r * sp * p * p};
  }
  /// Angles, lengths over r, and their rates.
  static std::array<double, 6> numbers(const std::array<double, 6>& y) {
    return {y[0], y[1], y[2] * unit / r, y[3], y[4], y[5] * unit / r};
  }
};

/// What a mechanism shows of the rank of its constraints: at a state off them, with either tolerance.
template <class M>
struct Shown {
  std::array<Projection<double>, 2> projections;
  std::array<StateVector<M>, 2> projected;
  std::array<StateVector<M>, 2> slopes{};  // of the solve that lets go of constraints, and of the one that passes
  double distance = 0;

  explicit Shown(StateVector<M> y) {
    const std::array<double, 2> tolerances{usual_rank_tolerance<double>(), change_point_tolerance<double>()};
    for (std::size_t k = 0; k < 2; ++k) {
      projected[k] = y;
      projections[k] = project_on_constraints<M>({}, 0.0, projected[k], tolerances[k]);
    }
    const auto& state = projected[0];
    EXPECT_EQ(constrained_motion<M>({}, {}, tolerances[1])(0.0, state, slopes[0]), Evaluation::ok);
    EXPECT_EQ(constrained_motion<M>()(0.0, state, slopes[1]), Evaluation::ok);
    typename M::Constraints c{};
    M::constraints({}, unpack<M>(0.0, state), c);
    distance = RankDistance<M>({})(c);
  }
};

template <int exponent, class M>
void expect_the_same_in_units(const Shown<M>& known, const StateVector<M>& off) {
  const Shown<RowsInUnits<M, exponent>> shown(off);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(shown.projections[k].evaluation, Evaluation::ok) << exponent;
    EXPECT_EQ(shown.projections[k].rank, known.projections[k].rank) << exponent;
    EXPECT_EQ(shown.projections[k].least_share, known.projections[k].least_share) << exponent;
    EXPECT_EQ(shown.projected[k], known.projected[k]) << exponent;
    EXPECT_EQ(shown.slopes[k], known.slopes[k]) << exponent;
  }
  EXPECT_EQ(shown.distance, known.distance) << exponent;
}

template <class M>
void expect_the_same_in_all_units(const StateVector<M>& off) {
  const Shown<M> known(off);
  EXPECT_EQ(known.projections[0].evaluation, Evaluation::ok);
  expect_the_same_in_units<-20>(known, off);
  expect_the_same_in_units<17>(known, off);  // 1.3e5
  expect_the_same_in_units<20>(known, off);
  expect_the_same_in_units<40>(known, off);
}

TEST(UnitsOfConstraints, DoNotMatterToTheirRank) {
  using Cranks = mechanisms::CrankLoop<mechanisms::ThreeEqualCranks>;
  expect_the_same_in_all_units<Cranks>({1.1, 1.1001, 1.0998, 0.0002, 0.3, 0.31, 0.28, 0.01});
  // Of the redundant loop three constraints of four count.
  EXPECT_EQ((Shown<RowsInUnits<Cranks, 20>>({1.1, 1.1, 1.1, 0, 0.3, 0.3, 0.3, 0}).projections[1].rank), 3);
  using FourBar = mechanisms::CrankLoop<mechanisms::FourBar>;
  auto off = pack<FourBar>(FourBar::initial_state());
  off[1] += 1e-3;
  off[3] = 0.3;
  expect_the_same_in_all_units<FourBar>(off);
  expect_the_same_in_all_units<EqualSlider<0>>({1.0, 1.001, 1.081, 1.5, 1.5, -2.5});
}

/// Past the change point by fixed steps, which know no tolerance; then how it is measured.
template <class M>
std::array<double, 6> passed() {
  const auto motion = projected(constrained_motion<M>());
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, RungeKutta4{.step = 1.0 / 128});
  EXPECT_TRUE(result) << describe(result);
  return M::numbers(y);
}

TEST(UnitsOfConstraints, OfLengthsDoNotMatterAtChangePoints) {
  const auto known = passed<EqualSlider<0>>();
  ASSERT_GT(known[0], pi / 2 + 0.3);  // past the place, on the branch on which the slider goes on
  EXPECT_NEAR(known[1], known[0], 1e-14);
  EXPECT_EQ((passed<EqualSlider<-20>>()), known);
  EXPECT_EQ((passed<EqualSlider<20>>()), known);
  EXPECT_EQ((passed<EqualSlider<0, -20>>()), known);  // x in units of 1e-6 m
  EXPECT_EQ((passed<EqualSlider<0, 20>>()), known);
  EXPECT_EQ((passed<EqualSlider<3, -17>>()), known);
}

template <class M>
void expect_lengths_not_to_matter() {
  using Known = EqualSlider<0>;
  const RankDistance<Known> known({});
  const RankDistance<M> distance({});
  EXPECT_EQ(distance.repeats(), known.repeats());
  for (const double angle : {0.2, 1.0, pi / 2 - 0.1, pi / 2 - 1e-3, pi / 2}) {
    Known::Constraints a{};
    typename M::Constraints b{};
    Known::constraints({}, Known::at(angle, 0.7), a);
    M::constraints({}, M::at(angle, 0.7), b);
    EXPECT_EQ(distance(b), known(a)) << angle;
    const auto kinds = ConstraintKinds<M>::at({}, 0.0, pack<M>(M::at(angle, 0.7)));
    EXPECT_EQ(kinds.turns, (std::array<bool, 3>{true, true, false})) << angle;
  }
}

TEST(UnitsOfConstraints, DoNotMatterToTheDistanceFromChangePoints) {
  expect_lengths_not_to_matter<EqualSlider<-20>>();
  expect_lengths_not_to_matter<EqualSlider<20>>();
  expect_lengths_not_to_matter<EqualSlider<30>>();
  expect_lengths_not_to_matter<EqualSlider<0, -20>>();
  expect_lengths_not_to_matter<EqualSlider<0, 20>>();
  // The place itself is found from a start at it, however long the crank.
  const RankDistance<EqualSlider<0>> distance({});
  EqualSlider<0>::Constraints c{};
  EqualSlider<0>::constraints({}, EqualSlider<0>::at(pi / 2, 1), c);
  EXPECT_LT(distance(c), 1e-15);
  EXPECT_FALSE(distance.repeats());
}

/// Of a hoop that rolls: with as many coordinates as the rank leaves.
template <class M>
StateVector<M> rolled() {
  const auto motion = unprojected_motion<M>();
  auto y = motion.initial();
  const auto result = integrate_partitioned<3>(motion, y, 0, 0.25, RungeKutta4{.step = 1.0 / 64});
  EXPECT_TRUE(result) << describe(result.integration);
  return y;
}

TEST(UnitsOfConstraints, OfRollingDoNotMatterToIndependentCoordinates) {
  using Hoop = rolling_hoop::Mechanism<double>;
  const auto known = rolled<Hoop>();
  EXPECT_EQ((rolled<RowsInUnits<Hoop, -20>>()), known);
  EXPECT_EQ((rolled<RowsInUnits<Hoop, 20>>()), known);
}

}  // namespace
}  // namespace units_of_constraints_test
