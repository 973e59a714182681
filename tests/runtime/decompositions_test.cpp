// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/numerics/decompositions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

namespace decompositions_test {
namespace {

using namespace torsor::runtime;
using Eigen::MatrixXd;

// Of matrices of two to four rows with entries of the size of 1: some twenty roundings.
constexpr double rounding = 20 * 1.1e-16;

TEST(Eigenpairs, OfADampedOscillatorAreItsRootsByTheQuadraticFormula) {
  MatrixXd A(2, 2);
  A << 0, 1, -4, -0.4;  // s^2 + 0.4 s + 4
  const Eigenpairs pairs = eigenpairs(A);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(pairs.values(k).real(), -0.2, 4 * rounding);
    EXPECT_NEAR(std::abs(pairs.values(k).imag()), std::sqrt(3.96), 4 * rounding);
    EXPECT_NEAR(pairs.vectors.col(k).norm(), 1.0, rounding);
    EXPECT_NEAR(std::abs(pairs.vectors(1, k) - pairs.values(k) * pairs.vectors(0, k)), 0.0, 4 * rounding);
  }
  EXPECT_THROW((void)eigenpairs(MatrixXd::Zero(2, 3)), std::invalid_argument);
}

TEST(SymmetricEigenpairs, OfAChainOfThreeAreTheTextbookOnes) {
  MatrixXd S(3, 3);
  S << 2, -1, 0, -1, 2, -1, 0, -1, 2;
  const SymmetricEigenpairs pairs = symmetric_eigenpairs(S);
  for (int k = -1; k <= 1; ++k) EXPECT_NEAR(pairs.values(k + 1), 2.0 + k * std::sqrt(2.0), 4 * rounding);
  EXPECT_NEAR(std::abs(pairs.vectors(1, 0)), std::sqrt(0.5), 4 * rounding);
  EXPECT_THROW((void)symmetric_eigenpairs(MatrixXd::Zero(2, 3)), std::invalid_argument);
}

// Of matrices so small that all of it is below one rounding of 1.
TEST(SingularValues, CountTheRankOverTheLargest) {
  MatrixXd A(2, 2);
  A << 1, 1, 1, 1 + 1e-6;
  for (const double size : {1e-30, 1.0, 1e30}) {
    EXPECT_EQ(singular_values(size * A).rank(1e-10), 2);
    EXPECT_EQ(singular_values(size * A).rank(1e-5), 1);
  }
}

// (3, 4, 0) and twice that: one direction is seen, with sqrt(5) times 5, two are not.
TEST(SingularValues, TellTheRankAndTheMotionsThatAreLeft) {
  MatrixXd A(2, 3);
  A << 3, 4, 0, 6, 8, 0;
  const SingularValues found = singular_values(A);
  EXPECT_NEAR(found.values(0), std::sqrt(125.0), 12 * rounding);
  EXPECT_EQ(found.rank(1e-10), 1);
  EXPECT_NEAR((A * found.right.rightCols(2)).norm(), 0.0, 12 * rounding);
  EXPECT_NEAR((found.right.transpose() * found.right - MatrixXd::Identity(3, 3)).norm(), 0.0, rounding);
  EXPECT_EQ(singular_values(MatrixXd::Zero(2, 2)).rank(1e-10), 0);
}

}  // namespace
}  // namespace decompositions_test
