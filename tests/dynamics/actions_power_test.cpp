// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::actions_power_test {
namespace {

using namespace testing_symbols;
using testing_mechanisms::random_mechanism;

/// Nothing is driven and nothing constrained: d(T − U)/dt along the motion is the power of the actions without a force
/// function, whose twists know nothing of the accelerations.
class RandomPower : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomPower, IsTheRateOfTheEnergyAlongTheMotion) {
  const WorkingDigits precision(50);
  const Scene scene = random_mechanism(GetParam(), {.driven = false, .constraints = false});
  const Equations equations(scene);
  const Model& model = equations.model();
  Value energy = kinetic_energy(model);
  energy -= gravity_force_function(model);
  energy -= equations.actions().spring_force_function;
  const Value rate = time_derivative(equations.program().bind(energy));
  const RandomState state(scene, GetParam());
  Evaluator<Real> here(equations.program(), state.in_real());
  const std::vector<Real> a = here(equations.forward().accelerations);
  Evaluator<Real> moving(equations.program(), [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (symbol == model.coordinates()[i].a) return a[i];
    }
    return state.in_real()(symbol);
  });
  // Terms of the rate reach some 1e4 times their sum: four digits of fifty.
  EXPECT_LT(relative_difference(moving(rate), here(equations.power())), 1e-44);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPower, ::testing::Range(1U, 61U));

}  // namespace
}  // namespace torsor::actions_power_test
