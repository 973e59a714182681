// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/orthonormal_rows.hpp"

#include <gtest/gtest.h>

#include "tests/program/test_symbols.hpp"

namespace torsor::orthonormal_rows_test {
namespace {

using namespace testing_symbols;

// Rows that depend on those before come with the combination that they are.
TEST(OrthonormalRows, NamesTheCombinationOfADependentRow) {
  const WorkingDigits precision(50);
  OrthonormalRows basis(3, power_of_ten(-30), power_of_ten(-20));
  EXPECT_TRUE(basis.add(0, {Real(1), Real(2), Real(0)}));
  EXPECT_TRUE(basis.add(1, {Real(0), Real(1), Real(-1)}));
  EXPECT_FALSE(basis.add(2, {Real(3), Real(4), Real(2)}));  // three times the first less twice the second
  EXPECT_FALSE(basis.add(3, {Real(0), Real(0), Real(0)}));
  EXPECT_EQ(basis.independent(), (std::vector<std::size_t>{0, 1}));
  const auto combinations = basis.combinations();
  ASSERT_EQ(combinations.size(), 2U);
  EXPECT_EQ(combinations[0].first, 2U);
  EXPECT_LT(relative_difference(combinations[0].second[0], Real(3)), 1e-45);
  EXPECT_LT(relative_difference(combinations[0].second[1], Real(-2)), 1e-45);
  for (const Real& part : combinations[1].second) EXPECT_TRUE(part.is_zero());
}

// The shortest of the solutions is a combination of the rows.
TEST(OrthonormalRows, GiveTheShortestSolution) {
  const WorkingDigits precision(50);
  OrthonormalRows basis(3, Real(0), Real(0));
  basis.add(0, {Real(1), Real(1), Real(0)});
  basis.add(1, {Real(1), Real(1), Real(2)});
  const RealRow x = basis.least({Real(2), Real(8)});
  const RealRow expected{Real(1), Real(1), Real(3)};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(relative_difference(x[i], expected[i]), 1e-47) << i;
}

}  // namespace
}  // namespace torsor::orthonormal_rows_test
