// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/routh.hpp"

#include <gtest/gtest.h>

#include <random>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::routh_test {
namespace {

using namespace testing_symbols;

using Numbers = std::vector<Number>;

Numbers product(const Numbers& a, const Numbers& b) {
  Numbers result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

RouthTable table_of(const Numbers& coefficients) {
  Program program;
  std::vector<Value> values;
  for (const Number& coefficient : coefficients) values.push_back(program.number(coefficient));
  return routh_table(program, values);
}

void expect_counts(const Numbers& coefficients, int right, int imaginary, int zero) {
  const RouthTable table = table_of(coefficients);
  ASSERT_TRUE(table.count);
  EXPECT_EQ(table.count->right, right);
  EXPECT_EQ(table.count->imaginary, imaginary);
  EXPECT_EQ(table.count->zero, zero);
  EXPECT_EQ(table.count->left, static_cast<int>(coefficients.size()) - 1 - right - imaginary - zero);
}

// Roots -5 ± 3i, 4, -8 ± 2i (Pommier, §7.3.2). The third column of the first row is a_{n−4}; a_{n−6}, which is printed,
// does not even exist here.
TEST(ExactRouthTable, CountsTheOneUnstableRootOfTheCoursesExample) {
  const Numbers polynomial{1, 22, 158, 176, -2584, -9248};
  expect_counts(polynomial, 1, 0, 0);
  const RouthTable table = table_of(polynomial);
  ASSERT_EQ(table.rows[0].entries.size(), 3U);
  EXPECT_TRUE(table.rows[0].entries[2].is_number(-2584));
  EXPECT_TRUE(table.rows[2].entries[0].is_number(150));  // 158 − 176/22
}

TEST(ExactRouthTable, IsExactWhereADoubleIsNot) {
  // (s² + 2)(s + 1) with 2 changed by 1e-30: no longer a vanishing row, and on one side unstable.
  const Number change = Number(10).pow(-30);
  expect_counts({1, 1, 2, 2}, 0, 2, 0);
  expect_counts({1, 1, 2, Number(2) + change}, 2, 0, 0);
  expect_counts({1, 1, 2, Number(2) - change}, 0, 0, 0);
  // (s² + √2)(s + √3): a vanishing row in Q(√2, √3).
  expect_counts({1, Number::sqrt3(), Number::sqrt2(), Number::sqrt2() * Number::sqrt3()}, 0, 2, 0);
}

TEST(ExactRouthTable, TakesZeroPivotsAndZeroRows) {
  expect_counts({1, 1, 2, 2, 3}, 2, 0, 0);                    // Ogata
  expect_counts({1, 2, 24, 48, -25, -50}, 1, 2, 0);           // (s² − 1)(s² + 25)(s + 2), Ogata
  expect_counts(product({1, 0, -3, 2}, {1, 0, 4}), 2, 2, 0);  // (s − 1)²(s + 2)(s² + 4)
  expect_counts({1, 0, 2, 0, 1}, 0, 4, 0);                    // (s² + 1)²
  expect_counts({1, 0, 0, 0, 1}, 2, 0, 0);
  expect_counts({-1, 0, 0}, 0, 0, 2);
  EXPECT_EQ(table_of({1, 1, 2, 2, 3}).rows[2].kind, RouthRowKind::zero_pivot);
  EXPECT_EQ(table_of({1, 2, 24, 48, -25, -50}).rows[2].kind, RouthRowKind::zero_row);
}

// Products of factors with known roots, among them repeated and imaginary ones and pairs s and −s.
TEST(ExactRouthTable, CountsTheRootsThatAPolynomialWasBuiltFrom) {
  std::mt19937_64 engine(7);
  const auto draw = [&engine](int from, int to) {
    return from + static_cast<int>(engine() % static_cast<unsigned>(to - from + 1));
  };
  for (int trial = 0; trial < 1000; ++trial) {
    Numbers polynomial{draw(1, 2)};
    int right = 0, imaginary = 0, zero = 0;
    const int degree = draw(1, 10);
    while (static_cast<int>(polynomial.size()) <= degree) {
      const int kind = draw(0, 4), a = draw(-2, 2), b = draw(1, 3);
      if (kind == 0) {
        polynomial = product(polynomial, {1, -a});
        (a == 0 ? zero : right) += a >= 0;
      } else if (kind == 1) {
        polynomial = product(polynomial, {1, 0, -b});
        ++right;
      } else {
        const int c = kind == 2 ? 0 : a;
        polynomial = product(polynomial, {1, -c, c * c + b});
        (c == 0 ? imaginary : right) += c >= 0 ? 2 : 0;
      }
    }
    const RouthTable table = table_of(polynomial);
    ASSERT_TRUE(table.count && table.count->right == right && table.count->imaginary == imaginary &&
                table.count->zero == zero)
        << "trial " << trial;
  }
}

TEST(SymbolicRouth, OfACubicIsHurwitzsCondition) {
  Program program;
  const Value a = program.symbol(make_symbol("a", "1/s")), b = program.symbol(make_symbol("b", "1/s^2")),
              c = program.symbol(make_symbol("c", "1/s^3")), one = program.number(Number(1));
  const std::vector<Value> cubic{one, a, b, c};
  EXPECT_EQ(readable_conditions(hurwitz_conditions(program, cubic)), "a > 0\na b - c > 0\na b c - c^2 > 0\n");
  const RouthTable table = routh_table(program, cubic);
  EXPECT_FALSE(table.count);
  Evaluator<Real> evaluate(program, at({{"a", Real(3)}, {"b", Real(5)}, {"c", Real(7)}}));
  // First column 1, a, b − c/a, c.
  EXPECT_LT(relative_difference(evaluate(table.rows[2].entries[0]), rational(8, 3)), 1e-45);
  EXPECT_EQ(evaluate(table.rows[3].entries[0]).to_double(), 7.0);
}

TEST(SymbolicRouth, SeesPivotsThatVanishIdentically) {
  Program program;
  const Value a = program.symbol(make_symbol("a", "1/s"));
  const Value zero = program.number(Number(), Unit::parse("1/s"));
  // (s − a)²(s + 2a) = s³ − 3a² s + 2a³
  const RouthTable table =
      routh_table(program, {program.number(Number(1)), zero, Number(-3) * a * a, Number(2) * a * a * a});
  EXPECT_EQ(table.rows[1].kind, RouthRowKind::zero_pivot);
  int changes = 0;
  Evaluator<Real> evaluate(program, at({{"a", rational(5, 3)}}));
  for (std::size_t k = 1; k < table.rows.size(); ++k) {
    changes += (evaluate(table.rows[k].entries[0]) > Real(0)) != (evaluate(table.rows[k - 1].entries[0]) > Real(0));
  }
  EXPECT_EQ(changes, 2);
}

// Ziegler's column with a follower load P: masses 2m and m, rods l, springs k and dampers c in both hinges. With
// dampers it is stable exactly for P l < 41/28 k + c²/(2 m l²).
TEST(SymbolicRouth, GivesTheFlutterLoadOfADampedColumn) {
  Scene scene("ziegler");
  const Expression m = scene.parameter("m", "kg"), l = scene.parameter("l", "m"), k = scene.parameter("k", "N m"),
                   c = scene.parameter("c", "N m s"), P = scene.parameter("P", "N");
  const Expression alpha = scene.coordinate("alpha", "rad"), beta = scene.coordinate("beta", "rad");
  const FrameHandle lower = scene.revolute("lower", scene.ground(), axis::z, alpha);
  const PointHandle knee = scene.point("knee", lower, {l, 0, 0});
  (void)knee;
  const FrameHandle upper = scene.revolute("upper", lower, axis::z, beta - alpha, {.origin = {l, 0, 0}});
  scene.body("first", lower, Inertia::point(2 * m).at({l, 0, 0}));
  scene.body("second", upper, Inertia::point(m).at({l, 0, 0}));
  scene.spring("foot", alpha, k);
  scene.spring("knee_spring", beta - alpha, k);
  scene.damper("foot_damper", alpha, c);
  scene.damper("knee_damper", beta - alpha, c);
  scene.force("load",
              {.body = upper, .point = scene.point("tip", upper, {l, 0, 0}), .components = {-P, 0, 0}, .axes = upper});
  ModelOptions symbolic;
  symbolic.symbolic_parameters = true;
  const Equations equations(scene, symbolic);
  const Linearisation linear = linearisation(equations);
  const AtState straight(equations, {{alpha, 0}, {beta, 0}});
  Program& program = equations.program();
  const std::vector<Value> polynomial =
      characteristic_polynomial(program, straight(linear.M), straight(linear.C), straight(linear.K));
  ASSERT_EQ(polynomial.size(), 5U);
  const std::vector<Value> conditions = hurwitz_conditions(program, polynomial);
  ASSERT_EQ(conditions.size(), 5U);
  const auto stable = [&](const Real& load) {
    Evaluator<Real> evaluate(
        program,
        at({{"m", rational(3, 2)}, {"l", rational(1, 2)}, {"k", Real(7)}, {"c", rational(1, 3)}, {"P", load}}));
    bool all = true;
    for (const Value& condition : conditions) all = all && evaluate(condition) > Real(0);
    return all;
  };
  // (41/28 7 + (1/9)/(2 3/2 1/4)) / (1/2)
  const Real critical = (rational(41, 4) + rational(4, 27)) * Real(2);
  EXPECT_TRUE(stable(critical - power_of_ten(-40)));
  EXPECT_FALSE(stable(critical + power_of_ten(-40)));
  // 2 s⁴ + 7 c s³ + (7 k + c² − 2 P) s² + 2 c k s + k² for m = l = 1.
  Evaluator<Real> evaluate(program,
                           at({{"m", Real(1)}, {"l", Real(1)}, {"k", Real(3)}, {"c", Real(5)}, {"P", Real(4)}}));
  const double expected[] = {2, 35, 7 * 3 + 25 - 8, 30, 9};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(evaluate(polynomial[i]).to_double(), expected[i]) << i;
}

TEST(ExactRouthTable, SaysWhatItCannotRead) {
  Program program;
  EXPECT_THROW(routh_table(program, {}), UsageError);
  EXPECT_THROW(routh_table(program, {Value(), program.number(Number(1))}), UsageError);
  EXPECT_THROW(hurwitz_conditions(program, {}), UsageError);
  EXPECT_THROW(characteristic_polynomial(program, {}, {}, {}), UsageError);
}

}  // namespace
}  // namespace torsor::routh_test
