// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/program.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/expression/expression_node.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

Stage stage_of_symbol(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::pi: return Stage::generation;
    case SymbolKind::parameter: return Stage::parameters;
    case SymbolKind::time:
    case SymbolKind::coordinate: return Stage::configuration;
    case SymbolKind::velocity: return Stage::state;
    case SymbolKind::acceleration:
    case SymbolKind::input:
    case SymbolKind::multiplier: return Stage::call;
  }
  return Stage::call;
}

}  // namespace

Program::Program(Resolver resolver, const Passes& passes) : resolver_(std::move(resolver)), passes_(passes) {}

ValueNumber Program::append(Definition definition) {
  definitions_.push_back(std::move(definition));
  functions_.emplace_back();
  return static_cast<ValueNumber>(definitions_.size()) - 1;
}

Value Program::number(const Number& value, const Unit& unit) { return {*this, Polynomial(value), unit}; }
Value Program::value_of_number(ValueNumber value_number) {
  return {*this, Polynomial(value_number), (*this)[value_number].unit};
}

Value Program::symbol(const SymbolPointer& symbol) {
  if (const auto known = symbols_.find(symbol.get()); known != symbols_.end()) return value_of_number(known->second);
  if (const auto known = resolved_.find(symbol.get()); known != resolved_.end()) return known->second.value;
  if (symbol->measure && measurer_.value) {
    const Value value = measurer_.value(*symbol);
    resolved_.emplace(symbol.get(), Resolved{value, size()});
    return value;
  }
  if (resolver_) {
    if (const std::optional<Expression> replacement = resolver_(symbol)) {
      const Value value = lower(*replacement);
      resolved_.emplace(symbol.get(), Resolved{value, size()});
      return value;
    }
  }
  Definition definition;
  definition.symbol = symbol;
  definition.unit = symbol->unit;
  definition.stage = stage_of_symbol(symbol->kind);
  if (!passes_.hoisting && definition.stage == Stage::parameters) definition.stage = Stage::configuration;
  const ValueNumber value_number = append(std::move(definition));
  symbols_.emplace(symbol.get(), value_number);
  return value_of_number(value_number);
}

std::optional<ValueNumber> Program::find(const SymbolPointer& symbol) const {
  const auto known = symbols_.find(symbol.get());
  if (known == symbols_.end()) return std::nullopt;
  return known->second;
}

void Program::truncate(std::size_t size) {
  while (definitions_.size() > size) {
    const auto value_number = static_cast<ValueNumber>(definitions_.size()) - 1;
    const Definition& last = definitions_.back();
    if (last.symbol) {
      symbols_.erase(last.symbol.get());
    } else if (last.function) {
      functions_[static_cast<std::size_t>(last.arguments[0])].pop_back();  // of one argument the latest stands last
    } else if (std::vector<ValueNumber>& bucket = sums_[last.polynomial.hash()];
               !bucket.empty() && bucket.back() == value_number) {
      bucket.pop_back();  // one that is bound apart stands in none
    }
    definitions_.pop_back();
    functions_.pop_back();
  }
  std::erase_if(resolved_, [size](const auto& each) { return each.second.size > size; });
  if (measurer_.forget) measurer_.forget(size);
}

Value Program::lower(const Expression& formula) {
  using Node = Expression::Node;
  const Node& node = formula.node();
  if (const auto* value = std::get_if<Number>(&node.content)) return number(*value, node.unit);
  if (const auto* s = std::get_if<SymbolPointer>(&node.content)) return symbol(*s);
  if (const auto* sum = std::get_if<Node::Sum>(&node.content)) {
    const Value left = lower(sum->left);  // named, so that every compiler creates value numbers in the same order
    const Value right = lower(sum->right);
    return left + right;
  }
  if (const auto* product = std::get_if<Node::Product>(&node.content)) {
    const Value left = lower(product->left);
    const Value right = lower(product->right);
    return left * right;
  }
  if (const auto* power = std::get_if<Node::Power>(&node.content)) {
    const Value base = lower(power->base);
    if (power->exponent == 0) return number(Number(1));
    return pow(base, power->exponent);
  }
  if (const auto* call = std::get_if<Node::Apply>(&node.content)) {
    std::vector<Value> arguments;
    for (const Expression& argument : call->arguments) arguments.push_back(lower(argument));
    return apply(call->function, arguments);
  }
  return time_derivative(lower(std::get<Node::Rate>(node.content).formula));
}

