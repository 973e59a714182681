// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/expression.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/expression/expression_node.hpp"

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

bool is_number(const Expression& x, const Number& value) {
  const auto* number = std::get_if<Number>(&x.node().content);
  return number != nullptr && *number == value;
}

std::string text_of_sum(const Expression::Node::Sum& sum) {
  const std::string left = sum.left.to_string(), right = sum.right.to_string();
  return right[0] == '-' ? fmt::format("{} - {}", left, right.substr(1)) : fmt::format("{} + {}", left, right);
}

bool is_one(const Expression& x) {
  const auto* power = std::get_if<Expression::Node::Power>(&x.node().content);
  return is_number(power != nullptr ? power->base : x, Number(1));
}

/// A formula that stands between commas or alone within parentheses.
std::string text_inside(const Expression& x) {
  const auto* product = std::get_if<Expression::Node::Product>(&x.node().content);
  if (product != nullptr && is_one(product->right)) return text_inside(product->left);
  if (product != nullptr && is_one(product->left)) return text_inside(product->right);
  const auto* sum = std::get_if<Expression::Node::Sum>(&x.node().content);
  return sum != nullptr ? text_of_sum(*sum) : x.to_string();
}

std::string call_text(Function function, const std::vector<Expression>& arguments) {
  std::string inside;
  for (const Expression& argument : arguments) inside += (inside.empty() ? "" : ", ") + text_inside(argument);
  return fmt::format("{}({})", to_string(function), inside);
}

/// Formulas are walked through, and freed, from within one another: a stack has room for twice as many.
constexpr int deepest_formula = 20'000;
/// From here on a sum that grows term by term is kept balanced.
constexpr int long_sum = 1000;

/// −x as it was told, of a number or of a product that begins with −1.
std::optional<Expression> without_minus(const Expression& x) {
  if (const auto* number = std::get_if<Number>(&x.node().content)) return Expression::quantity(-*number, x.unit());
  const auto* product = std::get_if<Expression::Node::Product>(&x.node().content);
  if (product == nullptr || !is_number(product->left, Number(-1))) return std::nullopt;
  return product->right;
}

/// The text of −x where x is max(−a, −b).
std::optional<std::string> minimum_text(const Expression& x) {
  const auto* call = std::get_if<Expression::Node::Apply>(&x.node().content);
  if (call == nullptr || call->function != Function::maximum) return std::nullopt;
  const auto a = without_minus(call->arguments[0]), b = without_minus(call->arguments[1]);
  if (!a || !b) return std::nullopt;
  return fmt::format("min({}, {})", text_inside(*a), text_inside(*b));
}

/// x is not negative, or -x is negative, as `piecewise` has been told it.
std::string condition_text(const Expression& x, const char* relation) {
  const auto* sum = std::get_if<Expression::Node::Sum>(&x.node().content);
  const auto left = sum != nullptr ? without_minus(sum->right) : std::nullopt;
  return left ? fmt::format("{} {} {}", text_inside(*left), relation, text_inside(sum->left))
              : fmt::format("0 {} {}", relation, text_inside(x));
}

/// The rows of `piecewise`, and of what it holds otherwise.
std::string piecewise_text(const Expression& x) {
  const auto* call = std::get_if<Expression::Node::Apply>(&x.node().content);
  if (call == nullptr || call->function != Function::select) return text_inside(x);
  const std::optional<Expression> strict = without_minus(call->arguments[0]);
  const Expression& form = call->arguments[strict ? 2 : 1];
  return fmt::format("{}: {}, {}", condition_text(strict ? *strict : call->arguments[0], strict ? "<" : "<="), text_inside(form),
                     piecewise_text(call->arguments[strict ? 1 : 2]));
}

/// In parentheses where a power or a quotient would take a part of it alone.
std::string text_of_base(const Expression& x) {
  const auto& content = x.node().content;
  const auto* number = std::get_if<Number>(&content);
  const bool parts = std::holds_alternative<Expression::Node::Product>(content) ||
                     std::holds_alternative<Expression::Node::Power>(content) ||
                     (number != nullptr && (number->sign() < 0 || !number->is_integer()));
  return parts ? fmt::format("({})", x.to_string()) : x.to_string();
}

