// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars that are neither float nor double: what a kernel asks of their traits.
#include <cmath>

#include <gtest/gtest.h>

#include "generated/double_pendulum.hpp"

namespace {

/// A value and its derivative along some direction.
struct Dual {
  double value = 0, slope = 0;
};

/// Two states side by side.
struct Pack {
  double lane[2];
  friend Pack operator+(Pack a, Pack b) { return {{a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]}}; }
  friend Pack operator-(Pack a, Pack b) { return {{a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]}}; }
  friend Pack operator*(Pack a, Pack b) { return {{a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]}}; }
};

}  // namespace

namespace torsor {

template <>
struct scalar_traits<Dual> {
  static void sincos(const Dual& angle, Dual& sine, Dual& cosine) noexcept {
    const double s = std::sin(angle.value), c = std::cos(angle.value);
    sine = {s, c * angle.slope};
    cosine = {c, -s * angle.slope};
  }
};

template <>
struct scalar_traits<Pack> {
  static constexpr Pack constant(double in_double, float, const char*) noexcept { return {{in_double, in_double}}; }
};

}  // namespace torsor

namespace {

TEST(SincosOfOtherScalars, IsTakenOneByOneFromTheirTraits) {
  const Dual angles[] = {{0.5, 1}, {2, 3}, {-1, 0}};
  Dual sines[3], cosines[3];
  torsor::sines_and_cosines(angles, sines, cosines);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(sines[i].value, std::sin(angles[i].value));
    EXPECT_EQ(cosines[i].value, std::cos(angles[i].value));
    EXPECT_EQ(sines[i].slope, std::cos(angles[i].value) * angles[i].slope);
    EXPECT_EQ(cosines[i].slope, -std::sin(angles[i].value) * angles[i].slope);
  }
}

TEST(SincosOfOtherScalars, CanUseTheCoreForPacks) {
  using Core = torsor::SineCosine<Pack, false>;
  for (int k = -1000; k < 1000; ++k) {
    const Pack angle{{0.37 * k, -2.1e3 * k}};
    Pack sine, cosine;
    Core::core(angle, sine, cosine);
    for (int lane = 0; lane < 2; ++lane) {
      double s, c;
      torsor::sincos_of_one(angle.lane[lane], s, c);
      EXPECT_EQ(sine.lane[lane], s) << angle.lane[lane];
      EXPECT_EQ(cosine.lane[lane], c) << angle.lane[lane];
    }
  }
}

}  // namespace
