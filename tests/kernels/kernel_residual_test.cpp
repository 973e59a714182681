// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_residual.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "tests/dynamics/central_differences.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/kernels/compressed_tables.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::kernel_residual_test {
namespace {

using testing_headers::numbers;
using testing_mechanisms::CentralDifferences;
using testing_mechanisms::largest_difference;

std::vector<Value> values_of(const Kernel& kernel) {
  std::vector<Value> all;
  for (const Assignment& assignment : kernel.assignments) all.push_back(assignment.value);
  return all;
}

/// A column of the Jacobian, its zeros filled in.
std::vector<Real> column(const Kernel& jacobian, const std::vector<Real>& entries, std::size_t which) {
  const std::vector<ConstantTable>& tables = jacobian.structures[0].tables;
  const std::vector<std::size_t> starts = numbers(tables, "residual_jacobian_row_start");
  const std::vector<std::size_t> columns = numbers(tables, "residual_jacobian_column");
  EXPECT_EQ(columns.size(), entries.size());
  std::vector<Real> all(starts.size() - 1, Real(0));
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    for (std::size_t k = starts[i]; k < starts[i + 1]; ++k) {
      if (columns[k] == which) all[i] = entries[k];
    }
  }
  return all;
}

struct Met {
  int attitudes = 0, constraints = 0, inputs = 0, repeated = 0;
  std::size_t places = 0, entries = 0;
};

/// The Jacobian against slopes of the residual, the residual against the motion.
void expect_residual_and_its_slopes(const Scene& scene, std::uint64_t seed, Met& met) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Equations equations(scene);
  const Model& model = equations.model();
  const Kernel residual = make_residual(equations), jacobian = make_residual_jacobian(equations);
  const std::vector<Value> rows = values_of(residual);
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const std::size_t m = equations.constraints().size();
  ASSERT_EQ(rows.size(), n + m);
  CentralDifferences differences(equations, seed);
  const std::vector<Real> entries = differences.at(values_of(jacobian));
  const auto compare = [&](std::size_t which, const CentralDifferences::Change& change) {
    EXPECT_LT(largest_difference(column(jacobian, entries, which), differences(rows, change)), CentralDifferences::bound)
        << scene.name() << ", column " << which;
  };
  for (std::size_t j = 0; j < n; ++j) {
    compare(j, differences.along(j));
    compare(n + j, differences.of(model.coordinates()[j].v));
    compare(2 * n + j, differences.of(model.coordinates()[j].a));
    met.attitudes += model.coordinates()[j].attitude >= 0;
  }
  for (std::size_t k = 0; k < m; ++k) compare(3 * n + k, differences.of(equations.constraints()[k].multiplier));

  Substitution along = at_motion(equations, equations.forward());
  std::vector<Value> left;
  for (const Value& row : rows) left.push_back(along(row));
  // Accelerations of the random state are below 1e8 (central_differences.hpp), and so is what their rounding leaves.
  for (const Real& row : differences.at(left)) EXPECT_LT(abs(row).to_double(), 1e-40) << scene.name();

  met.constraints += static_cast<int>(m);
  met.inputs += static_cast<int>(model.inputs().size());
  met.repeated += static_cast<int>(equations.redundancy().dropped.size());
  met.places += (n + m) * (3 * n + m);
  met.entries += entries.size();
}

TEST(Residual, VanishesAlongTheMotionAndHasItsSlopes) {
  Met met;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    testing_mechanisms::RandomMechanismOptions options;
    options.motors = seed % 2 == 0;
    options.joints = options.loops = seed % 3 == 0;
    options.chains = seed % 6 == 3;
    options.constraints = seed % 3 == 1;
    options.most_bodies = 3;
    SCOPED_TRACE(testing_mechanisms::call_of(seed, options));
    expect_residual_and_its_slopes(testing_mechanisms::random_mechanism(seed, options), seed, met);
  }
  EXPECT_GT(met.attitudes, 0);
  EXPECT_GT(met.constraints, 0);
  EXPECT_GT(met.inputs, 0);
  EXPECT_GT(met.repeated, 0);
  EXPECT_LT(met.entries, met.places);
}

TEST(Residual, OfThePendulumIsWrittenOut) {
  // r = m l² a + m g l sin q - u: 2 · (3/2)² = 9/2 kg m², 2 · 9.81 · 3/2 = 29.43 N m.
  const Equations equations(testing_mechanisms::pendulum());
  const Kernel jacobian = make_residual_jacobian(equations);
  const std::vector<ConstantTable>& tables = jacobian.structures[0].tables;
  EXPECT_EQ(numbers(tables, "residual_jacobian_row_start"), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(numbers(tables, "residual_jacobian_column"), (std::vector<std::size_t>{0, 2}));
  testing_mechanisms::NamedState at(equations, {{"theta", Real(1)}});
  EXPECT_NEAR(at.in_double(jacobian.assignments[0].value), 29.43 * std::cos(1.0), 1e-13);
  EXPECT_EQ(at.in_double(jacobian.assignments[1].value), 4.5);
}

}  // namespace
}  // namespace torsor::kernel_residual_test
