// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/program/flattening.hpp"
#include "torsor/generator/program/pivot_test.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

using ValueMatrix = std::vector<std::vector<Value>>;

/// L D Lᵀ of a symmetric matrix, unrolled; entries that vanish identically cost nothing. Small entries are multiplied
/// out where that shows what cancels in a pivot: next to a locked angle nothing else is left of it.
class Factorisation {
 public:
  Factorisation(Program& program, const ValueMatrix& symmetric);
  std::vector<Value> solve(const std::vector<Value>& right_side) const;
  /// (pivot d_k, diagonal entry it came from), for the caller to test.
  const std::vector<PivotTest>& pivots() const { return pivots_; }
  /// M = Lᵀ D L: L below its diagonal of ones, and 1/d_k.
  const ValueMatrix& lower() const { return lower_; }
  const std::vector<Value>& inverse_pivots() const { return inverse_pivots_; }

 private:
  Program* program_;
  mutable Flattening flattening_;  ///< remembers what it has multiplied out
  ValueMatrix lower_;
  std::vector<Value> inverse_pivots_;
  std::vector<PivotTest> pivots_;
};

/// L U of a matrix that need not be symmetric, unrolled, without exchange of rows. Where the pivots must be positive it
/// is enough: they are when all principal minors are, which is what a motion with friction needs to exist and be unique
/// (P-matrix; Painlevé's paradox otherwise).
class UnsymmetricFactorisation {
 public:
  UnsymmetricFactorisation(Program& program, const ValueMatrix& matrix);
  std::vector<Value> solve(const std::vector<Value>& right_side) const;
  const std::vector<PivotTest>& pivots() const { return pivots_; }

 private:
  Program* program_;
  mutable Flattening flattening_;
  ValueMatrix lower_, upper_;
  std::vector<Value> inverse_pivots_;
  std::vector<PivotTest> pivots_;
};

/// What a motion is solved for.
struct ForwardSolution {
  std::vector<Value> accelerations;
  std::vector<Value> multipliers;
  std::vector<PivotTest> pivots;  ///< of M, then of the Schur complement
  std::string method;                           ///< how it was solved, in words
};

/// M a = f + Σ_j λ_j column_j, Σ a_ji a_i + γ_j = 0 through the Schur complement A M⁻¹ B, for any number of right
/// sides. The complement is symmetric when every column equals its row of A, and is then solved by L D Lᵀ; with friction
/// by L U.
class MotionSolver {
 public:
  struct Constraints {
    ValueMatrix jacobian;   ///< A, row by row
    ValueMatrix columns;    ///< B, one for each row of A
    bool friction = false;  ///< whether a column is another than its row
  };
  MotionSolver(Program& program, const ValueMatrix& mass, Constraints constraints);
  ForwardSolution solve(const std::vector<Value>& force, const std::vector<Value>& gamma) const;

 private:
  Program* program_;
  mutable Flattening flattening_;
  Factorisation mass_;
  ValueMatrix jacobian_;
  ValueMatrix effects_;  ///< M⁻¹ column_j
  std::optional<Factorisation> schur_;
  std::optional<UnsymmetricFactorisation> schur_with_friction_;
  std::string method_;
};

}  // namespace torsor
