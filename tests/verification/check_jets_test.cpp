// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/long_tests.hpp"
#include "torsor/generator/verification/check_jets.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/kernels/kernel_jets.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/series_evaluation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"

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
// Ten by default, twenty with TORSOR_LONG_TESTS. Long fractions of the one of seed 1 take twice the time of all others: by
// default that of seed 13, which has its options, stands for it.
TEST(CheckJets, PassesRandomMechanisms) {
  for (unsigned each = 0; each < wanted(10U, 20U); ++each) {
    const unsigned seed = each == 1 && !wanted(false, true) ? 13 : each;
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

// Accelerations solved for in the inverse dynamics against recurrences of the solved equations, in which every
// operation of L D Lᵀ is a series: to order 12 and 60 digits.
void expect_equal_roads(const Scene& scene, const std::string& what) {
  const WorkingDigits precision(60);
  const Equations equations(scene);
  const Kernel kernel = make_jets(equations);
  ASSERT_TRUE(kernel.series && kernel.series->solve) << what;
  const SeriesSolve& solve = *kernel.series->solve;
  std::vector<Value> rates;
  const std::vector<SymbolPointer>& state = kernel.series->state;
  for (std::size_t i = 0; i + solve.unknowns.size() < state.size(); ++i) {
    rates.push_back(rate_of(equations.program(), state[i]));
  }
  for (const Value& acceleration : equations.forward().accelerations) rates.push_back(acceleration);
  const SeriesProgram solved(equations.program(), rates);
  EXPECT_LT(kernel.series->program.nonlinear_count(), solved.nonlinear_count()) << what;

  const RandomState at_random(scene, 3);
  Evaluator<Real> here(equations.program(), at_random.in_real());
  SeriesEvaluation<Real> implicit(kernel.series->program, state, here);
  implicit.solve_for(solve.unknowns, solve.start, solve.lower, solve.inverse_pivots);
  constexpr int order = 12;
  const auto found = implicit(order);
  const auto expected = SeriesEvaluation<Real>(solved, state, here)(order);
  for (int k = 0; k <= order; ++k) {
    const auto at = static_cast<std::size_t>(k);
    for (std::size_t i = 0; i < state.size(); ++i) {
      // 60 digits less what the coefficients' growth and the condition of M take.
      EXPECT_LT(testing_symbols::relative_difference(found[at][i], expected[at][i]), 1e-45) << what << ", order " << k;
    }
  }
}

TEST(Jets, SolveTheInverseDynamicsOrderByOrder) {
  Scene chain("chain");
  FrameHandle above = chain.ground();
  for (int i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i);
    const Expression angle = chain.coordinate("angle_" + number, "rad");
    const Triple place = {0, i == 0 ? metres("0") : metres("-1"), 0};
    above = chain.revolute("rod_" + number, above, i % 2 == 0 ? axis::z : axis::x, angle, {.origin = place});
    chain.body("bob_" + number, above, Inertia::point(kilograms("2")).at({0, metres("-1"), 0}));
  }
  chain.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  expect_equal_roads(chain, "chain");
}

}  // namespace
}  // namespace torsor::check_jets_test
