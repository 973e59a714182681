// SPDX-License-Identifier: GPL-3.0-or-later
// Where expressions of xacro could differ from Python without a word.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/xacro.hpp"
#include "tests/import/xacro_values.hpp"

namespace torsor::xacro_python_test {
namespace {

using testing_xacro::value_of;

// What Python 3.11 prints for each.
TEST(XacroPython, RoundsToTens) {
  for (const auto& [expression, printed] : std::vector<std::pair<std::string, std::string>>{
           {"round(123, -1)", "120"}, {"round(157, -2)", "200"}, {"round(125, -1)", "120"}, {"round(135, -1)", "140"},
           {"round(-125, -1)", "-120"}, {"round(-157, -2)", "-200"}, {"round(49, -2)", "0"}, {"round(50, -2)", "0"},
           {"round(51, -2)", "100"}, {"round(7, -40)", "0"}, {"round(9000000000000000000, -18)", "9000000000000000000"},
           {"round(True, -1)", "0"}, {"round(7, 2)", "7"}, {"round(7, None)", "7"}, {"round(125.0, -1)", "120.0"},
           {"round(125.5, -1)", "130.0"}, {"round(-1234.5, -2)", "-1200.0"}, {"round(0.3, -1)", "0.0"},
           {"round(-3.0, -1)", "-0.0"}}) {
    EXPECT_EQ(value_of(expression), printed) << expression;
  }
  EXPECT_THROW(value_of("round(9223372036854775807, -19)"), Error);
  EXPECT_THROW(value_of("round(7, 1.5)"), Error);
}

TEST(XacroPython, KeepsTheLastOfEqualKeys) {
  EXPECT_EQ(value_of("{'a': 1, 'a': 2}['a']"), "2");
  EXPECT_EQ(value_of("{'a': 1, 'b': 3, 'a': 2}"), "{'a': 2, 'b': 3}");
  EXPECT_EQ(value_of("len({1: 'x', 1.0: 'y', True: 'z'})"), "1");
  EXPECT_EQ(value_of("dict([('a', 1), ('a', 2)])['a']"), "2");
  EXPECT_EQ(value_of("dict({'a': 1})"), "{'a': 1}");
  EXPECT_THROW(value_of("dict(a=1, a=2)"), Error);
  EXPECT_THROW(value_of("dict([1, 2])"), Error);
}

TEST(XacroPython, AsksWhetherItIsOneObject) {
  for (const auto& [expression, printed] : std::vector<std::pair<std::string, std::string>>{
           {"2 if 1 is True else 3", "3"}, {"1 is not True", "True"}, {"None is None", "True"}, {"0 is None", "False"},
           {"False is False", "True"}, {"True is not False", "True"}, {"1 is 1", "True"}, {"1 is 1.0", "False"},
           {"'a' is 'b'", "False"}, {"'' is ''", "True"}, {"[] is None", "False"}}) {
    EXPECT_EQ(value_of(expression), printed) << expression;
  }
  EXPECT_THROW(value_of("'arm' is 'arm'"), Error);
  EXPECT_THROW(value_of("1.5 is 1.5"), Error);
}

TEST(XacroPython, CountsLettersAndNotBytes) {
  for (const auto& [expression, printed] : std::vector<std::pair<std::string, std::string>>{
           {"len('é')", "1"}, {"'été'[0]", "é"}, {"'été'[-1]", "é"}, {"'été'[1:]", "té"},
           {"'été'[:-1]", "ét"}, {"'été'[None:1]", "é"}, {"list('aé€')", "['a', 'é', '€']"},
           {"len('🤖') + len('関節')", "3"}, {"max('aé')", "é"}, {"'%3s|' % 'é'", "  é|"},
           {"'%-3s|' % '関'", "関  |"}, {"'%.1s' % 'été'", "é"}, {"'abc'[1]", "b"}, {"'abc'[1:2]", "b"}}) {
    EXPECT_EQ(value_of(expression), printed) << expression;
  }
  EXPECT_THROW(value_of("'É'.lower()"), Error);
  EXPECT_THROW(value_of("'é'[1]"), Error);
}

TEST(XacroPython, RefusesEscapesThatItDoesNotRead) {
  EXPECT_THROW(value_of("'\\x41'"), Error);
  EXPECT_EQ(value_of("len('a\\tb')"), "3");
}

}  // namespace
}  // namespace torsor::xacro_python_test
