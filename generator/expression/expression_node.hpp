// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// The inside of an Expression, for those who lower or print it.
struct Expression::Node {
  struct Sum { Expression left, right; };
  struct Product { Expression left, right; };
  struct Power { Expression base; int exponent; };
  struct Apply { Function function; std::vector<Expression> arguments; };
  struct Rate { Expression formula; };

  std::variant<Number, SymbolPointer, Sum, Product, Power, Apply, Rate> content;
  Unit unit;
};

}  // namespace torsor
