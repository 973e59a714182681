// SPDX-License-Identifier: GPL-3.0-or-later
// Motions through the places where constraints lose rank. TORSOR_LONG_TESTS: forty windows at every tolerance.
#include "tests/long_tests.hpp"
#include "torsor/runtime/constraints/change_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "torsor/runtime/constraints/closed_motion.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/revolute_loops.hpp"
#include "tests/runtime/closed_loops.hpp"
#include "tests/runtime/windows.hpp"

namespace change_points_test {
namespace {

using namespace torsor::runtime;
using mechanisms::Windows;
using ThreeCranks = mechanisms::CrankLoop<mechanisms::ThreeEqualCranks>;
constexpr double pi = std::numbers::pi;

template <class Method>
Method with_tolerance(double tolerance) {
  return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
}

/// The pendulum of length 1 that all these parallelograms are.
struct PlainPendulum {
  [[nodiscard]] Evaluation operator()(double, const std::array<double, 2>& y,
                                      std::array<double, 2>& dydt) const noexcept {
    dydt = {y[1], -9.81 * std::sin(y[0])};
    return Evaluation::ok;
  }
};

// θ(10) and θ'(10) from 2 rad at rest, by elliptic functions; six change points are passed on the way.
constexpr double swing[2]{0.015728632141428118626277592909, 5.27089879322982858518148735035};

template <class Motion, class Method>
Result<double> expect_swing(const Motion& motion, const Method& method, double allowed) {
  using M = typename Motion::Mechanism;
  auto y = motion.initial();
  double largest = 0.0;
  const double before = M::energy(unpack<M>(0.0, y));
  const auto result = integrate(motion, y, 0, 10, method, [&](double t, const StateVector<M>& s) {
    largest = std::max(largest, std::abs(M::energy(unpack<M>(t, s)) - before));
  });
  EXPECT_TRUE(result) << describe(result);
  EXPECT_NEAR(y[0], swing[0], allowed);
  EXPECT_NEAR(y[M::velocity_count], swing[1], allowed);
  EXPECT_LT(largest, 10 * allowed);  // J/kg: dE = g sin θ dθ + θ' dθ', with 9.8 and 5.3
  typename M::Constraints c{};
  M::constraints(motion.precomputed(), unpack<M>(0.0, y), c);
  for (const double value : c.value) EXPECT_LT(std::abs(value), 1e-14);
  return result;
}

/// Errors of a step within the tolerance of numbers to 5, in both components, over 10 s in which they grow tenfold.
template <class Motion>
void expect_errors_to_fall(const Motion& motion, double sharpest) {
  std::int64_t steps = 0;
  for (double tolerance = 1e-6; tolerance >= 0.5 * sharpest; tolerance /= 100) {
    const auto result =
        expect_swing(motion, with_tolerance<DormandPrince853>(tolerance), std::max(100 * tolerance, 3e-12) * 10);
    // Of order 8: 100^(1/8) = 1.8 times the steps, and some that are tried again beside the change points.
    const std::int64_t before = steps;
    steps = result.statistics.accepted + result.statistics.rejected;
    EXPECT_TRUE(before == 0 || static_cast<double>(steps) < 2.2 * static_cast<double>(before)) << steps;
  }
  EXPECT_LT(steps, 600);  // the pendulum itself takes some 300 at 1e-12
}

TEST(ChangePoints, ArePassedByParallelogramsWithErrorsThatFallWithTheTolerance) {
  expect_errors_to_fall(equations_of_motion<Windows<1>>(), 1e-12);
  expect_errors_to_fall(equations_of_motion<Windows<2>>(), 1e-12);
  expect_errors_to_fall(equations_of_motion<Windows<5>>(), 1e-12);
  expect_errors_to_fall(projected(constrained_motion<Windows<1>>()), 1e-12);
  expect_errors_to_fall(projected(constrained_motion<Windows<2>>()), 1e-12);
}

TEST(ChangePoints, ArePassedByFortyWindows) {
  const auto motion = equations_of_motion<Windows<40>>();
  if (torsor::wanted(false, true)) return expect_errors_to_fall(motion, 1e-12);
  auto y = motion.initial();
  std::array<double, 2> pendulum{y[0], y[81]};
  const double tolerance = 1e-10;
  ASSERT_TRUE(integrate(PlainPendulum{}, pendulum, 0, 0.8, with_tolerance<DormandPrince853>(1e-13)));
  const auto result = integrate(motion, y, 0, 0.8, with_tolerance<DormandPrince853>(tolerance));
  ASSERT_TRUE(result) << describe(result);
  ASSERT_LT(pendulum[0], pi / 2);
  for (std::size_t k = 0; k <= 40; ++k) {
    EXPECT_NEAR(y[k], pendulum[0], 100 * tolerance);
    EXPECT_NEAR(y[81 + k], pendulum[1], 100 * tolerance);
  }
}

/// The same loop, its constraints told in other units, which differ from row to row.
template <class M>
struct InOtherUnits : M {
  static void constraints(const typename M::Precomputed& p, const typename M::State& s,
                          typename M::Constraints& c) noexcept {
    M::constraints(p, s, c);
    constexpr std::size_t m = static_cast<std::size_t>(M::multiplier_count);
    for (std::size_t i = 0; i < m; ++i) {
      const double unit = i % 2 == 0 ? 16 : 0.125;
      c.value[i] *= unit;
      c.rate[i] *= unit;
      c.gamma[i] *= unit;
      for (std::size_t j = 0; j < c.jacobian.size() / m; ++j) c.jacobian[j * m + i] *= unit;
    }
  }
};

TEST(ChangePoints, AreMeasuredAlikeInAllUnitsOfConstraints) {
  using InMetres = mechanisms::CrankLoop<mechanisms::ThreeEqualCranks>;
  using Others = InOtherUnits<InMetres>;
  const RankDistance<InMetres> distance({});
  const RankDistance<Others> in_units({});
  EXPECT_EQ(distance.repeats(), in_units.repeats());
  for (const double angle : {0.3, 1.2, pi / 2 - 0.1, pi / 2 - 1e-3, 2.0}) {
    InMetres::Constraints c{};
    Others::Constraints d{};
    const StateVector<InMetres> y{angle, angle, angle, 0, 0, 0, 0, 0};
    InMetres::constraints({}, unpack<InMetres>(0.0, y), c);
    Others::constraints({}, unpack<Others>(0.0, y), d);
    // Both measure by states of their own, which corrections from far off lead to: alike, not the same.
    EXPECT_NEAR(in_units(d) / distance(c), 1.0, 0.1) << angle;
  }
}

/// A parallelogram of unit cranks on a base of 2 m that turns at the rate w about the pivot of crank 0, without
/// gravity: relative to the base both cranks swing about its outward direction as a pendulum under w² would.
struct OnATurningBase : mechanisms::CrankLoop<mechanisms::FourBar> {
  struct Lengths : mechanisms::FourBar {
    static constexpr std::array<double, 2> crank{1, 1}, base{0, 2}, coupler{0, 2};
  };
  using Still = mechanisms::CrankLoop<Lengths>;
  static constexpr double square = 9.81;
  static double rate() { return std::sqrt(square); }
  // Angles from the downward vertical; the base starts along x, which is at π/2. Swings of 0.2 rad from rest beside it:
  // the base turns five times as fast as they pass it.
  static State initial_state() noexcept {
    return {0.0, {{pi / 2 + 0.2, pi / 2 + 0.2, 0}}, {{rate(), rate(), rate()}}};
  }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 9>& mass) noexcept {
    mass = {1, 0, 0, 0, 1, 0, 0, 0, 0.2};
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    h = {};
    h[1] = -2 * square * std::cos(s.q[1] - rate() * s.time);  // the pivot's acceleration, along the crank's motion
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    Still::Constraints still{};
    Still::constraints({}, {s.time, {s.q.values}, {s.v.values}}, still);
    const double w = rate(), x = 2 * std::cos(w * s.time), y = 2 * std::sin(w * s.time);
    c.jacobian = still.jacobian;
    c.value = {still.value[0] + 2 - x, still.value[1] - y};
    c.rate = {still.rate[0] + w * y, still.rate[1] - w * x};
    c.gamma = {still.gamma[0] + square * x, still.gamma[1] + square * y};
  }
};

TEST(ChangePoints, ArePassedByLoopsThatTimeCarriesAlong) {
  using M = OnATurningBase;
  const auto motion = projected(constrained_motion<M>());
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 10, with_tolerance<DormandPrince853>(1e-10));
  ASSERT_TRUE(result) << describe(result);
  std::array<double, 2> swung{0.2, 0.0};
  ASSERT_TRUE(integrate(PlainPendulum{}, swung, 0, 10, with_tolerance<DormandPrince853>(1e-13)));
  // Errors of 1e-10 of angles to 33 rad a step, some hundred steps.
  const double turned = pi / 2 + 10 * M::rate(), allowed = 33 * 1e-10 * 100;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(y[k] - turned, swung[0], allowed);
    EXPECT_NEAR(y[3 + k] - M::rate(), swung[1], allowed);
  }
  EXPECT_NEAR(y[2], 10 * M::rate(), 1e-13);
  // At the place itself, where cranks and base lie in a row, nothing else tells the motion: it is even there.
  const double t = 0.7, along = M::rate() * t;
  const StateVector<M> there{pi / 2 + along, pi / 2 + along, along, M::rate() + 0.6, M::rate() + 0.6, M::rate()};
  StateVector<M> settled = there, slope;
  ASSERT_EQ(motion.settle(t, settled), Evaluation::ok);
  ASSERT_EQ(motion(t, there, slope), Evaluation::ok);
  for (std::size_t i = 0; i < 6; ++i) {
    // Interpolated through states some 0.04 away: (4!)²/8! 0.04⁸ is 1e-13, and ε/0.04² of terms of the size of 20 less
    // than 1e-11; accelerations have that of a derivative more.
    EXPECT_NEAR(settled[i], there[i], 1e-11) << i;
    EXPECT_NEAR(slope[i], i < 3 ? there[3 + i] : 0.0, 1e-8) << i;
  }
}

