// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by parameters against central differences in sixty digits, and against the regressor.
#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/recursions/regressor.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "tests/dynamics/central_differences.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::parameter_sensitivities_test {
namespace {

using testing_mechanisms::CentralDifferences;
using testing_mechanisms::column;
using testing_mechanisms::largest_difference;

ModelOptions all_run_time() { return {.all_run_time = true}; }

/// Of inverse and forward dynamics, by every parameter; true where the scene has constraints.
bool expect_slopes(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Equations one(scene, all_run_time()), other(scene, all_run_time());
  const ValueMatrix inverse = inverse_sensitivities(one);
  const ForwardSensitivities forward = forward_sensitivities(one);
  const std::vector<SymbolPointer> parameters = sensitivity_parameters(one);
  EXPECT_EQ(parameters.size(), scene.content().parameters.size());
  std::vector<Value> forces = other.inverse_dynamics();
  forces.resize(static_cast<std::size_t>(other.model().unknown_count()));
  const ForwardSolution& motion = other.forward();
  const RandomState state(scene, seed);
  Evaluator<Real> at(one.program(), state.in_real());
  CentralDifferences differences(other, seed);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto compare = [&](const ValueMatrix& exact, const std::vector<Value>& values) {
      const std::vector<Real> slopes = differences(values, CentralDifferences::of(parameters[k]));
      EXPECT_LT(largest_difference(at(column(exact, k)), slopes), CentralDifferences::bound)
          << scene.name() << " " << seed << " by " << parameters[k]->name;
    };
    compare(inverse, forces);
    compare(forward.accelerations, motion.accelerations);
    compare(forward.multipliers, motion.multipliers);
  }
  return !other.constraints().empty();
}

/// A bar of a run-time mass and length that slides down a wall, held there by a constraint, with a spring and a damper
/// whose laws have parameters, on a wall that a law of time moves.
Scene bar_at_a_wall() {
  Scene scene("bar_at_a_wall");
  const auto given = [&scene](const char* name, const char* unit, const char* value) {
    return scene.run_time_parameter(name, unit, Expression::quantity(value, unit));
  };
  const Expression mass = given("mass", "kg", "2"), length = given("length", "m", "1.5");
  const Expression stiffness = given("stiffness", "N/m", "40"), damping = given("damping", "N m s", "0.3");
  const Expression rest = given("rest", "m", "0.2"), speed = given("speed", "m/s", "0.1");
  const Expression x = scene.coordinate("x", "m"), theta = scene.coordinate("theta", "rad");
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, x);
  const FrameHandle bar = scene.revolute("bar", slider, axis::z, theta);
  scene.body("bar", bar, Inertia::point(mass).at({0, length, 0}));
  scene.body("foot", slider, Inertia::point(mass));
  scene.gravity({0, -given("g", "m/s^2", "9.81"), 0});
  scene.spring("spring", x, stiffness, rest);
  scene.damper("damper", theta, damping);
  scene.motor("push", x);
  scene.motor("pull", length * theta);  // a rope about a drum: the force's arm is a parameter
  scene.holonomic("wall", x - length * sin(theta) - speed * scene.time());
  return scene;
}

TEST(ParameterSensitivities, AreSlopesAlongEveryParameterOfAConstrainedMechanism) {
  EXPECT_TRUE(expect_slopes(bar_at_a_wall(), 2));
}

TEST(ParameterSensitivities, AreSlopesAlongEveryParameterOfRandomMechanisms) {
  int constrained = 0;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    testing_mechanisms::RandomMechanismOptions options;
    options.joints = seed % 2 == 0;
    options.most_bodies = 3;
    SCOPED_TRACE(testing_mechanisms::call_of(seed, options));
    constrained += expect_slopes(testing_mechanisms::random_mechanism(seed, options), seed) ? 1 : 0;
  }
  EXPECT_GE(constrained, 3);  // compilers draw in different orders: four mechanisms by g++, three by clang
}

TEST(ParameterSensitivities, ByAMassAreItsColumnOfTheRegressor) {
  // A point mass at the link's origin has m alone among the ten parameters of the link, and enters linearly.
  const WorkingDigits precision(CentralDifferences::digits);
  Scene scene("two_links");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, scene.coordinate("a", "rad"));
  const FrameHandle second = scene.revolute("second", first, axis::x, scene.coordinate("b", "rad"),
                                            {.origin = {testing_mechanisms::metres("0.7"), 0, 0}});
  const FrameHandle third = scene.prismatic("third", second, axis::z, scene.coordinate("c", "m"));
  scene.body("tip", third, Inertia::point(scene.run_time_parameter("m", "kg", testing_mechanisms::kilograms("2"))));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const Equations equations(scene);
  const ValueMatrix sensitivities = inverse_sensitivities(equations), y = regressor(equations.model());
  ASSERT_EQ(y[0].size(), 10U);
  const RandomState state(scene, 4);
  Evaluator<Real> at(equations.program(), state.in_real());
  const std::vector<Real> by_mass = at(column(sensitivities, 0)), of_regressor = at(column(y, 0));
  EXPECT_LT(largest_difference(by_mass, of_regressor), 1e-50);
  EXPECT_GT(abs(by_mass[2]).to_double(), 0.1);
}

TEST(ParameterSensitivities, AreAbsentWithoutRunTimeParameters) {
  const Equations equations(testing_mechanisms::pendulum());
  for (const char* name : {"inverse_dynamics_sensitivities", "forward_dynamics_sensitivities"}) {
    EXPECT_EQ(make_kernel(name, equations).skipped,
              "no parameter is set at run time (run_time_parameter, or --run-time)");
  }
}

}  // namespace
}  // namespace torsor::parameter_sensitivities_test