/// Without factors that are one, in whichever unit.
std::string product_text(const Expression& left, const Expression& right) {
  if (is_one(right)) return left.to_string();
  const auto* power = std::get_if<Expression::Node::Power>(&right.node().content);
  if (power != nullptr && power->exponent == -1) return fmt::format("{}/{}", left.to_string(), text_of_base(power->base));
  if (is_one(left)) return right.to_string();
  const std::string text = right.to_string();
  return left.to_string() + "*" + (text[0] == '-' ? "(" + text + ")" : text);
}

/// The unit of a call; `text` is how errors name it.
Unit checked_unit(Function function, const std::vector<Expression>& arguments,
                  const std::function<std::string()>& text) {
  if (arguments.size() != traits_of(function).arity) {
    throw Error(fmt::format("{} takes {} arguments", text(), traits_of(function).arity));
  }
  std::vector<ArgumentUnit> units;
  for (const Expression& argument : arguments) {
    units.push_back({argument.unit(), argument.is_zero()});
  }
  return unit_of_call(function, units, text, ": divide it by a quantity of that unit");
}

}  // namespace

std::shared_ptr<const Expression::Node> Expression::Node::of(Content content, const Unit& unit) {
  int inside = 0;
  const auto look = [&inside](const Expression& x) { inside = std::max(inside, x.node().depth); };
  std::visit(Overloaded{[](const Number&) {}, [](const SymbolPointer&) {},
                        [&](const Sum& sum) { look(sum.left), look(sum.right); },
                        [&](const Product& product) { look(product.left), look(product.right); },
                        [&](const Power& power) { look(power.base); },
                        [&](const Apply& call) { std::for_each(call.arguments.begin(), call.arguments.end(), look); },
                        [&](const Rate& rate) { look(rate.formula); }},
             content);
  if (inside >= deepest_formula) {
    throw Error(fmt::format("a formula has more than {} operations within one another: write powers as pow(x, n), and make "
                            "products of parts of about the same length",
                            deepest_formula));
  }
  return std::make_shared<const Node>(Node{std::move(content), unit, inside + 1});
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

void Expression::collect(std::vector<SymbolPointer>& symbols) const {
  std::visit(Overloaded{
                 [](const Number&) {},
                 [&](const SymbolPointer& own) {
                   if (std::find(symbols.begin(), symbols.end(), own) == symbols.end()) symbols.push_back(own);
                 },
                 [&](const Node::Sum& s) { s.left.collect(symbols), s.right.collect(symbols); },
                 [&](const Node::Product& p) { p.left.collect(symbols), p.right.collect(symbols); },
                 [&](const Node::Power& p) { p.base.collect(symbols); },
                 [&](const Node::Apply& call) {
                   for (const Expression& argument : call.arguments) argument.collect(symbols);
                 },
                 [&](const Node::Rate& rate) { rate.formula.collect(symbols); },
             },
             node_->content);
}

std::vector<SymbolPointer> Expression::symbols() const {
  std::vector<SymbolPointer> all;
  collect(all);
  return all;
}

bool Expression::depends_on(const SymbolPointer& symbol) const {
  const std::vector<SymbolPointer> all = symbols();
  return std::any_of(all.begin(), all.end(), [&](const SymbolPointer& own) {
    return own == symbol || std::find(own->made_of.begin(), own->made_of.end(), symbol) != own->made_of.end();
  });
}

Expression operator+(const Expression& a, const Expression& b) {
  require_same_unit(a, b);
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  // As a counter in binary carries: of sums that grow on one side, parts of like depth are put together.
  const auto* left = std::get_if<Expression::Node::Sum>(&a.node().content);
  const auto* right = std::get_if<Expression::Node::Sum>(&b.node().content);
  const int of_a = a.node().depth, of_b = b.node().depth;
  if (left != nullptr && of_a >= long_sum && of_b < long_sum && left->right.node().depth <= of_b) {
    return left->left + (left->right + b);
  }
  if (right != nullptr && of_b >= long_sum && of_a < long_sum && right->left.node().depth <= of_a) {
    return (a + right->left) + right->right;
  }
  return Expression(Expression::Node::of(Expression::Node::Sum{a, b}, a.unit()));
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
  return Expression(Expression::Node::of(Expression::Node::Product{a, b}, a.unit() * b.unit()));
}
Expression operator/(const Expression& a, const Expression& b) { return a * pow(b, -1); }
Expression pow(const Expression& base, int exponent) {
  if (exponent < 0 && base.is_zero()) throw Error("division by zero: the denominator is the literal 0");
  return Expression(Expression::Node::of(Expression::Node::Power{base, exponent}, base.unit().pow(exponent)));
}
Expression apply(Function function, const Expression& x) { return call(function, {x}); }
Expression call(Function function, const std::vector<Expression>& arguments) {
  const Unit unit = checked_unit(function, arguments, [&] { return call_text(function, arguments); });
  return Expression(Expression::Node::of(Expression::Node::Apply{function, arguments}, unit));
}
Expression rate(const Expression& formula) {
  return Expression(Expression::Node::of(Expression::Node::Rate{formula}, formula.unit() / Unit::parse("s")));
}

Expression sin(const Expression& angle) { return apply(Function::sin, angle); }
Expression cos(const Expression& angle) { return apply(Function::cos, angle); }
Expression tan(const Expression& angle) { return sin(angle) / cos(angle); }
Expression exp(const Expression& x) { return apply(Function::exp, x); }
Expression tanh(const Expression& x) {
  (void)checked_unit(Function::exp, {x}, [&] { return fmt::format("tanh({})", x.to_string()); });
  // Of |x| and sign(x) the slope at 0 would be 0: a selection has that of the form taken.
  const Expression small = exp(call(Function::select, {x, -2 * x, 2 * x}));
  return call(Function::select, {x, 1 - small, small - 1}) / (1 + small);
}
Expression log(const Expression& x) { return apply(Function::log, x); }
Expression sqrt(const Expression& x) { return apply(Function::sqrt, x); }
Expression abs(const Expression& x) { return apply(Function::abs, x); }
Expression sign(const Expression& x) { return apply(Function::sign, x); }
Expression max(const Expression& a, const Expression& b) { return call(Function::maximum, {a, b}); }
Expression min(const Expression& a, const Expression& b) {
  const auto text = [&] { return fmt::format("min({}, {})", a.to_string(), b.to_string()); };
  (void)checked_unit(Function::maximum, {a, b}, text);
  return -max(-a, -b);
}
Expression atan2(const Expression& y, const Expression& x) { return call(Function::atan2, {y, x}); }

Expression pi() {
  static const auto symbol = std::make_shared<const Symbol>(Symbol{"pi", Unit(), SymbolKind::pi, -1, nullptr});
  return Expression(symbol);
}

std::string Expression::to_string() const {
  return std::visit(Overloaded{
                        [](const Number& value) { return value.to_string(); },
                        [](const SymbolPointer& symbol) { return symbol->name; },
                        [](const Node::Sum& sum) { return fmt::format("({})", text_of_sum(sum)); },
                        [](const Node::Product& product) {
                          if (is_number(product.left, Number(-1))) {
                            const std::optional<std::string> least = minimum_text(product.right);
                            return least ? *least : "-" + product.right.to_string();
                          }
                          return product_text(product.left, product.right);
                        },
                        [](const Node::Power& power) {
                          const std::string base = text_of_base(power.base);
                          if (power.exponent == -1) return "1/" + base;
                          return power.exponent < 0 ? fmt::format("{}^({})", base, power.exponent)
                                                    : fmt::format("{}^{}", base, power.exponent);
                        },
                        [this](const Node::Apply& call) {
                          return call.function == Function::select ? fmt::format("piecewise({})", piecewise_text(*this))
                                                                   : call_text(call.function, call.arguments);
                        },
                        [](const Node::Rate& rate) { return fmt::format("d/dt({})", text_inside(rate.formula)); },
                    },
                    node_->content);
}

namespace literals {
Expression operator""_r(const char* decimal) { return Expression::quantity(decimal); }
}  // namespace literals

}  // namespace torsor