TEST(ChangePoints, ArePassedByEveryMethod) {
  const auto motion = equations_of_motion<Windows<2>>();
  expect_swing(motion, with_tolerance<DormandPrince54>(1e-9), 1e-6);
  expect_swing(motion, RungeKutta4{.step = 2e-3}, 1e-7);  // h⁴ times 10 s times rates to the fifth power, 5^5 / 120
  expect_swing(motion, with_tolerance<RadauIia5>(1e-9), 1e-6);
  expect_swing(motion, GaussCollocation<3>{.step = 1e-2}, 1e-7);  // h⁶ 10 s 5^7 / 2800
}

TEST(ChangePoints, ArePassedByLoopsWithConstraintsThatRepeatOthers) {
  expect_errors_to_fall(projected(constrained_motion<ThreeCranks>()), 1e-12);
}

TEST(ChangePoints, AreTheStartOfMotionsThatHaveADirection) {
  // Flat, at a rate: on the branch of parallelograms, or on that where the last coupler turns twice as fast.
  const auto motion = equations_of_motion<Windows<1>>({pi / 2, -3.0});
  auto y = motion.initial();
  std::array<double, 2> pendulum{pi / 2, -3.0};
  ASSERT_TRUE(integrate(PlainPendulum{}, pendulum, 0, 2, with_tolerance<DormandPrince853>(1e-13)));
  const auto result = integrate(motion, y, 0, 2, with_tolerance<DormandPrince853>(1e-10));
  ASSERT_TRUE(result) << describe(result);
  EXPECT_NEAR(y[0], pendulum[0], 1e-8);
  EXPECT_NEAR(y[1], pendulum[0], 1e-8);
}

