// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/parameter_value.hpp"

#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {

Real parameter_value(const SceneContent& scene, const Expression& formula, bool invent) {
  Program program;
  Evaluator<Real> evaluate(program, [&scene, invent](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return Real::pi();
    for (const ParameterContent& parameter : scene.parameters) {
      if (parameter.symbol != symbol) continue;
      if (parameter.value) return parameter_value(scene, *parameter.value, invent);
      if (invent) return generic_value(symbol, 0);
    }
    throw SceneError(fmt::format("'{}' has no value: give the parameter one", symbol->name));
  });
  return evaluate(program.lower(formula));
}

std::optional<Real> known_value(const SceneContent& scene, const Expression& formula) {
  try {
    return parameter_value(scene, formula);
  } catch (const SceneError&) {
    return std::nullopt;
  }
}

void require_double(const SceneContent& scene, const ParameterContent& parameter) {
  const std::optional<Real> value = parameter.value ? known_value(scene, *parameter.value) : std::nullopt;
  if (!value || value->is_nan()) return;
  const double rounded = value->to_double();
  if (std::isfinite(rounded) && (rounded != 0.0 || value->is_zero())) return;
  throw SceneError(fmt::format("the run-time parameter '{}' has the value {}, which no double holds: give one between 1e-308 "
                               "and 1e308 in size, in another unit",
                               parameter.symbol->name, value->to_string(6)));
}

std::optional<Expression> initial_formula(const SceneContent& scene, const SymbolPointer& symbol) {
  if (const auto component = scene.quaternion_component(symbol)) {
    return initial_component(scene.attitudes[component->first], component->second);
  }
  for (const CoordinateContent& c : scene.coordinates) {
    if (c.q == symbol && c.initial_value) return *c.initial_value;
    if (c.v == symbol && c.initial_rate) return *c.initial_rate;
  }
  return std::nullopt;
}

Real initial_value(const SceneContent& scene, const SymbolPointer& symbol, bool invent) {
  if (symbol->kind == SymbolKind::pi || symbol->kind == SymbolKind::parameter) {
    return parameter_value(scene, symbol, invent);
  }
  if (const auto formula = initial_formula(scene, symbol)) return parameter_value(scene, *formula, invent);
  for (const CoordinateContent& c : scene.coordinates) {
    if (c.q == symbol && invent && c.unknown()) return generic_value(symbol, 0);
  }
  return Real(0);
}

}  // namespace torsor
