// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/evaluation.hpp"

#include <algorithm>
#include <random>

namespace torsor {

bool vanishes(const Value& value) {
  if (value.is_zero()) return true;
  if (value.is_constant()) return false;
  constexpr int digits = 60;
  const WorkingDigits precision(digits);
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  for (int trial = 0; trial < 3; ++trial) {
    std::unordered_map<const Symbol*, Real> state;
    Evaluator<Real> evaluate(*value.program(), [&](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi(digits);
      const auto [place, added] = state.try_emplace(symbol.get());
      // Positive numbers around one: lengths and masses stay meaningful.
      if (added) place->second = Real(Number::rational(static_cast<long>(random() % 9000U) + 1000, 7919), digits);
      return place->second;
    });
    const Real result = evaluate(value);
    if (result.is_nan() || abs(result) > Real(Number(10).pow(-40), digits)) return false;
  }
  return true;
}

}  // namespace torsor