/// From any start: right, or a status that says what it is, in few steps.
template <int windows>
void expect_right_or_told(int count, double tolerance) {
  using M = Windows<windows>;
  std::mt19937 random(windows);
  std::uniform_real_distribution<double> angle(-pi, pi), rate(-4.0, 4.0);
  for (int i = 0; i < count; ++i) {
    typename M::Parameters start{angle(random), i % 3 == 0 ? 0.0 : rate(random)};
    // Every fifth comes to rest as near to a change point as ten powers of ten; the motion creeps into it.
    const double away = std::pow(10.0, -1 - i / 5 % 10);
    if (i % 5 == 4) start = {2.0, -std::sqrt(2 * 9.81 * (std::sin(away) - std::cos(2.0)))};
    const auto motion = equations_of_motion<M>(start);
    auto y = motion.initial();
    std::array<double, 2> pendulum{start.angle, start.rate};
    ASSERT_TRUE(integrate(PlainPendulum{}, pendulum, 0, 3, with_tolerance<DormandPrince853>(1e-13)));
    const auto result = integrate(motion, y, 0, 3, with_tolerance<DormandPrince853>(tolerance));
    EXPECT_LT(result.statistics.accepted + result.statistics.rejected, 2000) << start.angle << ' ' << start.rate;
    if (!result) {
      EXPECT_EQ(result.status, IntegrationStatus::model_failure) << start.angle << ' ' << start.rate;
      EXPECT_NE(describe(result).find("change point"), std::string::npos);
      EXPECT_EQ(i % 5, 4) << describe(result);
      continue;
    }
    // From near the upper equilibrium errors grow by exp(3 sqrt 9.81) = 1e4.
    EXPECT_NEAR(y[0], pendulum[0], 1e5 * tolerance) << start.angle << ' ' << start.rate;
    EXPECT_NEAR(y[M::velocity_count], pendulum[1], 1e5 * tolerance) << start.angle << ' ' << start.rate;
  }
}
TEST(ChangePoints, EndRightOrWithAStatusFromAnyStart) {
  const int more = torsor::wanted(1, 20);
  expect_right_or_told<1>(50 * more, 1e-8);
  expect_right_or_told<1>(50 * more, 1e-10);
  expect_right_or_told<2>(50 * more, 1e-10);
  expect_right_or_told<5>(20 * more, 1e-9);
}

