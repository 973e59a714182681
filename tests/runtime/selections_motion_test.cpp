// SPDX-License-Identifier: GPL-3.0-or-later
// Motions under forces that take several forms: a tabulated potential, stops, steps, drag by |v| v.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/emission/golden/selections.hpp.txt"

namespace torsor::runtime::selections_motion_test {
namespace {

using Mass = golden_selections::Mechanism<double>;

std::array<double, 4> start() { return {0.2, 0.6, -1.5, 0.8}; }

TEST(SelectionsMotion, EndsAlikeByEveryMethod) {
  // Through six switches and more in three seconds. Steps across a switch are refused until their errors are within the
  // tolerance; 8(5,3) and Taylor find them by different means, fixed steps not at all: of those the error is that of
  // one step across each, with jumps of a few N over 2 kg in 1e-5 s.
  const auto motion = equations_of_motion<Mass>();
  auto by_taylor = start(), by_853 = start(), by_steps = start();
  const auto first = integrate(motion, by_taylor, 0.0, 3.0, Taylor{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
  const auto second =
      integrate(motion, by_853, 0.0, 3.0, DormandPrince853{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
  const auto third = integrate(motion, by_steps, 0.0, 3.0, RungeKutta4{.step = 1e-5});
  EXPECT_TRUE(first) << describe(first);
  EXPECT_TRUE(second) << describe(second);
  EXPECT_TRUE(third) << describe(third);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(by_taylor[i], by_853[i], 1e-8) << i;
    EXPECT_NEAR(by_steps[i], by_853[i], 1e-4) << i;
  }
}

/// The work of all that has no potential is integrated beside the motion: it is what the energy changes by.
TEST(SelectionsMotion, ClosesItsBalanceOfEnergy) {
  struct WithWork {
    decltype(equations_of_motion<Mass>()) motion = equations_of_motion<Mass>();
    Mass::Precomputed precomputed = Mass::precompute(Mass::default_parameters());
    static Mass::Energy energy(const Mass::Precomputed& p, const std::array<double, 5>& y) {
      Mass::State state = Mass::initial_state();
      state.q.x = y[0], state.q.y = y[1], state.v.x = y[2], state.v.y = y[3];
      Mass::Energy e;
      Mass::energy(p, state, {}, e);
      return e;
    }
    Evaluation operator()(double t, const std::array<double, 5>& y, std::array<double, 5>& rates) noexcept {
      std::array<double, 4> own{y[0], y[1], y[2], y[3]}, slopes{};
      const auto status = motion(t, own, slopes);
      for (std::size_t i = 0; i < 4; ++i) rates[i] = slopes[i];
      rates[4] = energy(precomputed, y).power;
      return status;
    }
  };
  WithWork system;
  std::array<double, 5> y{0.2, 0.6, -1.5, 0.8, 0};
  const auto before = WithWork::energy(system.precomputed, y);
  const auto result =
      integrate(system, y, 0.0, 3.0, DormandPrince853{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
  EXPECT_TRUE(result) << describe(result);
  const auto after = WithWork::energy(system.precomputed, y);
  const double gained = after.kinetic - after.force_function - (before.kinetic - before.force_function);
  EXPECT_NEAR(gained, y[4], 1e-8);
}

/// A unit mass at rest under 4 N for 5 s <= t < 5.5 s: at 10 s x = 9.5 m and v = 2 m/s.
struct Pulse {
  using State = std::array<double, 2>;
  static double force(double t) noexcept { return t >= 5.0 && t < 5.5 ? 4.0 : 0.0; }
  Evaluation operator()(double t, const State& y, State& dydt) const noexcept {
    dydt = {y[1], force(t)};
    return Evaluation::ok;
  }
  Evaluation jets(double t, const State& y, std::span<State> c) const noexcept {
    for (State& each : c) each = {};
    c[0] = y;
    c[1] = {y[1], force(t)};
    if (c.size() > 2) c[2] = {force(t) / 2, 0.0};
    return Evaluation::ok;
  }
};
template <class Method>
void expect_pulse_is_kept(Method method) {
  // Tolerances of 1e-9 in some hundred steps; one step across a switch may err by as much as all others.
  const auto expect_end = [](const Pulse::State& y, const char* how) {
    EXPECT_NEAR(y[1], 2.0, 1e-6) << how;
    EXPECT_NEAR(y[0], 9.5, 5e-6) << how;
  };
  method.relative_tolerance = method.absolute_tolerance = 1e-9;
  Pulse::State y{};
  const auto on = reset_at([](double t, const Pulse::State&) { return t - 5.0; }, Crossing::rising,
                           [](double, Pulse::State&) {});
  const auto off = reset_at([](double t, const Pulse::State&) { return t - 5.5; }, Crossing::rising,
                            [](double, Pulse::State&) {});
  EXPECT_TRUE(integrate_with_events(Pulse{}, y, 0.0, 10.0, method, Events(on, off)));
  expect_end(y, "guards");
  y = {};
  const std::array<double, 3> times{5.0, 5.5, 10.0};
  EXPECT_TRUE(integrate_through(Pulse{}, y, 0.0, times, method, [](double, const Pulse::State&) {}));
  expect_end(y, "through the switches");
  y = {};
  method.largest_step = 0.5;
  EXPECT_TRUE(integrate(Pulse{}, y, 0.0, 10.0, method));
  expect_end(y, "short steps");
}
TEST(SelectionsMotion, KeepsAShortPulseAsThePageOfFormulasSays) {
  expect_pulse_is_kept(DormandPrince54{});
  expect_pulse_is_kept(DormandPrince853{});
  expect_pulse_is_kept(RadauIia5{});
  expect_pulse_is_kept(Taylor{});
}

}  // namespace
}  // namespace torsor::runtime::selections_motion_test
