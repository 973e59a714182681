// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/rotation.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::rotation_test {
namespace {

TEST(Rotation, TurnsFromOneAxisTowardsTheNextByAQuarterTurn) {
  for (int axis = 0; axis < 3; ++axis) {
    const Rotation quarter = Rotation::about(axis, 6);
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    EXPECT_EQ(quarter(last, next), Number(1));   // e_next becomes e_last
    EXPECT_EQ(quarter(next, last), Number(-1));  // e_last becomes -e_next
    EXPECT_EQ(quarter(axis, axis), Number(1));
    EXPECT_TRUE(quarter(next, next).is_zero());
  }
}

TEST(Rotation, AddsAnglesAboutOneAxisExactly) {
  for (int axis = 0; axis < 3; ++axis) {
    Rotation turned;
    for (int k = 0; k < 24; ++k) {
      EXPECT_TRUE((Rotation::about(axis, k) * turned.transpose()).is_identity()) << k;
      turned = turned * Rotation::about(axis, 1);
    }
    EXPECT_TRUE(turned.is_identity());  // a whole turn
    EXPECT_FALSE(Rotation::about(axis, 1).is_identity());
  }
}

TEST(Rotation, ComposesFromTheLeftAndHasItsTransposeAsInverse) {
  const Rotation a = Rotation::about(0, 5);
  const Rotation b = Rotation::about(2, -7);
  EXPECT_TRUE((a * b * (a * b).transpose()).is_identity());
  EXPECT_TRUE(((a * b).transpose() * a * b).is_identity());
  EXPECT_FALSE((a * b * (b * a).transpose()).is_identity());
  // (a b)_ij = Σ a_ik b_kj, spelt out for one entry.
  EXPECT_EQ((a * b)(1, 0), a(1, 0) * b(0, 0) + a(1, 1) * b(1, 0) + a(1, 2) * b(2, 0));
}

TEST(Rotation, IsBuiltFromExactlyOrthonormalColumnsOnly) {
  const auto r = [](int n, int d) { return Number::rational(n, d); };
  const Rotation tilted = Rotation::matrix({r(3, 5), r(-4, 5), 0, r(4, 5), r(3, 5), 0, 0, 0, 1});
  EXPECT_EQ(tilted(1, 0), r(4, 5));
  EXPECT_THROW(Rotation::matrix({1, 0, 0, 0, 1, 0, 0, 0, -1}), SceneError);  // a mirror
  EXPECT_THROW(Rotation::matrix({2, 0, 0, 0, 1, 0, 0, 0, 1}), SceneError);
  EXPECT_THROW(Rotation::matrix({1, r(1, 1000000), 0, 0, 1, 0, 0, 0, 1}), SceneError);
  try {
    Rotation::matrix({r(1, 2), 0, 0, 0, 1, 0, 0, 0, 1});
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(),
                 "the matrix with first row (1/2, 0, 0) is not a rotation: its columns must be orthonormal "
                 "and its determinant 1, exactly");
  }
}

TEST(Rotation, IsAboutNoOtherAxisThanThree) {
  for (const int axis : {-2000000, -1, 3, 2000000}) EXPECT_THROW(Rotation::about(axis, 1), SceneError) << axis;
}

}  // namespace
}  // namespace torsor::rotation_test
