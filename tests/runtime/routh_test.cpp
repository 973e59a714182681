// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/routh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "torsor/runtime/small_motions/characteristic_polynomial.hpp"
#include "tests/runtime/linear_systems.hpp"

namespace routh_test {
namespace {

using namespace torsor::runtime;
using Coefficients = std::vector<double>;

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

void expect_counts(const Coefficients& a, int right, int imaginary, int zero) {
  const RouthTable table = routh_table(a);
  EXPECT_EQ(table.right, right);
  EXPECT_EQ(table.imaginary, imaginary);
  EXPECT_EQ(table.zero, zero);
  EXPECT_EQ(table.left, static_cast<int>(a.size()) - 1 - right - imaginary - zero);
}

// The course's example (Pommier, §7.3.2): roots -5 ± 3i, 4, -8 ± 2i.
TEST(RouthTable, CountsTheOneUnstableRootOfTheCoursesExample) {
  const Coefficients polynomial = product(product({1, 10, 34}, {1, 16, 68}), {1, -4});
  EXPECT_EQ(polynomial, (Coefficients{1, 22, 158, 176, -2584, -9248}));
  const RouthTable table = routh_table(polynomial);
  EXPECT_EQ(table.right, 1);
  EXPECT_EQ(table.left, 4);
  EXPECT_EQ(table.imaginary, 0);
  EXPECT_FALSE(table.stable());
}

// The course prints a_{n−6} in the third column; it is a_{n−4}. Second row a_{n−1}, a_{n−3}, a_{n−5}; b = a_{n−2} − a_n
// a_{n−3} / a_{n−1} and so on.
TEST(RouthTable, HasTheEntriesOfItsDefinition) {
  const RouthTable table = routh_table(Coefficients{2, 4, 6, 8, 11, 12, 14});
  ASSERT_EQ(table.rows.size(), 7U);
  EXPECT_EQ(table.rows[0].entries, (Coefficients{2, 6, 11, 14}));
  EXPECT_EQ(table.rows[1].entries, (Coefficients{4, 8, 12}));
  EXPECT_EQ(table.rows[2].entries, (Coefficients{6 - 2 * 8 / 4.0, 11 - 2 * 12 / 4.0, 14}));
  EXPECT_EQ(table.rows[3].entries, (Coefficients{8 - 4 * 5 / 2.0, 12 - 4 * 14 / 2.0}));
  for (int k = 0; k < 7; ++k) EXPECT_EQ(table.rows[static_cast<std::size_t>(k)].power, 6 - k);
}

// s³ + a s² + b s + c is stable exactly when a, c > 0 and a b > c (Hurwitz).
TEST(RouthTable, IsHurwitzsConditionForACubic) {
  for (const double a : {-1.0, 0.5, 2.0}) {
    for (const double b : {-3.0, 1.0, 4.0}) {
      for (const double c : {-1.0, 0.4, 9.0}) {
        EXPECT_EQ(routh_table(Coefficients{1, a, b, c}).stable(), a > 0 && c > 0 && a * b > c);
      }
    }
  }
}

TEST(RouthTable, TakesZeroPivots) {
  // Ogata, Modern Control Engineering: s⁴ + s³ + 2s² + 2s + 3 and s⁵ + 2s⁴ + 3s³ + 6s² + 5s + 3 have two each.
  expect_counts({1, 1, 2, 2, 3}, 2, 0, 0);
  expect_counts({1, 2, 3, 6, 5, 3}, 2, 0, 0);
  EXPECT_EQ(routh_table(Coefficients{1, 1, 2, 2, 3}).rows[2].kind, RouthRow::zero_pivot);
  // s³ − 3s + 2 = (s − 1)²(s + 2); with s² + 4 beside it, where a small number in place of the pivot misleads.
  expect_counts({1, 0, -3, 2}, 2, 0, 0);
  expect_counts(product({1, 0, -3, 2}, {1, 0, 4}), 2, 2, 0);
  // Two zeros before the first number of a row: s⁶ + s⁵ + s⁴ + s³ + s² + s + 2, no root on the axis.
  const RouthTable table = routh_table(Coefficients{1, 1, 1, 1, 1, 1, 2});
  EXPECT_EQ(table.rows[2].kind, RouthRow::zero_pivot);
  EXPECT_EQ(table.imaginary, 0);
}

TEST(RouthTable, TakesZeroRows) {
  // s⁵ + 2s⁴ + 24s³ + 48s² − 25s − 50 = (s² − 1)(s² + 25)(s + 2), Ogata.
  const Coefficients ogata{1, 2, 24, 48, -25, -50};
  expect_counts(ogata, 1, 2, 0);
  const RouthTable table = routh_table(ogata);
  EXPECT_EQ(table.rows[2].kind, RouthRow::zero_row);
  EXPECT_EQ(table.rows[2].entries, (Coefficients{8, 96}));  // of 2s⁴ + 48s² − 50
  expect_counts({1, 0, 1}, 0, 2, 0);
  expect_counts({1, 0, 2, 0, 1}, 0, 4, 0);  // (s² + 1)²
  expect_counts({1, 0, 0, 0, 1}, 2, 0, 0);  // s⁴ + 1
  expect_counts({1, 0, -1}, 1, 0, 0);
  expect_counts({1, 0, 0, 0}, 0, 0, 3);
  expect_counts({1, 3, 2, 0, 0}, 0, 0, 2);
}

TEST(RouthTable, TurnsTheSignsOfANegativePolynomialRound) {
  expect_counts({-1, -3, -2}, 0, 0, 0);
  expect_counts({-1, 3, -2}, 2, 0, 0);
  expect_counts({5}, 0, 0, 0);
}

// Products of factors with whole coefficients and known roots; every coefficient is exact. Repeated factors, imaginary
// pairs, pairs s and −s and zeros are frequent, so that every kind of row occurs.
TEST(RouthTable, CountsTheRootsThatAPolynomialWasBuiltFrom) {
  std::mt19937_64 engine(20240501);
  const auto draw = [&engine](int from, int to) {
    return from + static_cast<int>(engine() % static_cast<unsigned>(to - from + 1));
  };
  int regular = 0, pivots = 0, rows = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Coefficients polynomial{static_cast<double>(draw(1, 2))};
    int right = 0, imaginary = 0, zero = 0;
    while (polynomial.size() < 8) {
      const int kind = draw(0, 5), a = draw(-2, 2), b = draw(1, 3);
      if (kind == 0) {
        polynomial = product(polynomial, {1.0, static_cast<double>(-a)});  // s = a
        (a == 0 ? zero : right) += a >= 0;
      } else if (kind == 1) {
        polynomial = product(polynomial, {1.0, 0.0, static_cast<double>(b)});
        imaginary += 2;
      } else if (kind == 2) {
        polynomial = product(polynomial, {1.0, 0.0, static_cast<double>(-b)});  // ± sqrt(b)
        ++right;
      } else {
        polynomial = product(polynomial, {1.0, static_cast<double>(-a), static_cast<double>(a * a + b)});
        (a == 0 ? imaginary : right) += a >= 0 ? 2 : 0;  // Re = a/2
      }
    }
    const RouthTable table = routh_table(polynomial);
    bool pivot = false, row = false;
    for (const auto& each : table.rows) {
      pivot = pivot || each.kind == RouthRow::zero_pivot;
      row = row || each.kind == RouthRow::zero_row;
    }
    regular += !pivot && !row;
    pivots += pivot;
    rows += row;
    ASSERT_TRUE(table.right == right && table.imaginary == imaginary && table.zero == zero)
        << "trial " << trial << ": " << right << ' ' << imaginary << ' ' << zero << "\n"
        << table;
  }
  EXPECT_GT(regular, 100);
  EXPECT_GT(pivots, 100);
  EXPECT_GT(rows, 100);
}

TEST(RouthTable, SaysWhatItCannotRead) {
  EXPECT_THROW((void)routh_table(Coefficients{}), std::invalid_argument);
  EXPECT_THROW((void)routh_table(Coefficients{0, 1}), std::invalid_argument);
  EXPECT_THROW((void)routh_table(Coefficients{1, std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW((void)routh_table(Coefficients{1, 2}, Coefficients{0}), std::invalid_argument);
}

TEST(RouthTable, IsWrittenAsAPersonWritesIt) {
  std::ostringstream text;
  text << routh_table(Coefficients{1, 1, 2, 2, 3});
  EXPECT_NE(text.str().find("s^4"), std::string::npos);
  EXPECT_NE(text.str().find("zero pivot"), std::string::npos);
}

TEST(CharacteristicPolynomial, OfTwoMassesIsTheirDeterminant) {
  // (2 s² + s + 5)(3 s² + 4 s + 7) − 1·1, divided by 6, with a stiffness coupling of −1.
  LinearSystem system = undamped(Eigen::Vector2d(2, 3).asDiagonal(), Eigen::Matrix2d::Zero());
  system.C << 1, 0, 0, 4;
  system.K << 5, -1, -1, 7;
  const CharacteristicPolynomial polynomial = characteristic_polynomial(system);
  const Coefficients expected{1, 11 / 6.0, (14 + 4 + 15) / 6.0, (7 + 20) / 6.0, 34 / 6.0};
  ASSERT_EQ(polynomial.coefficients.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(polynomial.coefficients[i], expected[i], 1e-13);
    EXPECT_LE(std::abs(polynomial.coefficients[i] - expected[i]), polynomial.uncertainties[i] + 1e-16);
  }
}

}  // namespace
}  // namespace routh_test
