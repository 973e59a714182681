// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace torsor::fuzzing {

/// Throw std::logic_error where a text is not what whoever opens it may rely on.

/// UTF-8 without control characters other than the end of a line, without characters that turn the direction of writing.
void expect_clean_text(std::string_view text);
/// Such a text, in which no line of a comment goes on in the next one (a backslash or a trigraph at its end) and no
/// trigraph stands.
void expect_source_text(std::string_view text);
/// Such a text of whole lines, in which no program says that it failed unexpectedly.
void expect_lines(std::string_view text);
/// Such a text that any reader of XML takes.
void expect_xml(std::string_view text);
/// Such a text as Graphviz reads it: what comes from outside stands in quotes.
void expect_dot(std::string_view text);
/// A message of one line that is not empty.
void expect_message(std::string_view message);

}  // namespace torsor::fuzzing
