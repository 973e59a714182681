// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::table_on_feet_test {
namespace {

using testing_mechanisms::metres;
using testing_mechanisms::moment;
using testing_programs::Outcome;
using testing_programs::run;

/// A table on four feet, thrown along a rough floor: the four normal forces are one more than equilibrium determines.
Scene table_on_feet() {
  Scene scene("table", "");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  const FrameHandle across = scene.prismatic("across", along, axis::y, y);
  const FrameHandle above = scene.prismatic("above", across, axis::z, z);
  const FrameHandle top = scene.spherical("top", above, scene.attitude("e"));
  scene.body("top", top,
             Inertia::general({.mass = testing_mechanisms::kilograms("3"), .xx = moment("0.04"), .yy = moment("0.06"),
                               .zz = moment("0.09")}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.initial(z, metres("0.11"));
  const char* const ends[] = {"-1", "1"};
  for (int foot = 0; foot < 4; ++foot) {
    const Expression dx = metres("0.2") * Expression::quantity(ends[foot % 2], "1");
    const Expression dy = metres("0.15") * Expression::quantity(ends[foot / 2], "1");
    const FrameHandle end = scene.weld("foot" + std::to_string(foot), top, {.origin = {dx, dy, metres("-0.1")}});
    scene.contact("floor" + std::to_string(foot), shape::Sphere{.frame = end, .radius = metres("0.01")},
                  shape::Plane{.frame = scene.ground()}, {.friction = Expression(Number::rational(1, 2))});
  }
  return scene;
}

std::vector<double> last_row(const std::string& csv) {
  std::istringstream lines(csv);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) last = line;
  }
  std::vector<double> row;
  std::istringstream cells(last);
  for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  return row;
}

struct Throw {
  double x, y;
  const char* tolerance;
};

// All feet end their slips at once, after v²/(2 f g), however the feet share the weight.
class Slides : public testing::TestWithParam<Throw> {};

TEST_P(Slides, EndAfterTheWayOfOneBlock) {
  const auto& [vx, vy, tolerance] = GetParam();
  const std::string start = "x'=" + std::to_string(vx) + ",y'=" + std::to_string(vy);
  const Outcome outcome =
      run(table_on_feet, {"simulate", "--to", "0.7", "--step", "0.1", "--tolerance", tolerance, "--initial", start});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const double way = std::hypot(vx, vy) / (2 * 0.5 * 9.81), allowed = 100 * std::stod(tolerance) + 1e-11;
  const std::vector<double> end = last_row(outcome.out);
  EXPECT_NEAR(end.at(1), way * vx, allowed);
  EXPECT_NEAR(end.at(2), way * vy, allowed);
  EXPECT_NEAR(end.at(3), 0.11, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Feet, Slides,
                         testing::Values(Throw{0.5, 1, "1e-10"}, Throw{-1.25, 1.5, "1e-8"}, Throw{-1.5, -2, "1e-8"},
                                         Throw{1.75, -0.9, "1e-12"}, Throw{-0.2, 0.8, "1e-8"}));

// With a spin the motion depends on how the feet share the weight: one of many is taken, and told so.
TEST(TableOnFeet, SpinsToRestAndTellsOfOtherMotions) {
  const Outcome outcome = run(table_on_feet, {"simulate", "--to", "1", "--step", "0.1", "--initial",
                                              "x'=1.1,y'=-1.5,e_omega_z=4"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("several motions fulfil the laws of contact"), std::string::npos);
  const std::vector<double> end = last_row(outcome.out);
  EXPECT_NEAR(end.at(3), 0.11, 1e-14);
}

}  // namespace
}  // namespace torsor::table_on_feet_test
