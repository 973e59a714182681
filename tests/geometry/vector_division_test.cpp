// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/vector_division.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/symbolic_vectors.hpp"

namespace torsor::vector_division_test {
namespace {

using namespace testing_symbols;

class VectorDivision : public ::testing::Test, protected SymbolicVectors {
 protected:
  Vector numbers(int x, int y, int z) {
    return {program.number(Number(x)), program.number(Number(y)), program.number(Number(z))};
  }
};

TEST_F(VectorDivision, FindsEverySolution) {
  const Vector a = symbols("a", "N");
  const Vector x = symbols("x", "m");
  const Vector b = bound(program, cross(a, x));  // orthogonal to a, and no other way to be so
  const VectorQuotient quotient = divide(b, a);
  EXPECT_TRUE(identically_zero(cross(a, quotient.particular) - b));
  EXPECT_TRUE(identically_zero(dot(a, quotient.particular)));
  EXPECT_TRUE(identically_zero(cross(a, quotient.at(program.lower(make_symbol("alpha", "m/N")))) - b));
  // x itself is among them: at α = a·x / a².
  const Value alpha = dot(a, x) / dot(a, a);
  EXPECT_TRUE(identically_zero(quotient.at(alpha) - x));
}

TEST_F(VectorDivision, HasTheSignOfTheCourse) {
  // x ∧ X = z: X = z ∧ x / 1 = y.
  const VectorQuotient quotient = divide(numbers(0, 0, 1), numbers(1, 0, 0));
  EXPECT_TRUE(identically_zero(quotient.particular - numbers(0, 1, 0)));
}

TEST_F(VectorDivision, RefusesTheNullVector) {
  const Vector a = symbols("a");
  EXPECT_EQ(error_of<SceneError>([&] { divide(a, Vector()); }),
            "A ∧ X = B: cannot divide by A, which is the null vector; every X gives 0");
  EXPECT_EQ(error_of<SceneError>([&] { divide(Vector(), a - a); }),
            "A ∧ X = B: cannot divide by A, which is the null vector; every X gives 0");
}

TEST_F(VectorDivision, RefusesWhatIsNotOrthogonal) {
  EXPECT_EQ(
      error_of<SceneError>([&] { divide(numbers(1, 2, 0), numbers(0, 3, 0)); }),
      "A ∧ X = B has no solution: A·B = 6 must vanish, since A ∧ X is orthogonal to A; take the part of B along A "
      "away first");
  EXPECT_THROW(divide(symbols("b"), symbols("a")), SceneError);
}

}  // namespace
}  // namespace torsor::vector_division_test
