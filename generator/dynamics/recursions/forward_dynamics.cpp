// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

Factorisation::Factorisation(Program& program, const ValueMatrix& symmetric)
    : program_(&program), flattening_(Flattening::of_matrix(program, symmetric.size())) {
  // From the last row to the first (M = Lᵀ D L): on a tree the parents' pivots come last and no entry fills in
  // (Featherstone, Rigid Body Dynamics Algorithms, 2008, §6.5).
  const std::size_t n = symmetric.size();
  ValueMatrix rest = symmetric;
  lower_.assign(n, std::vector<Value>(n));
  inverse_pivots_.resize(n);
  pivots_.resize(n);
  for (std::size_t k = n; k-- > 0;) {
    const Value pivot = program.bind(rest[k][k], "pivot");
    pivots_[k] = {pivot, symmetric[k][k]};
    if (pivot.is_zero()) continue;  // identically singular: the caller's test of the pivot fails
    inverse_pivots_[k] = program.bind(pow(pivot, -1));
    for (std::size_t i = 0; i < k; ++i) {
      if (!rest[k][i].is_zero()) lower_[k][i] = program.bind(rest[k][i] * inverse_pivots_[k]);
    }
    for (std::size_t i = 0; i < k; ++i) {
      if (lower_[k][i].is_zero()) continue;
      for (std::size_t j = 0; j <= i; ++j) {
        if (rest[k][j].is_zero()) continue;
        rest[i][j] = program.bind(flattening_.difference(rest[i][j], lower_[k][i], rest[k][j]));
      }
    }
  }
}

std::vector<Value> Factorisation::solve(const std::vector<Value>& right_side) const {
  const std::size_t n = right_side.size();
  std::vector<Value> x = right_side;
  for (std::size_t k = n; k-- > 0;) {
    x[k] = program_->bind(x[k]);
    for (std::size_t i = 0; i < k; ++i) {
      if (lower_[k][i].is_zero() || x[k].is_zero()) continue;
      x[i] = flattening_.difference(x[i], lower_[k][i], x[k]);
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    Value sum = x[k] * inverse_pivots_[k];
    for (std::size_t i = 0; i < k; ++i) {
      if (!lower_[k][i].is_zero() && !x[i].is_zero()) sum = flattening_.difference(sum, lower_[k][i], x[i]);
    }
    x[k] = program_->bind(sum);
  }
  return x;
}

UnsymmetricFactorisation::UnsymmetricFactorisation(Program& program, const ValueMatrix& matrix)
    : program_(&program), flattening_(Flattening::of_matrix(program, matrix.size())) {
  const std::size_t n = matrix.size();
  upper_ = matrix;
  lower_.assign(n, std::vector<Value>(n));
  inverse_pivots_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Value pivot = program.bind(upper_[k][k], "pivot");
    pivots_.push_back({pivot, matrix[k][k]});
    if (pivot.is_zero()) continue;  // identically singular: the caller's test of the pivot fails
    inverse_pivots_[k] = program.bind(pow(pivot, -1));
    for (std::size_t i = k + 1; i < n; ++i) {
      if (upper_[i][k].is_zero()) continue;
      lower_[i][k] = program.bind(upper_[i][k] * inverse_pivots_[k]);
      for (std::size_t j = k + 1; j < n; ++j) {
        if (upper_[k][j].is_zero()) continue;
        upper_[i][j] = program.bind(flattening_.difference(upper_[i][j], lower_[i][k], upper_[k][j]));
      }
    }
  }
}

std::vector<Value> UnsymmetricFactorisation::solve(const std::vector<Value>& right_side) const {
  const std::size_t n = right_side.size();
  std::vector<Value> x = right_side;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (!lower_[k][i].is_zero()) x[k] = flattening_.difference(x[k], lower_[k][i], x[i]);
    }
    x[k] = program_->bind(x[k]);
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) {
      if (!upper_[k][j].is_zero()) x[k] = flattening_.difference(x[k], upper_[k][j], x[j]);
    }
    x[k] = program_->bind(program_->bind(x[k]) * inverse_pivots_[k]);
  }
  return x;
}

