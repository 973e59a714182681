// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/dyad.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/symbolic_vectors.hpp"

namespace torsor::dyad_test {
namespace {

using namespace testing_symbols;

class Dyad : public ::testing::Test, protected SymbolicVectors {
 protected:
  static bool all_zero(const Matrix& m) {
    for (int i = 0; i < 3; ++i) {
      if (!identically_zero(Vector(m(i, 0), m(i, 1), m(i, 2)))) return false;
    }
    return true;
  }

  Vector a = symbols("a"), b = symbols("b"), c = symbols("c");
};

using CrossOperator = Dyad;
using MatrixAlgebra = Dyad;

TEST_F(Dyad, TakesTheProjectionOnItsSecondVectorAlongTheFirst) {
  EXPECT_TRUE(identically_zero(dyad(a, b) * c - dot(b, c) * a));
  EXPECT_FALSE(identically_zero(dyad(a, b) * c - dot(a, c) * b));
  EXPECT_TRUE(all_zero(transpose(dyad(a, b)) - dyad(b, a)));
  EXPECT_TRUE(identically_zero(trace(dyad(a, b)) - dot(a, b)));
}

TEST_F(CrossOperator, ActsLikeTheCrossProduct) {
  EXPECT_TRUE(identically_zero(cross_operator(a) * b - cross(a, b)));
  const Matrix square = cross_operator(a) * cross_operator(a);
  EXPECT_TRUE(all_zero(square - (dyad(a, a) - dot(a, a) * identity(program))));
}

TEST_F(MatrixAlgebra, IsLinear) {
  const Matrix m = dyad(a, b);
  const Value k = program.lower(make_symbol("k", "m"));
  EXPECT_TRUE(identically_zero((k * m) * c - k * (m * c)));
  EXPECT_TRUE(all_zero((m + identity(program)) * m - (m * m + m)));
  EXPECT_EQ((k * m)(0, 1).unit(), units::metre);
}

}  // namespace
}  // namespace torsor::dyad_test
