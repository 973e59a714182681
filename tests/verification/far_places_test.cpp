// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates that only place a mechanism on its ground cost its contacts and its actions no digits.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/verification/verify.hpp"
#include "tests/scenes/rolling.hpp"

namespace torsor::far_places_test {
namespace {

using namespace testing_mechanisms;

/// Sizes up to 2^53 and down to 2^-53, where differences of places were off by 1e5 roundings and more.
void expect_digits(const Scene& scene, std::vector<std::string> kernels, double at_most) {
  VerifyOptions options;
  options.kernels = std::move(kernels);
  options.states = 48;
  options.climbs = 0;
  const std::vector<VerifyRow> rows = verify_scene(scene, options);
  ASSERT_FALSE(rows.empty());
  for (const VerifyRow& row : rows) EXPECT_LT(row.worst.scaled, at_most) << row.kernel << " " << row.group;
}

TEST(FarPlaces, CostRollingNoDigits) { expect_digits(RollingDisc().scene, {"constraints", "forward_dynamics"}, 1000); }

/// A force that follows the velocity of a point, on a body that slides and turns.
TEST(FarPlaces, CostMeasuredVelocitiesNoDigits) {
  Scene scene("pushed");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.prismatic("along", scene.ground(), axis::x, x), axis::y, y);
  const FrameHandle body = scene.spherical("body", slide, scene.attitude("e"));
  scene.body("body", body, Inertia::box(kilograms("1"), metres("1"), metres("0.5"), metres("0.25")));
  const PointHandle tip = scene.point("tip", body, {metres("1"), 0, 0});
  const Triple v = scene.velocity(tip, body, scene.ground());
  const Expression push = Expression::quantity("3", "N");
  scene.force("push", {.body = body,
                       .point = tip,
                       .components = {push * max(-1, min(1, v[0] / Expression::quantity("0.01", "m/s"))), 0, 0},
                       .axes = scene.ground()});
  expect_digits(scene, {"bias", "forward_dynamics"}, 8);
}

}  // namespace
}  // namespace torsor::far_places_test
