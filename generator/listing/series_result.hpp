// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/program/series_program.hpp"

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
  /// Coefficients and constants that are read: not all that the program has, since the equations are solved without
  /// their terms in the accelerations themselves, and sums that are known at the start are not added up again.
  std::vector<Polynomial> coefficients(const SeriesProgram& program) const;
  /// By node: whether coefficients of higher orders read it with the accelerations that were found.
  std::vector<bool> wanted(const SeriesProgram& program) const;
};

/// A function that gives Taylor coefficients. The outputs of the program are the rates of the state, or, with a solve,
/// the rates of the positions and the left sides of the equations.
struct SeriesResult {
  SeriesProgram program;
  std::vector<SymbolPointer> state;  ///< positions, then velocities
  std::optional<SeriesSolve> solve{};
};

}  // namespace torsor
