// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/program.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/expression/arrival.hpp"
#include "generator/expression/derivative.hpp"
#include "generator/expression/error.hpp"
#include "generator/expression/expression_node.hpp"

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

Atom Program::append(Definition definition) {
  arrivals_.push_back(torsor::arrival(*this, definition));
  definitions_.push_back(std::move(definition));
  functions_.emplace_back();
  return static_cast<Atom>(definitions_.size()) - 1;
}

Value Program::number(const Number& value, const Unit& unit) { return {*this, Polynomial(value), unit}; }
Value Program::atom_value(Atom atom) { return {*this, Polynomial(atom), (*this)[atom].unit}; }

Value Program::symbol(const SymbolPointer& symbol) {
  if (const auto known = symbols_.find(symbol.get()); known != symbols_.end()) return atom_value(known->second);
  if (const auto known = resolved_.find(symbol.get()); known != resolved_.end()) return known->second;
  if (resolver_) {
    if (const std::optional<Expression> replacement = resolver_(symbol)) {
      const Value value = lower(*replacement);
      resolved_.emplace(symbol.get(), value);
      return value;
    }
  }
  Definition definition;
  definition.symbol = symbol;
  definition.unit = symbol->unit;
  definition.stage = stage_of_symbol(symbol->kind);
  if (!passes_.hoisting && definition.stage == Stage::parameters) definition.stage = Stage::configuration;
  const Atom atom = append(std::move(definition));
  symbols_.emplace(symbol.get(), atom);
  return atom_value(atom);
}

std::optional<Atom> Program::find(const SymbolPointer& symbol) const {
  const auto known = symbols_.find(symbol.get());
  if (known == symbols_.end()) return std::nullopt;
  return known->second;
}