TEST(ChangePoints, AreNotPassedAtRest) {
  using M = Windows<2>;
  const auto motion = equations_of_motion<M>({pi / 2, 0.0});
  auto y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, DormandPrince853{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
  EXPECT_NE(describe(result).find("change point"), std::string::npos);
}

TEST(ChangePoints, HaveNoAccelerationsOfTheirOwn) {
  // The state alone leaves accelerations open; beside it they are the pendulum's.
  const auto check = [](const auto& motion) {
    using M = Windows<2>;
    M::Accelerations a{};
    M::Multipliers lambda{};
    for (const double away : {0.0, 1e-12, -1e-8, 1e-6}) {
      EXPECT_EQ(motion.accelerations(M::initial_state({pi / 2 + away, 1.0}), a, lambda), Evaluation::singular) << away;
    }
    ASSERT_EQ(motion.accelerations(M::initial_state({pi / 2 - 0.01, 1.0}), a, lambda), Evaluation::ok);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], -9.81 * std::cos(0.01), 1e-9);  // rounding over the square of 0.01
  };
  check(equations_of_motion<Windows<2>>());
  check(constrained_motion<Windows<2>>());
}

/// All lies flat: the first cranks to the right, the others to the left, where the coupler between lies folded back.
template <int windows>
typename Windows<windows>::State flat_state(int right, double rate) {
  auto state = Windows<windows>::initial_state({pi / 2, rate});
  for (int k = right; k <= windows; ++k) state.q[k] = -pi / 2;
  if (right > 0 && right <= windows) state.q[windows + right] = pi;
  return state;
}
template <int windows>
void expect_no_accelerations_where_all_is_flat() {
  using M = Windows<windows>;
  typename M::Accelerations a{};
  typename M::Multipliers lambda{};
  for (const double start : {pi / 2, -pi / 2, 2.0}) {
    for (const double rate : {0.0, -3.0}) {
      const auto closed = equations_of_motion<M>({start, rate});
      const auto constrained = constrained_motion<M>({start, rate});
      for (int right = 0; right <= windows + 1; ++right) {
        const auto state = flat_state<windows>(right, rate);
        EXPECT_EQ(closed.accelerations(state, a, lambda), Evaluation::singular) << windows << start << right;
        EXPECT_EQ(constrained.accelerations(state, a, lambda), Evaluation::singular) << windows << ' ' << start;
      }
    }
  }
}
TEST(ChangePoints, HaveNoAccelerationsWhicheverWayTheCranksLie) {
  expect_no_accelerations_where_all_is_flat<1>();
  expect_no_accelerations_where_all_is_flat<2>();
  expect_no_accelerations_where_all_is_flat<5>();
}

