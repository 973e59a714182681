// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/text_template.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::text_template_test {
namespace {

std::string message_of(std::string_view text, const std::map<std::string, std::string>& values) {
  try {
    fill_template("page", text, values);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(TextTemplate, ReplacesPlaceholdersInsideALine) {
  EXPECT_EQ(fill_template("page", "a @x@ b @y_2@@x@\n", {{"x", "1"}, {"y_2", "two"}}), "a 1 b two1\n");
}

TEST(TextTemplate, GivesThePlaceholdersIndentationToEveryLineOfItsText) {
  EXPECT_EQ(fill_template("page", "{\n  @body@\n}\n", {{"body", "one\n\n  two\n"}}), "{\n  one\n\n    two\n}\n");
}

TEST(TextTemplate, DropsTheLineOfAnEmptyText) {
  EXPECT_EQ(fill_template("page", "{\n  @body@\n}", {{"body", ""}}), "{\n}");
}

TEST(TextTemplate, LeavesPlaceholdersInsideTextsAlone) {
  EXPECT_EQ(fill_template("page", "x @a@\n", {{"a", "@b@"}}), "x @b@\n");
}

TEST(TextTemplate, NamesAPlaceholderWithoutText) {
  EXPECT_EQ(message_of("a\n @x@ b\n", {}),
            "template 'page', line 2: nothing is given for the placeholder @x@; give it a text or take it out of the "
            "template");
}

TEST(TextTemplate, NamesATextWithoutPlaceholder) {
  EXPECT_EQ(
      message_of("a\n", {{"x", ""}}),
      "template 'page' has no placeholder @x@ for the text that is given: add it to the template or do not give it");
}

TEST(TextTemplate, RefusesAStrayAt) {
  EXPECT_NE(message_of("mail me@home\n", {}).find("line 1: the '@' in \"mail me@home\" begins no placeholder"),
            std::string::npos);
  EXPECT_NE(message_of("@Upper@\n", {{"Upper", ""}}).find("begins no placeholder"), std::string::npos);
}

}  // namespace
}  // namespace torsor::text_template_test
