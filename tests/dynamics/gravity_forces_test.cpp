// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/gravity_forces.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::gravity_forces_test {
namespace {

using namespace testing_mechanisms;

/// Against minus the gradient of the force function of weight. Forces are below 1e4: 50 digits leave 1e-44.
void expect_gradient(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(50);
  const Equations equations(scene);
  const Model& model = equations.model();
  const std::vector<Value> forces = gravity_forces(model);
  const Value force_function = gravity_force_function(model);
  const RandomState state(scene, seed);
  Evaluator<Real> at(equations.program(), state.in_real());
  double size = 0;
  for (int i = 0; i < model.unknown_count(); ++i) {
    Derivation slope = model.along(i);
    const Real expected = at(slope(force_function));
    const Real found = at(forces[static_cast<std::size_t>(i)]);
    EXPECT_LE(abs(found + expected).to_double(), 1e-44) << scene.name() << " " << seed << ", coordinate " << i;
    size += abs(expected).to_double();
  }
  EXPECT_GT(size, 0) << scene.name() << " " << seed << ": nothing was compared";
}

class RandomWeights : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomWeights, AreTheGradientOfTheForceFunction) {
  expect_gradient(random_mechanism(GetParam(), {.actions = true, .constraints = false}), 3);
  expect_gradient(random_mechanism(GetParam(), {.actions = false, .constraints = false, .joints = true}), 4);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomWeights, ::testing::Range(1U, 9U));

/// Three rods in a plane.
Scene rods() {
  Scene scene("rods");
  FrameHandle parent = scene.ground();
  for (int k = 0; k < 3; ++k) {
    const std::string name = "rod" + std::to_string(k);
    const Expression q = scene.coordinate("q" + std::to_string(k), "rad");
    const FrameHandle frame = scene.revolute(name, parent, axis::z, q);
    scene.body(name + "_mass", frame, Inertia::point(kilograms("2")).at({0, metres("-0.5"), 0}));
    parent = scene.weld(name + "_end", frame, {{0, metres("-1"), 0}, {}});
  }
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  return scene;
}

/// Operations of a kernel, a sine and a cosine two.
int operations(const Scene& scene, const char* name) {
  const Equations equations(scene);
  const Kernel kernel = make_kernel(name, equations);
  return count(equations.program(), kernel.values()).total();
}

TEST(GravityForces, AreTheBiasAtRest) {
  const WorkingDigits precision(50);
  const Scene scene = rods();
  const Equations equations(scene);
  const Kernel gravity = make_kernel("gravity", equations);
  NamedState state(equations, {{"q0", Real(Number::rational(1, 3), 50)},
                               {"q1", Real(Number::rational(-2, 3), 50)},
                               {"q2", Real(Number::rational(5, 4), 50)}});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(abs(state(gravity.assignments[i].value) - state(equations.bias()[i])).to_double(), 1e-44) << i;
    EXPECT_GT(abs(state(equations.bias()[i])).to_double(), 1) << i;
  }
}

/// Six joints whose axes take turns, each link a rod off its axis: weight is a vector in and a vector out for each
/// link, the bias two accelerations out and two of a wrench in.
TEST(GravityForces, CostAFractionOfTheBias) {
  Scene scene("arm");
  FrameHandle parent = scene.ground();
  for (int k = 0; k < 6; ++k) {
    const std::string name = "link" + std::to_string(k);
    const Expression q = scene.coordinate("q" + std::to_string(k), "rad");
    const FrameHandle frame = scene.revolute(name, parent, k % 2 == 0 ? axis::z : axis::x, q);
    scene.body(name + "_mass", frame,
               Inertia::rod(kilograms("2"), metres("0.5"), 1).at({metres("0.1"), metres("0.25"), 0}));
    parent = scene.weld(name + "_end", frame, {{0, metres("0.5"), 0}, {}});
  }
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  EXPECT_LT(4 * operations(scene, "gravity"), operations(scene, "bias"));
}

TEST(GravityForces, AreAbsentWithoutGravity) {
  Scene scene("weightless");
  const Expression q = scene.coordinate("q", "rad");
  scene.body("mass", scene.revolute("arm", scene.ground(), axis::z, q),
             Inertia::point(kilograms("2")).at({metres("1"), 0, 0}));
  EXPECT_EQ(why_absent("gravity", Equations(scene)), "the scene has no gravity");
}

/// A vector of run-time parameters turns with what the mechanism is bolted to.
TEST(GravityForces, FollowAGravityThatIsSetAtRunTime) {
  const WorkingDigits precision(50);
  Scene scene("on_a_wall");
  const Expression q = scene.coordinate("q", "rad");
  const Expression gx = scene.run_time_parameter("gx", "m/s^2", Expression::quantity("0", "m/s^2"));
  const Expression gy = scene.run_time_parameter("gy", "m/s^2", Expression::quantity("-9.81", "m/s^2"));
  scene.body("mass", scene.revolute("arm", scene.ground(), axis::z, q),
             Inertia::point(kilograms("2")).at({metres("1"), 0, 0}));
  scene.gravity({gx, gy, 0});
  const Equations equations(scene);
  const Kernel gravity = make_kernel("gravity", equations);
  NamedState state(equations, {{"gx", Real(3)}, {"gy", Real(-5)}});
  EXPECT_LE(abs(state(gravity.assignments[0].value) - Real(10)).to_double(), 1e-44);  // −m (g · ∂OG/∂q) = −2 (−5)
}

}  // namespace
}  // namespace torsor::gravity_forces_test
