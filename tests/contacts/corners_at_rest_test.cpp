// SPDX-License-Identifier: GPL-3.0-or-later
// A tall box that rocks on two edges of a face until it rests on all four corners of it.
#include <gtest/gtest.h>

#include <algorithm>
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

/// The same box with eight corners without a radius.
SpaceScene thrown_box() {
  SpaceScene scene = box();
  scene.balls.clear();
  scene.touches.clear();
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d place{corner % 2 == 0 ? -0.15 : 0.15, corner / 2 % 2 == 0 ? -width : width, corner / 4 == 0 ? -height : height};
    scene.balls.push_back({0, place, 0});
    scene.touches.push_back({corner, 0, true, 0.4, 0.3});
  }
  return scene;
}

// Two corners of an edge slide to their end while the box rocks on it, one of them passing zero at a distance: forces gave its slip
// no direction, and the motion ended there. Nothing sinks, and energy never grows.
TEST(CornersAtRest, SlipsOfAnEdgeEndWhereForcesGiveThemNoDirection) {
  constexpr std::array<double, 4> turned{-0.52859534820239595, -0.79616124568795288, -0.027232050531555228, 0.29321092092083068};
  constexpr std::array<double, 6> thrown{-0.54672087343033093,  -0.44451700899432173, -0.079385314531835727,
                                         -2.4413296719877859, 0.060193149836023828, -1.0494903418508974};
  const SpaceScene scene = thrown_box();
  State y{};
  y[2] = 0.5;
  std::copy(turned.begin(), turned.end(), y.begin() + 3);
  std::copy(thrown.begin(), thrown.end(), y.begin() + SpaceScene::nq);
  const auto energy = [&scene](const State& at) {
    const auto [kinetic, potential] = scene.energies(at);
    return kinetic + potential;
  };
  double last = energy(y);
  const auto watch = [&](const double&, const State& at) {
    const double now = energy(at);
    EXPECT_LE(now, last + 1e-9);
    last = now;
    for (const double gap : scene.gaps(at)) EXPECT_GE(gap, -1e-12);
    return true;
  };
  constexpr DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};
  const ContactResult result = integrate_contacts(scene, y, 0, 0.8, method, {}, watch);
  EXPECT_TRUE(result) << describe(result.status) << " at " << result.time;
  EXPECT_LE(result.worst_residual, 1e-12);
  // From one impact to the next the box turns by little: a step or two. A slip that had the direction of forces, far off
  // that of its velocity, took hundreds of steps along the place where forces give it none.
  EXPECT_LE(result.integration.statistics.accepted, 2 * result.events);
}

}  // namespace
}  // namespace corners_at_rest_test
