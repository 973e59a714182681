// SPDX-License-Identifier: GPL-3.0-or-later
// A table on four feet that slides with a spin: four slips, each in a direction of its own, end at one time.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "tests/contacts/random_space_scenes.hpp"
#include "tests/contacts/random_watch.hpp"
#include "tests/long_tests.hpp"

namespace table_on_feet_test {
namespace {

using torsor::wanted;
using namespace random_space_scenes;
using random_watch::distance;
using State = SpaceScene::State;

SpaceScene table() {
  SpaceScene scene;
  Body top;
  top.mass = 3;
  top.inertia = {0.04, 0.06, 0.09};
  scene.bodies.push_back(top);
  for (int foot = 0; foot < 4; ++foot) {
    scene.balls.push_back({0, {foot % 2 == 0 ? -0.2 : 0.2, foot / 2 == 0 ? -0.15 : 0.15, -0.1}, 0.01});
    scene.touches.push_back({foot, 0, true, 0.5, 0});
  }
  return scene;
}

struct Throw { double x, y, spin, tolerance; };

State thrown(const Throw& start, double tolerance) {
  State y{};
  y[2] = 0.11;
  y[3] = 1;
  y[SpaceScene::nq] = start.x;
  y[SpaceScene::nq + 1] = start.y;
  y[SpaceScene::nq + 5] = start.spin;
  const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
  std::size_t stops = 0;
  const auto count = [&stops](const ContactEvent& event) {
    stops += event.kind == ContactEventKind::slip_ends ? 1 : 0;
    return true;
  };
  const ContactResult result = integrate_contacts(table(), y, 0, 1, method, {}, count);
  EXPECT_TRUE(result) << describe(result.status) << ": " << describe(result.integration_event) << " at " << result.time;
  EXPECT_EQ(stops, 4U);
  EXPECT_NEAR(y[2], 0.11, 1e-15);
  for (std::size_t i = SpaceScene::nq; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-15);
  return y;
}

// Where a foot's slip ended first, what errors of the integration left of another's began and ended for ever; and a direction
// that jumped as its slip faded stopped the steps. The way is that of a finer integration, within some ten steps' errors.
TEST(TableOnFeet, ComesToRestWhereverItsFeetEndTheirSlips) {
  std::vector<Throw> throws{{-0.4, 0.3, 4, 5e-9}, {-0.4, 1.2, 0.3, 5e-9}, {2, -1.5, 4, 5e-11}, {2, 1.2, 0.3, 5e-11}};
  if (wanted(false, true)) {
    for (const double x : {1.1, -0.4, 2.0}) {
      for (const double y : {-1.5, 0.3, 1.2}) {
        for (const double spin : {4.0, -1.0, 0.3}) {
          for (const double tolerance : {5e-9, 5e-11}) throws.push_back({x, y, spin, tolerance});
        }
      }
    }
  }
  for (const Throw& each : throws) {
    SCOPED_TRACE(testing::Message() << each.x << ", " << each.y << ", " << each.spin << ", " << each.tolerance);
    EXPECT_LE(distance(thrown(each, each.tolerance), thrown(each, 1e-12)), 10 * each.tolerance);
  }
}

}  // namespace
}  // namespace table_on_feet_test