Value Program::bind(const Value& value, const std::string& name, bool shared) {
  const Polynomial& polynomial = value.polynomial();
  if (polynomial.is_constant()) return value;
  if (polynomial.terms().size() == 1) {
    const Term& term = polynomial.terms()[0];
    const bool plain = term.monomial.size() == 1 && term.monomial[0].exponent == 1;
    if (plain && (term.coefficient.is_one() || (-term.coefficient).is_one())) return value;
  }
  const bool negative = polynomial.sign() < 0;
  Polynomial positive = polynomial;
  if (negative) positive *= Number(-1);
  std::vector<ValueNumber>& bucket = sums_[positive.hash()];
  const auto known = std::find_if(bucket.begin(), bucket.end(), [&](ValueNumber value_number) {
    return shared && (*this)[value_number].polynomial == positive;
  });
  ValueNumber value_number{};
  if (known != bucket.end()) {
    value_number = *known;
  } else {
    Definition definition;
    definition.stage = stage_of(positive);
    definition.polynomial = std::move(positive);
    definition.unit = value.unit();
    definition.name = name;
    value_number = append(std::move(definition));
    if (shared) bucket.push_back(value_number);
  }
  Value bound(*this, Polynomial(value_number), value.unit());
  return negative ? -bound : bound;
}

ValueNumber Program::function_value_number(Function function, const std::vector<ValueNumber>& arguments,
                                           const Unit& unit) {
  const auto first = static_cast<std::size_t>(arguments[0]);
  for (const auto& [f, value_number] : functions_[first]) {
    if (f == function && (*this)[value_number].arguments == arguments) return value_number;
  }
  Definition definition;
  definition.function = function;
  definition.arguments = arguments;
  for (const ValueNumber argument : arguments) definition.stage = std::max(definition.stage, (*this)[argument].stage);
  definition.unit = function == Function::sqrt ? (*this)[arguments[0]].unit.root() : unit;
  const ValueNumber value_number = append(std::move(definition));
  functions_[first].emplace_back(function, value_number);
  if (function == Function::sin || function == Function::cos) {  // they come as a pair and are computed together
    const ValueNumber other =
        function_value_number(function == Function::sin ? Function::cos : Function::sin, arguments, unit);
    definitions_[static_cast<std::size_t>(value_number)].partner = other;
    definitions_[static_cast<std::size_t>(other)].partner = value_number;
  }
  return value_number;
}

/// The definition of a number, which functions of it need.
ValueNumber Program::constant_value_number(const Value& number) {
  std::vector<ValueNumber>& bucket = sums_[number.polynomial().hash()];
  for (const ValueNumber value_number : bucket) {
    if ((*this)[value_number].polynomial == number.polynomial() && !(*this)[value_number].symbol &&
        !(*this)[value_number].function)
      return value_number;
  }
  Definition constant;
  constant.polynomial = number.polynomial();
  constant.unit = number.unit();
  const ValueNumber value_number = append(std::move(constant));
  sums_[(*this)[value_number].polynomial.hash()].push_back(value_number);
  return value_number;
}

ValueNumber Program::argument_value_number(const Value& argument) {
  if (argument.is_constant()) return constant_value_number(argument);
  const Value bound = bind(argument);
  if (bound.value_number()) return *bound.value_number();
  // Minus one definition, under a name of its own that is found again.
  std::vector<ValueNumber>& bucket = sums_[bound.polynomial().hash()];
  for (const ValueNumber value_number : bucket) {
    if ((*this)[value_number].polynomial == bound.polynomial()) return value_number;
  }
  Definition negated;
  negated.polynomial = bound.polynomial();
  negated.unit = bound.unit();
  negated.stage = stage_of(bound.polynomial());
  const ValueNumber value_number = append(std::move(negated));
  sums_[bound.polynomial().hash()].push_back(value_number);
  return value_number;
}

Value Program::argument(const Definition& call, std::size_t i) {
  const ValueNumber value_number = call.arguments[i];
  const Definition& definition = (*this)[value_number];
  const bool number = !definition.symbol && !definition.function && definition.polynomial.is_constant();
  return number ? Value(*this, definition.polynomial, definition.unit) : value_of_number(value_number);
}

Value Program::apply_to_number(Function function, const Value& argument) {
  const Number value = argument.polynomial().constant();
  if (function == Function::abs) return number(value.abs(), argument.unit());
  if (function == Function::sign) return number(Number(value.sign()));
  const FunctionTraits& traits = traits_of(function);
  if (value.is_zero() && traits.at_zero) {
    return number(Number(*traits.at_zero), *traits.at_zero == 0 ? argument.unit() : Unit());
  }
  if (function == Function::sqrt) {
    if (value.sign() < 0) throw Error(fmt::format("square root of the negative number {}", value.to_string()));
    if (const auto root = value.square_root()) return number(*root, argument.unit().root());
  }
  if (function == Function::log && value.sign() <= 0) {
    throw Error(fmt::format("logarithm of {}: the argument must be positive", value.to_string()));
  }
  if (value.sign() < 0 && traits.parity == Parity::odd) return -apply(function, -argument);
  if (value.sign() < 0 && traits.parity == Parity::even) return apply(function, -argument);
  const Unit unit = function == Function::sqrt ? argument.unit().root() : Unit();
  // A named definition of the generation stage: its function has no exact value.
  return {*this, Polynomial(function_value_number(function, {constant_value_number(argument)}, unit)), unit};
}

