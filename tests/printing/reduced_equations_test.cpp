// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/reduced_equations.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/written.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::printing::reduced_equations_test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows rows(const SumMatrix& matrix) {
  Rows result;
  for (const std::vector<Sum>& row : matrix) {
    result.emplace_back();
    for (const Sum& sum : row) result.back().push_back(text(collected(sum)));
  }
  return result;
}

bool contains(const std::string& whole, const std::string& part) { return whole.find(part) != std::string::npos; }

/// A mass in a plane, held at the distance l from the origin: x^2 + y^2 = l^2.
Scene bob() {
  Scene s("bob");
  const Expression m = s.parameter("m", "kg", 2), l = s.parameter("l", "m", 3), g = s.parameter("g", "m/s^2", 10);
  const Expression x = s.coordinate("x", "m"), y = s.coordinate("y", "m");
  s.initial(y, -3);
  s.independent({x});
  const FrameHandle along = s.prismatic("along", s.ground(), axis::x, x);
  s.body("bob", s.prismatic("bob", along, axis::y, y), Inertia::point(m));
  s.gravity({0, -g, 0});
  s.holonomic("rod", x * x + y * y - l * l);
  s.motor("push", x);
  return s;
}

// m x'' = 2 lambda x + u and m y'' = 2 lambda y - m g: about x = 0, y = -l the height follows in second order only, so that
// m e'' - 2 lambda e = u. At the rest lambda = -m g/(2 l), and m e'' + m g/l e = u is the pendulum's equation.
TEST(ReducedEquations, AreThoseOfThePendulumThatARodMakes) {
  const auto reduced = reduced_equations(bob(), {}, {{"x", "0"}, {"y", "-l"}});
  ASSERT_TRUE(reduced);
  EXPECT_EQ(reduced->coordinates, std::vector<std::string>{"x"});
  EXPECT_EQ(reduced->velocities, std::vector<std::string>{"x"});
  EXPECT_TRUE(reduced->rates_are_velocities());
  EXPECT_EQ(rows(reduced->M), (Rows{{"m"}}));
  EXPECT_EQ(rows(reduced->C), (Rows{{"0"}}));
  EXPECT_EQ(rows(reduced->K), (Rows{{"-2 lambda_rod"}}));
  EXPECT_EQ(rows(reduced->E), (Rows{{"1"}}));
  ASSERT_EQ(reduced->F.size(), 1U);
  EXPECT_TRUE(reduced->F[0].is_zero());
  PrintOptions options;
  options.about = {{"x", "0"}, {"y", "-l"}};
  const std::string page = print_equations(bob(), Format::text, options);
  EXPECT_TRUE(contains(page, "Linearised equations in independent freedoms\n"
                             "  M_r e'' + C_r e' + K_r e = F_r + E_r u, e the deviations of the freedoms below; the others follow.\n"
                             "  Independent: x. Multipliers are those of the state.\n"
                             "  M_r = [ m ]\n"))
      << page;
  EXPECT_FALSE(contains(page, "  N = ["));
  const std::string latex = print_equations(bob(), Format::latex, options);
  EXPECT_TRUE(contains(latex, "\\mathbf{K}_r &= \\begin{pmatrix}")) << latex;
}

