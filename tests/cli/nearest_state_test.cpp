// SPDX-License-Identifier: GPL-3.0-or-later
// The closed state that the error about an open start proposes is the nearest one, in radians and in parts of the mechanism.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/cli/nearest_state.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::nearest_state_test {
namespace {

using Angles = std::array<double, 3>;
constexpr double crank = 0.5, coupler = 1.2, rocker = 0.8, span = 1.4, rise = 0.3;

/// The angle of a crank, that of the coupler on it, and that of a rocker whose end is a pin on the coupler's end.
Scene four_bar(const Angles& start) {
  Scene scene("four_bar", "");
  const auto metres = [](const char* number) { return Expression::quantity(number, "m"); };
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle second = scene.revolute("second", first, axis::z, b, {.origin = {metres("0.5"), 0, 0}});
  const FrameHandle third = scene.revolute("third", scene.ground(), axis::z, c, {.origin = {metres("1.4"), metres("0.3"), 0}});
  for (const FrameHandle& frame : {first, second, third}) {
    scene.body("rod" + std::to_string(frame.index), frame, Inertia::rod(Expression::quantity("1", "kg"), metres("1"), 0));
  }
  const Rotation up = Rotation::about(1, -6);
  const FrameHandle end = scene.weld("end", second, {{metres("1.2"), 0, 0}, up}),
                    pin = scene.weld("pin", third, {{metres("0.8"), 0, 0}, up});
  scene.loop_joint("loop", {.type = JointType::revolute, .a = end, .b = pin});
  const auto number = [](double value) { return Expression(Number::rational(static_cast<int>(std::lround(10 * value)), 10)); };
  scene.initial(a, number(start[0]));
  scene.initial(b, number(start[1]));
  scene.initial(c, number(start[2]));
  return scene;
}

double distance(const Angles& a, const Angles& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

std::array<double, 2> gap(const Angles& q) {
  return {crank * std::cos(q[0]) + coupler * std::cos(q[0] + q[1]) - span - rocker * std::cos(q[2]),
          crank * std::sin(q[0]) + coupler * std::sin(q[0] + q[1]) - rise - rocker * std::sin(q[2])};
}

double nearest_turn(double angle, double to) {
  return angle - 2 * std::numbers::pi * std::round((angle - to) / (2 * std::numbers::pi));
}

/// The least distance of a closed state: crank by crank angle in steps of 1e-4 rad, both sides of the triangle of coupler and
/// rocker.
double least_distance(const Angles& start) {
  double least = 1e300;
  for (double a = start[0] - std::numbers::pi; a < start[0] + std::numbers::pi; a += 1e-4) {
    const double x = span - crank * std::cos(a), y = rise - crank * std::sin(a), d = std::hypot(x, y);
    const double cosine = (coupler * coupler + d * d - rocker * rocker) / (2 * coupler * d);
    if (std::abs(cosine) > 1) continue;
    for (const double side : {-1.0, 1.0}) {
      const double direction = std::atan2(y, x) + side * std::acos(cosine);
      const double c = std::atan2(coupler * std::sin(direction) - y, coupler * std::cos(direction) - x);
      least = std::min(least, distance({a, nearest_turn(direction - a, start[1]), nearest_turn(c, start[2])}, start));
    }
  }
  return least;
}

// Newton's method alone went 4.9 rad from the first, where 1.3 rad are enough, and found nothing from the fourth.
TEST(NearestState, IsWhatIsProposedForALoop) {
  for (const Angles& start : std::vector<Angles>{
           {0, 0, 0}, {0, 0.3, -1.5}, {-1, 0.5, -2}, {1, 1, 1}, {2, -1, 0.5}, {-1.5, 1.2, -1.9}}) {
    SCOPED_TRACE(testing::Message() << start[0] << ", " << start[1] << ", " << start[2]);
    const std::string words = nearest_closed_start(four_bar(start), true);
    Angles found = start;
    const std::array<const char*, 3> names{"a=", "b=", "c="};
    ASSERT_NE(words.find("a state nearby that fulfils all: --initial"), std::string::npos) << words;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t at = words.find(names[i]);
      if (at != std::string::npos) found[i] = std::stod(words.substr(at + 2));
    }
    const std::array<double, 2> open = gap(found);
    EXPECT_NEAR(open[0], 0, 1e-13);
    EXPECT_NEAR(open[1], 0, 1e-13);
    EXPECT_LT(distance(found, start), least_distance(start) + 1e-3);  // the steps of the crank leave 1e-4
  }
}

/// A crank of 0.5 units of length, a rod of 1.2 on it, and a slider along the ground's x axis that the rod's end is to meet.
Scene slider_crank(const Expression& unit) {
  Scene scene("slider_crank", "");
  const auto lengths = [&](const char* number) { return Expression::quantity(number) * unit; };
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), x = scene.coordinate("x", "m");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle second = scene.revolute("second", first, axis::z, b, {.origin = {lengths("0.5"), 0, 0}});
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, x);
  for (const FrameHandle& frame : {first, second, slider}) {
    scene.body("body" + std::to_string(frame.index), frame,
               Inertia::rod(Expression::quantity("1", "kg"), lengths("1"), 0));
  }
  const PointHandle end = scene.point("end", second, {lengths("1.2"), 0, 0}), pin = scene.point("pin", slider, {0, 0, 0});
  scene.closure("along", pin, end, axis::x);
  scene.closure("across", pin, end, axis::y);
  scene.initial(a, Expression(Number::rational(9, 10)));
  scene.initial(b, Expression(Number::rational(-1, 2)));
  scene.initial(x, lengths("0.4"));
  return scene;
}