/// What a selection gives where its condition is known, or where it makes no difference.
std::optional<Value> Program::known_choice(Function function, const std::vector<Value>& arguments) {
  if (function == Function::maximum) {
    const Value difference = arguments[0] - arguments[1];
    if (!difference.is_constant()) return std::nullopt;
    return arguments[difference.is_zero() || difference.polynomial().constant().sign() > 0 ? 0 : 1];
  }
  if (function != Function::select) return std::nullopt;
  if (arguments[1].polynomial() == arguments[2].polynomial()) return arguments[1].is_zero() ? arguments[2] : arguments[1];
  if (!arguments[0].is_constant()) return std::nullopt;
  return arguments[arguments[0].is_zero() || arguments[0].polynomial().constant().sign() > 0 ? 1 : 2];
}

/// atan2 of numbers whose angle is a multiple of π/12.
std::optional<Value> Program::exact_angle(const Value& y, const Value& x) {
  if (!y.is_constant() || !x.is_constant()) return std::nullopt;
  const auto of = [](const Value& v) { return v.is_zero() ? Number() : v.polynomial().constant(); };
  const Number up = of(y), along = of(x);
  if (up.is_zero() && along.is_zero()) return number(Number());
  for (int twelfths = -11; twelfths <= 12; ++twelfths) {
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(twelfths));
    const bool along_it = (up * cosine - along * sine).is_zero();
    if (!along_it || (up * sine + along * cosine).sign() < 0) continue;
    return Number::rational(twelfths, 12) * symbol(pi().as_symbol());
  }
  return std::nullopt;
}

/// sqrt(c x^2 y^4) = sqrt(c) |x| y^2, whose slope is known at x = 0 and y = 0 too. Parameters are sizes and stay under the root.
std::optional<Value> Program::root_of_square(const Value& square) {
  if (square.polynomial().terms().size() != 1 || square.is_constant()) return std::nullopt;
  const Term& term = square.polynomial().terms()[0];
  Monomial plain, signless;
  for (const Factor& factor : term.monomial) {
    if (factor.exponent % 2 != 0) return std::nullopt;
    const int half = factor.exponent / 2;
    const std::optional<Function> function = (*this)[factor.value_number].function;
    const bool positive = function == Function::sqrt || function == Function::exp || function == Function::abs;
    const int odd = positive ? 0 : half % 2;
    if (odd != 0 && (*this)[factor.value_number].stage <= Stage::parameters) return std::nullopt;
    if (odd != 0) signless.push_back({factor.value_number, odd});
    if (half != odd) plain.push_back({factor.value_number, half - odd});
  }
  if (term.coefficient.sign() < 0) return std::nullopt;
  const auto of = [this](const Monomial& monomial) {
    Unit unit;
    for (const Factor& factor : monomial) unit = unit * (*this)[factor.value_number].unit.pow(factor.exponent);
    return Value(*this, Polynomial(Term{monomial, Number(1)}), unit);
  };
  Value root = apply(Function::sqrt, number(term.coefficient));
  if (!plain.empty()) root = root * of(plain);
  if (!signless.empty()) root = root * apply(Function::abs, of(signless));
  return Value(*this, root.polynomial(), square.unit().root());
}

Value Program::shifted_angle(Function function, const Value& angle) {
  // angle = rest + k π/12: the addition theorem with exact constants.
  Polynomial rest = angle.polynomial();
  const std::vector<Term>& terms = rest.terms();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Monomial& monomial = terms[i].monomial;
    if (monomial.size() != 1 || monomial[0].exponent != 1) continue;
    const Definition& definition = (*this)[monomial[0].value_number];
    if (!definition.symbol || definition.symbol->kind != SymbolKind::pi) continue;
    const Number twelfths = terms[i].coefficient * Number(12);
    const auto exact = sin_cos_of_pi_twelfths(twelfths);
    if (!exact) break;
    rest.erase(i);
    const Value remainder(*this, rest, angle.unit());
    const Value sine = sin(remainder);
    const Value cosine = cos(remainder);
    return function == Function::sin ? exact->second * sine + exact->first * cosine
                                     : exact->second * cosine - exact->first * sine;
  }
  return {};
}

