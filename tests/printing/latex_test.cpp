// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/printing/latex_width.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::latex_test {
namespace {

using namespace literals;

std::string print(const Scene& scene, const PrintOptions& options = {}) {
  return print_equations(scene, Format::latex, options);
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// Empty when braces, \left and \right and environments match, else what is wrong.
std::string imbalance(const std::string& text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped = i > 0 && text[i - 1] == '\\';
    if (text[i] == '{' && !escaped) ++depth;
    if (text[i] == '}' && !escaped && --depth < 0) return "closing brace at " + text.substr(i, 40);
  }
  if (depth != 0) return "open braces";
  std::vector<std::string> open;
  for (std::size_t i = text.find('\\'); i != std::string::npos; i = text.find('\\', i + 1)) {
    const std::string rest = text.substr(i);
    const auto argument = [&rest] { return rest.substr(rest.find('{') + 1, rest.find('}') - rest.find('{') - 1); };
    if (rest.starts_with("\\begin{")) open.push_back(argument());
    if (rest.starts_with("\\left(")) open.emplace_back("(");
    const bool end = rest.starts_with("\\end{");
    if (!end && !rest.starts_with("\\right)")) continue;
    const std::string expected = end ? argument() : "(";
    if (open.empty() || open.back() != expected) return "unexpected end of " + expected;
    open.pop_back();
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

TEST(Latex, WritesTheAbsorbersEquation) {
  const std::string text = print(test::absorber());
  EXPECT_NE(text.find("\\left(M_{1} + M_{2} + M_{3}\\right) \\ddot{X} + M_{2} d \\cos\\left(\\theta\\right) "
                      "\\ddot{\\theta}"),
            std::string::npos);
  EXPECT_NE(text.find("= -K \\left(X - X_{0}\\right) \\tag{$X$}"), std::string::npos);
  EXPECT_NE(text.find("\\frac{1}{2} M_{2} d^{2} \\dot{\\theta}^{2}"), std::string::npos);
}

TEST(Latex, IsBalancedForEveryKindOfScene) {
  for (const Scene& scene : {test::absorber(), test::double_pendulum({}), test::satellite(), test::elastic_pendulum(),
                             test::released_block(), test::sled(), test::chain(3), test::chain(7)}) {
    const std::string text = print(scene, {.document = true});
    EXPECT_EQ(imbalance(text), "") << scene.name();
    EXPECT_EQ(occurrences(text, "$") % 2, 0) << scene.name();
    EXPECT_TRUE(text.starts_with("\\documentclass"));
    EXPECT_TRUE(text.ends_with("\\end{document}\n"));
    // amsmath refuses a blank line inside an align environment.
    for (std::size_t at = text.find("\\begin{align*}"); at != std::string::npos;
         at = text.find("\\begin{align*}", at + 1)) {
      EXPECT_EQ(text.substr(at, text.find("\\end{align*}", at) - at).find("\n\n"), std::string::npos);
    }
  }
}

TEST(Latex, FindsItsOwnImbalances) {
  EXPECT_NE(imbalance("\\frac{1}{2"), "");
  EXPECT_NE(imbalance("\\left(x"), "");
  EXPECT_NE(imbalance("\\begin{align*} x \\end{pmatrix}"), "");
}

TEST(Latex, NamesSymbolsAsAPersonWould) {
  using printing::latex_name;
  EXPECT_EQ(latex_name("theta_1''"), "\\ddot{\\theta}_{1}");
  EXPECT_EQ(latex_name("M1"), "M_{1}");
  EXPECT_EQ(latex_name("omega0"), "\\omega_{0}");
  EXPECT_EQ(latex_name("lambda_along_x1"), "\\lambda_{\\mathrm{along},x_{1}}");
  EXPECT_EQ(latex_name("mass"), "\\mathrm{mass}");
  EXPECT_EQ(latex_name("X'"), "\\dot{X}");
}

TEST(Latex, WritesUnitsUpright) {
  EXPECT_EQ(printing::latex_unit(Unit::parse("kg m^2/s^3/A")), "\\mathrm{kg\\,m^{2}/s^{3}/A}");
  EXPECT_EQ(printing::latex_unit(Unit()), "\\mathrm{1}");
}

TEST(Latex, EscapesATitle) { EXPECT_EQ(printing::latex_escaped("50 % of a_1 & {b}"), "50 \\% of a\\_1 \\& \\{b\\}"); }

TEST(Latex, ReadsWhatItEscaped) {
  const std::string text = "a_1 <b> | c\\d ~ ^ 50 % & {e} $f$ #";
  EXPECT_EQ(printing::latex_unescaped(printing::latex_escaped(text)), text);
  const std::string foreign = "Élève ψ Ω – 5 € <α>";
  EXPECT_EQ(printing::latex_unescaped(printing::latex_escaped(foreign)), foreign);
  EXPECT_EQ(printing::latex_escaped("é ψ \xe6\x97\xa5"), "é \\ensuremath{\\psi} [U+65E5]");
  EXPECT_EQ(printing::latex_escaped("<|>"), "\\textless{}\\textbar{}\\textgreater{}");
}

// Widths of Computer Modern at 10 points, measured by TeX: \settowidth of each formula in display style.
TEST(LatexWidth, IsAboutThatOfTeX) {
  const std::pair<const char*, double> measured[] = {
      {"m \\ddot{x} + k \\left(x - x_{0}\\right) = 0", 88.2},
      {"\\frac{1}{2} m l^{2} \\dot{\\theta}^{2}", 33.3},
      {"-m L \\sin\\left(\\theta\\right) \\ddot{\\theta} - m L \\cos\\left(\\theta\\right) \\dot{\\theta}^{2}", 126.8},
      {"\\left(A_{1} + A_{2} \\cos^{2}\\left(\\delta\\right)\\right) \\ddot{\\alpha}", 87.3},
      {"\\mathrm{edge}\\, \\mathrm{height}", 48.1},
  };
  // A fifth, and two letters: lines are broken by it, and end well before the edge.
  for (const auto& [formula, width] : measured) EXPECT_NEAR(printing::latex_width(formula), width, 0.2 * width + 6) << formula;
}

// A line takes what fits, and what stands on the right follows on the last line where it has room.
TEST(Latex, FillsItsLines) {
  Scene scene("plate", "");
  const Expression A = scene.parameter("A", "kg m^2", 2), B = scene.parameter("B", "kg m^2", 3), F = scene.parameter("F", "kg m^2", 0.2_r);
  const Expression a = scene.coordinate("alpha", "rad"), b = scene.coordinate("beta", "rad");
  const FrameHandle body = scene.revolute("body", scene.revolute("arm", scene.ground(), axis::z, a), axis::x, b);
  scene.body("body", body, Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = A, .yy = B, .zz = B, .yz = F}));
  const std::string page = print(scene);
  const std::size_t begin = page.find("Lagrange's equations"), end = page.find("\\tag{$\\alpha$}");
  ASSERT_NE(end, std::string::npos) << page;
  EXPECT_NE(page.substr(end - 5, 5).find("= 0"), std::string::npos) << page.substr(begin, end - begin);
  EXPECT_EQ(page.find("\\\\\n  &\\quad = 0"), std::string::npos) << page;
}

TEST(Latex, PutsAShareOfPiInOneFractionAndNoParenthesesOverAStroke) {
  Scene scene("shares", "");
  const Expression slope = scene.parameter("slope", "rad", pi() / 3), m = scene.parameter("m", "kg", 1), k = scene.parameter("k", "N/m", 1);
  const Expression a = scene.parameter("a", "m", 1), b = scene.parameter("b", "m", 2), x = scene.coordinate("x", "m");
  scene.body("body", scene.prismatic("body", scene.ground(), {cos(slope), 0, sin(slope)}, x), Inertia::point(m * (a + b) / a));
  scene.spring("spring", x, k);
  const std::string page = print(scene);
  EXPECT_NE(page.find("&= \\frac{\\pi}{3}"), std::string::npos) << page;
  EXPECT_EQ(page.find("\\frac{\\left("), std::string::npos) << page;
}

TEST(CoefficientText, WritesHundredthsAndWhatIsFinerAsDecimals) {
  const auto text = [](long a, long b) { return printing::coefficient_text(Number::rational(a, b)); };
  EXPECT_EQ(text(1, 1000), "0.001");
  EXPECT_EQ(text(1, 2000), "0.0005");
  EXPECT_EQ(text(1, 50), "0.02");
  EXPECT_EQ(text(1, 2), "1/2");
  EXPECT_EQ(text(3, 80), "3/80");
  EXPECT_EQ(text(2, 5), "2/5");
  EXPECT_EQ(text(1, 300), "1/300");
}

TEST(ValueText, HasAPowerOfTenInThePlaceOfManyZeros) {
  EXPECT_EQ(printing::value_text(Number::rational(5, 1'000'000'000)), "5e-9");
  EXPECT_EQ(printing::value_text(Number::rational(-123, 100'000'000)), "-1.23e-6");
  EXPECT_EQ(printing::value_text(Number(5'972'000'000)), "5.972e9");
  EXPECT_EQ(printing::value_text(Number(210000)), "210000");
  EXPECT_EQ(printing::value_text(Number::rational(3, 10000)), "0.0003");
  EXPECT_EQ(printing::value_text(Number::rational(1, 3)), "1/3");
  EXPECT_EQ(printing::value_latex(Number::rational(5, 1'000'000'000)), "5 \\cdot 10^{-9}");
}

TEST(DecimalText, WritesWhatEndsAsADecimal) {
  EXPECT_EQ(printing::decimal_text(Number::rational(1, 20)), "0.05");
  EXPECT_EQ(printing::decimal_text(Number::rational(-981, 100)), "-9.81");
  EXPECT_EQ(printing::decimal_text(Number(12)), "12");
  EXPECT_EQ(printing::decimal_text(Number::rational(1, 3)), "1/3");
}

// Inertias of a file that are turned by an attitude of a file have fractions of a hundred digits.
TEST(DecimalText, CutsFractionsThatNobodyReads) {
  const auto text = [](const char* number) { return printing::decimal_text(parse_decimal(number)); };
  EXPECT_EQ(text("39600217960424652341615515521676656025/40908128851858423841834435138921879209"), "0.96802809299417873...");
  EXPECT_EQ(text("-39600217960424652341615515521676656025/40908128851858423841834435138921879209"), "-0.96802809299417873...");
  EXPECT_EQ(text("1000000000000000000/3"), "3.3333333333333333...e17");
  EXPECT_EQ(text("10000000000000000000/300001"), "33333222222592.591...");
  EXPECT_EQ(text("999999999999999999/1000000000000000001"), "0.99999999999999999...");
  EXPECT_EQ(text("1/300000000000000000"), "3.3333333333333333...e-18");
  EXPECT_EQ(text("1000000000000000001/30000000000000000000000"), "3.3333333333333333...e-5");
  EXPECT_EQ(text("1/30000000000000001"), "1/30000000000000001");  // 17 digits
  const Number third = parse_decimal("1000000000000000000/3000000000000000001");
  EXPECT_EQ(printing::decimal_text(third + third * Number::sqrt2()), "0.33333333333333333... + 0.33333333333333333... sqrt(2)");
  EXPECT_EQ(printing::coefficient_text(third), "0.33333333333333333...");
  EXPECT_EQ(printing::coefficient_text(parse_decimal("1000000000000000000000000000001/7")), "1.4285714285714285...e29");
  EXPECT_EQ(printing::value_text(third), "0.33333333333333333...");
  EXPECT_EQ(printing::value_latex(third), "0.33333333333333333\\ldots");
  EXPECT_EQ(printing::value_latex(parse_decimal("1/300000000000000000")), "3.3333333333333333\\ldots \\cdot 10^{-18}");
}

}  // namespace
}  // namespace torsor::latex_test
