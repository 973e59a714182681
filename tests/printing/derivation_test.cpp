// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a derivation, formulas broken where a line ends, matrices that fit, tangents, constraints that say nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <vector>

#include "examples/graham_variator/scene.cpp"
#include "torsor/generator/printing/canonical_sum.hpp"
#include "torsor/generator/printing/fitted_matrix.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::derivation_test {
namespace {

std::string print(const Scene& scene, Format format = Format::text) {
  PrintOptions options;
  options.derivation = true;
  options.linearisation = false;
  return print_equations(scene, format, options);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A bar of length 2 l, hinged at its end, with a torsional spring and friction.
Scene bar() {
  Scene scene("bar");
  const Expression m = scene.parameter("m", "kg", 2), l = scene.parameter("l", "m", 1), J = scene.parameter("J", "kg m^2", 1),
                   g = scene.parameter("g", "m/s^2", 10), k = scene.parameter("k", "N m", 3), c = scene.parameter("c", "N m s", 4);
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle hinge = scene.revolute("hinge", scene.ground(), axis::z, theta);
  scene.body("S", hinge, Inertia::general({.mass = m, .xx = J, .yy = J, .zz = J}).at({0, -l, 0}));
  scene.gravity({0, -g, 0});
  scene.spring("coil", theta, k, Expression(0));
  scene.damper("air", theta, c);
  return scene;
}

// By hand: V(G) = l θ' x_S, σ_G = J θ' z, T = ½ (m l² + J) θ'²; R = m Γ_G − m g with Γ_G = l θ'' x_S + l θ'² y_S, M what
// coil and friction leave: J θ'' + m l² θ'' + m g l sin θ at the hinge.
TEST(Derivation, FollowsTheCourseStepByStep) {
  const std::string text = print(bar());
  EXPECT_TRUE(has(text, "  S, along the axes of hinge:\n"
                        "  Omega(S) = [ 0      ]\n"
                        "             [ 0      ]\n"
                        "             [ theta' ]\n"
                        "  V(G of S) = [ l theta' ]\n"
                        "              [ 0        ]\n"
                        "              [ 0        ]\n"
                        "  sigma_G(S) = [ 0        ]\n"
                        "               [ 0        ]\n"
                        "               [ J theta' ]\n"))
      << text;
  EXPECT_TRUE(has(text, "  T(S) = 1/2 (m l^2 + J) theta'^2\n")) << text;
  EXPECT_TRUE(has(text, "  dT/d(theta') = (m l^2 + J) theta'\n"
                        "  d/dt dT/d(theta') = (m l^2 + J) theta''\n"
                        "  dT/d(theta) = 0\n"))
      << text;
  EXPECT_TRUE(has(text, "  gravity:\n  U = m l g cos(theta)\n  Q_theta = -m l g sin(theta)\n")) << text;
  EXPECT_TRUE(has(text, "  coil:\n  U = -1/2 k theta^2\n  Q_theta = -k theta\n")) << text;
  EXPECT_TRUE(has(text, "  air:\n  Q_theta = -c theta'\n")) << text;
  EXPECT_TRUE(has(text, "  R(hinge) = [ m l theta'' + m g sin(theta)  ]\n"
                        "             [ m l theta'^2 + m g cos(theta) ]\n"
                        "             [ 0                             ]\n"))
      << text;
  EXPECT_TRUE(has(text, "[ (m l^2 + J) theta'' + m l g sin(theta) ]\n")) << text;
  // The order: bodies, energy, partial derivatives, forces, equations, reactions.
  std::size_t before = 0;
  for (const char* heading : {"\nTwist and momentum screw", "\nKinetic energy, body by body", "\nKinetic energy [J]",
                              "\nPartial derivatives", "\nGeneralised forces", "\nLagrange's equations", "\nPainleve",
                              "\nWhat joints transmit"}) {
    const std::size_t at = text.find(heading);
    ASSERT_NE(at, std::string::npos) << heading;
    EXPECT_GT(at, before) << heading;
    before = at;
  }
}

TEST(Derivation, IsLeftOutUnlessItIsAskedFor) {
  EXPECT_FALSE(has(print_equations(bar(), Format::text), "body by body"));
}

TEST(Derivation, IsSpelledInLatexAndFoldedInHtml) {
  const std::string latex = print(bar(), Format::latex), html = print(bar(), Format::html);
  EXPECT_TRUE(has(latex, "\\frac{\\partial T}{\\partial \\dot{\\theta}} &= ")) << latex;
  EXPECT_TRUE(has(latex, "\\vec{\\Omega}(S) &= \\begin{pmatrix}")) << latex;
  EXPECT_TRUE(has(latex, "Painlev\xc3\xa9's equation")) << latex;
  EXPECT_FALSE(has(latex, "mathrm{dT")) << latex;
  EXPECT_TRUE(has(html, "<details><summary><h3>Partial derivatives of the kinetic energy</h3></summary>")) << html;
  EXPECT_TRUE(has(html, "<details open><summary><h3>Lagrange&#39;s equations</h3></summary>")) << html;
}

// A page is read: of many bodies it says that it leaves them out.
TEST(Derivation, SaysWhatItLeavesOut) {
  const std::string text = print(test::chain(9));
  EXPECT_TRUE(has(text, "Not written one by one: there are 9 bodies, and a page is for 8 at most.")) << text.substr(0, 2000);
}

// Pommier, 8.3.2 exercise 6: d tan δ T_A; two of the four conditions of rolling hold by themselves in a plane mechanism.
TEST(ReadableForms, OfTheVariatorHaveTangentsAndNoEquationsThatSayNothing) {
  const std::string text = print_equations(graham_variator_scene(), Format::text);
  EXPECT_TRUE(has(text, "  beta:  A2 beta'' + A2 cos(delta) alpha'' = d tan(delta) T_A + p T_E\n")) << text;
  EXPECT_TRUE(has(text, "  c alpha' + d tan(delta) beta' = 0    (rolling_A_y, non-holonomic)\n")) << text;
  EXPECT_FALSE(has(text, "0 = 0")) << text;
  EXPECT_TRUE(has(text, "  rolling_A_x (non-holonomic) holds whatever the motion: it is no equation, and its multiplier is 0.\n")) << text;
  EXPECT_TRUE(has(print_equations(graham_variator_scene(), Format::latex), "d \\tan\\left(\\delta\\right) T_{A}"));
}

// sin^3/cos = sin^2 tan; sin/cos^2 stays, for a tangent would leave the denominator.
TEST(ReadableForms, KeepTheSinesThatNoCosineDivides) {
  const auto x = std::make_shared<const Symbol>(Symbol{"x", Unit(), SymbolKind::coordinate, 1, nullptr});
  const printing::Sum sine = printing::Sum::function(Function::sin, printing::Sum::symbol(x));
  const printing::Sum cosine = printing::Sum::function(Function::cos, printing::Sum::symbol(x));
  const auto written = [](const printing::Sum& sum) { return printing::text(printing::collected(sum)); };
  EXPECT_EQ(written(sine * printing::power(cosine, -2)), "tan(x)");
  EXPECT_EQ(written(sine * sine * sine * printing::power(cosine, -2)), "sin(x)^2 tan(x)");
  EXPECT_EQ(written(sine * sine * printing::power(cosine, -4)), "tan(x)^2");
  EXPECT_EQ(written(sine * printing::power(cosine, -4)), "sin(x)/cos(x)^2");
  const WorkingDigits precision(40);
  const Real angle = Real::parse("0.5");
  const Real value = printing::evaluate(printing::collected(sine * sine * sine * printing::power(cosine, -2)),
                                        [&](const SymbolPointer&) { return angle; }, 40);
  // A few roundings of 40 digits each.
  EXPECT_LT(abs(value - sin(angle) * sin(angle) * sin(angle) / cos(angle)), Real::parse("1e-38"));
}

printing::Written letters(const std::string& name) { return printing::named(name); }

// Entries longer than the line have the name of the first that is equal to them.
TEST(FittedMatrix, NamesLongEntriesOnce) {
  const printing::Written a = letters(std::string(50, 'a')), b = letters("b"), none;
  const printing::FittedMatrix fits = printing::fitted("M", {{a, b}, {b, none}}, 100);
  EXPECT_TRUE(fits.instead.empty() && fits.named.empty());
  const printing::FittedMatrix named = printing::fitted("M", {{b, a}, {a, none}}, 60);
  ASSERT_EQ(named.named.size(), 1U);
  EXPECT_EQ(named.named[0].first, "M[1,2]");
  EXPECT_EQ(printing::text(named.rows[0][1]), "M[1,2]");
  EXPECT_EQ(printing::text(named.rows[1][0]), "M[1,2]");
  EXPECT_EQ(printing::latex(named.rows[1][0]), "\\mathbf{M}_{1,2}");
  // Wider than a line even so: what is not zero, entry by entry.
  const printing::WrittenMatrix wide(1, std::vector<printing::Written>(40, a));
  const printing::FittedMatrix list = printing::fitted("M", wide, 60);
  EXPECT_EQ(list.instead, "entries that are not zero");
  EXPECT_EQ(list.named.size(), 40U);
  const printing::FittedMatrix column = printing::fitted("v", {{a}, {none}}, 40);
  EXPECT_EQ(column.instead, "by components");
  EXPECT_EQ(column.named[1].first, "v[2]");
}

/// The longest line of a formula in LaTeX as letters that are set, roughly: commands count one.
std::size_t longest_line(const std::string& latex) {
  std::size_t longest = 0, here = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex.compare(i, 2, "\\\\") == 0) {
      longest = std::max(longest, here);
      here = 0;
      ++i;
      continue;
    }
    if (latex[i] == '\\') {
      while (i + 1 < latex.size() && std::isalpha(static_cast<unsigned char>(latex[i + 1])) != 0) ++i;
      ++here;
    } else if (std::string(" {}^_&").find(latex[i]) == std::string::npos) {
      ++here;
    }
  }
  return std::max(longest, here);
}

