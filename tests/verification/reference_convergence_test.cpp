// SPDX-License-Identifier: GPL-3.0-or-later
// References hold the digits that converged, and say so where these are fewer than was asked for.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/verification/reference.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::reference_convergence_test {
namespace {

using namespace testing_programs;

/// x = sin t.
Scene swinging() { return testing_mechanisms::block_on_a_spring({.speed = Expression::quantity("1", "m/s")}); }

/// x'' = 2 x³ from x = 1, x' = 1: x = 1/(1 − t), which ends at t = 1.
Scene ending() {
  Scene scene("ending");
  const Expression x = scene.coordinate("x", "m");
  scene.body("mass", scene.prismatic("mass", scene.ground(), axis::x, x), Inertia::point(scene.parameter("m", "kg", 1)));
  scene.generalised_force("push", x, Expression::quantity("2", "N/m^3") * x * x * x);
  scene.initial(x, 1, 1);
  return scene;
}

/// Chaos: the double pendulum of the examples loses some four digits in 5 s.
Scene chaotic() {
  Scene scene = testing_mechanisms::double_pendulum({});
  scene.initial(Expression(scene.content().coordinates[0].q), 2);
  scene.initial(Expression(scene.content().coordinates[1].q), Expression(Number::rational(5, 2)));
  return scene;
}

std::vector<std::vector<std::string>> rows(const std::string& csv) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("time", 0) == 0) continue;
    all.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) all.back().push_back(field);
  }
  return all;
}

std::size_t digits_of(const std::string& number) {
  std::size_t count = 0;
  bool leading = true;
  for (const char c : number.substr(0, number.find('e'))) {
    if (c == '0' && leading) continue;
    if (c < '0' || c > '9') continue;
    leading = false;
    ++count;
  }
  return count;
}

TEST(ReferenceConvergence, WritesTheDigitsThatConvergedAndFailsTheCommand) {
  const Outcome outcome = run(chaotic, {"reference", "--digits", "10", "--times", "0.5,5"});
  EXPECT_EQ(outcome.code, 1);
  const auto all = rows(outcome.out);
  ASSERT_EQ(all.size(), 2U) << outcome.out;
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(digits_of(all[0][i]), 10U) << all[0][i];
  // Steps of both runs differ by some 1e-12, which grows 2600 times in 5 s: all ten digits cannot be left.
  std::size_t least = 10;
  for (std::size_t i = 1; i < 5; ++i) least = std::min(least, digits_of(all[1][i]));
  EXPECT_LT(least, 10U) << outcome.out;
  EXPECT_NE(outcome.out.find("# that agree to the digits that are written, fewer than 10;"), std::string::npos);
  EXPECT_NE(outcome.out.find("# at t = 5 "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("note: at t = 5 "), std::string::npos) << outcome.err;
  EXPECT_THROW(reference_csv(chaotic(), {10, {"0.5", "5"}}), Error);
}

TEST(ReferenceConvergence, KeepsWhatIsBeforeASingularity) {
  const Outcome outcome = run(ending, {"reference", "--digits", "15", "--times", "0.5,0.75,2"});
  EXPECT_EQ(outcome.code, 1);
  const auto all = rows(outcome.out);
  ASSERT_EQ(all.size(), 2U) << outcome.out;
  EXPECT_EQ(all[0][1], "2.00000000000000");  // 1/(1 − 1/2)
  EXPECT_EQ(all[1][1], "4.00000000000000");
  EXPECT_NE(outcome.err.find("note: from t = 2 on there is no row: the extrapolation integration stops at t = "),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(run(ending, {"reference", "--digits", "15", "--times", "2"}).code, 3);  // nothing to write
}

TEST(ReferenceConvergence, WritesNoDigitOfASmallNumberThatBothRunsDoNotShare) {
  // 3.14159265358979323846 is π less 2.643383279502884197e-21, and so is the sine there. It is known to 1e-20 and some
  // digits more, which are fewer than twenty of its own.
  const Outcome outcome = run(swinging, {"reference", "--digits", "20", "--times", "3.14159265358979323846"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto all = rows(outcome.out);
  ASSERT_EQ(all.size(), 1U);
  const std::size_t digits = digits_of(all[0][1]);
  EXPECT_LT(digits, 20U) << all[0][1];
  const double difference = std::stod(all[0][1]) - 2.643383279502884197e-21;
  // One unit of the last digit that is written, or the rounding of a double.
  EXPECT_LE(std::abs(difference), 2.65e-21 * std::max(std::pow(10.0, 1.0 - static_cast<double>(digits)), 4e-16));
}

}  // namespace
}  // namespace torsor::reference_convergence_test
