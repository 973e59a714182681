// SPDX-License-Identifier: GPL-3.0-or-later
// A tall box that rocks on two edges of a face until it rests on all four corners of it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "tests/contacts/random_space_scenes.hpp"

namespace corners_at_rest_test {
namespace {

using namespace random_space_scenes;
using State = SpaceScene::State;

constexpr double width = 0.05, height = 0.1, foot = 0.01;

SpaceScene box() {
  SpaceScene scene;
  Body body;
  body.mass = 1;
  body.inertia = {(0.09 + 0.04) / 12, (0.01 + 0.04) / 12, (0.09 + 0.01) / 12};
  scene.bodies.push_back(body);
  for (int corner = 0; corner < 4; ++corner) {
    scene.balls.push_back({0, {corner / 2 == 0 ? -0.15 : 0.15, corner % 2 == 0 ? -width : width, -height}, foot});
    scene.touches.push_back({corner, 0, true, 0.8, 0});
  }
  return scene;
}

// Its weight acts on the diagonals of the face. Where three corners were closed and the fourth was not, one of the three
// had no force but rounding: the box began to slip and to tip without end.
TEST(CornersAtRest, AllFourHoldABoxThatHasRocked) {
  constexpr double yaw = 0.84, tilt = 1e-7;
  // Turned by the tilt about x, then by the yaw about z; the lower feet are just above the floor.
  const double a = std::cos(tilt / 2), b = std::sin(tilt / 2), c = std::cos(yaw / 2), d = std::sin(yaw / 2);
  State y{};
  y[3] = c * a;
  y[4] = c * b;
  y[5] = d * b;
  y[6] = d * a;
  y[2] = height + foot + width * tilt + 1e-9;
  constexpr DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};
  std::array<bool, 4> closed{};
  const auto watch = [&closed](const ContactEvent& event) {
    for (std::size_t i = 0; i < closed.size(); ++i) closed[i] = event.contacts[i].touches;
    return true;
  };
  const ContactResult result = integrate_contacts(box(), y, 0, 1, method, {}, watch);
  EXPECT_TRUE(result) << describe(result.status) << " at " << result.time;
  EXPECT_EQ(result.events, result.impacts);  // no corner slips nor is lifted
  EXPECT_LE(result.worst_residual, 1e-13);
  for (const bool each : closed) EXPECT_TRUE(each);
  EXPECT_NEAR(y[2], height + foot, 1e-15);
  for (std::size_t i = SpaceScene::nq; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-13);
}

}  // namespace
}  // namespace corners_at_rest_test
