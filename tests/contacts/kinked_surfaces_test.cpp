// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with a kink, and those whose speed jumps: what rides over a ridge flies off with the velocity that it has, and in a
// valley no law says what happens.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/contacts/simple_systems.hpp"

namespace kinked_surfaces_test {
namespace {

using namespace simple_systems;

/// A particle of mass 1 on a ridge (slope > 0) or in a valley at x = 1: z >= -slope |x - 1|, q = (x, z).
ByHand<2, 2, 1> over_ridge(double slope, double f = 0) {
  return {{ContactRule{.tangents = f > 0 ? 1 : 0, .friction = f}}, [=](double, const auto& y, auto& r) {
            const double here = y[0] < 1 ? slope : -slope;
            r.M.setIdentity();
            r.F << 0, -g;
            r.gap[0] = y[1] + slope * std::abs(y[0] - 1);
            r.J.row(0) << -here, 1;
            r.w(0) = y[3] - here * y[2];
            r.drift(0) = 0;
            if (f > 0) {
              r.J.row(1) << 1, here;
              r.w(1) = y[2] + here * y[3];
              r.drift(1) = 0;
            }
          }};
}

// Uphill with 1 m/s² k against it, k = g s/(1 + s²) along x; then a flight that ends on the other side.
TEST(KinkedSurfaces, LetFlyOffWhatRidesOverARidge) {
  for (const double slope : {0.3, 1e-3}) {
    for (const double tolerance : {1e-13, 1e-8}) {
      SCOPED_TRACE(testing::Message() << "slope " << slope << ", tolerance " << tolerance);
      std::array<double, 4> y{0.9, -0.1 * slope, 2, 2 * slope};
      std::vector<ContactEventKind> kinds;
      std::vector<double> times;
      const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      const ContactResult result = integrate_contacts(over_ridge(slope), y, 0, 0.06, method, {}, [&](const ContactEvent& event) {
        kinds.push_back(event.kind);
        times.push_back(event.time);
        return true;
      });
      ASSERT_TRUE(result) << describe(result.status);
      const double brake = g * slope / (1 + slope * slope), speed = std::sqrt(4 - 0.2 * brake), leaves = (2 - speed) / brake;
      ASSERT_FALSE(kinds.empty());
      EXPECT_EQ(kinds[0], ContactEventKind::opens);
      EXPECT_NEAR(times[0], leaves, 1e-12);
      const double flight = 0.06 - leaves;
      if (slope < 0.1) continue;  // it lands within a millisecond
      ASSERT_EQ(kinds.size(), 1U);
      EXPECT_NEAR(y[0], 1 + speed * flight, 1e-12);
      EXPECT_NEAR(y[1], slope * speed * flight - g * flight * flight / 2, 1e-12);
      EXPECT_NEAR(y[3], slope * speed - g * flight, 1e-12);
    }
  }
}

TEST(KinkedSurfaces, EndAMotionIntoAValley) {
  for (const double f : {0.0, 0.2}) {
    std::array<double, 4> y{0.9, 0.03, 2, -0.6};
    const ContactResult result = integrate_contacts(over_ridge(-0.3, f), y, 0, 0.3);
    EXPECT_EQ(result.status, ContactStatus::no_point) << describe(result.status);
    EXPECT_NEAR(y[0], 1, 1e-12);
    EXPECT_NE(describe(result.status).find("the rate of its gap does"), std::string_view::npos);
  }
}

TEST(KinkedSurfaces, LetFlyOffWhatSlidesWithFriction) {
  std::array<double, 4> y{0.9, -0.03, 2, 0.6};
  std::vector<ContactEventKind> kinds;
  const ContactResult result = integrate_contacts(over_ridge(0.3, 0.2), y, 0, 0.06, DormandPrince853{}, {},
                                                  [&](const ContactEvent& event) {
                                                    kinds.push_back(event.kind);
                                                    return true;
                                                  });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(kinds, std::vector{ContactEventKind::opens});
  EXPECT_GT(y[1], 0);
}

// A lift that rises at 0.6 m/s and stops at t = 0.1 s, with two bodies on it, and a third that stands on the first.
TEST(KinkedSurfaces, LetFlyOffAllThatALiftCarries) {
  const ContactRule plain{.tangents = 0};
  const ByHand<3, 3, 3> lift{{plain, plain, plain}, [](double t, const auto& y, auto& r) {
                               const double speed = t < 0.1 ? 0.6 : 0, height = 0.6 * std::min(t, 0.1);
                               r.M.setIdentity();
                               r.F << -g, -g, -g;
                               r.gap = {y[0] - height, y[1] - height, y[2] - y[0]};
                               r.J << 1, 0, 0, 0, 1, 0, -1, 0, 1;
                               r.w << y[3] - speed, y[4] - speed, y[5] - y[3];
                               r.drift.setZero();
                             }};
  std::array<double, 6> y{0, 0, 0, 0.6, 0.6, 0.6};
  std::vector<int> opened;
  const ContactResult result = integrate_contacts(lift, y, 0, 0.15, DormandPrince853{}, {}, [&](const ContactEvent& event) {
    EXPECT_EQ(event.kind, ContactEventKind::opens);
    EXPECT_NEAR(event.time, 0.1, 1e-12);
    opened.push_back(event.contact);
    return true;
  });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(opened, (std::vector{0, 1}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(y[static_cast<std::size_t>(i)], 0.06 + 0.6 * 0.05 - g * 0.05 * 0.05 / 2, 1e-12);
    EXPECT_NEAR(y[static_cast<std::size_t>(3 + i)], 0.6 - g * 0.05, 1e-12);
  }
}

}  // namespace
}  // namespace kinked_surfaces_test
