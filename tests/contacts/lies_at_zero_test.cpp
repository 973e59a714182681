// SPDX-License-Identifier: GPL-3.0-or-later
// Thin rods that lie on a floor at z = 0: what rounding leaves of their coordinates fades to nothing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/contacts/contact_scale.hpp"

namespace lies_at_zero_test {
namespace {

using namespace simple_systems;

struct Rod {
  double mass, half, friction, restitution;
  double z, angle, turns;  ///< at the start
};
using Rods = std::array<Rod, 2>;

/// Two rods that never meet and touch with both ends: q = (x, z, θ) of each, θ raises its first end.
ByHand<6, 6, 4> rods_at_zero(const Rods& rods) {
  ByHand<6, 6, 4> system{{}, [rods](double, const auto& y, auto& r) {
                           r.M.setIdentity();
                           r.F.setZero();
                           r.J.setZero();
                           for (int i = 0; i < 4; ++i) {
                             const Rod& rod = rods[static_cast<std::size_t>(i / 2)];
                             const int x = 3 * (i / 2), n = 2 * i;
                             const auto q = static_cast<std::size_t>(x), v = q + 6;
                             r.M.diagonal().segment(x, 3) << rod.mass, rod.mass, rod.mass * rod.half * rod.half / 3;
                             r.F(x + 1) = -rod.mass * g;
                             const double place = i % 2 == 0 ? -rod.half : rod.half;
                             const double along = place * std::cos(y[q + 2]), up = -place * std::sin(y[q + 2]);
                             r.gap[static_cast<std::size_t>(i)] = y[q + 1] + up;
                             r.J.row(n).segment(x, 3) << 0, 1, -along;
                             r.J.row(n + 1).segment(x, 3) << 1, 0, up;
                             r.w(n) = y[v + 1] - along * y[v + 2];
                             r.w(n + 1) = y[v] + up * y[v + 2];
                             r.drift(n) = -up * y[v + 2] * y[v + 2];
                             r.drift(n + 1) = -along * y[v + 2] * y[v + 2];
                           }
                         }};
  for (std::size_t i = 0; i < 4; ++i) {
    system.rules[i] = {.tangents = 1, .friction = rods[i / 2].friction, .restitution = rods[i / 2].restitution};
  }
  return system;
}

// Once the blows of the rod that came down last ended the motion: "too many events", or a guard that was no number. The other one
// lay there with coordinates of 1e-320.
TEST(LiesAtZero, RestsWhateverFallsBeside) {
  constexpr std::array<Rods, 5> scenes{{
      {{{2.59, 0.51, 0.43, 0, 0.37, -0.45, -0.28}, {2.51, 0.24, 0.95, 0.1, 0.48, -0.48, 0.64}}},
      {{{1.1, 0.19, 0.67, 0.1, 0.83, -0.31, -0.86}, {2.48, 0.49, 0.59, 0.3, 0.68, -0.4, -0.56}}},
      {{{0.61, 0.35, 0.73, 0.1, 0.39, -0.37, -0.52}, {0.76, 0.26, 0.87, 0.1, 0.7, -0.43, -0.91}}},
      {{{1.52, 0.5, 0.51, 0.1, 0.4, -0.27, 0.77}, {0.41, 0.19, 0.99, 0.1, 0.33, 0.11, -0.03}}},
      {{{1.67, 0.59, 0.34, 0.1, 0.8, 0.13, -0.73}, {0.41, 0.17, 0.98, 0, 0.6, -0.48, 0.24}}},
  }};
  constexpr DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    std::array<double, 12> y{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Rod& rod = scenes[scene][k];
      y[3 * k + 1] = rod.z;
      y[3 * k + 2] = rod.angle;
      y[3 * k + 8] = rod.turns;
    }
    const ContactResult result = integrate_contacts(rods_at_zero(scenes[scene]), y, 0, 2, method);
    ASSERT_TRUE(result) << describe(result.status) << " at " << result.time << ", scene " << scene;
    for (const std::size_t i : {1U, 2U, 4U, 5U}) EXPECT_NEAR(y[i], 0, 1e-15) << scene;
    for (std::size_t i = 6; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-14) << scene;
  }
}

// Once that of a force of 1e-323 was endless, and so was what rounding was said to make of its contact's forces.
TEST(LiesAtZero, SizeAlongANumberNextToNothing) {
  ContactVector sizes(3), all(3);
  sizes << 5, 10, 20;
  for (const double each : {1.0, 1e-300, 2 * std::numeric_limits<double>::denorm_min()}) {
    all << 1, each, 0;
    EXPECT_EQ(size_along(sizes, all, 1, 2), 10) << each;
    all << 1, 0, -each;
    EXPECT_EQ(size_along(sizes, all, 1, 2), 20) << each;
  }
  all << 1, 0, 0;
  EXPECT_EQ(size_along(sizes, all, 1, 2), 20);
  EXPECT_EQ(size_along(sizes, all, 1, 0), 0);
}

}  // namespace
}  // namespace lies_at_zero_test
