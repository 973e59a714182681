// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor::numbers_with_roots_test {
namespace {

using printing::Written;

// The sign of a number that stands alone is that of all its parts, and each part has one sign.
TEST(NumbersWithRoots, HaveTheSignOfEachPart) {
  struct Case {
    Number number;
    std::string text, latex;
  };
  const Number half = Number::rational(1, 2), root2 = Number::sqrt2(), root3 = Number::sqrt3();
  const std::vector<Case> cases{
      {-half - half * root3, "-1/2 - 1/2 sqrt(3)", "-\\frac{1}{2} - \\frac{1}{2} \\sqrt{3}"},
      {half - half * root3, "1/2 - 1/2 sqrt(3)", "\\frac{1}{2} - \\frac{1}{2} \\sqrt{3}"},
      {half * root3 - half, "1/2 sqrt(3) - 1/2", "\\frac{1}{2} \\sqrt{3} - \\frac{1}{2}"},
      {root2 - root2 * root3, "sqrt(2) - sqrt(6)", "\\sqrt{2} - \\sqrt{6}"},
      {root2 * root3 - root2, "sqrt(6) - sqrt(2)", "\\sqrt{6} - \\sqrt{2}"},
      {-half * root2, "-1/2 sqrt(2)", "-\\frac{1}{2} \\sqrt{2}"},
  };
  for (const Case& each : cases) {
    const Written alone{{each.number, {}}};
    EXPECT_EQ(printing::text(alone), each.text);
    EXPECT_EQ(printing::latex(alone), each.latex);
    EXPECT_EQ(printing::text_lines(alone, 0, "", 100), each.text);
    EXPECT_EQ(printing::latex_lines(alone, 100).latex, each.latex);
    const Written behind{{Number(1), {}}, {each.number, {}}};
    EXPECT_EQ(printing::text(behind), "1 " + std::string(each.text[0] == '-' ? "- " + each.text.substr(1) : "+ " + each.text));
  }
}

// 3 m/s^2 and 1 m/s^2 of gravity along a slide that is tilted by 30 degrees.
TEST(NumbersWithRoots, StandWithTheirSignInAnEquation) {
  Scene scene("tilted_slide");
  const Expression q = scene.coordinate("q", "m");
  const FrameHandle tilted = scene.weld("tilted", scene.ground(), {.rotation = Rotation::about(1, 2)});
  const FrameHandle slide = scene.prismatic("slide", tilted, axis::x, q);
  scene.body("bead", slide, Inertia::point(Expression::quantity("1", "kg")));
  scene.gravity({Expression::quantity("-3", "m/s^2"), 0, Expression::quantity("1", "m/s^2")});
  const std::string text = print_equations(scene, Format::text, {});
  EXPECT_NE(text.find("q'' = -1/2 - 3/2 sqrt(3)"), std::string::npos) << text;
}

}  // namespace
}  // namespace torsor::numbers_with_roots_test
