// SPDX-License-Identifier: GPL-3.0-or-later
// Events of motions with invariants: unit quaternions and closed loops hold where a guard fires, and after it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "generated/andrews_squeezer.hpp"
#include "generated/torque_free_body.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace events_on_constraints_test {
namespace {

using namespace torsor::runtime;
using Body = torque_free_body::Mechanism<double>;
using Squeezer = andrews_squeezer::Mechanism<double>;
using FourBar = mechanisms::CrankLoop<mechanisms::FourBar>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

double off_norm(const StateVector<Body>& y) {
  return std::abs(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3] - 1);
}

/// The largest |f_i|, and |A v - b|_i.
template <class M>
std::array<double, 2> residual(double t, const StateVector<M>& y) {
  typename M::Constraints c{};
  M::constraints(M::precompute(M::default_parameters()), unpack<M>(t, y), c);
  std::array<double, 2> largest{};
  for (const double f : c.value) largest[0] = std::max(largest[0], std::abs(f));
  for (const double rate : c.rate) largest[1] = std::max(largest[1], std::abs(rate));
  return largest;
}

// Tolerances so loose that interpolants are off the invariants by far more than roundings.
template <class Method>
class EventsWithQuaternions : public ::testing::Test {};
using LooseMethods = ::testing::Types<DormandPrince54, DormandPrince853, Taylor, RungeKutta4, GaussCollocation<2>>;
class LooseNames {
 public:
  template <class Method>
  static std::string GetName(int i) {
    constexpr const char* names[] = {"DormandPrince54", "DormandPrince853", "Taylor", "RungeKutta4", "GaussOrder4"};
    return names[i];
  }
};
TYPED_TEST_SUITE(EventsWithQuaternions, LooseMethods, LooseNames);

template <class Method>
Method loose(double step) {
  Method method;
  if constexpr (requires { method.relative_tolerance; }) {
    method.relative_tolerance = method.absolute_tolerance = 1e-5;
  } else {
    method.step = step;
  }
  return method;
}

TYPED_TEST(EventsWithQuaternions, KeepTheNormWhereAStopIsHitAndAfterIt) {
  // A body that tumbles hits a stop of one component of its attitude and goes back the way it came.
  const auto motion = equations_of_motion<Body>(Body::Parameters{3.0, 2.0, 1.0});
  StateVector<Body> y{1, 0, 0, 0, 1.0, 0.5, 0.25};
  double worst_told = 0.0, worst_reset = 0.0, worst_shown = 0.0, guard_left = 0.0;
  int told = 0;
  const auto inside = [](double, const StateVector<Body>& s) { return 0.4 - s[1]; };
  const auto stop = barrier(inside, [&](double, StateVector<Body>& s) {
    worst_reset = std::max(worst_reset, off_norm(s));
    for (std::size_t i = 4; i < 7; ++i) s[i] = -s[i];
    s[0] *= 1.001;  // a reset that is careless of the norm
  });
  const auto result = integrate_with_events(
      motion, y, 0, 12, loose<TypeParam>(0.1), Events(stop),
      [&](const auto& event) {
        ++told;
        worst_told = std::max(worst_told, off_norm(event.state));
        guard_left = std::max(guard_left, -inside(event.time, event.state));
      },
      [&](double, const StateVector<Body>& s) { worst_shown = std::max(worst_shown, off_norm(s)); });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_GE(told, 2);
  // The sum of four squares: some roundings of 1.
  EXPECT_LE(worst_told, 4 * epsilon);
  EXPECT_LE(worst_reset, 4 * epsilon);
  EXPECT_LE(worst_shown, 4 * epsilon);
  EXPECT_LE(off_norm(y), 4 * epsilon);
  EXPECT_LE(guard_left, 0.0);  // a barrier's state is on its side
}

