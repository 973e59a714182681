// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "torsor/generator/kernels/kernel.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::kernel_energy_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

/// A block of 2 kg on a slope of 30 degrees, x downwards, with a spring, a damper, a motor and a given force function:
/// T = x'^2, U = 10 x - 3/2 (x - 1/2)^2 + 5 x, power = (-7 x' + u) x'.
TEST(KernelEnergy, HasEveryKindOfEnergyAndPower) {
  Scene scene("block");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slope = scene.weld("slope", scene.ground(), {.origin = {}, .rotation = Rotation::about(2, -2)});
  scene.body("block", scene.prismatic("slide", slope, axis::x, x), Inertia::point(kilograms("2")));
  scene.gravity({0, Expression::quantity("-10", "m/s^2"), 0});
  scene.spring("spring", x, Expression::quantity("3", "N/m"), metres("0.5"));
  scene.damper("damper", x, Expression::quantity("7", "N s/m"));
  scene.force_function("field", Expression::quantity("5", "N") * x);
  scene.motor("push", x);
  const Equations equations(scene);
  const Kernel kernel = make_kernel("energy", equations);
  const Real place = rational(4, 5), rate = rational(-2, 3), input = rational(11, 7);
  NamedState here(equations, {{"x", place}, {"x'", rate}, {"push", input}});
  const Real stretch = place - rational(1, 2);
  const auto expect = [&](const std::string& target, const Real& value) {
    const auto& all = kernel.assignments;
    const auto is_target = [&](const Assignment& each) { return each.target.to_string() == target; };
    const auto found = std::find_if(all.begin(), all.end(), is_target);
    ASSERT_NE(found, all.end()) << target;
    EXPECT_LT(relative_difference(here(found->value), value), 1e-45) << target;
  };
  expect("result.kinetic", rate * rate);
  expect("result.force_function", Real(15) * place - rational(3, 2) * stretch * stretch);
  expect("result.power", (input - Real(7) * rate) * rate);
}

}  // namespace
}  // namespace torsor::kernel_energy_test
