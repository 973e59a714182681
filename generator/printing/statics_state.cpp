// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/statics_state.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/printing/state_values.hpp"

namespace torsor::printing {
namespace {

bool is_rate(SymbolKind kind) { return kind == SymbolKind::velocity || kind == SymbolKind::acceleration; }

Expression in_unit_of(const SymbolPointer& symbol, const Expression& value) {
  const bool number = value.unit() == Unit() && !(symbol->unit == Unit());
  return number ? value * Expression::quantity(Number(1), symbol->unit) : value;
}

const CoordinateContent* driven(const Scene& scene, const SymbolPointer& symbol) {
  for (const CoordinateContent& c : scene.content().coordinates) {
    if (c.law && (symbol == c.q || symbol == c.v || symbol == c.a)) return &c;
  }
  return nullptr;
}

/// Throws where `symbol` is no part of a rest at which it can have that value.
void check_rest(const Scene& scene, const SymbolPointer& symbol, const Expression& value, const std::string& formula) {
  const std::string& name = symbol->name;
  if (symbol->kind == SymbolKind::parameter) {
    throw UsageError(fmt::format("--about takes a state, e.g. theta=0, and '{}' is a parameter: give its value by --set", name));
  }
  if (const CoordinateContent* c = driven(scene, symbol)) {
    throw UsageError(fmt::format("--about {} = {}: the coordinate '{}' follows the law {}; name the time, t, or a parameter "
                                 "of the law by --set",
                                 name, formula, c->q->name, c->law->to_string()));
  }
  if (is_rate(symbol->kind) && !value.is_zero()) {
    throw UsageError(fmt::format("--about {} = {}: at a rest every rate is zero; drive the coordinate by a law for a steady "
                                 "motion, or linearise about it by equations --about",
                                 name, formula));
  }
  for (const SymbolPointer& other : value.symbols()) {
    if (other != symbol && !is_rate(other->kind)) continue;
    throw UsageError(fmt::format("--about {} = {}: the value depends on '{}'; give a formula of parameters, the time and "
                                 "other coordinates",
                                 name, formula, other->name));
  }
}

void normalise(const Scene& scene, AtState::Named& state) {
  const auto given = [&](const SymbolPointer& symbol) {
    return std::find_if(state.begin(), state.end(), [&](const auto& each) { return each.first.as_symbol() == symbol; });
  };
  for (AttitudeContent attitude : scene.content().attitudes) {
    std::array<Expression, 4> e;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto component = given(attitude.symbols->e[k]);
      if (component != state.end()) e[k] = component->second, ++count;
    }
    if (count == 3) {
      throw UsageError(fmt::format("--about gives three components of the attitude '{}', which leave the sign of the fourth "
                                   "open: give all four, which are normalised",
                                   attitude.name));
    }
    if (count < 4) continue;
    if (std::all_of(e.begin(), e.end(), [](const Expression& component) { return component.is_zero(); })) {
      throw UsageError(fmt::format("--about: the four components of the attitude '{}' are zero: give a quaternion", attitude.name));
    }
    attitude.initial = e;
    for (std::size_t k = 0; k < 4; ++k) given(attitude.symbols->e[k])->second = initial_component(attitude, k);
  }
}

}  // namespace

Scene with_parameters(const Scene& scene, const Assignments& set) {
  Scene changed = scene;
  for (const auto& [name, formula] : set) {
    const SymbolPointer symbol = parse_formula(name, scene).as_symbol();
    if (!symbol || symbol->kind != SymbolKind::parameter) {
      throw UsageError(fmt::format("--set takes parameters, e.g. m=0, and '{}' is none: name a state by --about", name));
    }
    const Expression value = in_unit_of(symbol, parse_formula(formula, scene));
    for (const SymbolPointer& other : value.symbols()) {
      if (other->kind == SymbolKind::parameter || other->kind == SymbolKind::pi) continue;
      throw UsageError(fmt::format("--set {} = {}: the value depends on '{}'; give a number or a formula of parameters", name,
                                   formula, other->name));
    }
    try {
      changed.set_parameter(symbol, value);
    } catch (const SceneError& error) {
      throw UsageError(fmt::format("--set {} = {}: {}", name, formula, error.what()));
    }
  }
  return changed;
}

AtState::Named rest_state(const Scene& scene, const Assignments& about) {
  AtState::Named state;
  StateValues values;
  for (const auto& [name, formula] : about) {
    const Expression what = parse_formula(name, scene);
    const SymbolPointer symbol = what.as_symbol();
    Expression value = parse_formula(formula, scene);
    if (symbol) {
      check_rest(scene, symbol, value, formula);
      value = in_unit_of(symbol, value);
      values.emplace_back(symbol, value);
    }
    state.emplace_back(what, value);
  }
  refuse_values_of_each_other(values);
  normalise(scene, state);
  return state;
}

}  // namespace torsor::printing
