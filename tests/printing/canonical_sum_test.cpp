// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/canonical_sum.hpp"

#include <gtest/gtest.h>

#include <ginac/ginac.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/printing/factoring.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/trigonometry.hpp"
#include "torsor/generator/printing/written.hpp"

namespace torsor::printing::canonical_sum_test {
namespace {

SymbolPointer make(const std::string& name, SymbolKind kind, int index) {
  return std::make_shared<const Symbol>(Symbol{name, Unit(), kind, index, nullptr});
}

class CanonicalSum : public testing::Test {
 protected:
  const SymbolPointer a_ = make("a", SymbolKind::parameter, 1), b_ = make("b", SymbolKind::parameter, 2),
                      m_ = make("m", SymbolKind::parameter, 3), x_ = make("x", SymbolKind::coordinate, 4),
                      y_ = make("y", SymbolKind::coordinate, 5), z_ = make("z", SymbolKind::coordinate, 6);
  const Sum a = Sum::symbol(a_), b = Sum::symbol(b_), m = Sum::symbol(m_), x = Sum::symbol(x_), y = Sum::symbol(y_),
            z = Sum::symbol(z_);

  static Sum minus(Sum left, const Sum& right) { return left += Number(-1) * right; }
  static Sum plus(Sum left, const Sum& right) { return left += right; }
  static Sum sine(const Sum& angle) { return Sum::function(Function::sin, angle); }
  static Sum cosine(const Sum& angle) { return Sum::function(Function::cos, angle); }
  static std::string written(const Sum& sum) { return text(collected(sum)); }
};

TEST_F(CanonicalSum, OrdersTermsByCreationWhateverTheOrderOfAdding) {
  EXPECT_EQ(written(plus(plus(b, a), m)), "a + b + m");
  EXPECT_EQ(written(plus(m, plus(a, b))), "a + b + m");
}

TEST_F(CanonicalSum, GivesBothSpellingsOfAnInverseDifferenceOneForm) {
  const Sum one = power(minus(x, y), -2);
  const Sum other = Number(-1) * power(minus(y, x), -2);
  EXPECT_EQ(compare(one, other), std::strong_ordering::equal);
  EXPECT_EQ(written(one), "1/(x - y)");
  EXPECT_EQ(written(power(minus(Number(2) * y, Number(2) * x), -2)), "-1/2/(x - y)");
}

TEST_F(CanonicalSum, KeepsTheRootOfASumAndMultipliesItsSquareOut) {
  const Sum root = power(plus(x * x, y * y), 1);
  EXPECT_EQ(written(a * root), "a sqrt(x^2 + y^2)");
  EXPECT_EQ(compare(root * root, plus(x * x, y * y)), std::strong_ordering::equal);
  EXPECT_EQ(written(x * power(plus(x * x, y * y), -1)), "x/sqrt(x^2 + y^2)");
}

TEST_F(CanonicalSum, WritesTheNumberOfASquareBeforeItWhereItsRootIsNone) {
  const Sum each = plus(Number::rational(9, 1000) * m, Sum(Number::rational(3, 1000)));
  EXPECT_EQ(text({as_term(Number(2) * each * each * x)}), "2 (0.009 m + 0.003)^2 x");
  EXPECT_EQ(text({as_term(Number(6) * each * each * x)}), "6 (0.009 m + 0.003)^2 x");
  EXPECT_EQ(text({as_term(each * each * x)}), "(0.009 m + 0.003)^2 x");
}

TEST_F(CanonicalSum, TakesSignsOutOfSinesAndCosines) {
  EXPECT_EQ(written(sine(minus(y, x))), "-sin(x - y)");
  EXPECT_EQ(written(cosine(minus(y, x))), "cos(x - y)");
  EXPECT_TRUE(sine(Sum()).is_zero());
}

TEST_F(CanonicalSum, RefusesToDivideByZero) { EXPECT_THROW(power(Sum(), -2), Error); }

TEST_F(CanonicalSum, MergesSquaresOfSineAndCosine) {
  const Sum squares = plus(a * sine(x) * sine(x), a * cosine(x) * cosine(x));
  EXPECT_EQ(written(simplified(squares)), "a");
  EXPECT_EQ(written(simplified(minus(a, a * sine(x) * sine(x)))), "a cos(x)^2");
  EXPECT_EQ(written(simplified(minus(a * cosine(x) * cosine(x), a * sine(x) * sine(x)))), "a cos(2 x)");
  // Different coefficients are left alone.
  EXPECT_EQ(simplified(plus(a * sine(x) * sine(x), b * cosine(x) * cosine(x))).size(), 2U);
}

TEST_F(CanonicalSum, AppliesEachAdditionTheorem) {
  const Sum cc = cosine(x) * cosine(y), ss = sine(x) * sine(y), sc = sine(x) * cosine(y), cs = cosine(x) * sine(y);
  EXPECT_EQ(written(simplified(plus(cc, ss))), "cos(x - y)");
  EXPECT_EQ(written(simplified(minus(cc, ss))), "cos(x + y)");
  EXPECT_EQ(written(simplified(minus(ss, cc))), "-cos(x + y)");
  EXPECT_EQ(written(simplified(plus(sc, cs))), "sin(x + y)");
  EXPECT_EQ(written(simplified(minus(sc, cs))), "sin(x - y)");
  EXPECT_EQ(written(simplified(minus(cs, sc))), "-sin(x - y)");
}

TEST_F(CanonicalSum, SimplifiesARotationsOrthogonalityAwayCompletely) {
  // Squared length of the first column of R_z(x) R_x(y) R_z(z), multiplied out: 1.
  const Sum first = minus(cosine(x) * cosine(z), sine(x) * cosine(y) * sine(z));
  const Sum second = plus(sine(x) * cosine(z), cosine(x) * cosine(y) * sine(z));
  const Sum third = sine(y) * sine(z);
  EXPECT_EQ(written(simplified(plus(plus(first * first, second * second), third * third))), "1");
}

TEST_F(CanonicalSum, FactorsWhatAPersonWouldFactor) {
  EXPECT_EQ(written(minus(a * b, a * x)), "-a (x - b)");
  EXPECT_EQ(written(a * minus(x, b) * minus(x, b)), "a (x - b)^2");
  EXPECT_EQ(written(plus(a * a * m, b * a * a)), "a^2 (b + m)");
  EXPECT_EQ(written(minus(Sum(), plus(a * sine(x), b * sine(x)))), "-(a + b) sin(x)");
}

TEST_F(CanonicalSum, LeavesNoFractionsInParenthesesThatWereNotThere) {
  EXPECT_EQ(written(minus(plus(Number(4) * (m * x), m * y), m * a)), "m (4 x + y - a)");
  EXPECT_EQ(written(Number(2) * minus(m * x, m * a)), "2 m (x - a)");
  const Sum half = minus(x, Number::rational(1, 2) * a);
  EXPECT_EQ(written(Number(3) * (m * half)), "3 m (x - 1/2 a)");
  EXPECT_EQ(written(m * half * half), "m (x - 1/2 a)^2");
}

TEST_F(CanonicalSum, TakesWhatAllTermsOfAnEntryShareOutOfIt) {
  const auto entry = [](const Sum& sum) { return text(collected_entry(sum)); };
  const Sum v = Sum::symbol(make("v", SymbolKind::velocity, 7)), w = Sum::symbol(make("w", SymbolKind::velocity, 8));
  EXPECT_EQ(entry(plus(Number(-2) * (m * a * sine(x) * v), Number(-2) * (m * a * sine(x) * w))), "-2 a m sin(x) (v + w)");
  // Sums of parameters are shared too, and a velocity stands last.
  EXPECT_EQ(entry(plus(m, a) * (plus(Number(2) * v, w) * w)), "(a + m) (2 v + w) w");
  EXPECT_EQ(entry(minus(a, m * v * v)), "a - m v^2");
  EXPECT_EQ(entry(plus(a * b, m * x * x)), "a b + m x^2");
}

TEST_F(CanonicalSum, HasTheSameValueAsAnEntry) {
  const Sum v = Sum::symbol(make("v", SymbolKind::velocity, 7)), w = Sum::symbol(make("w", SymbolKind::velocity, 8));
  const auto value = [](const Written& of) {
    return evaluate(of, [](const SymbolPointer& symbol) {
      return Real(Number::rational(symbol->index * symbol->index + 3, 7), 30);
    }, 30);
  };
  for (const Sum& sum : {minus(minus(a * m * sine(x), b * m * cosine(y)), m * v * w), minus(a * m * w, a * m * v),
                         Number::rational(-2, 3) * (plus(a, m) * plus(v, Number(3) * w) * sine(x) * w)}) {
    EXPECT_LT(std::abs(value(collected_entry(sum)).to_double() - value(collected(sum)).to_double()), 1e-12) << text(collected_entry(sum));
  }
}

TEST_F(CanonicalSum, WritesOneProductOfSineAndCosineInOneWay) {
  const Sum both = minus(Number(2) * (a * sine(x) * cosine(x)), b * sine(Number(2) * x));
  EXPECT_EQ(written(simplified(both)), "2 (a - b) cos(x) sin(x)");
  EXPECT_EQ(written(simplified(b * sine(Number(2) * x))), "b sin(2 x)");
}

TEST_F(CanonicalSum, WritesOneDivisorBareAndSeveralInParentheses) {
  EXPECT_EQ(written(x * power(a, -2)), "x/a");
  EXPECT_EQ(written(x * power(a, -2) * power(b, -2)), "x/(a b)");
  EXPECT_EQ(written(power(a, -2) * power(b, -4)), "1/(a b^2)");
}

TEST_F(CanonicalSum, ReadsTheSameWhateverGiNaCsOrder) {
  // Fresh GiNaC symbols have fresh hashes: orders and signs inside GiNaC change from one view to the next.
  const Program program;
  std::string first;
  for (int i = 0; i < 50; ++i) {
    InlineView view(program, {});
    const GiNaC::ex gx = view.symbol(x_), gy = view.symbol(y_), ga = view.symbol(a_), gb = view.symbol(b_);
    const GiNaC::ex formula = ga / (gx - gy) + gb * GiNaC::pow(2 * gy - 2 * gx, -3) +
                              GiNaC::pow(ga * gx - gb * gy, 3) * GiNaC::sin(gy - gx) + GiNaC::sqrt(gx * gx + ga * gb);
    const std::string now = written(view.sum(formula));
    if (first.empty()) first = now;
    ASSERT_EQ(now, first);
  }
}

}  // namespace
}  // namespace torsor::printing::canonical_sum_test
