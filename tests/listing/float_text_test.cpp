// SPDX-License-Identifier: GPL-3.0-or-later
// What the text of kernels gives in float, which has 24 bits and ends at 1e-38.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "tests/verification/running_numbers.hpp"

namespace torsor::float_text_test {
namespace {

/// Two masses, each on a rod of its own.
Scene two_rods(const std::string& first_mass, const std::string& second_mass) {
  Scene scene("two_rods");
  const Expression one = Expression::quantity("1", "m");
  for (const auto& [name, mass] : {std::pair<std::string, std::string>{"h", first_mass}, {"l", second_mass}}) {
    const Expression x = scene.coordinate("x" + name, "m"), z = scene.coordinate("z" + name, "m");
    const FrameHandle slide = scene.prismatic("slide_" + name, scene.ground(), axis::x, x);
    const FrameHandle body = scene.prismatic("body_" + name, slide, axis::z, z);
    scene.body(name, body, Inertia::point(Expression::quantity(mass, "kg")));
    scene.holonomic("rod_" + name, (x * x + z * z - one * one) / (2 * one));
  }
  scene.gravity({0, 0, -Expression::quantity("9.81", "m/s^2")});
  return scene;
}

/// Whether the text of forward_dynamics takes rods at the place (3/5, -4/5) for regular, as traits::regular of a header.
template <class Float>
bool is_regular(const Scene& scene) {
  using Scalar = Running<Float>;
  const std::vector<OwnKernel> kernels = make_own_kernels(scene, {}, {"forward_dynamics"});
  KernelText<Scalar> text(scene, {}, kernels.front(), testing_rounding::running_numbers<Float>());
  text.move_to([](const SymbolPointer& symbol) {
    if (symbol->kind != SymbolKind::coordinate) return Scalar(0);
    return Scalar::of_number(symbol->name[0] == 'x' ? Number::rational(3, 5) : Number::rational(-4, 5));
  });
  return text.is_regular([](const Scalar& pivot, const Scalar& measure) {
    return pivot.value() > std::numeric_limits<Float>::epsilon() * std::abs(measure.value());
  });
}

TEST(FloatText, OfUnlikeMassesAreRegularInBothScalars) {
  EXPECT_TRUE(is_regular<double>(two_rods("1000", "0.1")));
  EXPECT_TRUE(is_regular<float>(two_rods("1000", "0.1"))) << "1e-4 of the other pivot is no rounding of a float";
  EXPECT_TRUE(is_regular<double>(two_rods("1e11", "1")));
  EXPECT_FALSE(is_regular<double>(two_rods("1e13", "1"))) << "2^-40";
  EXPECT_TRUE(is_regular<float>(two_rods("5e5", "1")));
  EXPECT_FALSE(is_regular<float>(two_rods("2e6", "1"))) << "2^-20";
}

TEST(FloatText, OfAPinInTheMiddleOfItsHoleHasNumbers) {
  Scene scene("pin");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle pin = scene.prismatic("pin", slide, axis::z, z);
  scene.body("pin", pin, Inertia::point(Expression::quantity("1", "kg")));
  scene.contact("hole", shape::Sphere{pin, Expression::quantity("0.001", "m")},
                shape::HollowSphere{scene.ground(), Expression::quantity("0.0011", "m")}, {.friction = Expression(0.1)});
  const std::vector<OwnKernel> kernels = make_own_kernels(scene, {}, {"contacts"});
  KernelText<Running<float>> text(scene, {}, kernels.front(), testing_rounding::running_numbers<float>());
  for (const float place : {0.0F, 1e-22F, 1e-6F}) {
    text.move_to([&](const SymbolPointer& symbol) {
      return Running<float>(symbol->kind == SymbolKind::coordinate && symbol->name == "x" ? place : 0.0F);
    });
    for (const Running<float>& number : text.results()) {
      EXPECT_TRUE(std::abs(number.value()) <= 1.0001F) << place << ": " << number.value();
    }
  }
}

}  // namespace
}  // namespace torsor::float_text_test
