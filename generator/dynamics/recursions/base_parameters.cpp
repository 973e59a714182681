// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/recursions/base_parameters.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/mechanics/parameter_value.hpp"
#include "generator/program/evaluation.hpp"
#include "generator/program/generic_state.hpp"

namespace torsor {
namespace {

using Column = std::vector<Real>;

/// Digits to work in, and the part of a column's size that is nothing in them.
struct Arithmetic {
  int digits;
  double negligible;
};

/// Lengths and angles that are small, and products of them, make columns nearly dependent: what 50 digits do not tell from
/// rounding, the further ones do.
constexpr std::array<Arithmetic, 2> arithmetics{{{50, BaseParameters::tolerance}, {200, 1e-90}}};

enum class Parameters { as_given, varied };

/// Y at one pseudo-random state after another.
class RegressorSamples {
 public:
  RegressorSamples(const Model& model, const ValueMatrix& y, int digits)
      : model_(model), y_(y), digits_(digits), random_(1991), evaluate_(model.program(), {}) {}

  /// Appends the rows of Y at a further state to its columns.
  void append(std::vector<Column>& columns, Parameters parameters) {
    constexpr int attempts = 64;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      move(parameters, attempt % 2 == 1);
      std::vector<Column> rows;
      bool defined = true;
      for (const std::vector<Value>& row : y_) {
        rows.push_back(evaluate_(row));
        for (const Real& entry : rows.back()) defined = defined && !entry.is_nan();
      }
      if (!defined) continue;
      for (const Column& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
      }
      return;
    }
    throw SceneError(
        fmt::format("the regressor is undefined at each of {} states: let the initial configuration be one where the "
                    "formulas of all joints are defined, and their neighbourhood too",
                    attempts));
  }

  bool has_parameters() const { return has_parameters_; }

 private:
  /// Between −2 and 2, few digits.
  Real draw() { return Real(Number::rational(static_cast<long>(random_() % 16001U) - 8000, 4001), digits_); }

  /// Any state, or one near the initial one: formulas like √(l² − x²) are not defined everywhere.
  void move(Parameters parameters, bool near) {
    values_.clear();
    evaluate_.move_to([this, parameters, near](const SymbolPointer& symbol) {
      return at_unit_quaternions(symbol, [&](const SymbolPointer& each) { return value(each, parameters, near); });
    });
  }

  const Real& value(const SymbolPointer& symbol, Parameters parameters, bool near) {
    const auto [place, added] = values_.try_emplace(symbol.get());
    if (!added) return place->second;
    const bool parameter = symbol->kind == SymbolKind::parameter;
    has_parameters_ = has_parameters_ || parameter;
    if (!parameter && !near) {
      place->second = draw();
      return place->second;
    }
    const Real given = initial_value(model_.scene(), symbol, true);
    if (parameter && parameters == Parameters::as_given) {
      place->second = given;
    } else {
      const Real step = draw() / Real(16);
      place->second = parameter && !given.is_zero() ? given + given * step : given + step;
    }
    return place->second;
  }

  const Model& model_;
  const ValueMatrix& y_;
  int digits_;
  std::mt19937_64 random_;
  std::unordered_map<const Symbol*, Real> values_;
  Evaluator<Real> evaluate_;
  bool has_parameters_ = false;
};

/// Gaussian elimination by columns, each against those kept before it, pivots the largest entries left.
class ColumnElimination {
 public:
  ColumnElimination(std::size_t rows, Real negligible) : negligible_(std::move(negligible)), taken_(rows, false) {}

  /// Keeps an independent column; of a dependent one, returns false and leaves its coefficients on the kept ones.
  bool add(Column column) {
    coefficients_.assign(kept_.size(), Real(0));
    Real size(0);
    for (const Real& entry : column) size = std::max(size, abs(entry));
    if (size.is_zero()) return false;
    for (Real& entry : column) entry /= size;
    Column upper;
    for (const Kept& other : kept_) {
      const Real factor = column[other.pivot];
      upper.push_back(factor);
      if (factor.is_zero()) continue;
      for (const auto& [row, entry] : other.lower) column[row] -= factor * entry;
    }
    std::size_t pivot = column.size();
    for (std::size_t r = 0; r < column.size(); ++r) {
      if (!taken_[r] && (pivot == column.size() || abs(column[r]) > abs(column[pivot]))) pivot = r;
    }
    if (pivot == column.size() || !(abs(column[pivot]) > negligible_)) {
      solve(upper, size);
      return false;
    }
    taken_[pivot] = true;
    Kept kept{pivot, size, column[pivot], {}, std::move(upper)};
    for (std::size_t r = 0; r < column.size(); ++r) {
      if (!taken_[r] && !column[r].is_zero()) kept.lower.emplace_back(r, column[r] / kept.diagonal);
    }
    kept_.push_back(std::move(kept));
    return true;
  }

