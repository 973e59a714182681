// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/expression.hpp"

#include <fmt/format.h>

#include "generator/expression/decimal.hpp"
#include "generator/expression/error.hpp"
#include "generator/expression/expression_node.hpp"

namespace torsor {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

void require_same_unit(const Expression& a, const Expression& b) {
  if (a.is_zero() || b.is_zero() || a.unit() == b.unit()) return;
  throw UnitError(fmt::format("cannot add {} [{}] and {} [{}]: both terms of a sum need the same unit", a.to_string(),
                              a.unit().to_string(), b.to_string(), b.unit().to_string()));
}

void require_dimensionless(std::string_view function, const Expression& x) {
  if (x.is_zero() || x.unit() == Unit()) return;
  throw UnitError(fmt::format("the argument of {}({}) has the unit {} and must be dimensionless: divide it by a "
                              "quantity of that unit",
                              function, x.to_string(), x.unit().to_string()));
}

bool is_number(const Expression& x, const Number& value) {
  const auto* number = std::get_if<Number>(&x.node().content);
  return number != nullptr && *number == value;
}

}  // namespace

std::string_view to_string(Function function) {
  switch (function) {
    case Function::sin: return "sin";
    case Function::cos: return "cos";
    case Function::sqrt: return "sqrt";
    case Function::exp: return "exp";
    case Function::log: return "log";
  }
  return "?";
}

Expression::Expression(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
Expression::Expression() : Expression(Number()) {}
Expression::Expression(int value) : Expression(Number(value)) {}
Expression::Expression(double value) : Expression(from_double(value)) {}
Expression::Expression(const Number& value) : node_(std::make_shared<Node>(Node{value, Unit()})) {}
Expression::Expression(SymbolPointer symbol)
    : node_(std::make_shared<Node>(Node{symbol, symbol->unit})) {}

Expression Expression::quantity(std::string_view decimal, std::string_view unit) {
  return quantity(parse_decimal(decimal), Unit::parse(unit));
}
Expression Expression::quantity(const Number& value, const Unit& unit) {
  return Expression(std::make_shared<Node>(Node{value, unit}));
}

const Unit& Expression::unit() const { return node_->unit; }
bool Expression::is_zero() const { return is_number(*this, Number()); }
SymbolPointer Expression::as_symbol() const {
  const auto* symbol = std::get_if<SymbolPointer>(&node_->content);
  return symbol == nullptr ? nullptr : *symbol;
}

bool Expression::depends_on(const SymbolPointer& symbol) const {
  return std::visit(Overloaded{
                        [](const Number&) { return false; },
                        [&](const SymbolPointer& own) { return own == symbol; },
                        [&](const Node::Sum& s) { return s.left.depends_on(symbol) || s.right.depends_on(symbol); },
                        [&](const Node::Product& p) { return p.left.depends_on(symbol) || p.right.depends_on(symbol); },
                        [&](const Node::Power& p) { return p.base.depends_on(symbol); },
                        [&](const Node::Apply& call) { return call.argument.depends_on(symbol); },
                        [&](const Node::Rate& rate) { return rate.formula.depends_on(symbol); },
                    },
                    node_->content);
}

Expression operator+(const Expression& a, const Expression& b) {
  require_same_unit(a, b);
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return Expression(std::make_shared<Expression::Node>(Expression::Node{Expression::Node::Sum{a, b}, a.unit()}));
}
Expression operator-(const Expression& a) {
  if (const auto* number = std::get_if<Number>(&a.node().content)) return Expression::quantity(-*number, a.unit());
  return Expression(-1) * a;
}
Expression operator-(const Expression& a, const Expression& b) {
  require_same_unit(a, b);
  return a + -b;
}
Expression operator*(const Expression& a, const Expression& b) {
  return Expression(std::make_shared<Expression::Node>(
      Expression::Node{Expression::Node::Product{a, b}, a.unit() * b.unit()}));
}
Expression operator/(const Expression& a, const Expression& b) { return a * pow(b, -1); }
Expression pow(const Expression& base, int exponent) {
  if (exponent < 0 && base.is_zero()) throw Error("division by zero: the denominator is the literal 0");
  return Expression(std::make_shared<Expression::Node>(
      Expression::Node{Expression::Node::Power{base, exponent}, base.unit().pow(exponent)}));
}
Expression apply(Function function, const Expression& x) {
  if (function != Function::sqrt) require_dimensionless(to_string(function), x);
  const Unit unit = function == Function::sqrt ? x.unit().root() : Unit();
  return Expression(
      std::make_shared<Expression::Node>(Expression::Node{Expression::Node::Apply{function, x}, unit}));
}
Expression rate(const Expression& formula) {
  return Expression(std::make_shared<Expression::Node>(
      Expression::Node{Expression::Node::Rate{formula}, formula.unit() / Unit::parse("s")}));
}

Expression sin(const Expression& angle) { return apply(Function::sin, angle); }
Expression cos(const Expression& angle) { return apply(Function::cos, angle); }
Expression tan(const Expression& angle) { return sin(angle) / cos(angle); }
Expression exp(const Expression& x) { return apply(Function::exp, x); }
Expression log(const Expression& x) { return apply(Function::log, x); }
Expression sqrt(const Expression& x) { return apply(Function::sqrt, x); }

Expression pi() {
  static const auto symbol = std::make_shared<const Symbol>(Symbol{"pi", Unit(), SymbolKind::pi, -1, nullptr});
  return Expression(symbol);
}

std::string Expression::to_string() const {
  return std::visit(Overloaded{
                        [](const Number& value) { return value.to_string(); },
                        [](const SymbolPointer& symbol) { return symbol->name; },
                        [](const Node::Sum& sum) {
                          return fmt::format("({} + {})", sum.left.to_string(), sum.right.to_string());
                        },
                        [](const Node::Product& product) {
                          if (is_number(product.left, Number(-1))) return "-" + product.right.to_string();
                          return fmt::format("{}*{}", product.left.to_string(), product.right.to_string());
                        },
                        [](const Node::Power& power) {
                          return fmt::format("{}^({})", power.base.to_string(), power.exponent);
                        },
                        [](const Node::Apply& call) {
                          return fmt::format("{}({})", torsor::to_string(call.function), call.argument.to_string());
                        },
                        [](const Node::Rate& rate) { return fmt::format("d/dt({})", rate.formula.to_string()); },
                    },
                    node_->content);
}

namespace literals {
Expression operator""_r(const char* decimal) { return Expression::quantity(decimal); }
}  // namespace literals

}  // namespace torsor
