// SPDX-License-Identifier: GPL-3.0-or-later
// Selections and angles as a person reads them.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/emission/selections_scene.hpp"
#include "tests/printing/check_inline.hpp"

namespace torsor::selections_text_test {
namespace {

Scene stops() {
  Scene scene("stops");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  scene.body("mass", scene.prismatic("mass", along, axis::y, y), Inertia::point(scene.parameter("m", "kg", 2)));
  const Expression k = scene.parameter("k", "N/m", 40), d = scene.parameter("d", "m", 1), F = scene.parameter("F", "N", 3);
  const Expression J = scene.parameter("J", "J", 3);
  scene.generalised_force("stop", x, -k * sign(x) * max(abs(x) - d, 0));
  scene.generalised_force("steps", y, piecewise({{x < -d, F}, {x <= d, 2 * F * y / d}}, -F));
  scene.force_function("angle", J * atan2(y - 2 * d, x));
  return scene;
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TEST(SelectionsText, IsWrittenByCases) {
  const std::string text = print_equations(stops(), Format::text, {});
  expect_part(text, "U = J atan2(y - 2 d, x)");
  expect_part(text, "- k max(abs(x) - d, 0) sign(x)");
  expect_part(text, "[F if x + d < 0, else 2 F y/d if -x + d >= 0, else -F]");
  // GiNaC differentiates: the slope of the stop is k beyond it.
  expect_part(text, "k [1 if abs(x) - d >= 0, else 0] sign(x)^2");
}

TEST(SelectionsText, IsSetByCasesInLatex) {
  const std::string text = print_equations(stops(), Format::latex, {});
  expect_part(text, "\\max\\left(\\left|x\\right| - d, 0\\right) \\operatorname{sign}\\left(x\\right)");
  expect_part(text, "\\begin{cases} F & x + d < 0 \\\\ 2 \\frac{F y}{d} & -x + d \\ge 0 \\\\ -F & \\text{else} \\end{cases}");
  expect_part(text, "\\operatorname{atan2}\\left(y - 2 d, x\\right)");
}

/// A spline of a position far from its origin, one of a difference, and one of a speed.
Scene splines() {
  Scene scene("splines");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  scene.body("mass", scene.prismatic("mass", along, axis::y, y), Inertia::point(scene.parameter("m", "kg", 2)));
  scene.generalised_force("track", x, spline(x, {{100000, 0}, {100001, 1}, {100002, 0}}, "N"));
  scene.generalised_force("gap", y, spline(2 * y - x, {{0, 0}, {1, 1}, {2, 0}}, "N"));
  scene.generalised_force("damper", y, spline(rate(y), {{0, 0}, {1, 1}, {2, 0}}, "N"));
  return scene;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Multiplied out, each selection of coefficients would stand four times, and 10^15 would cancel.
TEST(SelectionsText, KeepsTheDistanceFromTheKnotOfASpline) {
  const std::string text = print_equations(splines(), Format::text, {});
  const std::size_t begin = text.find("Lagrange's equations");
  const std::string equations = text.substr(begin, text.find("Painleve") - begin);
  EXPECT_EQ(count(equations, "])^3"), 3u) << equations;
  EXPECT_EQ(count(equations, "])^2"), 3u) << equations;
  EXPECT_EQ(count(equations, "^3"), 3u) << equations;
  EXPECT_EQ(count(equations, "[3/2 if x - 100001 < 0, else -3/2 if x - 100002 >= 0, else 0] (x - [100000 if x - 100001 < 0, "), 1u)
      << equations;
  const std::string latex = print_equations(splines(), Format::latex, {});
  EXPECT_EQ(count(latex, "x^{3}"), 0u) << latex;
}

/// Forces that are minima: alone, of a sum, and of a stop that only presses.
Scene minima() {
  Scene scene("minima");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  scene.body("mass", scene.prismatic("mass", along, axis::y, y), Inertia::point(scene.parameter("m", "kg", 2)));
  const Expression k = scene.parameter("k", "N/m", 40), d = scene.parameter("d", "m", 1);
  scene.generalised_force("both", x, k * min(x + d, 2 * y));
  scene.generalised_force("seat", y, k * min(y - d, 0) - k * pow(min(x, y), 2) / d);
  return scene;
}

TEST(SelectionsText, WritesAMinimumAsSuch) {
  const std::string text = print_equations(minima(), Format::text, {});
  expect_part(text, "k min(x + d, 2 y)");
  expect_part(text, "-k min(x, y)^2/d + k min(y - d, 0)");
  EXPECT_EQ(text.find("max(-"), std::string::npos) << text;
  expect_part(print_equations(minima(), Format::latex, {}), "\\min\\left(x + d, 2 y\\right)");
  const test::InlineCheck check = test::check_inline(minima(), 40, 8, 3);
  EXPECT_TRUE(check.written_out);
  EXPECT_LT(check.worst.to_double(), 1e-35) << check.worst_of;
}

TEST(SelectionsText, NamesAMinimumInErrors) {
  Scene scene("units");
  const Expression x = scene.coordinate("x", "m"), t = scene.parameter("tau", "s", 1);
  try {
    (void)min(x, t);
    FAIL();
  } catch (const UnitError& error) {
    expect_part(error.what(), "min(x, tau)");
  }
}

/// What is printed, at random states of 40 digits, against the program.
TEST(SelectionsText, SaysWhatTheProgramComputes) {
  for (const Scene& scene : {stops(), testing_scenes::golden_selections()}) {
    const test::InlineCheck check = test::check_inline(scene, 40, 8, 3);
    EXPECT_TRUE(check.written_out);
    EXPECT_LT(check.worst.to_double(), 1e-35) << check.worst_of;
  }
}

TEST(SelectionsText, IsReadBack) {
  const Scene scene = stops();
  EXPECT_EQ(parse_formula("max(abs(x), min(y, 2*y))", scene).to_string(),
            "max(abs(x), min(y, 2*y))");
  EXPECT_EQ(parse_formula("-max(-y, x)", scene).to_string(), "-max(-y, x)");
  EXPECT_EQ(parse_formula("min(x, y) - 2*min(-x, y)", scene).to_string(), "(min(x, y) - 2*min(-x, y))");
  EXPECT_EQ(parse_formula("atan2(x, y) + sign(x)", scene).to_string(), "(atan2(x, y) + sign(x))");
}

}  // namespace
}  // namespace torsor::selections_text_test
