// SPDX-License-Identifier: GPL-3.0-or-later
// Redundant loops that start at rest with all coordinates 0: nothing there says how large a rounding is but the lengths.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace loops_from_rest_test {
namespace {

using namespace torsor::runtime;

/// A parallelogram with an extra bar whose lengths are no round numbers, released from 1.25 rad.
template <int power>
struct Lengths {
  static constexpr double unit = power < 0 ? 1e-3 : power > 0 ? 1e3 : 1.0;
  static constexpr int cranks = 3;
  static constexpr std::array<double, 3> crank{0.7 * unit, 0.7 * unit, 0.7 * unit}, base{0, 0.3 * unit, 1.1 * unit},
      coupler{0, 0.3 * unit, 1.1 * unit}, mass{1, 2, 0.5};
  static constexpr double inertia = 0.3 * unit * unit;
  static std::array<double, 4> start() { return {1.25, 1.25, 1.25, 0}; }
};

/// Its angles counted from where it starts, so that all are 0 there.
template <class L>
struct FromRest : mechanisms::CrankLoop<L> {
  using Base = mechanisms::CrankLoop<L>;
  using typename Base::State, typename Base::Precomputed, typename Base::GeneralizedForces, typename Base::Constraints;
  static State absolute(State s) noexcept {
    for (int k = 0; k < Base::cranks; ++k) s.q[k] += 1.25;
    return s;
  }
  static State initial_state() noexcept { return {}; }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    Base::bias(p, absolute(s), h);
  }
  static void constraints(const Precomputed& p, const State& s, Constraints& c) noexcept {
    Base::constraints(p, absolute(s), c);
  }
};

template <int power>
class LoopsFromRest {
 public:
  using L = Lengths<power>;
  using M = FromRest<L>;
  using State = StateVector<M>;

  /// Ends at the same state as a pendulum of the cranks' length, which the loop moves as.
  template <class Integrate>
  static void expect(const char* name, const Integrate& integrated, double tolerance) {
    // Stages are off the closure by more than the usual tolerance of rank.
    const auto motion = constrained_motion<M>({}, {}, change_point_tolerance<double>());
    State y = motion.initial();
    const Result<double> result = integrated(motion, y);
    ASSERT_TRUE(result) << name << " " << power << ": " << describe(result);
    const double end = std::sqrt(L::unit);
    EXPECT_EQ(result.time, end);
    const auto pendulum = [](double, const std::array<double, 2>& z, std::array<double, 2>& dzdt) noexcept {
      dzdt = {z[1], -mechanisms::gravity<double> / (0.7 * L::unit) * std::sin(1.25 + z[0])};
      return Evaluation::ok;
    };
    std::array<double, 2> z{};
    ASSERT_TRUE(integrate(pendulum, z, 0.0, end, DormandPrince853{.relative_tolerance = 1e-13}));
    EXPECT_GT(std::abs(z[0]), 0.1);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(y[k], z[0], tolerance) << name << " " << power;
      EXPECT_NEAR(y[4 + k], z[1], tolerance * 4 / end) << name << " " << power;  // rates, to 4 in the time of the fall
    }
    EXPECT_NEAR(y[3], 0, tolerance);
    typename M::Constraints c{};
    M::constraints({}, unpack<M>(end, y), c);
    // Sums of four terms of at most the longest bar, each within two roundings.
    for (const double value : c.value) EXPECT_LE(std::abs(value), 16 * 1.1e-16 * 1.1 * L::unit) << name << " " << power;
  }

  static void expect_all() {
    // Some hundred steps that err by the tolerance, in a motion that amplifies by less than ten.
    const double t = 1e-10, allowed = 100 * 10 * t, end = std::sqrt(L::unit);
    const DormandPrince853 explicit_method{.relative_tolerance = t, .absolute_tolerance = t};
    const RadauIia5 implicit_method{.relative_tolerance = t, .absolute_tolerance = t};
    expect("stabilised", [&](const auto& motion, State& y) {
      return integrate(motion, y, 0, end, StabilisedRadauIia5{.relative_tolerance = t, .absolute_tolerance = t});
    }, allowed);
    expect("projected", [&](const auto& motion, State& y) {
      return integrate(projected(motion), y, 0, end, explicit_method);
    }, allowed);
    expect("partitioned", [&](const auto& motion, State& y) {
      return integrate_partitioned<1>(motion, y, 0, end, explicit_method).integration;
    }, allowed);
    expect("partitioned, Radau", [&](const auto& motion, State& y) {
      return integrate_partitioned<1>(motion, y, 0, end, implicit_method).integration;
    }, allowed);
  }
};

TEST(LoopsFromRest, MoveByEveryMethodWhateverTheirSize) {
  LoopsFromRest<0>::expect_all();
  LoopsFromRest<-1>::expect_all();
  LoopsFromRest<1>::expect_all();
}

}  // namespace
}  // namespace loops_from_rest_test