Value Program::apply(Function function, const std::vector<Value>& given) {
  std::vector<ArgumentUnit> units;
  for (const Value& argument : given) {
    units.push_back({argument.unit(), argument.is_zero()});
  }
  const Unit unit = unit_of_call(function, units, [&] {
    std::string text;
    for (const Value& argument : given) text += (text.empty() ? "" : ", ") + to_string(argument);
    return fmt::format("{}({})", torsor::to_string(function), text);
  });
  const FunctionTraits& traits = traits_of(function);
  if (const std::optional<Value> known = known_choice(function, given)) {
    return {*this, known->polynomial(), unit};
  }
  if (function == Function::atan2) {
    if (std::optional<Value> exact = exact_angle(given[0], given[1])) return *exact;
  } else if (traits.arity == 1 && given[0].is_constant()) {
    return apply_to_number(function, given[0]);
  }
  if (function == Function::sin || function == Function::cos) {
    if (const Value shifted = shifted_angle(function, given[0]); shifted.program() != nullptr) return shifted;
  }
  if (traits.parity != Parity::none && given[0].polynomial().sign() < 0) {
    std::vector<Value> mirrored = given;
    mirrored[0] = -mirrored[0];
    const Value value = apply(function, mirrored);
    return traits.parity == Parity::odd ? -value : value;
  }
  if (function == Function::sqrt) {
    if (const std::optional<Value> root = root_of_square(given[0])) return *root;
  }
  if ((function == Function::abs || function == Function::sign) && given[0].polynomial().terms().size() == 1) {
    const Term& term = given[0].polynomial().terms()[0];
    if (!term.coefficient.is_one()) {  // |2 x| = 2 |x|
      const Value rest(*this, Polynomial(Term{term.monomial, Number(1)}), given[0].unit());
      const Value value = apply(function, rest);
      return function == Function::abs ? term.coefficient * value : value;
    }
  }
  std::vector<ValueNumber> arguments;
  for (const Value& argument : given) arguments.push_back(argument_value_number(argument));
  if (function == Function::maximum && arguments[1] < arguments[0]) std::swap(arguments[0], arguments[1]);
  return {*this, Polynomial(function_value_number(function, arguments, unit)), unit};
}

Stage Program::stage_of(const Polynomial& polynomial) const {
  Stage latest = Stage::generation;
  for (const Term& term : polynomial.terms()) {
    for (const Factor& factor : term.monomial) latest = std::max(latest, (*this)[factor.value_number].stage);
  }
  return latest;
}
Stage Program::stage(const Value& value) const { return stage_of(value.polynomial()); }

std::vector<ValueNumber> Program::live(const std::vector<Value>& outputs) const {
  std::vector<bool> needed(definitions_.size(), false);
  const auto mark = [&needed](const Polynomial& polynomial) {
    for (const Term& term : polynomial.terms()) {
      for (const Factor& factor : term.monomial) needed[static_cast<std::size_t>(factor.value_number)] = true;
    }
  };
  for (const Value& output : outputs) mark(output.polynomial());
  for (std::size_t k = definitions_.size(); k-- > 0;) {
    if (!needed[k]) continue;
    mark(definitions_[k].polynomial);
    for (const ValueNumber argument : definitions_[k].arguments) needed[static_cast<std::size_t>(argument)] = true;
  }
  std::vector<ValueNumber> value_numbers;
  for (std::size_t k = 0; k < needed.size(); ++k) {
    if (needed[k]) value_numbers.push_back(static_cast<ValueNumber>(k));
  }
  return value_numbers;
}

void Program::simplify(Polynomial& polynomial) const {
  if (!passes_.identities) return;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Term& term : polynomial.terms()) {
      for (const Factor& factor : term.monomial) {
        const Definition& definition = (*this)[factor.value_number];
        if (factor.exponent < 2 || definition.function != Function::sin) continue;
        const Monomial common = term.monomial * Monomial{{factor.value_number, -2}};
        const Monomial twin = common * Monomial{{*definition.partner, 2}};
        const auto& terms = polynomial.terms();
        const auto found = std::find_if(terms.begin(), terms.end(), [&](const Term& other) {
          return other.monomial == twin && other.coefficient == term.coefficient;
        });
        if (found == terms.end()) continue;
        const Number coefficient = term.coefficient;
        const Monomial squared = term.monomial;
        polynomial.add({twin, -coefficient});
        polynomial.add({squared, -coefficient});
        polynomial.add({common, coefficient});
        changed = true;
        break;
      }
      if (changed) break;
    }
  }
}

}  // namespace torsor
