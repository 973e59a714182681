// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/derivative.hpp"

#include <map>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/expression/function_slope.hpp"
#include "torsor/generator/program/smoothed_quotient.hpp"

namespace torsor {
namespace {

/// The same number, dimensionless: arguments of one call may be definitions met first under different units.
Value without_unit(const Value& value) {
  return value.program() == nullptr ? value : Value(*value.program(), value.polynomial(), Unit());
}

/// ∂f/∂x_i for the value number f(x_0, x_1, ...) of an analytic function, or of one that has a slope all the same.
Value slope(Program& program, ValueNumber value_number, std::size_t i) {
  const Definition definition = program[value_number];  // a copy: the program grows below
  const Value self = program.value_of_number(value_number);
  switch (*definition.function) {
    case Function::sin: return program.value_of_number(*definition.partner);
    case Function::cos: return -program.value_of_number(*definition.partner);
    case Function::abs: return program.apply(Function::sign, program.value_of_number(definition.arguments[0]));
    case Function::sign:
    case Function::maximum:
    case Function::select: return {};  // see choice_of
    default: break;
  }
  std::vector<Value> arguments;
  if (definition.arguments.size() == 1) {
    arguments.push_back(program.value_of_number(definition.arguments[0]));
  } else {
    for (std::size_t k = 0; k < definition.arguments.size(); ++k) {
      arguments.push_back(without_unit(program.argument(definition, k)));
    }
  }
  const auto number = [&program](const Number& value) { return program.number(value); };
  return slope_of(*definition.function, self, arguments, i, number);
}

/// Condition and forms of a function that selects one of two: c, a where c >= 0, b elsewhere.
struct Choice {
  Value condition, first, second;
};

std::optional<Choice> choice_of(Program& program, const Definition& definition) {
  if (definition.function == Function::select) {
    const Value condition = program.argument(definition, 0), first = program.argument(definition, 1);
    return Choice{condition, first, program.argument(definition, 2)};
  }
  if (definition.function != Function::maximum) return std::nullopt;
  const Value first = without_unit(program.argument(definition, 0));
  const Value second = without_unit(program.argument(definition, 1));
  return Choice{first - second, first, second};
}

/// The memo of a value number; the table grows with the program.
std::optional<Value>& slot(std::vector<std::optional<Value>>& table, ValueNumber value_number) {
  const auto index = static_cast<std::size_t>(value_number);
  if (table.size() <= index) table.resize(index + 1);
  return table[index];
}

}  // namespace

Derivation::Derivation(Program& program, Seed seed, Unit variable)
    : program_(&program), seed_(std::move(seed)), variable_(variable) {}

Value Derivation::operator()(const Value& value) { return of_polynomial(value.polynomial(), value.unit()); }

Value Derivation::of_polynomial(const Polynomial& polynomial, const Unit& unit) {
  Value sum(*program_, Polynomial(), unit / variable_);
  for (const Term& term : polynomial.terms()) {
    for (const auto& [value_number, partial] : partials_of_term(*program_, term)) {
      const Value inner = of_value_number(value_number);
      if (inner.is_zero()) continue;
      const Value outer(*program_, partial.polynomial(), unit / (*program_)[value_number].unit);
      sum += outer * inner;
    }
  }
  return sum;
}

Value Derivation::of_value_number(ValueNumber value_number) {
  if (const auto& known = slot(known_, value_number)) return *known;
  const Definition definition = (*program_)[value_number];  // a copy: the program grows below
  Value derivative;
  if (definition.symbol) {
    derivative = seed_(definition.symbol);
  } else if (definition.function) {
    const Value product = of_call(value_number, definition);
    // The argument may be a definition met first under another unit (a folded factor of 1 m hides one).
    if (!product.is_zero()) derivative = {*program_, product.polynomial(), definition.unit / variable_};
  } else {
    derivative = program_->bind(of_polynomial(definition.polynomial, definition.unit));
  }
  slot(known_, value_number) = derivative;
  return derivative;
}

Value Derivation::of_call(ValueNumber value_number, const Definition& definition) {
  if (const std::optional<Choice> choice = choice_of(*program_, definition)) {
    const Value first = without_unit((*this)(choice->first)), second = without_unit((*this)(choice->second));
    if (first.is_zero() && second.is_zero()) return {};
    return program_->bind(program_->select(choice->condition, first, second));
  }
  Value sum;
  for (std::size_t i = 0; i < definition.arguments.size(); ++i) {
    const Value inner = of_value_number(definition.arguments[i]);
    if (inner.is_zero()) continue;
    const Value outer = slope(*program_, value_number, i);
    sum += definition.arguments.size() == 1 ? outer * inner : without_unit(outer * inner);
  }
  return sum.program() == nullptr ? sum : program_->bind(sum);
}

Derivation partial_derivation(Program& program, const SymbolPointer& symbol) {
  return {program,
          [&program, symbol](const SymbolPointer& other) {
            return other == symbol ? program.number(Number(1)) : Value();
          },
          symbol->unit};
}

namespace {

/// ∂ė_k/∂ω_i = ± ½ e_j: j and the sign.
struct QuaternionRate {
  std::size_t j;
  int sign;
};
constexpr QuaternionRate quaternion_rates[4][3] = {
    {{1, -1}, {2, -1}, {3, -1}}, {{0, 1}, {3, -1}, {2, 1}}, {{3, 1}, {0, 1}, {1, -1}}, {{2, -1}, {1, 1}, {0, 1}}};

}  // namespace

Value rate_along(Program& program, const SymbolPointer& coordinate, const SymbolPointer& velocity) {
  if (coordinate->rate == velocity) return program.number(Number(1));
  const auto attitude = coordinate->attitude.lock();
  if (!attitude) return {};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (attitude->e[k] != coordinate || attitude->omega[i] != velocity) continue;
      const auto [j, sign] = quaternion_rates[k][i];
      return Number::rational(sign, 2) * program.symbol(attitude->e[j]);
    }
  }
  return {};
}

