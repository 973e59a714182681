// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
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

  using Content = std::variant<Number, SymbolPointer, Sum, Product, Power, Apply, Rate>;

  Content content;
  Unit unit;
  int depth = 0;  ///< operations within one another

  /// Of an operation. Throws Error beyond a depth that those who walk through formulas have room for.
  static std::shared_ptr<const Node> of(Content content, const Unit& unit);
};

}  // namespace torsor
