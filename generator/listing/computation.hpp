// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/listing/series_result.hpp"
#include "torsor/generator/listing/target.hpp"
#include "torsor/generator/program/pivot_test.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// `target = value`. The same value may go to several targets.
struct Assignment {
  Target target;
  Value value;
};

/// What one function computes, as values of a program.
struct Computation {
  std::vector<Assignment> assignments;
  std::vector<PivotTest> pivots{};
  std::optional<SeriesResult> series{};  ///< of a function that gives Taylor coefficients, without assignments

  /// Whether the function returns a status.
  bool has_status() const { return series.has_value() || !pivots.empty(); }
  std::vector<Value> values() const;  ///< everything that must be computed, pivots included
};

/// The pass `zero_test`: results that vanish identically although their definitions do not show it (terms that cancel
/// across definitions) are set to zero. They cost nothing then and carry no rounding.
void clear_identically_zero(Program& program, Computation& computation);

/// Values with the limits that they have where a root in a denominator vanishes, see limits_at_roots.hpp.
void take_limits_at_roots(Program& program, Computation& computation);

/// The pass `products`: the same values with products that its sums have in common computed once (shared_products.hpp).
void share_products(Program& program, Computation& computation);

}  // namespace torsor