Value rate_of(Program& program, const SymbolPointer& coordinate) {
  const auto attitude = coordinate->attitude.lock();
  if (!attitude) return program.symbol(coordinate->rate);
  Value sum;
  for (const SymbolPointer& omega : attitude->omega) {
    const Value entry = rate_along(program, coordinate, omega);
    sum += entry * program.symbol(omega);
  }
  return program.bind(sum);
}

Derivation derivation_along(Program& program, const SymbolPointer& velocity) {
  return {program,
          [&program, velocity](const SymbolPointer& symbol) -> Value {
            if (symbol->kind != SymbolKind::coordinate) return {};
            return rate_along(program, symbol, velocity);
          },
          velocity->unit * units::second};
}

Derivation time_derivation(Program& program) {
  const auto seed = [&program](const SymbolPointer& symbol) -> Value {
    switch (symbol->kind) {
      case SymbolKind::time: return program.number(Number(1));
      case SymbolKind::pi:
      case SymbolKind::parameter: return {};
      default: break;
    }
    if (!symbol->attitude.expired()) return rate_of(program, symbol);
    if (!symbol->rate) {
      throw SceneError(fmt::format("'{}' has no known time derivative: only time, parameters, coordinates and their "
                                   "velocities may stand under d/dt",
                                   symbol->name));
    }
    return program.symbol(symbol->rate);
  };
  return {program, seed, Unit::parse("s")};
}

Value time_derivative(const Value& value) {
  if (value.program() == nullptr) return {};  // nothing at all
  if (value.is_constant()) return {*value.program(), Polynomial(), value.unit() / Unit::parse("s")};
  Derivation derivation = time_derivation(*value.program());
  return derivation(value);
}

