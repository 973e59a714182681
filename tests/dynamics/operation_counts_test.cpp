// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor::operation_counts_test {
namespace {

struct Totals {
  int inverse_dynamics = 0, mass_matrix = 0, forward_dynamics = 0;
};

int total(const Program& program, const ValueMatrix& matrix) {
  std::vector<Value> entries;
  for (const std::vector<Value>& row : matrix) entries.insert(entries.end(), row.begin(), row.end());
  return count(program, entries).total();
}

/// Of the models of tests/reference/models.json, by name.
const std::map<std::string, Totals>& totals_of_models() {
  static const std::map<std::string, Totals> totals = [] {
    std::map<std::string, Totals> all;
    for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
      const Equations equations(scene);
      Totals& of = all[scene.name()];
      of.inverse_dynamics = count(equations.program(), equations.inverse_dynamics()).total();
      of.mass_matrix = total(equations.program(), equations.mass());
      of.forward_dynamics = count(equations.program(), equations.forward().accelerations).total();
    }
    return all;
  }();
  return totals;
}

// Some four fifths to two thirds of what Pinocchio's algorithms need, taped and optimised by CppAD: 60, 487, 808, 934,
// 2,038, 4,246 for inverse dynamics, 27, 268, 626, 726, 2,498, 7,896 for the mass matrix, and 73, 1,148, 1,792, 2,078,
// 4,850, 10,336 for forward dynamics. No way to a mass matrix of chain32 below 7,162 is known: docs/kernels.md.
TEST(OperationCounts, OfSerialChainsStayBelowTheirLimits) {
  const std::map<std::string, Totals> limits{
      {"pend2", {28, 8, 37}},        {"ur5", {330, 205, 640}},         {"panda", {600, 430, 1250}},
      {"chain8", {740, 570, 1550}},  {"chain16", {1600, 1900, 3600}},  {"chain32", {3300, 7162, 7800}}};
  for (const auto& [model, limit] : limits) {
    const Totals& of = totals_of_models().at(model);
    EXPECT_LE(of.inverse_dynamics, limit.inverse_dynamics) << model;
    EXPECT_LE(of.mass_matrix, limit.mass_matrix) << model;
    EXPECT_LE(of.forward_dynamics, limit.forward_dynamics) << model;
  }
}

TEST(OperationCounts, OfInverseDynamicsGrowLinearlyWithTheChain) {
  const auto inverse_dynamics = [](const char* model) { return totals_of_models().at(model).inverse_dynamics; };
  // One line through all lengths: the same cost for every further pair of links, whatever comes before it.
  const int per_link = (inverse_dynamics("chain32") - inverse_dynamics("chain16")) / 16;
  EXPECT_NEAR(inverse_dynamics("chain16") - inverse_dynamics("chain8"), 8 * per_link, per_link / 10);
  EXPECT_NEAR(inverse_dynamics("chain8") - inverse_dynamics("chain4"), 4 * per_link, per_link / 2);
  EXPECT_GT(per_link, 50);
}

// An arm of six joints about z, x, z, x, z, x; link i along −y of length 0.5 + 0.05 i, its centre in the middle.
TEST(OperationCounts, OfMassMatrixAndBiasOfAnArmStayAFractionOfThoseOfEnergyLagrange) {
  const std::vector<Scene> scenes = read_models(TORSOR_SOURCE_DIR "/tests/reference/arm6.json");
  const Equations equations(scenes.at(0));
  std::vector<Value> outputs = equations.bias();
  for (const std::vector<Value>& row : equations.mass()) outputs.insert(outputs.end(), row.begin(), row.end());
  // Lagrange's operator on T with common sub-expressions searched at the end needs 9,151.
  EXPECT_LE(count(equations.program(), outputs).total(), 580);
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
