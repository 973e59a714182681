// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/reference.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::reference_test {
namespace {

using namespace testing_mechanisms;
using namespace testing_symbols;
using namespace literals;

/// Lines without comments, split at commas.
std::vector<std::vector<std::string>> table(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// A block on a spring: x = cos(ω t)/2 about the rest length, ω² = k/m = 9/4; the values are formulas of others.
Scene oscillator() {
  Scene scene("oscillator");
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression k = scene.run_time_parameter("k", "N/m", m * Expression::quantity("9", "s^-2") / 4);
  const Expression rest = scene.parameter("rest", "m", 1);
  const Expression x = scene.coordinate("x", "m");
  scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(m));
  scene.spring("spring", x, k, rest);
  scene.initial(x, rest + metres("0.5"));
  return scene;
}

TEST(Reference, FollowsTheClosedFormToItsDigits) {
  const WorkingDigits precision(60);
  const std::vector<std::vector<std::string>> rows = table(reference_csv(oscillator(), {40, {"0.5", "1", "3.25"}}));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time", "x", "x'"}));
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Real angle = Real::parse(rows[k][0]) * rational(3, 2);
    EXPECT_LT(relative_difference(Real::parse(rows[k][1]), Real(1) + cos(angle) / Real(2)), 1e-38);
    EXPECT_LT(relative_difference(Real::parse(rows[k][2]), -rational(3, 4) * sin(angle)), 1e-38);
  }
}

TEST(Reference, SaysHowItWasMade) {
  const std::string text = reference_csv(oscillator(), {20, {"1"}});
  EXPECT_TRUE(text.starts_with("# Reference motion of the scene oscillator: "));
  EXPECT_NE(
      text.find("# regenerate: oscillator_scene reference --digits 20 --times 1 --output oscillator.reference.csv"),
      std::string::npos);
}

/// With a constraint: a pendulum in Cartesian coordinates moves like the one of one angle.
TEST(Reference, IsTheSameForTwoParametrisations) {
  const WorkingDigits precision(60);
  Scene angle = pendulum();
  angle.initial(Expression(angle.content().coordinates[0].q), pi() / 6);
  SlidingPoint cartesian("cartesian", "2");
  cartesian.scene.gravity({0, quantity("-9.81", "m/s^2"), 0});
  cartesian.scene.holonomic("rod", cartesian.x * cartesian.x + cartesian.y * cartesian.y - quantity("2.25", "m^2"));
  cartesian.scene.initial(cartesian.x, 0.75_r);
  cartesian.scene.initial(cartesian.y, -0.75_r * sqrt(Expression(3)));
  const Real theta = Real::parse(table(reference_csv(angle, {30, {"1.5"}}))[1][1]);
  const std::vector<std::string> row = table(reference_csv(cartesian.scene, {30, {"1.5"}}))[1];
  EXPECT_LT(relative_difference(Real::parse(row[1]), rational(3, 2) * sin(theta)), 1e-28);
  EXPECT_LT(relative_difference(Real::parse(row[2]), -rational(3, 2) * cos(theta)), 1e-28);
}

TEST(Reference, NeedsAValueForEveryParameter) {
  Scene scene = oscillator();
  scene.parameter("unknown", "m");
  EXPECT_EQ(error_of<SceneError>([&] {
              reference_csv(scene, {20, {"1"}});
            }),
            "the scene 'oscillator' has parameters without a value: a reference needs all of them");
}

}  // namespace
}  // namespace torsor::reference_test