TEST(ChangePoints, LeaveAStateOnItsBranch) {
  // Beside the flat position by 1e-7, where rounding of positions would turn a velocity by 1e-9.
  using M = Windows<2>;
  const auto motion = equations_of_motion<M>();
  for (const double away : {0.0, 1e-10, 1e-7, -1e-5, 1e-3}) {
    auto y = pack<M>(M::initial_state({pi / 2 + away, -4.0}));
    const auto before = y;
    y[5] += 1e-3;  // of the first crank's velocity
    ASSERT_EQ(motion.project(0.0, y), Evaluation::ok) << away;
    // The velocity that is off displaces the outer nodes by 4e-5 across the branch, and they return off by the square
    // of this along it, 2e-9; smooth in σ, it leaves its eighth differences.
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(y[i], before[i], 1e-10) << away;
    // The least change shares 1e-3 out among cranks in the ratio of their masses; all turn alike.
    EXPECT_NEAR(y[6], y[5], 1e-10) << away;
    EXPECT_NEAR(y[7], y[5], 1e-10) << away;
    EXPECT_NEAR(y[8], 0.0, 1e-10) << away;
    const double share = M::mass_of(0) / (M::mass_of(0) + M::mass_of(1) + M::mass_of(2));
    EXPECT_NEAR(y[5], -4.0 + 1e-3 * share, 1e-10) << away;
  }
}

/// A bar of length 1 between the ends of two cranks by its length alone, f = (|P1 - P0|² - 1)/2: one constraint, whose
/// whole gradient vanishes where all is flat.
struct BarByItsLength : mechanisms::Contract<2, 1> {
  struct Parameters {
    [[maybe_unused]] static constexpr int size = 2;
    double angle, rate;
  };
  [[maybe_unused]] static constexpr int parameter_count = 2;
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {2.0, 0.0}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state(const Parameters& p) noexcept { return {0.0, {{p.angle, p.angle}}, {{p.rate, p.rate}}}; }
  static State initial_state() noexcept { return initial_state(default_parameters()); }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 4>& mass) noexcept {
    mass = {1.0, 0.0, 0.0, 2.0};
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    h = {{9.81 * std::sin(s.q[0]), 2 * 9.81 * std::sin(s.q[1])}};
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    const double sa = std::sin(s.q[0]), ca = std::cos(s.q[0]), sb = std::sin(s.q[1]), cb = std::cos(s.q[1]);
    const double x = 1.0 + sb - sa, y = ca - cb, a = s.v[0], b = s.v[1];
    const double xa = -ca, ya = -sa, xb = cb, yb = sb;
    c.value = {(x * x + y * y - 1.0) / 2};
    c.jacobian = {x * xa + y * ya, x * xb + y * yb};
    c.rate = {c.jacobian[0] * a + c.jacobian[1] * b};
    const double vx = xa * a + xb * b, vy = ya * a + yb * b;
    c.gamma = {vx * vx + vy * vy + x * (sa * a * a - sb * b * b) + y * (-ca * a * a + cb * b * b)};
  }
  static double energy(const State& s) noexcept {
    return (0.5 * s.v[0] * s.v[0] + s.v[1] * s.v[1] - 9.81 * (std::cos(s.q[0]) + 2 * std::cos(s.q[1]))) / 3;
  }
};
TEST(ChangePoints, AreNoticedWhereAConstraintVanishesAsAWhole) {
  expect_errors_to_fall(projected(constrained_motion<BarByItsLength>()), 1e-11);
  BarByItsLength::Accelerations a{};
  BarByItsLength::Multipliers lambda{};
  EXPECT_EQ(constrained_motion<BarByItsLength>().accelerations(BarByItsLength::initial_state({pi / 2, 1.0}), a, lambda),
            Evaluation::singular);
}

