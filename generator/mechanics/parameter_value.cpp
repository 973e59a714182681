// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/parameter_value.hpp"

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/expression/evaluation.hpp"

namespace torsor {

Real parameter_value(const SceneContent& scene, const Expression& formula) {
  Program program;
  Evaluator<Real> evaluate(program, [&scene](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return Real::pi();
    for (const ParameterContent& parameter : scene.parameters) {
      if (parameter.symbol == symbol && parameter.value) return parameter_value(scene, *parameter.value);
    }
    throw SceneError(fmt::format("'{}' has no value: give the parameter one", symbol->name));
  });
  return evaluate(program.lower(formula));
}

}  // namespace torsor