Value Program::lower(const Expression& formula) {
  using Node = Expression::Node;
  const Node& node = formula.node();
  if (const auto* value = std::get_if<Number>(&node.content)) return number(*value, node.unit);
  if (const auto* s = std::get_if<SymbolPointer>(&node.content)) return symbol(*s);
  if (const auto* sum = std::get_if<Node::Sum>(&node.content)) {
    const Value left = lower(sum->left);  // named, so that every compiler creates atoms in the same order
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
  if (const auto* call = std::get_if<Node::Apply>(&node.content)) return apply(call->function, lower(call->argument));
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
  std::vector<Atom>& bucket = sums_[positive.hash()];
  const auto known = std::find_if(bucket.begin(), bucket.end(), [&](Atom atom) {
    return shared && (*this)[atom].polynomial == positive;
  });
  Atom atom = -1;
  if (known != bucket.end()) {
    atom = *known;
  } else {
    Definition definition;
    definition.stage = stage_of(positive);
    definition.polynomial = std::move(positive);
    definition.unit = value.unit();
    definition.name = name;
    atom = append(std::move(definition));
    if (shared) bucket.push_back(atom);
  }
  Value bound(*this, Polynomial(atom), value.unit());
  return negative ? -bound : bound;
}

Atom Program::function_atom(Function function, Atom argument) {
  auto& known = functions_[static_cast<std::size_t>(argument)];
  for (const auto& [f, atom] : known) {
    if (f == function) return atom;
  }
  Definition definition;
  definition.function = function;
  definition.argument = argument;
  definition.stage = (*this)[argument].stage;
  if (function == Function::sqrt) definition.unit = (*this)[argument].unit.root();
  const Atom atom = append(std::move(definition));
  functions_[static_cast<std::size_t>(argument)].emplace_back(function, atom);
  if (function == Function::sin || function == Function::cos) {  // they come as a pair and are computed together
    const Atom other = function_atom(function == Function::sin ? Function::cos : Function::sin, argument);
    definitions_[static_cast<std::size_t>(atom)].partner = other;
    definitions_[static_cast<std::size_t>(other)].partner = atom;
  }
  return atom;
}

Value Program::apply_to_number(Function function, const Value& argument) {
  const Number value = argument.polynomial().constant();
  if (value.is_zero()) {
    if (function == Function::sin || function == Function::sqrt) return number(Number(), argument.unit());
    if (function == Function::cos || function == Function::exp) return number(Number(1));
  }
  if (function == Function::sqrt) {
    if (value.sign() < 0) throw Error(fmt::format("square root of the negative number {}", value.to_string()));
    if (const auto root = value.square_root()) return number(*root, argument.unit().root());
  }
  if (function == Function::log && value.sign() <= 0) {
    throw Error(fmt::format("logarithm of {}: the argument must be positive", value.to_string()));
  }
  if (value.sign() < 0 && function == Function::sin) return -apply(function, -argument);
  if (value.sign() < 0 && function == Function::cos) return apply(function, -argument);
  const Unit unit = function == Function::sqrt ? argument.unit().root() : Unit();
  Definition constant;  // a named definition of the generation stage: its function has no exact value
  constant.polynomial = argument.polynomial();
  constant.unit = argument.unit();
  std::vector<Atom>& bucket = sums_[constant.polynomial.hash()];
  for (const Atom atom : bucket) {
    if ((*this)[atom].polynomial == constant.polynomial) return {*this, Polynomial(function_atom(function, atom)), unit};
  }
  const Atom atom = append(std::move(constant));
  sums_[(*this)[atom].polynomial.hash()].push_back(atom);
  return {*this, Polynomial(function_atom(function, atom)), unit};
}

Value Program::shifted_angle(Function function, const Value& angle) {
  // angle = rest + k π/12: the addition theorem with exact constants.
  Polynomial rest = angle.polynomial();
  const std::vector<Term>& terms = rest.terms();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Monomial& monomial = terms[i].monomial;
    if (monomial.size() != 1 || monomial[0].exponent != 1) continue;
    const Definition& definition = (*this)[monomial[0].atom];
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

Value Program::apply(Function function, const Value& argument) {
  if (function != Function::sqrt && !argument.is_zero() && !(argument.unit() == Unit())) {
    throw UnitError(fmt::format("the argument of {}({}) has the unit {} and must be dimensionless",
                                torsor::to_string(function), to_string(argument), argument.unit().to_string()));
  }
  if (argument.is_constant()) return apply_to_number(function, argument);
  const bool odd_or_even = function == Function::sin || function == Function::cos;
  if (odd_or_even) {
    if (const Value shifted = shifted_angle(function, argument); shifted.program() != nullptr) return shifted;
    if (argument.polynomial().sign() < 0) {
      const Value mirrored = apply(function, -argument);
      return function == Function::sin ? -mirrored : mirrored;
    }
  }
  Value bound = bind(argument);
  if (!bound.atom()) {  // minus one definition: only sqrt, exp and log come here
    Definition negated;
    negated.polynomial = bound.polynomial();
    negated.unit = bound.unit();
    negated.stage = stage_of(bound.polynomial());
    bound = atom_value(append(std::move(negated)));
  }
  const Atom atom = function_atom(function, *bound.atom());
  return {*this, Polynomial(atom), function == Function::sqrt ? argument.unit().root() : Unit()};
}

Stage Program::stage_of(const Polynomial& polynomial) const {
  Stage latest = Stage::generation;
  for (const Term& term : polynomial.terms()) {
    for (const Factor& factor : term.monomial) latest = std::max(latest, (*this)[factor.atom].stage);
  }
  return latest;
}
Stage Program::stage(const Value& value) const { return stage_of(value.polynomial()); }

std::vector<Atom> Program::live(const std::vector<Value>& outputs) const {
  std::vector<bool> needed(definitions_.size(), false);
  const auto mark = [&needed](const Polynomial& polynomial) {
    for (const Term& term : polynomial.terms()) {
      for (const Factor& factor : term.monomial) needed[static_cast<std::size_t>(factor.atom)] = true;
    }
  };
  for (const Value& output : outputs) mark(output.polynomial());
  for (std::size_t k = definitions_.size(); k-- > 0;) {
    if (!needed[k]) continue;
    mark(definitions_[k].polynomial);
    if (definitions_[k].function) needed[static_cast<std::size_t>(definitions_[k].argument)] = true;
  }
  std::vector<Atom> atoms;
  for (std::size_t k = 0; k < needed.size(); ++k) {
    if (needed[k]) atoms.push_back(static_cast<Atom>(k));
  }
  return atoms;
}

void Program::simplify(Polynomial& polynomial) const {
  if (!passes_.identities) return;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Term& term : polynomial.terms()) {
      for (const Factor& factor : term.monomial) {
        const Definition& definition = (*this)[factor.atom];
        if (factor.exponent < 2 || definition.function != Function::sin) continue;
        const Monomial common = term.monomial * Monomial{{factor.atom, -2}};
        const Monomial twin = common * Monomial{{definition.partner, 2}};
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
