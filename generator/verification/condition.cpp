// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/condition.hpp"

#include <algorithm>

#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"

namespace torsor {
namespace {

/// Square, column by column.
struct Square {
  explicit Square(std::size_t n) : size(n), entries(n * n, Real(0)) {}
  Real& operator()(std::size_t i, std::size_t j) { return entries[i + j * size]; }
  const Real& operator()(std::size_t i, std::size_t j) const { return entries[i + j * size]; }

  std::size_t size;
  std::vector<Real> entries;
};

Square inverse(const Square& matrix) {
  Square result(matrix.size);
  result.entries = LuFactorisation(matrix.entries, static_cast<int>(matrix.size)).inverse();
  return result;
}

/// Of the columns from the first one given.
double norm(const Square& matrix, std::size_t first = 0) { return norm_of_columns(matrix.entries, matrix.size, first); }

double condition_number(const Square& matrix) {
  return torsor::condition_number(matrix.entries, static_cast<int>(matrix.size));
}

/// M and the constraints kept, at one state and in the metric of the diagonal of M.
class Scaled {
 public:
  Scaled(const Equations& equations, Evaluator<Real>& exact)
      : equations_(equations), exact_(exact), n_(equations.mass().size()) {
    for (std::size_t i = 0; i < n_; ++i) root_.push_back(sqrt(abs(exact(equations.mass()[i][i]))));
    if (!equations.constraints().empty()) kept_ = equations.redundancy().kept;
  }

  std::size_t freedoms() const { return n_; }
  std::size_t constraints() const { return kept_.size(); }
  Real mass(std::size_t i, std::size_t j) const { return exact_(equations_.mass()[i][j]) / (root_[i] * root_[j]); }
  double mass_norm() const {
    Square all(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) all(i, j) = mass(i, j);
    }
    return norm(all);
  }
  bool holonomic(std::size_t k) const { return equations_.constraints()[kept_[k]].holonomic; }
  std::vector<Real> row(std::size_t k) const { return scaled(equations_.constraints()[kept_[k]].jacobian); }
  std::vector<Real> column(std::size_t k) const { return scaled(equations_.constraints()[kept_[k]].column); }

 private:
  std::vector<Real> scaled(const std::vector<Value>& values) const {
    std::vector<Real> result;
    Real square(0);
    for (std::size_t i = 0; i < n_; ++i) {
      result.push_back(exact_(values[i]) / root_[i]);
      square += result[i] * result[i];
    }
    for (Real& entry : result) entry = entry / sqrt(square);
    return result;
  }

  const Equations& equations_;
  Evaluator<Real>& exact_;
  std::size_t n_;
  std::vector<Real> root_;
  std::vector<std::size_t> kept_;
};

}  // namespace

double motion_condition(const Equations& equations, Evaluator<Real>& exact) {
  const Scaled scaled(equations, exact);
  const std::size_t n = scaled.freedoms();
  Square all(n + scaled.constraints());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) all(i, j) = scaled.mass(i, j);
  }
  for (std::size_t k = 0; k < scaled.constraints(); ++k) {
    const std::vector<Real> row = scaled.row(k);
    const std::vector<Real> column = scaled.column(k);
    for (std::size_t i = 0; i < n; ++i) {
      all(n + k, i) = row[i];
      all(i, n + k) = column[i];
    }
  }
  return condition_number(all);
}

double reduction_condition(const Equations& equations, const IndependentFreedoms& freedoms, Evaluator<Real>& exact) {
  const Scaled scaled(equations, exact);
  const std::size_t n = scaled.freedoms();
  const std::size_t m = scaled.constraints();
  Square of_rows(n);
  Square of_columns(n);
  for (std::size_t k = 0; k < m; ++k) {
    const std::vector<Real> row = scaled.row(k);
    const std::vector<Real> column = scaled.column(k);
    for (std::size_t i = 0; i < n; ++i) {
      of_rows(k, i) = row[i];
      of_columns(k, i) = column[i];
    }
  }
  for (std::size_t k = 0; k < freedoms.velocities.size(); ++k) {
    of_rows(m + k, freedoms.velocities[k]) = Real(1);
    of_columns(m + k, freedoms.velocities[k]) = Real(1);
  }
  Square of_coordinates(n);
  std::size_t placed = 0;
  for (std::size_t k = 0; k < m; ++k) {
    if (!scaled.holonomic(k)) continue;
    for (std::size_t i = 0; i < n; ++i) of_coordinates(placed, i) = of_rows(k, i);
    ++placed;
  }
  for (const std::size_t freedom : freedoms.coordinates) of_coordinates(placed++, freedom) = Real(1);
  const Square right = inverse(of_rows);  // its last columns are N
  const Square left = inverse(of_columns);

  Square reduced(freedoms.velocities.size());
  for (std::size_t a = 0; a < reduced.size; ++a) {
    for (std::size_t i = 0; i < n; ++i) {
      Real row(0);
      for (std::size_t j = 0; j < n; ++j) row += scaled.mass(i, j) * right(j, m + a);
      for (std::size_t b = 0; b < reduced.size; ++b) reduced(b, a) += left(i, m + b) * row;
    }
  }
  const double of_velocities = std::max(norm(of_rows) * norm(right), norm(of_columns) * norm(left));
  // Nᵀ M N may be small beside the products it is the sum of: |N|² |M| in the place of its own norm.
  const double of_state = norm(left, m) * scaled.mass_norm() * norm(right, m) * norm(inverse(reduced));
  return condition_number(of_coordinates) * of_velocities * of_state;
}

}  // namespace torsor
