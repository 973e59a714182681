// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::testing_mechanisms {

/// State of a scene by name; what is not named is zero, parameters stand at their values.
class NamedState {
 public:
  NamedState(const Equations& equations, testing_symbols::Point point)
      : evaluate_(equations.program(), [point = std::move(point)](const SymbolPointer& symbol) {
          if (symbol->kind == SymbolKind::pi) return Real::pi();
          const auto place = point.find(symbol->name);
          return place == point.end() ? Real(0) : place->second;
        }) {}
  Real operator()(const Value& value) { return evaluate_(value); }
  double in_double(const Value& value) { return evaluate_(value).to_double(); }

 private:
  Evaluator<Real> evaluate_;
};

}  // namespace torsor::testing_mechanisms
