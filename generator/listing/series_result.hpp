// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/program/series_program.hpp"

namespace torsor {

/// Accelerations that are found order by order from equations linear in them, M a + ... = 0: coefficient k of a is -M⁻¹
/// times coefficient k of the left side without it, M at the start.
struct SeriesSolve {
  std::vector<SymbolPointer> unknowns;    ///< accelerations
  std::vector<Value> start;               ///< their values
  std::vector<std::vector<Value>> lower;  ///< M = Lᵀ D L at the start: L below its diagonal of ones
  std::vector<Value> inverse_pivots;      ///< 1/d_k

  /// What must be known at the start besides the coefficients.
  std::vector<Value> at_start(const SeriesProgram& program) const;
};

/// A function that gives Taylor coefficients. The outputs of the program are the rates of the state, or, with a solve,
/// the rates of the positions and the left sides of the equations.
struct SeriesResult {
  SeriesProgram program;
  std::vector<SymbolPointer> state;  ///< positions, then velocities
  std::optional<SeriesSolve> solve{};
};

}  // namespace torsor
