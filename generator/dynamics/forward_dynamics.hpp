// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/expression/program.hpp"

namespace torsor {

using ValueMatrix = std::vector<std::vector<Value>>;

/// L D Lᵀ of a symmetric matrix, unrolled; entries that vanish identically cost nothing.
class Factorisation {
 public:
  Factorisation(Program& program, const ValueMatrix& symmetric);
  std::vector<Value> solve(const std::vector<Value>& right_side) const;
  /// (pivot d_k, diagonal entry it came from), for the caller to test.
  const std::vector<std::pair<Value, Value>>& pivots() const { return pivots_; }

 private:
  Program* program_;
  ValueMatrix lower_;
  std::vector<Value> inverse_pivots_;
  std::vector<std::pair<Value, Value>> pivots_;
};

/// Solution of M a = f + Σ_j λ_j column_j, Σ a_ji a_i + γ_j = 0 through the Schur complement A M⁻¹ B.
struct ForwardSolution {
  std::vector<Value> accelerations;
  std::vector<Value> multipliers;
  std::vector<std::pair<Value, Value>> pivots;  ///< of M, then of the Schur complement
  std::string method;                           ///< how it was solved, in words
};
ForwardSolution solve_forward(Program& program, const ValueMatrix& mass, const std::vector<Value>& force,
                              const ValueMatrix& jacobian, const ValueMatrix& columns,
                              const std::vector<Value>& gamma);

}  // namespace torsor
