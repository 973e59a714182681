// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// A word of an expression.
struct Token {
  enum class Kind { number, text, name, symbol, end };
  Kind kind = Kind::end;
  std::string word;  ///< a name or a symbol as it is written
  Value value;       ///< of a number or a text
};

/// The words of an expression and an end. Throws ExpressionError naming a character that has no meaning.
std::vector<Token> tokens(std::string_view expression);

}  // namespace torsor::xacro
