// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/evaluation.hpp"

#include <algorithm>
#include <random>

namespace torsor {

template class Evaluator<double>;
template class Evaluator<Real>;

std::vector<bool> vanish(const std::vector<Value>& values) {
  std::vector<bool> result;
  for (const Value& value : values) result.push_back(value.is_zero() || !value.is_constant());
  const auto with_program =
      std::find_if(values.begin(), values.end(), [](const Value& v) { return v.program() != nullptr && !v.is_zero(); });
  if (with_program == values.end()) return result;
  constexpr int digits = 60;
  const WorkingDigits precision(digits);
  const Real smallest(Number(10).pow(-40), digits);
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  for (int trial = 0; trial < 3; ++trial) {
    // Around one, so that lengths and masses stay meaningful. What moves is positive, then negative, then either:
    // sqrt(x^2) is not x.
    const auto draw = [&](bool moves) {
      const long size = static_cast<long>(random() % 9000U) + 1000;
      const bool negative = moves && (trial == 1 || (trial == 2 && size % 2 == 0));
      return Real(Number::rational(negative ? -size : size, 7919), digits);
    };
    std::unordered_map<const Symbol*, Real> state;
    Evaluator<Real> evaluate(*with_program->program(), [&](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi(digits);
      if (const auto known = state.find(symbol.get()); known != state.end()) return known->second;
      if (const auto attitude = symbol->attitude.lock()) {
        Real square(0);
        for (const SymbolPointer& e : attitude->e) {
          state[e.get()] = draw(true);
          square += state[e.get()] * state[e.get()];
        }
        for (const SymbolPointer& e : attitude->e) state[e.get()] /= sqrt(square);
        return state[symbol.get()];
      }
      return state[symbol.get()] = draw(symbol->kind != SymbolKind::parameter && symbol->kind != SymbolKind::time);
    });
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!result[i] || values[i].is_zero()) continue;
      const Real number = evaluate(values[i]);
      result[i] = !number.is_nan() && abs(number) <= smallest;
    }
  }
  return result;
}

void clear_vanishing(std::vector<Value>& values) {
  const std::vector<bool> zero = vanish(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (zero[i]) values[i] = Value();
  }
}

void clear_vanishing(std::vector<std::vector<Value>>& matrix) {
  std::vector<Value> all;
  for (const auto& row : matrix) all.insert(all.end(), row.begin(), row.end());
  clear_vanishing(all);
  std::size_t k = 0;
  for (auto& row : matrix) {
    for (Value& entry : row) entry = all[k++];
  }
}

bool vanishes(const Value& value) {
  if (value.is_zero()) return true;
  return !value.is_constant() && vanish({value})[0];
}

}  // namespace torsor
