// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/polynomial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace torsor::polynomial_test {
namespace {

std::vector<Term> random_terms(std::mt19937& random, int count) {
  std::vector<Term> terms;
  for (int k = 0; k < count; ++k) {
    Monomial monomial;
    for (ValueNumber value_number = 0; value_number < 4; ++value_number) {
      const int exponent = static_cast<int>(random() % 4U) - 1;
      if (exponent != 0) monomial.push_back({value_number, exponent});
    }
    terms.push_back({monomial, Number::rational(static_cast<long>(random() % 7U) - 3, 2)});
  }
  return terms;
}

/// The exact value at value number k = k + 2.
Number value_of(const Term& term) {
  Number value = term.coefficient;
  for (const Factor& factor : term.monomial) value *= Number(factor.value_number + 2).pow(factor.exponent);
  return value;
}
Number value_of(const std::vector<Term>& terms) {
  Number sum;
  for (const Term& term : terms) sum += value_of(term);
  return sum;
}

TEST(Polynomial, IsTheSameWhateverTheOrderOfBuilding) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Term> terms = random_terms(random, 12);
    Polynomial forward;
    for (const Term& term : terms) forward.add(term);
    std::shuffle(terms.begin(), terms.end(), random);
    Polynomial first_half;
    Polynomial second_half;
    for (std::size_t k = 0; k < terms.size(); ++k) (k % 2 == 0 ? first_half : second_half) += Polynomial(terms[k]);
    Polynomial merged = first_half;  // more than two terms on both sides: another way than add
    merged += second_half;
    ASSERT_EQ(merged, forward);
    ASSERT_EQ(merged.hash(), forward.hash());
  }
}

TEST(Polynomial, KeepsItsValueAndHoldsDistinctSortedTermsThatAreNotZero) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Term> terms = random_terms(random, 12);
    Polynomial sum;
    for (const Term& term : terms) sum.add(term);
    ASSERT_EQ(value_of(sum.terms()), value_of(terms));
    for (std::size_t k = 0; k < sum.terms().size(); ++k) {
      ASSERT_FALSE(sum.terms()[k].coefficient.is_zero());
      if (k > 0) {
        ASSERT_LT(sum.terms()[k - 1].monomial, sum.terms()[k].monomial);
      }
    }
  }
}

TEST(Polynomial, VanishesWhenItsTermsCancel) {
  std::mt19937 random(3);
  const std::vector<Term> terms = random_terms(random, 20);
  Polynomial sum;
  for (const Term& term : terms) sum.add(term);
  Polynomial negated = sum;
  negated *= Number(-1);
  ASSERT_FALSE(sum.is_zero());
  sum += negated;
  EXPECT_TRUE(sum.is_zero());
  EXPECT_TRUE(sum.is_constant());
}

TEST(Polynomial, CancelsIrrationalCoefficientsExactly) {
  Polynomial sum(Term{{{3, 1}}, Number::sqrt2() * Number::sqrt3()});
  sum += Polynomial(Term{{{3, 1}}, -(Number(6).square_root().value())});
  EXPECT_TRUE(sum.is_zero());
}

TEST(Polynomial, KnowsAnAtomAConstantAndItsSign) {
  EXPECT_TRUE(Polynomial(ValueNumber{5}).is_single_value_number());
  EXPECT_FALSE(Polynomial(Term{{{5, 2}}, Number(1)}).is_single_value_number());
  EXPECT_FALSE(Polynomial(Term{{{5, 1}}, Number(-1)}).is_single_value_number());
  Polynomial sum(ValueNumber{5});
  sum += Polynomial(Number(7));
  EXPECT_EQ(sum.constant(), Number(7));
  EXPECT_FALSE(sum.is_constant());
  EXPECT_EQ(Polynomial(ValueNumber{5}).constant(), Number());
  EXPECT_EQ(sum.sign(), 1);
  sum *= Number(-1);
  EXPECT_EQ(sum.sign(), -1);
  sum *= Number();
  EXPECT_EQ(sum.sign(), 0);
}

TEST(Monomial, MultipliesByAddingExponentsAndDropsThoseThatCancel) {
  const Monomial a{{1, 2}, {4, -1}, {7, 3}};
  const Monomial b{{0, 1}, {4, 1}, {7, -1}};
  EXPECT_EQ(a * b, (Monomial{{0, 1}, {1, 2}, {7, 2}}));
  EXPECT_EQ(a * b, b * a);
  EXPECT_EQ(a * pow(a, -1), Monomial{});
  EXPECT_EQ(pow(a, 0), Monomial{});
  EXPECT_EQ(pow(a, 3), a * a * a);
}

}  // namespace
}  // namespace torsor::polynomial_test