namespace {

/// Adjoints of all symbols that the value depends on, in order of creation. Of a selection they are selected as a whole:
/// in the form that does not count a slope may be no number, which times an adjoint of zero would be none either.
std::map<ValueNumber, Value> adjoints_of_symbols(const Value& value) {
  Program& program = *value.program();
  std::map<ValueNumber, Value>
      adjoints;  // ordered by value number: the sweep goes from the last definition to the first
  const auto spread = [&](const Polynomial& polynomial, const Unit& unit, const Value& adjoint) {
    for (const Term& term : polynomial.terms()) {
      for (const auto& [value_number, partial] : partials_of_term(program, term)) {
        const Value outer(program, partial.polynomial(), unit / program[value_number].unit);
        adjoints[value_number] += outer * adjoint;
      }
    }
  };
  spread(value.polynomial(), value.unit(), program.number(Number(1)));
  std::map<ValueNumber, Value> found;
  while (!adjoints.empty()) {
    const auto last = std::prev(adjoints.end());
    const ValueNumber value_number = last->first;
    const Definition definition = program[value_number];
    const Value adjoint = program.bind(last->second);
    adjoints.erase(last);
    if (adjoint.is_zero() || definition.stage == Stage::generation) continue;
    if (definition.symbol) {
      found[value_number] = adjoint;
    } else if (const std::optional<Choice> choice = choice_of(program, definition)) {
      const std::map<ValueNumber, Value> first = adjoints_of_symbols(choice->first);
      const std::map<ValueNumber, Value> second = adjoints_of_symbols(choice->second);
      std::set<ValueNumber> symbols;
      for (const auto& [symbol, unused] : first) symbols.insert(symbol);
      for (const auto& [symbol, unused] : second) symbols.insert(symbol);
      const auto of = [](const std::map<ValueNumber, Value>& all, ValueNumber symbol) {
        const auto place = all.find(symbol);
        return place == all.end() ? Value() : without_unit(place->second);
      };
      for (const ValueNumber symbol : symbols) {
        const Value partial = program.select(choice->condition, of(first, symbol), of(second, symbol));
        const Value product = partial * adjoint;
        adjoints[symbol] += Value(program, product.polynomial(), value.unit() / program[symbol].unit);
      }
    } else if (definition.function) {
      for (std::size_t i = 0; i < definition.arguments.size(); ++i) {
        const ValueNumber argument = definition.arguments[i];
        const Value product = slope(program, value_number, i) * adjoint;
        if (product.is_zero()) continue;
        adjoints[argument] += Value(program, product.polynomial(), value.unit() / program[argument].unit);
      }
    } else {
      spread(definition.polynomial, definition.unit, adjoint);
    }
  }
  return found;
}

}  // namespace

std::vector<Value> gradient(const Value& value, const std::vector<SymbolPointer>& symbols) {
  Program& program = *value.program();
  const std::map<ValueNumber, Value> found = adjoints_of_symbols(value);
  std::vector<Value> result;
  result.reserve(symbols.size());
  for (const SymbolPointer& symbol : symbols) {
    const std::optional<ValueNumber> value_number = program.find(symbol);
    const auto place = value_number ? found.find(*value_number) : found.end();
    result.push_back(place != found.end() ? place->second
                                          : Value(program, Polynomial(), value.unit() / symbol->unit));
  }
  return result;
}

std::vector<Value> gradient_along(const Value& value, const std::vector<SymbolPointer>& velocities) {
  Program& program = *value.program();
  const std::map<ValueNumber, Value> found = adjoints_of_symbols(value);
  std::vector<Value> result;
  result.reserve(velocities.size());
  for (const SymbolPointer& velocity : velocities) {
    Value sum(program, Polynomial(), value.unit() / (velocity->unit * units::second));
    for (const auto& [value_number, adjoint] : found) {
      const SymbolPointer symbol = program[value_number].symbol;
      if (symbol->kind == SymbolKind::coordinate) sum += rate_along(program, symbol, velocity) * adjoint;
    }
    result.push_back(sum);
  }
  return result;
}

Substitution::Substitution(Program& program, Replacement replacement)
    : program_(&program), replacement_(std::move(replacement)) {}

Value Substitution::operator()(const Value& value) {
  Value sum(*program_, Polynomial(), value.unit());
  for (const Term& term : value.polynomial().terms()) {
    Value product = program_->number(term.coefficient);
    for (const Factor& factor : term.monomial)
      product = product * pow(of_value_number(factor.value_number), factor.exponent);
    // A literal may carry a unit that its value numbers do not show; the sum's own unit is the right one.
    sum += Value(*program_, product.polynomial(), value.unit());
  }
  return sum;
}

Value Substitution::of_value_number(ValueNumber value_number) {
  if (const auto& known = slot(known_, value_number)) return *known;
  const Definition definition = (*program_)[value_number];
  Value result;
  if (definition.symbol) {
    result = replacement_(definition.symbol).value_or(program_->value_of_number(value_number));
  } else if (definition.function) {
    const std::vector<Unit> units = argument_units(*definition.function, definition.unit);
    std::vector<Value> arguments;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Value argument = of_value_number(definition.arguments[i]);
      arguments.emplace_back(*program_, argument.polynomial(), units[i]);
    }
    result = program_->apply(*definition.function, arguments);
  } else {
    result = program_->bind((*this)(Value(*program_, definition.polynomial, definition.unit)), definition.name);
  }
  slot(known_, value_number) = result;
  return result;
}

}  // namespace torsor