namespace {

// A row of A may vanish as a whole where a loop loses a constraint, and its pivot in proportion to the diagonal entry: it
// is small beside those of all rows of its unit. A pivot of 1e-12 of their sum, many roundings, leaves four digits of the
// multipliers in doubles.
std::vector<PivotTest> beside_those_of_its_unit(Program& program, const std::vector<PivotTest>& pivots) {
  std::vector<PivotTest> result;
  for (const PivotTest& of_row : pivots) {
    Value sum;
    std::size_t rows = 0;
    for (const PivotTest& other : pivots) {
      if (of_row.measure.is_zero() || other.measure.is_zero() || !(other.measure.unit() == of_row.measure.unit())) continue;
      sum += other.measure;
      ++rows;
    }
    result.push_back(rows > 1 ? PivotTest{of_row.pivot, program.bind(sum), true} : of_row);
  }
  return result;
}

Value along(const std::vector<Value>& row, const std::vector<Value>& x) {
  Value sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum += row[i] * x[i];
  return sum;
}

}  // namespace

MotionSolver::MotionSolver(Program& program, const ValueMatrix& mass, Constraints constraints)
    : program_(&program), flattening_(program), mass_(program, mass), jacobian_(std::move(constraints.jacobian)) {
  const bool friction = constraints.friction;
  // S = A M⁻¹ B.
  const std::size_t m = jacobian_.size();
  method_ = m == 0 ? "an unrolled L D L' of M" : "an unrolled L D L' of M and of the Schur complement A M^-1 A'";
  if (friction) method_ = "an unrolled L D L' of M and L U of the Schur complement A M^-1 B";
  for (const auto& column : constraints.columns) effects_.push_back(mass_.solve(column));
  ValueMatrix schur(m, std::vector<Value>(m));
  const auto entry = [&](std::size_t j, std::size_t k) {
    return program.bind(flattening_.cheaper(along(jacobian_[j], effects_[k])));
  };
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t k = 0; k < m; ++k) {
      if (friction) {
        schur[j][k] = entry(j, k);
      } else if (k <= j) {
        schur[j][k] = schur[k][j] = entry(j, k);
      }
    }
  }
  if (m == 0) return;
  if (friction) {
    schur_with_friction_.emplace(program, schur);
  } else {
    schur_.emplace(program, schur);
  }
}

ForwardSolution MotionSolver::solve(const std::vector<Value>& force, const std::vector<Value>& gamma) const {
  // S λ = −(A a0 + γ), a = a0 + M⁻¹ B λ.
  ForwardSolution solution;
  solution.accelerations = mass_.solve(force);
  solution.pivots = mass_.pivots();
  solution.method = method_;
  const std::size_t m = jacobian_.size();
  if (m == 0) return solution;
  std::vector<Value> right_side(m);
  for (std::size_t j = 0; j < m; ++j) {
    const Value sum = -(along(jacobian_[j], solution.accelerations) + gamma[j]);
    right_side[j] = program_->bind(flattening_.cheaper(sum));
  }
  const auto reduce = [&](const auto& reduced) {
    solution.multipliers = reduced.solve(right_side);
    const std::vector<PivotTest> pivots = schur_ ? beside_those_of_its_unit(*program_, reduced.pivots()) : reduced.pivots();
    solution.pivots.insert(solution.pivots.end(), pivots.begin(), pivots.end());
  };
  if (schur_) {
    reduce(*schur_);
  } else {
    reduce(*schur_with_friction_);
  }
  for (std::size_t i = 0; i < solution.accelerations.size(); ++i) {
    Value& a = solution.accelerations[i];
    for (std::size_t j = 0; j < m; ++j) a += effects_[j][i] * solution.multipliers[j];
    a = program_->bind(a);
  }
  return solution;
}

}  // namespace torsor
