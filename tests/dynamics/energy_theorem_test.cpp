// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/point_cloud.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::energy_theorem_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

class RandomEnergyTheorem : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomEnergyTheorem, HoldsForAnyBodiesInAnyFrame) {
  const WorkingDigits precision(50);
  const Scene scene = random_mechanism(GetParam());
  const Equations equations(scene);
  const RandomState state(scene, 2);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const auto& bodies = scene.content().bodies;
  std::vector<BodyNames> sets{all_bodies(equations.model())};
  for (const char* name : {"body0", "body1"}) {  // one rigid body each, with what is welded to it
    BodyNames one;
    for (const BodyContent& body : bodies) {
      if (body.name.substr(0, 5) == name) one.push_back(body.name);
    }
    if (!one.empty()) sets.push_back(one);
  }
  for (const BodyNames& set : sets) {
    for (const char* observer : {"ground", "body0"}) {
      const EnergyTheorem theorem = energy_theorem(equations, set, observer);
      const Real power = evaluate(theorem.external_power) + evaluate(theorem.internal_power);
      EXPECT_LT(relative_difference(power, evaluate(theorem.kinetic_rate)), 1e-43) << observer << " " << set.size();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEnergyTheorem, ::testing::Range(600U, 615U));

/// Two masses on rails with a spring between them and one to the ground, drag on each other and a given force, seen
/// from the ground and from a turntable that does not carry them.
struct Rails {
  Rails() {
    const auto newton = [](const char* value) { return Expression::quantity(value, "N"); };
    const Expression stiffness = Expression::quantity("11", "N/m");
    const Expression x1 = scene.coordinate("x1", "m");
    const Expression x2 = scene.coordinate("x2", "m");
    const Placement start{.origin = {0, metres("0.5"), metres("0.2")}};
    const FrameHandle table = scene.revolute("table", scene.ground(), {1, 2, 2}, scene.coordinate("q", "rad"),
                                             {.origin = {metres("0.3"), 0, metres("0.1")}});
    const FrameHandle m1 = scene.prismatic("m1", scene.ground(), axis::x, x1, start);
    const FrameHandle m2 = scene.prismatic("m2", scene.ground(), {0, 3, 4}, x2, start);
    scene.body("table", table, Inertia::disk(kilograms("5"), metres("1"), 2));
    scene.body("m1", m1, Inertia::solid_sphere(kilograms("2"), metres("0.1")));
    scene.body("m2", m2, Inertia::solid_sphere(kilograms("3"), metres("0.1")));
    scene.point("A1", m1, {metres("0.2"), metres("0.1"), 0});
    scene.point("A2", m2, {metres("-0.3"), metres("0.1"), 0});
    scene.point("post", scene.ground(), {metres("2"), metres("-1"), metres("0.7")});
    scene.spring("between",
                 {.a = scene.point("A1"), .b = scene.point("A2"), .stiffness = stiffness, .rest = metres("0.4")});
    scene.spring("to_ground",
                 {.a = scene.point("A1"), .b = scene.point("post"), .stiffness = stiffness, .rest = metres("0.3")});
    scene.drag("drag", {.body = m1,
                        .point = PointReference("A2"),
                        .coefficient = Expression::quantity("0.6", "N s/m"),
                        .relative_to = m2});
    scene.force("push", {.body = m1,
                         .point = PointReference("A1"),
                         .components = {newton("3"), newton("-1"), newton("2")},
                         .axes = scene.ground()});
    scene.spring("return", x1, stiffness, metres("0.2"));
  }
  Scene scene{"rails"};
};

TEST(Power, OfAMutualActionIsTheSameInEveryFrame) {
  const WorkingDigits precision(50);
  const Rails given;
  const Equations equations(given.scene);
  const RandomState state(given.scene, 6);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  for (const char* name : {"between", "to_ground", "drag", "return"}) {
    const Real in_ground = evaluate(action_power(equations, name));
    EXPECT_GT(abs(in_ground).to_double(), 1e-3) << name;
    for (const char* observer : {"table", "m1", "m2"}) {
      EXPECT_LT(relative_difference(evaluate(action_power(equations, name, observer)), in_ground), 1e-45) << name;
    }
  }
  // And it is the rate of the springs' own force function, by differentiation.
  const Value springs = equations.program().bind(equations.actions().spring_force_function);
  const Value rate = time_derivative(springs);
  const Real sum = evaluate(action_power(equations, "between")) + evaluate(action_power(equations, "to_ground")) +
                   evaluate(action_power(equations, "return"));
  EXPECT_LT(relative_difference(sum, evaluate(rate)), 1e-45);
}

TEST(Power, OfAnExternalActionChangesWithTheFrame) {
  const WorkingDigits precision(50);
  const Rails given;
  const Equations equations(given.scene);
  const Model& model = equations.model();
  const RandomState state(given.scene, 6);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const Column force{Real(3), Real(-1), Real(2)};
  // F · V(A1/ground), and F · V(A1/table) = F · V(A1/ground) − F · V(A1 ∈ table/ground).
  const Column velocity = columns(evaluate, rates_of(model.locate(PointReference("A1"), 0, "test")));
  EXPECT_LT(relative_difference(evaluate(action_power(equations, "push")), dot(force, velocity)), 1e-45);
  const int table = model.place("table", "test").link;
  const Twist twist = relative_twist(model, table, 0);
  const Vector place = model.locate(PointReference("A1"), table, "test");
  const Vector carried = model.express(reduced_at(twist, place).linear, table, 0);
  const Real change = dot(force, columns(evaluate, carried));
  EXPECT_GT(abs(change).to_double(), 1e-2);
  EXPECT_LT(relative_difference(evaluate(action_power(equations, "push", "table")), dot(force, velocity) - change),
            1e-45);
  EXPECT_EQ(error_of<SceneError>([&] { action_power(equations, "wind"); }),
            "unknown action 'wind': the scene has between, to_ground, drag, push, return");
}

TEST(EnergyTheorem, SortsPowersByTheBoundary) {
  const WorkingDigits precision(50);
  const Rails given;
  const Equations equations(given.scene);
  const RandomState state(given.scene, 6);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const Real both = evaluate(energy_theorem(equations, {"m1", "m2"}).internal_power);
  const Real inside = evaluate(action_power(equations, "between")) + evaluate(action_power(equations, "drag"));
  EXPECT_LT(relative_difference(both, inside), 1e-45);
  EXPECT_LT(relative_difference(evaluate(energy_theorem(equations, {"m1", "m2"}, "table").internal_power), inside),
            1e-45);
  EXPECT_TRUE(energy_theorem(equations, {"m1"}).internal_power.is_zero());
}

}  // namespace
}  // namespace torsor::energy_theorem_test
