// SPDX-License-Identifier: GPL-3.0-or-later
// Closed loops over long motions and where they lose rank. TORSOR_LONG_TESTS: a million steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "tests/long_tests.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "tests/runtime/revolute_loops.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace loops_stress_test {
namespace {

using namespace torsor::runtime;
using mechanisms::Bricard;
using Pendulum = mechanisms::CartesianPendulum<double>;
using FourBar = mechanisms::CrankLoop<mechanisms::FourBar>;

std::int64_t many_steps() { return torsor::wanted(10'000, 1'000'000); }

TEST(BricardsLinkage, TurnsInTheOneFreedomThatItsSixEquationsLeave) {
  // Along the whole motion one equation repeats the others: by 6e-6, since the stages of a step are off the closure by
  // more than the usual tolerance of rank and would take its error for an equation.
  const double near = change_point_tolerance<double>();
  const auto motion = projected(constrained_motion<Bricard>({}, {}, near), near);
  auto y = motion.initial();
  const double before = Bricard::energy(unpack<Bricard>(0.0, y));
  double open = 0.0, off = 0.0, uneven = 0.0, widest[2]{};
  int ranks = 0;
  const auto watch = [&](double t, const StateVector<Bricard>& s) {
    Bricard::Constraints c{};
    Bricard::constraints({}, unpack<Bricard>(t, s), c);
    for (const double value : c.value) open = std::max(open, std::abs(value));
    const double theta = std::cos(s[0]), phi = std::cos(s[1]);
    off = std::max(off, std::abs(theta + phi + theta * phi));
    uneven = std::max({uneven, std::abs(s[2] - s[0]), std::abs(s[4] - s[0]), std::abs(s[3] - s[1])});
    widest[0] = std::max(widest[0], s[0]);
    widest[1] = std::max(widest[1], -s[0]);
    auto there = s;
    there[0] += 1e-9;  // so that there is something to project
    const auto projection = project_on_constraints<Bricard>({}, t, there, near);
    ranks += projection.evaluation == Evaluation::ok && projection.rank == 4 ? 0 : 1;
  };
  const DormandPrince853 method{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11};
  const auto result = integrate(motion, y, 0, 20, method, watch);
  ASSERT_TRUE(result) << describe(result);
  EXPECT_EQ(ranks, 0);
  // The projection leaves residuals alone that are two roundings of Σ_j |A_ij| min(|q_j|, π/2): six angles, |A_ij| ≤ 1.
  const double rounding = 2 * 2.2e-16 * 6 * std::numbers::pi / 2;
  EXPECT_LT(open, rounding);
  EXPECT_LT(off, rounding);
  EXPECT_LT(uneven, 48 * 1.1e-16);
  // Some four hundred steps that err by 1e-11 in angles and in rates to 9/s, which the masses turn into 9 · 20 J.
  EXPECT_NEAR(Bricard::energy(unpack<Bricard>(0.0, y)), before, 1e-11 * 180 * 450);
  // It reaches both ends, θ = ±2π/3, but for what a step jumps over.
  EXPECT_GT(widest[0], 2 * std::numbers::pi / 3 - 0.05);
  EXPECT_GT(widest[1], 2 * std::numbers::pi / 3 - 0.05);
  EXPECT_LE(std::max(widest[0], widest[1]), 2 * std::numbers::pi / 3 + 1e-7);  // flat there: the root of 1e-14
}

// Along the whole motion three equations repeat the others, and one of them vanishes but for rounding.
template <class Linkage>
void expect_bennetts_motion() {
  const auto motion = projected(constrained_motion<Linkage>());
  auto y = motion.initial();
  const double before = Linkage::energy(unpack<Linkage>(0.0, y));
  double off = 0.0, uneven = 0.0, turned = 0.0;
  const auto watch = [&](double, const StateVector<Linkage>& s) {
    off = std::max(off, std::abs(std::tan(s[0] / 2) * std::tan(s[1] / 2) + std::numbers::sqrt3));
    uneven = std::max(uneven, std::abs(s[2] + s[0]));
    turned = std::max(turned, s[0] - 0.7);
  };
  const DormandPrince853 method{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11};
  const auto result = integrate(motion, y, 0, 2, method, watch);
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(off, 1e-13);
  EXPECT_LT(uneven, 1e-14);
  EXPECT_GT(turned, 1);
  EXPECT_LT(result.statistics.accepted, 100);
  EXPECT_NEAR(Linkage::energy(unpack<Linkage>(0.0, y)), before, 1e-11 * 100 * 100);  // steps, J/rad
}
TEST(BennettsLinkage, TurnsInTheOneFreedomThatItsFiveEquationsLeave) {
  expect_bennetts_motion<mechanisms::Bennett>();
  expect_bennetts_motion<mechanisms::BennettAsGenerated>();
}

/// The largest residuals over a run, in the constraints' own units.
template <class M, class System, class Method>
std::array<double, 2> residuals(const System& motion, const Method& method, double end, std::int64_t steps) {
  auto y = motion.initial();
  std::array<double, 2> largest{};
  const auto result = integrate(motion, y, 0, end, method, [&](double t, const StateVector<M>& s) {
    typename M::Constraints c{};
    M::constraints(motion.precomputed(), unpack<M>(t, s), c);
    for (const double value : c.value) largest[0] = std::max(largest[0], std::abs(value));
    for (const double rate : c.rate) largest[1] = std::max(largest[1], std::abs(rate));
  });
  EXPECT_TRUE(result) << describe(result);
  EXPECT_GE(result.statistics.accepted, steps);
  return largest;
}

TEST(StabilisedRadauIia5, StaysOnItsConstraintsOverManySteps) {
  const std::int64_t steps = many_steps();
  const double h = 0.005;
  const StabilisedRadauIia5 method{
      .relative_tolerance = 1e-7, .absolute_tolerance = 1e-7, .largest_step = h, .step_limit = 100'000'000};
  const double end = h * static_cast<double>(steps);
  const auto pendulum = residuals<Pendulum>(equations_of_motion<Pendulum>(), method, end, steps);
  EXPECT_LT(pendulum[0], 1e-13);  // of a length of 1
  EXPECT_LT(pendulum[1], 5 * 1e-13);  // of speeds to 5
  const auto bars = residuals<FourBar>(constrained_motion<FourBar>(), method, end, steps);
  EXPECT_LT(bars[0], 1e-13);
  EXPECT_LT(bars[1], 10 * 1e-13);  // rates to 10/s
}

TEST(Projection, StaysOnItsConstraintsOverManySteps) {
  const std::int64_t steps = many_steps();
  const double h = 0.01;
  const DormandPrince853 method{
      .relative_tolerance = 1e-9, .absolute_tolerance = 1e-9, .largest_step = h, .step_limit = 100'000'000};
  const auto pendulum = residuals<Pendulum>(projected(equations_of_motion<Pendulum>()), method,
                                            h * static_cast<double>(steps), steps);
  EXPECT_LT(pendulum[0], 1e-13);
  EXPECT_LT(pendulum[1], 5 * 1e-13);
}

/// Two points on one line, x2 = x1 + 1 and, over again, x2 = x1 + 1 in rates: with `contradiction` they say different
/// things of the velocities.
struct Contradicting : mechanisms::CartesianPendulum<double> {
  static constexpr int multiplier_count = 2;
  using Multipliers = mechanisms::Values<double, 2>;
  struct Constraints {
    std::array<double, 2> value, rate;
    std::array<double, 4> jacobian;
    std::array<double, 2> gamma;
  };
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c.value = {s.q[1] - s.q[0] - 1.0, s.q[1] - s.q[0] - 1.0};
    c.rate = {s.v[1] - s.v[0], s.v[1] - s.v[0] - 0.5};  // the second is driven apart at 0.5
    c.jacobian = {-1.0, -1.0, 1.0, 1.0};
    c.gamma = {0.0, 0.0};
  }
};
TEST(Projection, ReportsVelocitiesThatContradictEachOther) {
  StateVector<Contradicting> y{0.0, 1.0, 0.3, 0.3}, before = y;
  EXPECT_EQ(project_on_constraints<Contradicting>({}, 0.0, y).evaluation, Evaluation::singular);
  EXPECT_EQ(y, before);
  y = {0.0, 1.0, 0.0, 0.0};  // at rest there is no size of a velocity to compare with
  EXPECT_EQ(project_on_constraints<Contradicting>({}, 0.0, y).evaluation, Evaluation::singular);
}

/// A constraint that has no value beside x = 0.
struct Undefined : mechanisms::CartesianPendulum<double> {
  static void constraints(const Precomputed& p, const State& s, Constraints& c) noexcept {
    CartesianPendulum::constraints(p, s, c);
    c.value[0] = std::sqrt(s.q[0]);
    c.jacobian[0] = 0.5 / c.value[0];
  }
};
TEST(PartitionedMotion, TellsWhatIsNoNumberFromWhatDoesNotSuit) {
  const auto motion = equations_of_motion<Undefined>();
  StateVector<Undefined> y{-1.0, 0.0, 0.0, 0.0};
  const auto result = integrate_partitioned<1>(motion, y, 0, 1, DormandPrince853{});
  EXPECT_EQ(result.integration.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.integration.evaluation, Evaluation::not_finite);
}

/// Two points of masses 1 and r on a line, tied by a rod: a force of 1 on the first.
struct Rod : mechanisms::Contract<2, 1> {
  [[maybe_unused]] static constexpr int parameter_count = 1;
  struct Parameters {
    [[maybe_unused]] static constexpr int size = 1;
    double mass;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {1.0}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {0.0, {{0.0, 1.0}}, {}}; }
  static void mass_matrix(const Precomputed& p, const State&, std::array<double, 4>& mass) noexcept {
    mass = {1.0, 0.0, 0.0, p.parameters.mass};
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {{-1.0, 0.0}}; }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c = {{s.q[1] - s.q[0] - 1.0}, {s.v[1] - s.v[0]}, {-1.0, 1.0}, {0.0}};
  }
};
TEST(MassRatios, FromTrillionthsToTrillionsAreTakenByConstraintsAndProjection) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (int power = -12; power <= 12; ++power) {
    const double r = std::pow(10.0, power);
    const auto motion = constrained_motion<Rod>({r});
    Rod::Accelerations a{};
    Rod::Multipliers lambda{};
    ASSERT_EQ(motion.accelerations(Rod::initial_state(), a, lambda), Evaluation::ok) << power;
    // (1 + r) a = 1, λ = r a, by products and quotients of some twelve roundings: relative errors below 8 ε. But the
    // first a is the free one, 1, less the second mass's share r/(1 + r): 8 ε of both.
    const double share = r / (1 + r);
    EXPECT_NEAR(a[0], 1 / (1 + r), 8 * epsilon * (1 + share)) << power;
    EXPECT_NEAR(a[1], 1 / (1 + r), 8 * epsilon / (1 + r)) << power;
    EXPECT_NEAR(lambda[0], share, 8 * epsilon * share) << power;
    // Off by d, known to the rounding of places of size 1: each gives way by the share of the other's mass, and
    // momentum stays.
    StateVector<Rod> y{0.0, 1.001, 2.0, 1.0};
    ASSERT_EQ(project_on_constraints<Rod>(motion.precomputed(), 0.0, y).evaluation, Evaluation::ok) << power;
    EXPECT_NEAR(y[0], (1.001 - 1.0) * share, 8 * epsilon * share) << power;
    EXPECT_NEAR(y[1] - y[0], 1.0, 4 * epsilon) << power;
    EXPECT_NEAR(y[2], 2.0 - share, 8 * epsilon * (2.0 + share)) << power;
    EXPECT_NEAR(y[3], y[2], 4 * epsilon) << power;
    auto z = motion.initial();
    const auto result = integrate(projected(motion), z, 0, 2, DormandPrince853{});
    ASSERT_TRUE(result) << power << ": " << describe(result);
    // a t²/2 with t²/2 = 2, which the method gives exactly but for what rounds: a, by the above, and in each step the
    // velocity, of size 2 share at most, for 2 s; and each projection moves by 8 ε of the share.
    const double steps = static_cast<double>(result.statistics.accepted);
    EXPECT_NEAR(z[0], 2 / (1 + r), 8 * epsilon * (2 * (1 + share) + steps * (4 / (1 + r) + share))) << power;
  }
}

}  // namespace
}  // namespace loops_stress_test
