// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/generic_form.hpp"

#include <map>
#include <variant>
#include <vector>

#include "torsor/generator/expression/expression_node.hpp"

namespace torsor {
namespace {

using Node = Expression::Node;

/// Parts that several places share are walked through once.
class Former {
 public:
  Expression of(const Expression& e) {
    const auto known = formed_.find(&e.node());
    if (known != formed_.end()) return known->second;
    const Expression formed = std::visit([&](const auto& content) { return form(e, content); }, e.node().content);
    formed_.emplace(&e.node(), formed);
    return formed;
  }

  bool met() const { return forms_ > 0; }

 private:
  static Expression form(const Expression& e, const Number&) { return e; }
  static Expression form(const Expression& e, const SymbolPointer&) { return e; }
  Expression form(const Expression&, const Node::Sum& sum) { return of(sum.left) + of(sum.right); }
  Expression form(const Expression&, const Node::Product& product) { return of(product.left) * of(product.right); }
  Expression form(const Expression&, const Node::Power& power) { return pow(of(power.base), power.exponent); }
  Expression form(const Expression&, const Node::Rate& rate_of) { return rate(of(rate_of.formula)); }
  Expression form(const Expression& e, const Node::Apply& apply) {
    std::vector<Expression> arguments;
    for (const Expression& argument : apply.arguments) arguments.push_back(of(argument));
    if (!traits_of(apply.function).selects) return call(apply.function, arguments);
    if (apply.function == Function::sign) return factor();
    Expression sum = 0;
    for (std::size_t i = apply.function == Function::select ? 1 : 0; i < arguments.size(); ++i) {
      if (!arguments[i].is_zero()) sum = sum + factor() * arguments[i];  // a product with the literal 0 has a unit
    }
    return sum.is_zero() ? e : sum;
  }

  /// No two are alike, nor do they add up to one another's by chance.
  Expression factor() {
    ++forms_;
    return Expression(Number::rational(31 + forms_ * forms_, 57 + 2 * forms_));
  }

  int forms_ = 0;
  std::map<const Node*, Expression> formed_;
};

}  // namespace

bool takes_forms(const Expression& e) {
  Former former;
  static_cast<void>(former.of(e));
  return former.met();
}

Expression generic_form(const Expression& e) {
  Former former;
  const Expression formed = former.of(e);
  return former.met() ? formed : e;
}

}  // namespace torsor