template <class System, class Method>
void expect_closed_squeezer(const System& motion, const Method& method) {
  // β turns through a right angle at high speed: told of, then stopped at a whole turn.
  StateVector<Squeezer> y = motion.initial();
  const double start = y[0], pi = std::numbers::pi;
  const auto quarter = note([&](double, const StateVector<Squeezer>& s) { return s[0] - start - pi / 2; });
  const auto turn = stop_at([&](double, const StateVector<Squeezer>& s) { return s[0] - start - 2 * pi; });
  double told = 0.0, told_rate = 0.0;
  int count = 0;
  const auto result = integrate_with_events(motion, y, 0, 0.03, method, Events(quarter, turn), [&](const auto& event) {
    const auto off = residual<Squeezer>(event.time, event.state);
    told = std::max(told, off[0]);
    told_rate = std::max(told_rate, off[1]);
    ++count;
  });
  ASSERT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  EXPECT_EQ(count, 2);
  // Positions to 1e-13 of the longest bar, as after steps. Rates to 500 rad/s of bars of 0.04 m.
  EXPECT_LE(told, 1e-13 * 0.035);
  EXPECT_LE(told_rate, 1e-13 * 20);
  const auto off = residual<Squeezer>(result.time, y);
  EXPECT_LE(off[0], 1e-13 * 0.035);
  EXPECT_LE(off[1], 1e-13 * 20);
  EXPECT_GE(y[0] - start, 2 * pi);  // the first state beyond
}

TEST(EventsOnClosedLoops, LieOnTheGeneratedConstraintsOfAndrewsSqueezer) {
  const auto motion = projected(equations_of_motion<Squeezer>());
  expect_closed_squeezer(motion, loose<DormandPrince54>(0));
  expect_closed_squeezer(motion, loose<DormandPrince853>(0));
  expect_closed_squeezer(motion, RungeKutta4{.step = 2e-5});
  // Its steps end on the constraints by themselves, those to an event too.
  expect_closed_squeezer(equations_of_motion<Squeezer>(), loose<StabilisedRadauIia5>(0));
}

TEST(EventsOnClosedLoops, KeepAFourBarClosedThatHitsALimit) {
  // The second crank swings against a stop and rebounds: the reset turns its own rate only, the loop gives the others.
  const auto motion = projected(constrained_motion<FourBar>());
  StateVector<FourBar> y = motion.initial();
  const double limit = y[1] - 0.2;
  const auto beyond = [&](double, const StateVector<FourBar>& s) { return s[1] - limit; };
  const auto stop = barrier(beyond, [](double, StateVector<FourBar>& s) { s[4] = -s[4]; });
  double told = 0.0, shown = 0.0, guard_left = 0.0;
  int count = 0;
  const auto result = integrate_with_events(
      motion, y, 0, 4, loose<DormandPrince54>(0), Events(stop),
      [&](const auto& event) {
        const auto off = residual<FourBar>(event.time, event.state);
        told = std::max({told, off[0], off[1]});
        guard_left = std::max(guard_left, -beyond(event.time, event.state));
        ++count;
      },
      [&](double t, const StateVector<FourBar>& s) {
        const auto off = residual<FourBar>(t, s);
        shown = std::max({shown, off[0], off[1]});
      });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_GE(count, 2);
  // Lengths to 1 m, rates to 10/s: some roundings of each.
  EXPECT_LE(told, 10 * 8 * epsilon);
  EXPECT_LE(shown, 10 * 8 * epsilon);
  EXPECT_LE(guard_left, 0.0);
}

/// At rest, but put down on a seat that sinks from 1 and comes back within every second: to 0.6, from t = 2 on to -0.2.
struct OnASeat {
  static double seat(double t) { return 1 - (t < 2 ? 0.4 : 1.2) * std::pow(std::sin(std::numbers::pi * t), 2); }
  Evaluation operator()(double, const std::array<double, 1>&, std::array<double, 1>& rate) const noexcept {
    rate[0] = 0.0;
    return Evaluation::ok;
  }
  [[nodiscard]] Evaluation project(double t, std::array<double, 1>& y) const noexcept {
    y[0] = seat(t);
    return Evaluation::ok;
  }
};

// Steps of a whole second end where they began; only what settling says of the states inside shows the crossings.
TEST(EventsOfSettledStates, AreSeenInsideAStepAcrossWhichNothingMoves) {
  std::array<double, 1> y{1.0};
  const DormandPrince54 by_seconds{.first_step = 1.0, .largest_step = 1.0};
  const auto below = stop_at([](double, const std::array<double, 1>& s) { return s[0]; });
  const auto result = integrate_with_events(OnASeat{}, y, 0.0, 5.0, by_seconds, Events(below));
  ASSERT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  const double crossing = 2 + std::asin(std::sqrt(1 / 1.2)) / std::numbers::pi;  // where the slope is -2.8 1/s
  EXPECT_NEAR(result.time, crossing, 16 * epsilon);
}

}  // namespace
}  // namespace events_on_constraints_test
