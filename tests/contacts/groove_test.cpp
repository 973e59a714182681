// SPDX-License-Identifier: GPL-3.0-or-later
// A particle that comes to rest in a groove: it slides on one wall and bounces off the other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "tests/contacts/told_motion.hpp"

namespace groove_test {
namespace {

using namespace told_motion;

/// A particle of mass 1 between two walls that meet at the origin and rise by `angle` from the x axis to either side.
ByHand<2, 2, 2> groove(double angle, double e, double f, bool swapped) {
  const double side = swapped ? -1 : 1;
  const ContactRule rule{.tangents = 1, .friction = f, .restitution = e};
  return {{rule, rule}, [=](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << 0, -g;
            for (int i = 0; i < 2; ++i) {
              const double across = (i == 0 ? side : -side) * std::sin(angle), up = std::cos(angle);
              r.gap[static_cast<std::size_t>(i)] = across * y[0] + up * y[1];
              r.J.row(2 * i) << across, up;
              r.J.row(2 * i + 1) << up, -across;
            }
            r.w = r.J * Eigen::Vector2d(y[2], y[3]);
            r.drift.setZero();
          }};
}

// The last slip ends where the particle touches the other wall without a velocity: nothing falls through zero there, and once the
// slip ended again and again.
TEST(Groove, HoldsWhatSlidesIntoItWhicheverWallIsDeclaredFirst) {
  for (const double e : {0.0, 0.1, 0.3}) {
    for (const double f : {0.1, 0.3, 0.6}) {
      for (const bool swapped : {false, true}) {
        std::array<double, 4> y{0.02, 1, 0.3, 0};
        const Motion motion = move(groove(0.9, e, f, swapped), y, 3);
        EXPECT_EQ(motion.result.time, 3) << e << ' ' << f << swapped;
        for (const double number : y) EXPECT_NEAR(number, 0, 1e-12) << e << ' ' << f << swapped;
      }
    }
  }
}

}  // namespace
}  // namespace groove_test
