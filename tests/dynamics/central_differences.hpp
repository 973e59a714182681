// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/random_state.hpp"

namespace torsor::testing_mechanisms {

/// Slopes of values of one program at a random state by central differences: what derivations have no part in.
///
/// With a step of 1e-20 in sixty digits differences are off by 1e-40 times a third derivative and by rounding, 1e-60 of
/// the values over 1e-20; third derivatives and values of the scenes here stay below 1e8.
class CentralDifferences {
 public:
  static constexpr int digits = 60;
  static constexpr double bound = 1e-30;
  using Change = std::vector<std::pair<SymbolPointer, Real>>;

  CentralDifferences(const Equations& equations, std::uint64_t seed)
      : equations_(equations), state_(equations.scene(), seed), there_(equations.program(), state_.in_real()) {}

  /// One symbol changes.
  static Change of(const SymbolPointer& symbol) { return {{symbol, Real(1)}}; }
  /// A coordinate changes, or an attitude turns about its moving axis.
  Change along(std::size_t freedom) {
    const Model& model = equations_.model();
    Change change;
    for (const SymbolPointer& q : model.positions()) {
      const Value rate = rate_along(model.program(), q, model.coordinates()[freedom].v);
      if (!rate.is_zero()) change.emplace_back(q, there_(rate));
    }
    return change;
  }

  std::vector<Real> at(const std::vector<Value>& values) { return there_(values); }

  std::vector<Real> operator()(const std::vector<Value>& values, const Change& change) {
    const Real step(Number(10).pow(-20), digits);
    const auto displaced = [&](const Real& by) {
      there_.move_to([this, change, by](const SymbolPointer& symbol) {
        Real value = state_.in_real()(symbol);
        for (const auto& [moved, rate] : change) {
          if (moved == symbol) value += by * rate;
        }
        return value;
      });
      return there_(values);
    };
    const std::vector<Real> above = displaced(step), below = displaced(-step);
    there_.move_to(state_.in_real());
    std::vector<Real> slopes;
    for (std::size_t i = 0; i < above.size(); ++i) slopes.push_back((above[i] - below[i]) / (step + step));
    return slopes;
  }

 private:
  const Equations& equations_;
  RandomState state_;
  Evaluator<Real> there_;
};

/// Largest difference, relative to 1 + the second's size.
inline double largest_difference(const std::vector<Real>& x, const std::vector<Real>& y) {
  double largest = x.size() == y.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    largest = std::max(largest, (abs(x[i] - y[i]) / (Real(1) + abs(y[i]))).to_double());
  }
  return largest;
}

inline std::vector<Value> column(const ValueMatrix& matrix, std::size_t k) {
  std::vector<Value> all;
  for (const auto& row : matrix) all.push_back(row[k]);
  return all;
}

inline std::vector<Value> flattened(const ValueMatrix& matrix) {
  std::vector<Value> all;
  for (const auto& row : matrix) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace torsor::testing_mechanisms
