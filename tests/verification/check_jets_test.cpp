// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_jets.hpp"

#include <gtest/gtest.h>

#include "generator/emission/kernel_jets.hpp"
#include "generator/expression/derivative.hpp"
#include "generator/expression/series_evaluation.hpp"
#include "generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/dynamics/simple_scenes.hpp"

namespace torsor::check_jets_test {
namespace {

using namespace testing_mechanisms;

void expect_passed(const Scene& scene, int states, const std::string& what) {
  const std::vector<CheckResult> results = check_jets(scene, {.states = states});
  ASSERT_EQ(results.size(), 2U);
  for (const CheckResult& result : results)
    EXPECT_TRUE(result.passed()) << what << ": " << result.name << ' ' << result.worst;
}

TEST(CheckJets, PassesAPendulumAndAQuaternion) {
  expect_passed(pendulum(), 3, "pendulum");
  expect_passed(torque_free_body(), 3, "torque-free body");
}

// Trees and loops, every joint of the table, quaternions, laws of time, motors, redundant constraints.
TEST(CheckJets, PassesRandomMechanisms) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomMechanismOptions options{.actions = seed % 2 == 0,
                                         .motors = seed % 5 == 0,
                                         .driven = seed % 3 == 0,
                                         .constraints = seed % 2 == 1,
                                         .joints = true,
                                         .loops = seed % 4 == 3,
                                         .most_bodies = 3};
    expect_passed(random_mechanism(seed, options), 1, call_of(seed, options));
  }
}

// The coefficients by repeated symbolic derivation in time, accelerations put in: c_1 to c_3 of a mechanism in which
// nothing depends on time or inputs.
TEST(CheckJets, AgreesWithSymbolicTimeDerivatives) {
  const WorkingDigits precision(60);
  const Scene scene = pendulum();
  const Equations equations(scene);
  Program& program = equations.program();
  const Kernel kernel = make_jets(equations);
  const RandomState state(scene, 7);
  Evaluator<Real> here(program, state.in_real());
  const auto c = SeriesEvaluation<Real>(kernel.series->program, kernel.series->state, here)(3);
  const Value a = equations.forward().accelerations[0];
  // a = f(q): da/dt = f'(q) v, d²a/dt² = f''(q) v² + f'(q) a by hand of the closed form f = -(g/l) sin q.
  const Real q = here(program.symbol(kernel.series->state[0])), v = here(program.symbol(kernel.series->state[1]));
  const Real ratio = Real(Number::rational(981, 150), 60);
  EXPECT_LT(abs(here(a) + ratio * sin(q)).to_double(), 1e-55);
  EXPECT_LT(abs(here(time_derivative(a)) + ratio * cos(q) * v).to_double(), 1e-55);
  EXPECT_LT(abs(c[1][1] + ratio * sin(q)).to_double(), 1e-55);
  EXPECT_LT(abs(c[2][1] + ratio * cos(q) * v / Real(2)).to_double(), 1e-55);
  EXPECT_LT(abs(c[3][1] - (ratio * sin(q) * v * v + ratio * ratio * cos(q) * sin(q)) / Real(6)).to_double(), 1e-55);
  EXPECT_LT(abs(c[3][0] - c[2][1] / Real(3)).to_double(), 1e-55);
}

}  // namespace
}  // namespace torsor::check_jets_test
