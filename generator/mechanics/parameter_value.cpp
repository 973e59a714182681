// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/parameter_value.hpp"

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

Real initial_value(const SceneContent& scene, const SymbolPointer& symbol, bool invent) {
  if (symbol->kind == SymbolKind::pi || symbol->kind == SymbolKind::parameter) {
    return parameter_value(scene, symbol, invent);
  }
  if (const auto component = scene.quaternion_component(symbol)) {
    return parameter_value(scene, initial_component(scene.attitudes[component->first], component->second), invent);
  }
  for (const CoordinateContent& c : scene.coordinates) {
    if (c.q == symbol && c.initial_value) return parameter_value(scene, *c.initial_value, invent);
    if (c.q == symbol && invent && c.unknown()) return generic_value(symbol, 0);
    if (c.v == symbol && c.initial_rate) return parameter_value(scene, *c.initial_rate, invent);
  }
  return Real(0);
}

}  // namespace torsor
