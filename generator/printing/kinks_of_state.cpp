// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/kinks_of_state.hpp"

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/forces/actions.hpp"
#include "torsor/generator/dynamics/motion/initial_numbers.hpp"
#include "torsor/generator/dynamics/theorems/forms_that_meet.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor::printing {
namespace {

constexpr int digits = 50;

/// What the state leaves open is beside the scene's start, by a millionth that no condition is about: formulas have values there.
Evaluator<Real>::SymbolValue numbers_of(InitialNumbers& scene) {
  return [&scene](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::parameter || symbol->kind == SymbolKind::pi) return scene(symbol);
    const Real beside(Number::rational(10007 + symbol->index * 7919L % 4007, 4'007'000'000L), Real::working_digits());
    return symbol->kind == SymbolKind::input ? beside : scene(symbol) + beside;
  };
}

}  // namespace

Kinks kinks_of_state(const Equations& equations, const AtState::Named& state) {
  Program& program = equations.program();
  const Linearisation linear = linearisation(equations);
  std::vector<Value> values = equations.bias();
  for (const ValueMatrix* matrix : {&linear.M, &linear.C, &linear.K, &linear.E}) {
    for (const std::vector<Value>& row : *matrix) values.insert(values.end(), row.begin(), row.end());
  }
  const WorkingDigits precision(digits);
  InitialNumbers scene(equations.scene());
  const AtState at(equations, state);
  const auto meeting = [&](const std::vector<Value>& of) { return forms_that_meet(program, of, at, numbers_of(scene)); };
  Kinks kinks{meeting(values), {}};
  if (kinks.conditions.empty()) return kinks;
  for (const ActionContent& action : equations.scene().content().actions) {
    const std::string& name = name_of(action);
    const AppliedActions alone =
        applied_actions(equations.model(), [&](const ActionContent& other) { return name_of(other) == name; });
    std::vector<Value> forces = applied_forces(equations.model(), alone);
    const std::size_t count = forces.size();
    for (const CoordinateContent& c : equations.scene().content().coordinates) {
      for (const SymbolPointer& symbol : symbols_of(c)) {
        if (symbol->kind == SymbolKind::acceleration) continue;
        auto slope = partial_derivation(program, symbol);
        for (std::size_t i = 0; i < count; ++i) forces.push_back(slope(forces[i]));
      }
    }
    if (!meeting(forces).empty()) kinks.laws.push_back(name);
  }
  return kinks;
}

}  // namespace torsor::printing
