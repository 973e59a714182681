// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "benchmarks/model_counts/models.hpp"
#include "generator/dynamics/equations/equations.hpp"
#include "generator/expression/formula.hpp"

namespace torsor::operation_counts_test {
namespace {

/// Totals of inverse dynamics for the models of tests/reference/models.json, by name.
const std::map<std::string, int>& inverse_dynamics_totals() {
  static const std::map<std::string, int> totals = [] {
    std::map<std::string, int> all;
    for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
      const Equations equations(scene);
      all[scene.name()] = count(equations.program(), equations.inverse_dynamics()).total();
    }
    return all;
  }();
  return totals;
}

// What a 150-line prototype of the bound recursions needs, with what Pinocchio taped and optimised by CppAD needs: 60,
// 487, 808, 934 and 4,246.
TEST(OperationCounts, OfInverseDynamicsStayBelowThoseOfThePrototype) {
  const auto& totals = inverse_dynamics_totals();
  EXPECT_LE(totals.at("pend2"), 36);
  EXPECT_LE(totals.at("ur5"), 412);
  EXPECT_LE(totals.at("panda"), 782);
  EXPECT_LE(totals.at("chain8"), 963);
  EXPECT_LE(totals.at("chain32"), 4420);
}

TEST(OperationCounts, OfInverseDynamicsGrowLinearlyWithTheChain) {
  const auto& totals = inverse_dynamics_totals();
  // One line through all lengths: the same cost for every further pair of links, whatever comes before it.
  const int per_link = (totals.at("chain32") - totals.at("chain16")) / 16;
  EXPECT_NEAR(totals.at("chain16") - totals.at("chain8"), 8 * per_link, per_link / 10);
  EXPECT_NEAR(totals.at("chain8") - totals.at("chain4"), 4 * per_link, per_link / 2);
  EXPECT_GT(per_link, 50);
}

/// Axes z, x, z, x, z, x; link i along −y of length 0.5 + 0.05 i, centre at its middle, mass 1 + 0.1 i, inertia 0.01 +
/// 0.001 i, 0.002 + 0.0001 i, 0.011 + 0.001 i about it; gravity along −y.
Scene spatial_chain() {
  Scene scene("spatial_chain");
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  FrameHandle parent = scene.ground();
  Triple origin{0, 0, 0};
  for (int i = 1; i <= 6; ++i) {
    const auto number = [i](long base, long slope, long denominator, const char* unit) {
      return Expression::quantity(Number::rational(base + slope * i, denominator), Unit::parse(unit));
    };
    const std::string name = "link" + std::to_string(i);
    const Expression length = number(50, 5, 100, "m");
    parent = scene.revolute(name, parent, i % 2 == 1 ? axis::z : axis::x,
                            scene.coordinate("q" + std::to_string(i), "rad"), {.origin = origin});
    scene.body(name, parent,
               Inertia::general(number(10, 1, 10, "kg"), number(10, 1, 1000, "kg m^2"), number(20, 1, 10000, "kg m^2"),
                                number(11, 1, 1000, "kg m^2"))
                   .at({0, -length / 2, 0}));
    origin = {0, -length, 0};
  }
  return scene;
}

TEST(OperationCounts, OfMassMatrixAndBiasOfASpatialChainStayAFractionOfThoseOfEnergyLagrange) {
  const Equations equations(spatial_chain());
  std::vector<Value> outputs = equations.bias();
  for (const std::vector<Value>& row : equations.mass()) outputs.insert(outputs.end(), row.begin(), row.end());
  // Lagrange's operator on T with common sub-expressions searched at the end needs 9,151.
  EXPECT_LE(count(equations.program(), outputs).total(), 670);
}

TEST(OperationCounts, OfStructuralZerosAreZero) {
  // A planar mechanism pays nothing for the third dimension: a point pendulum needs sin and one multiplication.
  Scene scene("pendulum");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, scene.coordinate("theta", "rad"));
  scene.body("bob", arm, Inertia::point(Expression::quantity("2", "kg")).at({0, Expression::quantity("-1.5", "m"), 0}));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  const Equations equations(scene);
  const OperationCount bias = count(equations.program(), equations.bias());
  EXPECT_EQ(bias.sincos_pairs, 1);
  EXPECT_EQ(bias.additions, 0);
  EXPECT_EQ(bias.multiplications, 2);  // 2 · 1.5 times (9.81 sin θ), the acceleration being bound first
  EXPECT_EQ(count(equations.program(), equations.mass()[0]).total(), 0);
}

}  // namespace
}  // namespace torsor::operation_counts_test
