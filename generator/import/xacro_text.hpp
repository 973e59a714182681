// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// A text taken apart: "link_${i}" is a text and an expression.
struct TextPart {
  enum class Kind { text, expression, command };
  Kind kind = Kind::text;
  std::string content;  ///< of ${...} and $(...) what stands inside
};

/// $${ and $$( are ${ and $( that mean nothing. Throws ExpressionError for a bracket that is not closed.
std::vector<TextPart> text_parts(const std::string& text);

/// The value of a text: that of the expression or the command when it holds nothing else, otherwise a text of all.
Value text_value(const std::string& text, const std::function<Value(const std::string&)>& expression,
                 const std::function<Value(const std::string&)>& command);

}  // namespace torsor::xacro