// Lengths count in parts of the mechanism: what is nearest does not depend on its size.
TEST(NearestState, IsTheSameForAMechanismOfAnySize) {
  std::vector<Angles> found;  // x in units
  for (const auto& [unit, size] : {std::pair{"0.001", 1e-3}, std::pair{"1", 1.0}, std::pair{"1000", 1e3}}) {
    EvaluatedMotion motion(slider_crank(Expression::quantity(unit, "m")), {}, {}, {});
    NearestState nearest(motion, motion.start({}));
    const auto state = nearest.find({});
    ASSERT_TRUE(state.has_value()) << unit;
    const Angles q{(*state)[0], (*state)[1], (*state)[2] / size};
    EXPECT_NEAR(crank * std::cos(q[0]) + coupler * std::cos(q[0] + q[1]), q[2], 1e-9) << unit;
    EXPECT_NEAR(crank * std::sin(q[0]) + coupler * std::sin(q[0] + q[1]), 0, 1e-9) << unit;
    found.push_back(q);
  }
  for (const Angles& q : found) EXPECT_LT(distance(q, found.front()), 1e-6);
}

// A ball joint holds a rod whose end is to be on the ground's x axis at 0.6 and z = 0.8: the shortest turn is about y.
TEST(NearestState, MeasuresTurnsOfAnAttitudeAsOneRotation) {
  Scene scene("ball", "");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle rod = scene.spherical("rod", scene.ground(), e);
  const Expression kg = Expression::quantity("1", "kg"), metre = Expression::quantity("1", "m"), moment = kg * metre * metre;
  scene.body("rod", rod, Inertia::general({.mass = kg, .xx = moment, .yy = moment, .zz = moment}));
  const PointHandle end = scene.point("end", rod, {0, 0, metre});
  const PointHandle place = scene.point("place", scene.ground(), {Expression(Number::rational(3, 5)) * metre, 0, 0});
  scene.closure("x", place, end, axis::x);
  scene.closure("y", place, end, axis::y);
  EvaluatedMotion motion(scene, {}, {}, {});
  const std::vector<double> start = motion.start({});
  NearestState nearest(motion, start);
  const auto found = nearest.find({});
  ASSERT_TRUE(found.has_value());
  const double turn = std::asin(0.6);
  EXPECT_NEAR(nearest.distance(*found), turn, 1e-9);
  EXPECT_NEAR(std::abs((*found)[0]), std::cos(turn / 2), 1e-9);
  EXPECT_NEAR(std::abs((*found)[2]), std::sin(turn / 2), 1e-9);
  EXPECT_NEAR((*found)[3], 0, 1e-9);
}

}  // namespace
}  // namespace torsor::nearest_state_test
