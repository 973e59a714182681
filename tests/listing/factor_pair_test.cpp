// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of factors: where a sum has one, what is left when a value number stands for it, and whether a formula still forms
// the sums that it formed before.
#include "torsor/generator/listing/factor_pair.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace torsor::factor_pair_test {
namespace {

using Pairs = std::vector<FactorPair>;

Polynomial sum(const std::vector<Term>& terms) {
  Polynomial all;
  for (const Term& term : terms) all.add(term);
  return all;
}

TEST(FactorPair, IsTheOneOfWhichItsProductIsOne) {
  EXPECT_EQ((FactorPair{2, 5}.product()), sum({{{{2, 1}, {5, 1}}, 1}}));
  EXPECT_EQ((FactorPair{2, 2}.product()), sum({{{{2, 2}}, 1}}));
  EXPECT_EQ((FactorPair{2, Number(3)}.product()), sum({{{{2, 1}}, 3}}));
  for (const FactorPair& pair : Pairs{{2, 5}, {2, 2}, {2, Number(3)}, {2, Number(1) / 2}}) {
    EXPECT_EQ(as_pair(pair.product()), pair);
  }
}

TEST(FactorPair, IsNotOfOtherSums) {
  for (const Polynomial& other : std::vector<Polynomial>{
           {}, sum({{{}, 3}}), sum({{{{2, 1}}, 1}}), sum({{{{2, 1}}, -3}}), sum({{{{2, 3}}, 1}}), sum({{{{2, 2}}, 3}}),
           sum({{{{2, 1}, {5, 1}}, 3}}), sum({{{{2, 1}, {5, 1}}, -1}}), sum({{{{2, 1}, {5, -1}}, 1}}),
           sum({{{{2, 2}, {5, 1}}, 1}}),
           sum({{{{2, 1}, {5, 1}, {7, 1}}, 1}}), sum({{{{2, 1}}, 3}, {{{5, 1}}, 3}})}) {
    EXPECT_EQ(as_pair(other), std::nullopt);
  }
}

TEST(FactorPair, IsReplacedAsOftenAsATermMultipliesBoth) {
  const Polynomial others = sum({{{{1, 1}, {3, 1}}, 1}, {{{1, 1}, {2, -1}}, 1}, {{}, 5}});
  Polynomial before = sum({{{{1, 3}, {2, 2}, {4, 1}}, 1}, {{{1, 1}, {2, 1}}, -2}});
  Polynomial after = sum({{{{1, 1}, {4, 1}, {9, 2}}, 1}, {{{9, 1}}, -2}});
  EXPECT_EQ((FactorPair{1, 2}.replaced(before += others, 9)), after += others);
}

TEST(FactorPair, OfASquareIsReplacedAsOftenAsItIsThere) {
  EXPECT_EQ((FactorPair{1, 1}.replaced(sum({{{{1, 5}}, 1}, {{{1, 1}}, 1}, {{{1, -2}}, 1}}), 9)),
            sum({{{{1, 1}, {9, 2}}, 1}, {{{1, 1}}, 1}, {{{1, -2}}, 1}}));
}

TEST(FactorPair, OfANumberIsReplacedOnceWhateverTheSign) {
  EXPECT_EQ((FactorPair{1, Number(3)}.replaced(sum({{{{1, 2}, {2, 1}}, -3}, {{{1, 1}}, 3}, {{{2, 1}}, 3}, {{{1, 3}}, 6}}), 9)),
            sum({{{{1, 1}, {2, 1}, {9, 1}}, -1}, {{{9, 1}}, 1}, {{{2, 1}}, 3}, {{{1, 3}}, 6}}));
}

TEST(FactorPair, IsFoundOnceForEachTimeThatAFormulaMultipliesIt) {
  const auto pairs_of = [](const Polynomial& polynomial) {
    Pairs pairs;
    add_pairs(factored(polynomial), pairs);
    return pairs;
  };
  EXPECT_EQ(pairs_of(sum({{{{1, 4}, {2, 1}}, 3}})), (Pairs{{1, Number(3)}, {1, 1}, {1, 1}, {1, 2}, {2, Number(3)}}));
  // x1 x2 (x3 x4 + x5)
  EXPECT_EQ(pairs_of(sum({{{{1, 1}, {2, 1}, {3, 1}, {4, 1}}, 1}, {{{1, 1}, {2, 1}, {5, 1}}, 1}})), (Pairs{{3, 4}, {1, 2}}));
  EXPECT_EQ(pairs_of(sum({{{{1, 1}}, 1}, {{{2, 1}}, 1}})), Pairs{});
}

TEST(FactorPair, KeepsAFactoringWhereTheSameSumsAreFormed) {
  const Polynomial before = sum({{{{1, 1}, {2, 1}, {3, 1}}, 1}, {{{1, 1}, {4, 1}}, 1}});  // x1 (x2 x3 + x4)
  const auto keeps = [&before](const FactorPair& pair) {
    return same_factoring(factored(before), factored(pair.replaced(before, 9)), pair, 9);
  };
  EXPECT_TRUE(keeps({2, 3}));   // x1 (x4 + x9)
  EXPECT_FALSE(keeps({1, 2}));  // x9 x3 + x1 x4
  // Without a sum inside there is none that could be another.
  const Polynomial flat = sum({{{{1, 1}, {2, 1}, {3, 1}}, 1}, {{{4, 1}}, -1}});
  EXPECT_TRUE(same_factoring(factored(flat), factored(FactorPair{1, 2}.replaced(flat, 9)), {1, 2}, 9));
  // The other sign of a term is another sum.
  const Polynomial turned = sum({{{{1, 1}, {9, 1}}, 1}, {{{1, 1}, {4, 1}}, -1}});
  EXPECT_FALSE(same_factoring(factored(before), factored(turned), {2, 3}, 9));
}

}  // namespace
}  // namespace torsor::factor_pair_test
