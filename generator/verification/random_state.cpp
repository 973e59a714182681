// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/random_state.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {

RandomState::RandomState(const Scene& scene, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    constexpr double steps = 1048576;  // 2^20: few bits, so that the number is the same in every format
    return low + (high - low) * static_cast<double>(random() >> 44U) / steps;
  };
  const SceneContent& content = scene.content();
  values_[content.time.get()] = uniform(0, 2);
  Program program;
  double inertia_factor = 0;  // moments and products of inertia keep their proportions: some others belong to no body
  for (const ParameterContent& parameter : content.parameters) {
    double scale = 1;
    if (parameter.value) {
      Evaluator<double> evaluate(program, in_double());
      scale = evaluate(program.lower(*parameter.value));
    }
    double factor = uniform(0.5, 1.5);
    if (parameter.symbol->unit == units::kilogram_metre_squared) {
      if (inertia_factor == 0) inertia_factor = factor;
      factor = inertia_factor;
    }
    values_[parameter.symbol.get()] = scale * factor;
  }
  for (const CoordinateContent& c : content.coordinates) {
    for (const SymbolPointer& symbol : {c.q, c.v, c.a}) values_[symbol.get()] = uniform(-2, 2);
  }
  for (const AttitudeContent& attitude : content.attitudes) {
    for (const SymbolPointer& e : attitude.symbols->e) values_[e.get()] = uniform(-1, 1);
  }
  for (const ActionContent& action : content.actions) {
    if (const auto* motor = std::get_if<Motor>(&action)) values_[motor->input.get()] = uniform(-2, 2);
  }
  for (const ConstraintContent& constraint : content.constraints) {
    values_[constraint.multiplier.get()] = uniform(-2, 2);
  }
}

double RandomState::value(const SymbolPointer& symbol) const {
  const auto place = values_.find(symbol.get());
  if (place == values_.end()) throw Error(fmt::format("no value for the symbol '{}' at a random state", symbol->name));
  return place->second;
}

Evaluator<double>::SymbolValue RandomState::in_double() const {
  return [this](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return 3.14159265358979323846;
    if (!symbol->attitude.expired()) return in_real()(symbol).to_double();
    return value(symbol);
  };
}

Evaluator<Real>::SymbolValue RandomState::in_real() const {
  return [this](const SymbolPointer& symbol) {
    return at_unit_quaternions(symbol, [this](const SymbolPointer& each) { return Real::from_double(value(each)); });
  };
}

}  // namespace torsor
