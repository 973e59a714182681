// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_sparse_jacobian.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/kernels/compressed_tables.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::kernel_sparse_jacobian_test {
namespace {

using testing_headers::constant;
using testing_headers::numbers;

/// Two carts, three constraints: that the first keeps to y = 2 x, that the second follows it in x, and a condition on
/// rates whose entry along the last coordinate is 1 - sin² - cos² = 0.
Scene carts() {
  Scene scene("carts");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle cart = scene.prismatic("cart", slide, axis::y, y);
  const FrameHandle other = scene.prismatic("other", scene.ground(), axis::x, z);
  const FrameHandle wheel = scene.revolute("wheel", other, axis::z, theta);
  scene.body("cart", cart, Inertia::point(testing_mechanisms::kilograms("2")));
  scene.body("wheel", wheel, Inertia::point(testing_mechanisms::kilograms("1")).at({testing_mechanisms::metres("1"), 0, 0}));
  scene.holonomic("line", y - 2 * x);
  scene.holonomic("follow", z - x);
  scene.nonholonomic("steered", sin(theta) * rate(y) + (1 - sin(theta) * sin(theta) - cos(theta) * cos(theta)) * rate(z));
  return scene;
}

TEST(SparseConstraintJacobian, HasAPatternOfCompressedRows) {
  const Equations equations(carts());
  const Kernel kernel = make_sparse_constraint_jacobian(equations);
  const std::vector<ConstantTable>& tables = kernel.structures[0].tables;
  EXPECT_EQ(std::get<std::size_t>(constant(tables, "constraint_jacobian_nonzeros")), 5U);
  EXPECT_EQ(numbers(tables, "constraint_jacobian_row_start"), (std::vector<std::size_t>{0, 2, 4, 5}));
  EXPECT_EQ(numbers(tables, "constraint_jacobian_column"), (std::vector<std::size_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(kernel.structures[0].members[0].rows, 5);
}

TEST(SparseConstraintJacobian, IsTheJacobianWithoutItsZeros) {
  int compared = 0, left_out = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Scene scene = testing_mechanisms::random_mechanism(seed, {.joints = seed % 2 == 0, .loops = seed % 3 == 0});
    const Equations equations(scene);
    const Kernel kernel = make_sparse_constraint_jacobian(equations);
    if (!kernel.skipped.empty()) continue;
    const std::vector<ConstantTable>& tables = kernel.structures[0].tables;
    const std::vector<std::size_t> starts = numbers(tables, "constraint_jacobian_row_start");
    const std::vector<std::size_t> columns = numbers(tables, "constraint_jacobian_column");
    ASSERT_EQ(starts.size(), equations.constraints().size() + 1);
    ASSERT_EQ(columns.size(), kernel.assignments.size());
    const RandomState state(scene, seed);
    Evaluator<Real> at(equations.program(), state.in_real());
    for (std::size_t i = 0; i < equations.constraints().size(); ++i) {
      std::size_t next = starts[i];
      for (std::size_t j = 0; j < static_cast<std::size_t>(equations.model().unknown_count()); ++j) {
        const Real entry = at(equations.constraints()[i].jacobian[j]);
        const bool listed = next < starts[i + 1] && columns[next] == j;
        // The very same definition; what is left out has nothing but rounding of fifty digits at a random state.
        if (listed) {
          EXPECT_EQ(abs(at(kernel.assignments[next++].value) - entry).to_double(), 0);
          ++compared;
        } else {
          EXPECT_LT(abs(entry).to_double(), 1e-40);
          ++left_out;
        }
      }
      EXPECT_EQ(next, starts[i + 1]);
    }
  }
  EXPECT_GE(compared, 20);
  EXPECT_GE(left_out, 5);
}

TEST(SparseConstraintJacobian, IsAbsentWithoutConstraints) {
  const Equations equations(testing_mechanisms::pendulum());
  EXPECT_EQ(make_kernel("sparse_constraint_jacobian", equations).skipped, "the scene has no constraints");
}

}  // namespace
}  // namespace torsor::kernel_sparse_jacobian_test
