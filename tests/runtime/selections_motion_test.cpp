// SPDX-License-Identifier: GPL-3.0-or-later
// Motions under forces that take several forms: a tabulated potential, stops, steps, drag by |v| v.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"
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

}  // namespace
}  // namespace torsor::runtime::selections_motion_test