/// Two skates under one point of a slope, which turn at rates of their own: the point stays, but for the moment when
/// they are parallel, where one of the two conditions is lost. Not holonomic.
struct TwoSkates : mechanisms::Contract<4, 2> {
  [[maybe_unused]] static constexpr int parameter_count = 0;
  static State initial_state() noexcept { return {0.0, {{0.0, 0.0, 0.3, 1.5}}, {{0.0, 0.0, 0.25, -0.75}}}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 16>& mass) noexcept {
    mass.fill(0.0);
    for (std::size_t i = 0; i < 4; ++i) mass[5 * i] = 1.0;
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {{-3.0, 0.0, 0.0, 0.0}}; }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c = {};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto i = static_cast<int>(2 + k);
      const double sine = std::sin(s.q[i]), cosine = std::cos(s.q[i]);
      c.jacobian[k] = -sine;
      c.jacobian[2 + k] = cosine;
      c.rate[k] = -sine * s.v[0] + cosine * s.v[1];
      c.gamma[k] = -s.v[i] * (cosine * s.v[0] + sine * s.v[1]);
    }
  }
};
TEST(ChangePoints, OfSystemsThatAreNotHolonomicArePassedToo) {
  const auto motion = projected(constrained_motion<TwoSkates>());
  auto y = motion.initial();
  double moved = 0.0;
  const auto result = integrate(motion, y, 0, 10, with_tolerance<DormandPrince853>(1e-10), [&](double, const auto& s) {
    moved = std::max({moved, std::abs(s[0]), std::abs(s[1]), std::abs(s[4]), std::abs(s[5])});
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(moved, 1e-9);  // 10 s at 1e-10
  EXPECT_NEAR(y[2], 0.3 + 2.5, 1e-9);
  EXPECT_NEAR(y[3], 1.5 - 7.5, 1e-9);
  EXPECT_LT(result.statistics.accepted + result.statistics.rejected, 300);
}

TEST(RedundantLoops, TakeNoMoreStepsThanTheirMotionAsksFor) {
  // Bricard's linkage: one of six equations repeats the others. Those of a tolerance let go took ten times as many.
  using mechanisms::Bricard;
  const double near = change_point_tolerance<double>();
  const auto steps = [](const auto& motion) {
    auto y = motion.initial();
    const double before = Bricard::energy(unpack<Bricard>(0.0, y));
    const auto result = integrate(motion, y, 0, 5, with_tolerance<DormandPrince853>(1e-10));
    EXPECT_TRUE(result) << describe(result);
    EXPECT_NEAR(Bricard::energy(unpack<Bricard>(0.0, y)), before, 1e-10 * 180 * 200);
    return result.statistics.accepted + result.statistics.rejected;
  };
  EXPECT_LE(steps(projected(constrained_motion<Bricard>())),
            1.2 * static_cast<double>(steps(projected(constrained_motion<Bricard>({}, {}, near), near))));
}

/// As a header without the kernel `mass_matrix`, which this hides.
struct WithoutMassMatrix : Windows<1> {
  [[maybe_unused]] static constexpr int mass_matrix = 0;
};
TEST(ClosedMotion, IsTheDefaultOfMechanismsWithConstraints) {
  using Pendulum = mechanisms::CartesianPendulum<double>;
  static_assert(std::is_same_v<decltype(equations_of_motion<Pendulum>()), ClosedMotion<Pendulum>>);
  static_assert(std::is_same_v<decltype(unprojected_motion<Pendulum>()), EquationsOfMotion<Pendulum>>);
  static_assert(std::is_same_v<decltype(equations_of_motion<mechanisms::Oscillator<double>>()),
                               EquationsOfMotion<mechanisms::Oscillator<double>>>);
  // Without the kernel that it takes it does not compile, and names it.
  static_assert(detail::holds_its_constraints<Pendulum> && !detail::holds_its_constraints<WithoutMassMatrix>);
  static_assert(detail::holds_its_constraints<mechanisms::Oscillator<double>>);
  const auto drift = [](const auto& motion) {
    auto y = motion.initial();
    EXPECT_TRUE(integrate(motion, y, 0, 10, RungeKutta4{.step = 0.01}));
    return std::abs(y[0] * y[0] + y[1] * y[1] - 1);
  };
  EXPECT_LT(drift(equations_of_motion<Pendulum>()), 1e-15);
  EXPECT_GT(drift(unprojected_motion<Pendulum>()), 1e-5);
}

TEST(StepTooSmall, NamesTheModelThatFailsNearby) {
  Result<double> result;
  result.status = IntegrationStatus::step_too_small;
  EXPECT_EQ(describe(result).find("singular"), std::string::npos);
  EXPECT_NE(describe(result).find("a mode is fast"), std::string::npos);
  result.evaluation = Evaluation::singular;
  EXPECT_NE(describe(result).find("change point"), std::string::npos);
  EXPECT_NE(describe(result).find("chart"), std::string::npos);
}

}  // namespace
}  // namespace change_points_test
