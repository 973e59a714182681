// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/vector.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/symbolic_vectors.hpp"

namespace torsor::vector_test {
namespace {

using namespace testing_symbols;

class VectorTest : public ::testing::Test, protected SymbolicVectors {
 protected:
  static bool all_zero(const Vector& v) {
    return identically_zero(v[0]) && identically_zero(v[1]) && identically_zero(v[2]);
  }

  Vector a = symbols("a"), b = symbols("b"), c = symbols("c");
};

using VectorIdentity = VectorTest;

TEST_F(VectorIdentity, CrossProductsOfTheAxesAreCyclic) {
  for (int i = 0; i < 3; ++i) {
    Vector first, second, third;
    first[i] = second[(i + 1) % 3] = third[(i + 2) % 3] = program.number(Number(1));
    EXPECT_TRUE(all_zero(cross(first, second) - third));
    EXPECT_TRUE(all_zero(cross(second, first) + third));
  }
}

TEST_F(VectorIdentity, MixedProductIsCyclicAndAlternating) {
  EXPECT_TRUE(identically_zero(dot(a, cross(b, c)) - dot(b, cross(c, a))));
  EXPECT_TRUE(identically_zero(dot(a, cross(b, c)) + dot(b, cross(a, c))));
  EXPECT_TRUE(identically_zero(dot(a, cross(a, c))));
  EXPECT_FALSE(identically_zero(dot(a, cross(b, c))));
}

TEST_F(VectorIdentity, DoubleCrossProductExpands) {
  const Vector left = cross(a, bound(program, cross(b, c)));
  const Vector right = dot(a, c) * b - dot(a, b) * c;
  EXPECT_TRUE(all_zero(left - right));
}

TEST_F(VectorIdentity, SquaresOfBothProductsAddUp) {
  const Vector product = cross(a, b);
  EXPECT_TRUE(
      identically_zero(dot(product, product) + pow(dot(a, b), 2) - dot(a, a) * dot(b, b)));  // Lagrange's identity
}

TEST_F(VectorIdentity, RotationsKeepBothProducts) {
  const Rotation r = Rotation::about(0, 5) * Rotation::about(2, 1) * Rotation::about(1, -2);
  EXPECT_TRUE(identically_zero(dot(r * a, r * b) - dot(a, b)));
  EXPECT_TRUE(all_zero(cross(r * a, r * b) - r * cross(a, b)));
}

TEST_F(VectorIdentity, MatricesActLikeTheRotationsTheyHold) {
  const Rotation r = Rotation::about(1, 7) * Rotation::about(0, 3);
  const Rotation s = Rotation::about(2, -5);
  const Matrix product = constant_matrix(program, r) * constant_matrix(program, s);
  EXPECT_TRUE(all_zero(product * a - (r * s) * a));
  EXPECT_TRUE(all_zero(transpose(product) * a - (r * s).transpose() * a));
  EXPECT_TRUE(all_zero(bound(program, product) * a - r * (s * a)));
}

using VectorUnits = VectorTest;

TEST_F(VectorUnits, MultiplyInProductsAndMustAgreeInSums) {
  const Vector arm = symbols("p", "m");
  const Vector force = symbols("f", "N");
  EXPECT_EQ(cross(arm, force)[0].unit(), units::newton_metre);
  EXPECT_EQ(dot(arm, force).unit(), units::joule);
  EXPECT_THROW(arm + force, UnitError);
  EXPECT_THROW(arm - force, UnitError);
}

TEST_F(VectorUnits, ComponentsCarryTheirAxisInTheirName) {
  const Vector sum = bound(program, a + b, "arm");
  EXPECT_EQ(label(program, *sum[0].value_number()), "arm, x");
  EXPECT_EQ(label(program, *sum[2].value_number()), "arm, z");
}

}  // namespace
}  // namespace torsor::vector_test
