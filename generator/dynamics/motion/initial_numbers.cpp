// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/initial_numbers.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// A plain number is understood in the unit of what it is the value of.
Expression in_unit(const Expression& value, const Unit& unit) {
  return value.unit().is_dimensionless() ? value * Expression::quantity(Number(1), unit) : value;
}

Real without_value(const SymbolPointer& symbol) {
  if (symbol->kind == SymbolKind::pi) return Real::pi();
  const long scrambled = (symbol->index + 1) * 7919L % 4007;
  return Real(Number::rational(4007 + 2 * scrambled, 2 * 4007), Real::working_digits());
}

}  // namespace

InitialNumbers::InitialNumbers(const Scene& scene)
    : scene_(scene.content()),
      program_([this](const SymbolPointer& symbol) { return resolve(symbol); }),
      evaluate_(program_, without_value),
      evaluate_sized_(program_, [](const SymbolPointer& symbol) { return Sized(without_value(symbol)); }) {}

std::optional<Expression> InitialNumbers::resolve(const SymbolPointer& symbol) const {
  if (symbol->kind == SymbolKind::time) return Expression(0);
  for (const ParameterContent& p : scene_.parameters) {
    if (p.symbol == symbol && p.value) return in_unit(*p.value, symbol->unit);
  }
  if (const auto component = scene_.quaternion_component(symbol)) {
    return initial_component(scene_.attitudes[component->first], component->second);
  }
  for (const CoordinateContent& c : scene_.coordinates) {
    if (c.q == symbol)
      return c.law ? *c.law : c.initial_value ? in_unit(*c.initial_value, symbol->unit) : Expression(0);
    if (c.v == symbol)
      return c.law ? rate(*c.law) : c.initial_rate ? in_unit(*c.initial_rate, symbol->unit) : Expression(0);
  }
  return std::nullopt;
}

Real InitialNumbers::operator()(const Expression& formula) { return evaluate_(program_.lower(formula)) + Real(0); }

Real InitialNumbers::operator()(const SymbolPointer& symbol) { return (*this)(Expression(symbol)); }

Sized InitialNumbers::sized(const SymbolPointer& symbol) { return evaluate_sized_(program_.lower(Expression(symbol))); }

}  // namespace torsor
