// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/size_table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/test_symbols.hpp"

namespace torsor::size_table_test {
namespace {

using namespace testing_symbols;
using Relation = SizeBound::Relation;

TEST(SizeTable, SaysWhereTheNumbersOfABoundAre) {
  const Expression a(make_symbol("a")), b(make_symbol("b")), c(make_symbol("c"));
  const std::vector<SizeBound> bounds{{a, Relation::at_least, 0, "a = \1", {}},
                                      {a * b, Relation::at_most, c, "a, b and c are \1, \1 and \1", {a, b, c}},
                                      {b, Relation::below, c, "b = \1 is not below \1", {}}};
  EXPECT_EQ(count_of_numbers(bounds), 9u);
  EXPECT_EQ(size_table(bounds, "of::"),
            "\n    {of::at_least, 0, 0, \"a = \\001\"},"
            "\n    {of::at_most, 2, 4, \"a, b and c are \\001, \\001 and \\001\"},"
            "\n    {of::below, 7, 7, \"b = \\001 is not below \\001\"}");
}

TEST(SizeTable, WritesSentencesThatNoFormatNorLiteralTakesForItsOwn) {
  EXPECT_EQ(sentence_literal("'q{}' \"\\\" is 5 % = \1"), "\"'q{}' \\\"\\\\\\\" is 5 _ = \\001\"");
}

}  // namespace
}  // namespace torsor::size_table_test