  const std::vector<Real>& coefficients() const { return coefficients_; }

 private:
  struct Kept {
    std::size_t pivot;
    Real size, diagonal;
    std::vector<std::pair<std::size_t, Real>> lower;  ///< (row, entry) under a pivot of one
    Column upper;                                     ///< on the columns kept before
  };

  void solve(Column& upper, const Real& size) {
    for (std::size_t k = kept_.size(); k-- > 0;) {
      const Real factor = upper[k] / kept_[k].diagonal;
      if (!(abs(factor) > negligible_)) continue;
      for (std::size_t i = 0; i < k; ++i) upper[i] -= factor * kept_[k].upper[i];
      coefficients_[k] = factor * size / kept_[k].size;
    }
  }

  Real negligible_;
  std::vector<bool> taken_;
  std::vector<Kept> kept_;
  std::vector<Real> coefficients_;
};

BaseParameters eliminate(const std::vector<Column>& columns, const Real& negligible) {
  BaseParameters result;
  ColumnElimination elimination(columns.front().size(), negligible);
  std::vector<std::vector<Real>> found;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (elimination.add(columns[c])) {
      result.independent.push_back(c);
    } else {
      result.dependent.push_back(c);
      found.push_back(elimination.coefficients());
    }
  }
  result.combination.assign(result.independent.size(), std::vector<Real>(found.size(), Real(0)));
  for (std::size_t d = 0; d < found.size(); ++d) {
    for (std::size_t b = 0; b < found[d].size(); ++b) result.combination[b][d] = found[d][b];
  }
  return result;
}

/// Whether Y_d = Y_b K there.
bool holds(const BaseParameters& base, const std::vector<Column>& columns, const Real& negligible) {
  for (std::size_t d = 0; d < base.dependent.size(); ++d) {
    for (std::size_t r = 0; r < columns.front().size(); ++r) {
      Real rest = columns[base.dependent[d]][r];
      Real size = abs(rest);
      for (std::size_t b = 0; b < base.independent.size(); ++b) {
        if (base.combination[b][d].is_zero()) continue;
        const Real part = base.combination[b][d] * columns[base.independent[b]][r];
        rest -= part;
        size += abs(part);
      }
      if (abs(rest) > size * negligible) return false;
    }
  }
  return true;
}

/// What holds in that arithmetic, nothing where none holds.
std::optional<BaseParameters> base_parameters_in(const Arithmetic& arithmetic, const Model& model, const ValueMatrix& y) {
  const WorkingDigits precision(arithmetic.digits);
  const Real negligible = Real::from_double(arithmetic.negligible);
  const std::size_t count = y.front().size();
  RegressorSamples samples(model, y, arithmetic.digits);
  std::vector<Column> columns(count);
  const auto further = [&](Parameters parameters) {
    std::vector<Column> others(count);
    for (int state = 0; state < 3; ++state) samples.append(others, parameters);
    return others;
  };
  // A few states more than it takes where rows and columns are spread evenly; a trunk that carries many branches
  // needs more. A relation that is none fails at a further state with probability one.
  std::size_t wanted = count / y.size() + 3;
  std::vector<std::size_t> before;
  for (int attempt = 0; attempt < 8; ++attempt, wanted *= 2) {
    while (columns.front().size() < wanted * y.size()) samples.append(columns, Parameters::as_given);
    BaseParameters base = eliminate(columns, negligible);
    if (!holds(base, further(Parameters::as_given), negligible)) {
      if (base.independent == before) return std::nullopt;  // more states do not change the choice: digits are missing
      before = std::move(base.independent);
      continue;
    }
    if (samples.has_parameters()) base.at_any_parameters = holds(base, further(Parameters::varied), negligible);
    return base;
  }
  return std::nullopt;
}

}  // namespace

BaseParameters base_parameters(const Model& model, const ValueMatrix& y) {
  if (y.empty() || y.front().empty()) return {};
  for (const Arithmetic& arithmetic : arithmetics) {
    if (std::optional<BaseParameters> base = base_parameters_in(arithmetic, model, y)) return *std::move(base);
  }
  throw Error(
      fmt::format("no relations between the {} inertial parameters hold at further states to {}: lengths of the "
                  "mechanism differ too much in size; leave the kernel 'regressor' out",
                  y.front().size(), arithmetics.back().negligible));
}

}  // namespace torsor
