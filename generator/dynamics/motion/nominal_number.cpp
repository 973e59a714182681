// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/nominal_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

double number_of(const SceneContent& scene, const SymbolPointer& symbol) {
  if (symbol->kind == SymbolKind::pi) return std::acos(-1.0);
  const auto place = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                  [&](const ParameterContent& each) { return each.symbol == symbol; });
  if (place == scene.parameters.end() || !place->value) return std::numeric_limits<double>::quiet_NaN();
  Program formula;
  const Value value = formula.lower(*place->value);
  return Evaluator<double>(formula, [&](const SymbolPointer& inner) { return number_of(scene, inner); })(value);
}

}  // namespace

std::optional<double> nominal_number(const SceneContent& scene, const Value& value) {
  if (value.is_zero()) return 0.0;
  if (value.is_constant()) return value.polynomial().constant().to_double();
  const Program& program = *value.program();
  if (program.stage(value) > Stage::parameters) return std::nullopt;
  Evaluator<double> evaluate(program, [&](const SymbolPointer& symbol) { return number_of(scene, symbol); });
  const double number = evaluate(value);
  if (std::isnan(number)) return std::nullopt;
  return number;
}

}  // namespace torsor
