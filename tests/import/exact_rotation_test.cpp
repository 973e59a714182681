// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/exact_rotation.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/import/exact_direction.hpp"

namespace torsor::exact_rotation_test {
namespace {

using Quaternion = std::array<double, 4>;

const Number tolerance = Number::rational(1, 1000000000);

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}
Quaternion about(int axis, double angle) {
  Quaternion q{std::cos(angle / 2), 0, 0, 0};
  q[static_cast<std::size_t>(axis) + 1] = std::sin(angle / 2);
  return q;
}
ExactRotation exact(const Quaternion& q) {
  return exact_rotation({from_double(q[0]), from_double(q[1]), from_double(q[2]), from_double(q[3])}, tolerance);
}
bool equal(const Rotation& a, const Rotation& b) { return (a.transpose() * b).is_identity(); }

// Quaternions made in doubles, with their rounding.
TEST(ExactRotation, OfTurnsByMultiplesOfFifteenDegreesIsThatProductInAnyOrder) {
  const double step = std::acos(-1.0) / 12;
  int compared = 0;
  for (const auto& [i, j, k] : std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 0}, {1, 2, 1}, {2, 0, 2}}) {
    for (int a = -11; a < 12; a += 7) {
      for (int b = -6; b <= 6; b += 4) {
        for (int c = -12; c < 12; c += 7) {
          const Quaternion q = product(product(about(i, a * step), about(j, b * step)), about(k, c * step));
          const Rotation expected = Rotation::about(i, a) * Rotation::about(j, b) * Rotation::about(k, c);
          EXPECT_TRUE(equal(exact(q).rotation, expected)) << i << j << k << " " << a << " " << b << " " << c;
          ++compared;
        }
      }
    }
  }
  EXPECT_EQ(compared, 4 * 4 * 4 * 4);
}

TEST(ExactRotation, KeepsZerosBesideAnyOtherAngle) {
  const Rotation r = exact(product(about(2, 0.3), about(0, std::acos(-1.0) / 2))).rotation;
  for (const auto& [row, column] : std::vector<std::pair<int, int>>{{0, 1}, {1, 1}, {2, 0}, {2, 2}}) {
    EXPECT_TRUE(r(row, column).is_zero()) << row << column;
  }
  EXPECT_NEAR(r(0, 0).to_double(), std::cos(0.3), 2e-16);
  EXPECT_NEAR(r(1, 0).to_double(), std::sin(0.3), 2e-16);
}

// Entries are good to the rounding of the quaternion's components, of which each entry has products.
TEST(ExactRotation, OfAnyQuaternionIsItsOwn) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 20; ++n) {
    Quaternion q{normal(random), normal(random), normal(random), normal(random)};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& x : q) x /= length;
    const ExactRotation found = exact(q);
    EXPECT_EQ(found.taken_for, "");
    EXPECT_NEAR(found.rotation(0, 1).to_double(), 2 * (q[1] * q[2] - q[0] * q[3]), 1e-15);
    EXPECT_NEAR(found.rotation(2, 2).to_double(), 1 - 2 * (q[1] * q[1] + q[2] * q[2]), 1e-15);
  }
}

// Files give quaternions of any length.
TEST(ExactRotation, OfALongerQuaternionIsTheSame) {
  EXPECT_TRUE(equal(exact({2, 0, 2, 0}).rotation, Rotation::about(1, 6)));
  EXPECT_NEAR(exact({3, 1, 2, 5}).rotation(0, 1).to_double(), 2 * (1 * 2 - 3 * 5) / 39.0, 1e-15);
}

TEST(ExactRotation, SaysWhatItTook) {
  EXPECT_EQ(exact({0.7071067811865476, 0.7071067811865476, 0, 0}).taken_for, "");  // exact already
  EXPECT_EQ(exact({0.7071067811865476, 0.7071067811865475, 0, 0}).taken_for, "Rx(pi/2)");
  EXPECT_EQ(exact({0.9659258262890683, 0, 0.25881904510252074, 0}).taken_for, "Ry(pi/6)");
  EXPECT_EQ(exact({1, 1e-12, 0, 0}).taken_for, "no turn");
  EXPECT_EQ(exact({0.5, 0.5, -0.5, 0.5}).taken_for, "");
}

}  // namespace
}  // namespace torsor::exact_rotation_test
