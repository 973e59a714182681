// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels of slopes at rest, where a drag of the square of a speed divides by that speed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/verification/running_numbers.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/kernel_text.hpp"

namespace torsor::kernel_limits_test {
namespace {

using Scalar = Running<double>;

/// A pendulum on a trolley in a fluid: -(d + c V) v at its tip, v of the tip, V = |v|.
Scene pendulum(const std::string& quadratic) {
  Scene scene("pendulum_in_a_fluid");
  const Expression x = scene.coordinate("x", "m"), a = scene.coordinate("a", "rad");
  const Expression l = Expression::quantity("0.7", "m"), m = Expression::quantity("2", "kg");
  const FrameHandle trolley = scene.prismatic("trolley", scene.ground(), axis::x, x);
  const FrameHandle rod = scene.revolute("rod", trolley, axis::y, a);
  scene.body("trolley", trolley, Inertia::point(m));
  scene.body("rod", rod, Inertia::point(m).at({0, 0, -l}));
  scene.gravity({0, 0, -Expression::quantity("9.81", "m/s^2")});
  scene.spring("spring", x, Expression::quantity("50", "N/m"));
  const PointHandle tip = scene.point("tip", rod, {0, 0, -l});
  const Triple v = scene.velocity(tip, rod, scene.ground());
  const Expression d = Expression::quantity("0.5", "N s/m"), c = Expression::quantity(quadratic, "kg/m");
  const Expression of_speed = -(d + c * sqrt(v[0] * v[0] + v[2] * v[2]));
  scene.force("drag", {.body = "rod", .point = tip, .components = {of_speed * v[0], 0, of_speed * v[2]}, .axes = "ground"});
  return scene;
}

std::vector<double> results(const std::string& kernel, const Scene& scene, double rates) {
  const std::vector<OwnKernel> kernels = make_own_kernels(scene, {}, {kernel});
  KernelText<Scalar> text(scene, {}, kernels.front(), testing_rounding::running_numbers<double>());
  text.move_to([&](const SymbolPointer& symbol) {
    return Scalar(symbol->kind == SymbolKind::coordinate ? 0.3 : symbol->kind == SymbolKind::velocity ? rates : 0.0);
  });
  std::vector<double> numbers;
  for (const Scalar& each : text.results()) numbers.push_back(each.value());
  return numbers;
}

TEST(KernelLimits, OfADragAtRestAreThoseOfItsLinearPart) {
  for (const char* kernel : {"linearisation", "forward_dynamics_derivatives", "inverse_dynamics_derivatives"}) {
    const std::vector<double> whole = results(kernel, pendulum("3"), 0), linear = results(kernel, pendulum("0"), 0);
    ASSERT_EQ(whole.size(), linear.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_NEAR(whole[i], linear[i], 1e-14 * (1 + std::abs(linear[i]))) << kernel << i;
    }
    // They are approached in proportion to the speed, as the slope of v |v| is.
    const std::vector<double> near = results(kernel, pendulum("3"), 1e-7);
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(whole[i], near[i], 1e-5) << kernel << i;
    const std::vector<double> moving = results(kernel, pendulum("3"), 1);
    double change = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) change = std::max(change, std::abs(whole[i] - moving[i]));
    EXPECT_GT(change, 1) << kernel;
  }
}

}  // namespace
}  // namespace torsor::kernel_limits_test