// (2, 2) is no place of a circle of radius l unless l^2 = 8, and x' = 3 leaves it at the rate 2 * 2 * 3 = 12. Where l and y
// are open, they must fulfil what is left; where the state fulfils all, nothing is said.
TEST(ReducedEquations, SayWhereTheStateViolatesAConstraint) {
  const auto left = [](const About& about) {
    std::vector<std::string> all;
    for (const ConstraintLeft& each : constraints_left(bob(), {}, about)) {
      all.push_back((each.rate ? "rate " : "") + each.name + (each.open ? " open " : " ") + text(collected(each.left.value())));
    }
    return all;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(left({{"x", "0"}, {"y", "-l"}}), Texts{});
  EXPECT_EQ(left({{"x", "l*cos(pi/5)"}, {"y", "l*sin(pi/5)"}}), Texts{});
  EXPECT_EQ(left({{"x", "2"}, {"y", "2"}, {"x'", "3"}}), (Texts{"rod open -l^2 + 8", "rate rod 12"}));
  EXPECT_EQ(left({{"x", "0"}}), Texts{"rod open -l^2 + y^2"});
  PrintOptions options;
  options.about = {{"x", "2"}, {"y", "2"}, {"x'", "3"}};
  const std::string page = print_equations(bob(), Format::text, options);
  EXPECT_TRUE(contains(page, "(rod: must hold at this state)\n")) << page;
  EXPECT_TRUE(contains(page, "(the rate of rod: does not hold at this state)\n")) << page;
  options.about = {{"x", "0"}, {"y", "-l"}};
  EXPECT_FALSE(contains(print_equations(bob(), Format::text, options), "at this state"));
}

// A sled that runs along its edge at the speed V: a turn e_psi moves it aside, y' = V e_psi, and turns the force of the edge,
// lambda e_psi along x. Velocities along and about stay, those across follow.
TEST(ReducedEquations, TellHowCoordinatesOfARollingMotionChange) {
  Scene scene = test::sled();
  (void)scene.parameter("V", "m/s", 2);
  const auto reduced = reduced_equations(scene, {}, {{"psi", "0"}, {"x'", "V"}});
  ASSERT_TRUE(reduced);
  EXPECT_EQ(reduced->coordinates, (std::vector<std::string>{"x", "y", "psi"}));
  EXPECT_EQ(reduced->velocities, (std::vector<std::string>{"x", "psi"}));
  EXPECT_FALSE(reduced->rates_are_velocities());
  EXPECT_EQ(rows(reduced->M), (Rows{{"m", "0"}, {"0", "I"}}));
  EXPECT_EQ(rows(reduced->C), (Rows{{"0", "0"}, {"0", "0"}}));
  EXPECT_EQ(rows(reduced->K), (Rows{{"0", "0", "lambda_edge"}, {"0", "0", "0"}}));
  EXPECT_EQ(rows(reduced->D), (Rows{{"0", "0", "0"}, {"0", "0", "V"}, {"0", "0", "0"}}));
  EXPECT_EQ(rows(reduced->N), (Rows{{"1", "0"}, {"0", "0"}, {"0", "1"}}));
}

// Free scenes have no second linearisation, and what no reader reads is not written.
TEST(ReducedEquations, AreWrittenWhereThereAreConstraints) {
  EXPECT_FALSE(contains(print_equations(test::absorber(), Format::text), "independent freedoms"));
  EXPECT_TRUE(contains(print_equations(test::sled(), Format::text), "e: of x, y, psi; w: of the rates of x, psi."));
  EXPECT_FALSE(reduced_equations(test::sled(), {1, 1}, {}));
  PrintOptions options;
  options.terms = 60;
  options.language = NaturalLanguage::named("fr");
  EXPECT_TRUE(contains(print_equations(test::sled(), Format::text, options), "Équations linéarisées en paramètres indépendants"));
  const std::string page = print_equations(test::sled(), Format::text, {.terms = 5});
  EXPECT_TRUE(contains(page, "An entry has more than 1 terms: name a state")) << page;
}

TEST(ReducedEquations, AreNoneWhereNothingIsLeftToMove) {
  Scene scene("held");
  const Expression x = scene.coordinate("x", "m");
  scene.body("held", scene.prismatic("held", scene.ground(), axis::x, x), Inertia::point(scene.parameter("m", "kg", 2)));
  scene.holonomic("hold", x);
  const std::string page = print_equations(scene, Format::text);
  EXPECT_TRUE(contains(page, "None is left: the constraints determine all velocities.")) << page;
}

}  // namespace
}  // namespace torsor::printing::reduced_equations_test
