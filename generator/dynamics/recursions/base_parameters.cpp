// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/base_parameters.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

using Column = RealRow;

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

/// Columns divided by their largest entries, each against those kept before it.
BaseParameters eliminate(const std::vector<Column>& columns, const Real& negligible) {
  std::vector<Real> sizes;
  RealRows scaled;
  for (const Column& column : columns) {
    Real size(0);
    for (const Real& entry : column) size = std::max(size, abs(entry));
    sizes.push_back(size.is_zero() ? Real(1) : size);
    scaled.push_back(column);
    for (Real& entry : scaled.back()) entry /= sizes.back();
  }
  RowReduction<Real> reduction(transposed(scaled, columns.front().size()), columns.size());
  reduction.take_in_order(in_order(columns.size()), negligible);
  BaseParameters result;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    (reduction.has_pivot(c) ? result.independent : result.dependent).push_back(c);
  }
  const RealRows reduced = reduction.reduced();  // in the order of the columns
  for (std::size_t b = 0; b < reduced.size(); ++b) {
    result.combination.emplace_back();
    for (const std::size_t d : result.dependent) {
      const Real part = abs(reduced[b][d]) > negligible ? reduced[b][d] : Real(0);
      result.combination.back().push_back(part * sizes[d] / sizes[result.independent[b]]);
    }
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
std::optional<BaseParameters> base_parameters_in(const ZeroTest& arithmetic, const Model& model, const ValueMatrix& y) {
  const WorkingDigits precision(arithmetic.digits);
  const Real negligible = arithmetic.bound();
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
  constexpr ZeroTest arithmetics[] = {zero_tests::regressor, zero_tests::regressor_of_small_lengths};
  for (const ZeroTest& arithmetic : arithmetics) {
    if (std::optional<BaseParameters> base = base_parameters_in(arithmetic, model, y)) return *std::move(base);
  }
  throw Error(
      fmt::format("no relations between the {} inertial parameters hold at further states to 1e-{}: lengths of the "
                  "mechanism differ too much in size; leave the kernel 'regressor' out",
                  y.front().size(), zero_tests::regressor_of_small_lengths.exponent));
}

}  // namespace torsor