// One coefficient of 12 terms of 10 letters each has to be broken inside its parentheses.
TEST(Latex, BreaksLongCoefficientsInsideTheirParentheses) {
  Scene scene("heavy");
  const Expression x = scene.coordinate("x", "m");
  Expression mass = scene.parameter("mass_number_a", "kg", 1);
  for (int k = 1; k < 12; ++k) mass = mass + scene.parameter("mass_number_" + std::string(1, static_cast<char>('a' + k)), "kg", k + 1);
  scene.body("S", scene.prismatic("S", scene.ground(), axis::x, x), Inertia::point(mass));
  const std::string latex = print_equations(scene, Format::latex);
  const std::size_t begin = latex.find("  T &= "), end = latex.find("\\end{align*}", begin);
  const std::string energy = latex.substr(begin, end - begin);
  EXPECT_TRUE(has(energy, "\\bigl(")) << energy;
  EXPECT_TRUE(has(energy, "\\bigr) \\dot{x}^{2}")) << energy;
  // A line holds 90 letters of plain text, and its last term may pass that by nothing.
  EXPECT_LE(longest_line(energy), 95U) << energy;
}

TEST(Latex, WritesUnitsAndSubscriptsOfPeople) {
  EXPECT_EQ(printing::latex_unit(Unit::parse("N m")), "\\mathrm{N\\,m}");
  EXPECT_EQ(printing::latex_unit(Unit::parse("m^(1/2)/s^2")), "\\mathrm{m^{1/2}/s^{2}}");
  EXPECT_EQ(printing::latex_name("M[1,2]"), "\\mathbf{M}_{1,2}");
}

}  // namespace
}  // namespace torsor::derivation_test
