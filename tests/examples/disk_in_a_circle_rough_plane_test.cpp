// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "generated/disk_in_a_circle_rough_plane.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::disk_in_a_circle_rough_plane_test {
namespace {

using namespace torsor::runtime;
using Disk = MechanismWithContacts<disk_in_a_circle_rough_plane::Mechanism<double>>;

// Pommier, 8.3.2 exercise 2: a disk that rolls round a circle needs f = 4 R d/(h (6 R + d)), d² = ρ² − h². With more it
// goes on rolling, with less the assumption of the page ends at once: it slips, and its centre leaves the circle.
TEST(DiskInACircleRoughPlane, RollsWhereFrictionSufficesAndSlipsWhereItDoesNot) {
  constexpr double R = 10, h = 1;
  const double d = std::sqrt(3.0), needed = 4 * R * d / (h * (6 * R + d));
  for (const double part : {1.001, 0.999}) {
    const Disk system({.f = part * needed});
    Disk::State y = system.initial();
    const auto result = integrate_contacts(system, y, 0, 0.05,
                                           DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_LE(result.worst_residual, 1e-13);
    const ContactMechanismOf<Disk> mechanism(system);
    ContactMotion motion(mechanism);
    ASSERT_TRUE(motion.read(0.05, y));
    const double slip = std::hypot(motion.reading().w(1), motion.reading().w(2));
    // It does not sink: a gap is a difference of lengths of 1 m.
    EXPECT_NEAR(motion.reading().gap[0], 0, 1e-14);
    if (part > 1) {
      // Some ten steps within 1e-13, and the growth of a deviation in a twentieth of a second.
      EXPECT_NEAR(std::hypot(y[0], y[1]), R, 1e-10);
      EXPECT_NEAR(y[2], h, 1e-10);
      EXPECT_LE(slip, 1e-12);
    } else {
      EXPECT_GT(slip, 1e-5);
    }
  }
}

}  // namespace
}  // namespace torsor::disk_in_a_circle_rough_plane_test
