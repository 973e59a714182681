// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generated/andrews_squeezer.hpp"
#include "generated/chaplygin_sleigh.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace stabilised_radau_iia_5_test {
namespace {

using namespace torsor::runtime;
using Pendulum = mechanisms::CartesianPendulum<double>;
using Squeezer = andrews_squeezer::Mechanism<double>;
using Sleigh = chaplygin_sleigh::Mechanism<double>;

template <class Method>
Method with_tolerance(double tolerance) {
  return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
}

struct Outcome {
  double error = 0.0, value = 0.0, rate = 0.0;  // at the end, relative to 1 + |y|; on the way, of the constraints
  Statistics statistics;
};
template <class M, class Method>
Outcome outcome(const Method& method, double end, const StateVector<M>& truth) {
  const auto motion = unprojected_motion<M>();  // what holds the constraints is the method
  auto y = motion.initial();
  Outcome outcome;
  const auto watch = [&](double t, const StateVector<M>& at) {
    typename M::Constraints constraints{};
    M::constraints(motion.precomputed(), unpack<M>(t, at), constraints);
    for (const double value : constraints.value) outcome.value = std::max(outcome.value, std::abs(value));
    for (const double rate : constraints.rate) outcome.rate = std::max(outcome.rate, std::abs(rate));
  };
  const auto result = integrate(motion, y, 0.0, end, method, watch);
  EXPECT_TRUE(result) << describe(result);
  for (std::size_t i = 0; i < y.size(); ++i) {
    outcome.error = std::max(outcome.error, std::abs(y[i] - truth[i]) / (1 + std::abs(truth[i])));
  }
  outcome.statistics = result.statistics;
  return outcome;
}

// Benchmark A01 at t = 10 (elliptic functions).
constexpr StateVector<Pendulum> pendulum_at_10{-0.275087462576116860054391449254, -0.961419205099125064265135068597,
                                               4.17559810095172883646051950627, -1.19474905456047527164751276163};

TEST(StabilisedRadauIia5, HoldsTheConstraintsToRoundingWhereTheOrdinaryEquationsDrift) {
  const Outcome stabilised = outcome<Pendulum>(with_tolerance<StabilisedRadauIia5>(1e-8), 10, pendulum_at_10);
  const Outcome drifting = outcome<Pendulum>(with_tolerance<RadauIia5>(1e-8), 10, pendulum_at_10);
  // (x² + y² - 1)/2 and x x' + y y' of terms of 1 and 4, each rounded thrice.
  EXPECT_LT(stabilised.value, 6 * 1.1e-16);
  EXPECT_LT(stabilised.rate, 24 * 1.1e-16);
  EXPECT_GT(drifting.value, 1e-9);
  // 600 steps that err by less than the tolerance.
  EXPECT_LT(stabilised.error, 600 * 1e-8);
  EXPECT_LT(stabilised.error, drifting.error);
}

TEST(StabilisedRadauIia5, HasOrderFiveInTheWorkItDoes) {
  // Errors against the number of steps, over six decades of tolerance; one order more or less would change the slope
  // by 1.
  const Outcome coarse = outcome<Pendulum>(with_tolerance<StabilisedRadauIia5>(1e-6), 10, pendulum_at_10);
  const Outcome fine = outcome<Pendulum>(with_tolerance<StabilisedRadauIia5>(1e-12), 10, pendulum_at_10);
  const double steps = static_cast<double>(fine.statistics.accepted) / static_cast<double>(coarse.statistics.accepted);
  EXPECT_NEAR(std::log(coarse.error / fine.error) / std::log(steps), 5.0, 0.6);
}

TEST(StabilisedRadauIia5, MeetsAndrewsSqueezer) {
  // At t = 0.03, two derivations that agree to 24 digits: seven angles, then their rates.
  const StateVector<Squeezer> truth{
      15.8107711951537070971193873,   -15.7563710584118394697277528, 0.0408222401196458048582823196,
      -0.534730116342079593770185031, 0.524409965879954069371655800, 0.534730116342079593770185031,
      1.04808074104193787306851547,   1139.92030225910606419809685,  -1424.37929517754007319602644,
      11.0329119106185937453273113,   19.2933741050320408316275568,  0.573569914829502453817687862,
      -19.2933741050320408316275568,  0.323179149249130874990748391};
  const Outcome found = outcome<Squeezer>(with_tolerance<StabilisedRadauIia5>(1e-10), 0.03, truth);
  // Closures of lengths of 0.04 m turned by two angles of 16 rad, which are rounded themselves; their rates are 0.04 m
  // times 1400 1/s, some twenty roundings.
  EXPECT_LT(found.value, 2 * 16 * 0.04 * 1.1e-16);
  EXPECT_LT(found.rate, 20 * 0.04 * 1400 * 1.1e-16);
  // 515 steps; the flow amplifies rates of 1e3 1/s over 0.03 s, by some 30.
  EXPECT_LT(found.error, 515 * 1e-10 * 30);
}

TEST(StabilisedRadauIia5, TakesConstraintsOnVelocitiesAlone) {
  // The blade keeps its direction to rounding; the truth is another method's, at a sharper tolerance.
  const auto motion = equations_of_motion<Sleigh>();
  auto truth = motion.initial();
  ASSERT_TRUE(integrate(motion, truth, 0.0, 2.0, with_tolerance<RadauIia5>(1e-12)));
  const Outcome found = outcome<Sleigh>(with_tolerance<StabilisedRadauIia5>(1e-9), 2.0, truth);
  EXPECT_LT(found.rate, 1e-14);
  // Each step errs by less than the tolerance; the sleigh's motion amplifies by less than ten in 2 s.
  EXPECT_LT(found.error, 1e-9 * 10 * static_cast<double>(found.statistics.accepted));
  EXPECT_LT(found.statistics.accepted, 100);
}

TEST(StabilisedRadauIia5, ReportsConstraintsThatLoseTheirRank) {
  // At the origin the circle has no gradient.
  const auto motion = equations_of_motion<Pendulum>();
  StateVector<Pendulum> y{0.0, 0.0, 1.0, 0.0};
  const auto result = integrate(motion, y, 0, 1, StabilisedRadauIia5{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
}

/// A point at rest, held on x = y and on x - y + δ (z - 1) = 0: two planes that δ turns against each other. Where
/// x is above 1.5 the second is not a number.
struct NearlyParallelPlanes : mechanisms::Contract<3, 2> {
  struct Parameters {
    double delta = 1;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {0, {{1, 1, 1}}, {{0, 0, 0}}}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 9>& mass) noexcept {
    mass = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {}; }
  static void constraints(const Precomputed& p, const State& s, Constraints& c) noexcept {
    const double delta = p.parameters.delta;
    c.value = {s.q[0] - s.q[1], s.q[0] - s.q[1] + delta * (s.q[2] - 1)};
    if (s.q[0] > 1.5) c.value[1] = std::sqrt(-s.q[0]);
    c.rate = {s.v[0] - s.v[1], s.v[0] - s.v[1] + delta * s.v[2]};
    c.jacobian = {1, 1, -1, -1, 0, delta};
    c.gamma = {};
  }
  static mechanisms::Status forward_dynamics(const Precomputed&, const State&, const Inputs&, Accelerations& a,
                                             Multipliers& lambda) noexcept {
    a = {};
    lambda = {};
    return mechanisms::Status::ok;
  }
};

/// What the last projection of a step makes of a change of the state that the planes start in.
struct LastWord {
  bool accepted = false;
  Evaluation evaluation = Evaluation::ok;
  std::array<double, 6> change{};
};
LastWord last_word(double delta, const std::array<double, 6>& change) {
  using Motion = EquationsOfMotion<NearlyParallelPlanes>;
  Motion motion(NearlyParallelPlanes::Parameters{delta});
  CheckedSystem<Motion, double, 6> f(motion);
  StabilisedEquations<Motion, double, 6> equations;
  const std::array<double, 6> y = motion.initial();
  EXPECT_TRUE(equations.linearise(f, 0.0, y, {}));
  LastWord word;
  word.change = change;
  word.accepted = equations.finish(f, 0.0, y, word.change);
  word.evaluation = f.evaluation;
  return word;
}

TEST(StabilisedRadauIia5, DoesNotMagnifyRoundingInItsLastProjection) {
  // z is off by 1e-6, which planes that differ by 1e-7 see as 1e-13 of terms of 2: rounding, which says nothing of z.
  const LastWord magnified = last_word(1e-7, {0, 0, 1e-6, 0, 0, 0});
  EXPECT_TRUE(magnified.accepted);
  EXPECT_EQ(magnified.change[2], 1e-6);
  // Planes that are not parallel bring it back, to the last bits of 1.
  const LastWord plain = last_word(1, {0, 0, 1e-3, 0, 0, 0});
  EXPECT_TRUE(plain.accepted);
  EXPECT_NEAR(plain.change[2], 0.0, 2 * 2.3e-16);
  // And where the residual is more than rounding it is taken away whatever the angle: 1e-5 of z is 1e-11.
  const LastWord seen = last_word(1e-6, {0, 0, 1e-5, 0, 0, 0});
  EXPECT_TRUE(seen.accepted);
  EXPECT_LT(std::abs(seen.change[2]), 1e-5 / 10);
}

TEST(StabilisedRadauIia5, RefusesToEndAStepWhereConstraintsAreNotFinite) {
  const LastWord word = last_word(1, {1, 1, 0, 0, 0, 0});
  EXPECT_FALSE(word.accepted);
  EXPECT_EQ(word.evaluation, Evaluation::not_finite);
}

}  // namespace
}  // namespace stabilised_radau_iia_5_test
