// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/condition.hpp"

#include <algorithm>
#include <cmath>

#include "generator/verification/dense_linear.hpp"

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
  const std::size_t n = matrix.size;
  const LuFactorisation lu(matrix.entries, static_cast<int>(n));
  Square result(n);
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Real> unit(n, Real(0));
    unit[j] = Real(1);
    const std::vector<Real> column = lu.solve(unit);
    for (std::size_t i = 0; i < n; ++i) result(i, j) = column[i];
  }
  return result;
}

double norm(const Square& matrix) {
  double largest = 0;
  for (std::size_t j = 0; j < matrix.size; ++j) {
    double column = 0;
    for (std::size_t i = 0; i < matrix.size; ++i) column += std::abs(matrix(i, j).to_double());
    largest = std::max(largest, column);
  }
  return largest;
}

double condition_number(const Square& matrix) { return norm(matrix) * norm(inverse(matrix)); }

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
  Square partition(n);
  for (std::size_t k = 0; k < m; ++k) {
    const std::vector<Real> row = scaled.row(k);
    for (std::size_t i = 0; i < n; ++i) partition(k, i) = row[i];
  }
  for (std::size_t k = 0; k < freedoms.velocities.size(); ++k) partition(m + k, freedoms.velocities[k]) = Real(1);
  const Square basis = inverse(partition);  // its last columns are N

  Square reduced(freedoms.velocities.size());
  for (std::size_t a = 0; a < reduced.size; ++a) {
    for (std::size_t i = 0; i < n; ++i) {
      Real row(0);
      for (std::size_t j = 0; j < n; ++j) row += scaled.mass(i, j) * basis(j, m + a);
      for (std::size_t b = 0; b < reduced.size; ++b) reduced(b, a) += basis(i, m + b) * row;
    }
  }
  std::vector<Real> root;
  for (std::size_t a = 0; a < reduced.size; ++a) root.push_back(sqrt(abs(reduced(a, a))));
  for (std::size_t a = 0; a < reduced.size; ++a) {
    for (std::size_t b = 0; b < reduced.size; ++b) reduced(a, b) = reduced(a, b) / (root[a] * root[b]);
  }
  return norm(partition) * norm(basis) * condition_number(reduced);
}

}  // namespace torsor
