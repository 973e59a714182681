// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/expression_derivative.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/expression/expression_node.hpp"
#include "torsor/generator/expression/function_slope.hpp"

namespace torsor {
namespace {

using Node = Expression::Node;

/// The literal 0 fits any unit; a product with it would have one.
Expression times(const Expression& a, const Expression& b) {
  return a.is_zero() || b.is_zero() ? Expression(0) : a * b;
}

struct NodeDerivative {
  const Expression& whole;
  const SymbolPointer& symbol;

  Expression of(const Expression& e) const { return partial_derivative(e, symbol); }

  Expression operator()(const Number&) const { return 0; }
  Expression operator()(const SymbolPointer& other) const { return other == symbol ? 1 : 0; }
  Expression operator()(const Node::Sum& sum) const { return of(sum.left) + of(sum.right); }
  Expression operator()(const Node::Product& product) const {
    return times(of(product.left), product.right) + times(product.left, of(product.right));
  }
  Expression operator()(const Node::Power& power) const {
    return times(Expression(power.exponent) * pow(power.base, power.exponent - 1), of(power.base));
  }
  Expression operator()(const Node::Apply& apply) const {
    const Expression& x = apply.arguments.front();
    if (apply.function == Function::sin) return times(cos(x), of(x));
    if (apply.function == Function::cos) return times(-sin(x), of(x));
    if (traits_of(apply.function).selects) {
      throw SceneError(
          fmt::format("'{}' stands in {}, whose derivative by it is not known: write the displacement as a sum "
                      "of it and what does not depend on it",
                      symbol->name, whole.to_string()));
    }
    const auto constant = [](const Number& number) { return Expression(number); };
    Expression sum = 0;
    for (std::size_t i = 0; i < apply.arguments.size(); ++i) {
      sum = sum + times(slope_of(apply.function, whole, apply.arguments, i, constant), of(apply.arguments[i]));
    }
    return sum;
  }
  Expression operator()(const Node::Rate&) const { return 0; }
};

}  // namespace

Expression partial_derivative(const Expression& e, const SymbolPointer& symbol) {
  if (!e.depends_on(symbol)) return 0;
  return std::visit(NodeDerivative{e, symbol}, e.node().content);
}

}  // namespace torsor
