// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

Real scaled(const Real& value, int exponent) { return Real(cln::scale_float(value.raw(), exponent)); }

}  // namespace

LuFactorisation::LuFactorisation(std::vector<Real> column_major, int size)
    : size_(size), factors_(std::move(column_major)) {
  if (size < 0 || factors_.size() != static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {
    throw UsageError("a linear system of size " + std::to_string(size) +
                     " needs the square of that many entries, not " + std::to_string(factors_.size()));
  }
  const auto entry = [this](int row, int column) -> Real& {
    return factors_[static_cast<std::size_t>(row) + static_cast<std::size_t>(column) * static_cast<std::size_t>(size_)];
  };
  for (int row = 0; row < size; ++row) {
    Real largest;
    for (int column = 0; column < size; ++column) {
      if (entry(row, column).is_nan()) {
        throw Error("entry (" + std::to_string(row) + ", " + std::to_string(column) +
                    ") of a linear system is not a number: check what it was computed from");
      }
      largest = std::max(largest, abs(entry(row, column)));
    }
    const int exponent = largest.is_zero() ? 0 : -static_cast<int>(cln::float_exponent(largest.raw()));
    for (int column = 0; column < size; ++column) entry(row, column) = scaled(entry(row, column), exponent);
    row_exponents_.push_back(exponent);
    permutation_.push_back(row);
  }
  std::vector<Real> column_sizes(static_cast<std::size_t>(size));
  for (int column = 0; column < size; ++column) {
    Real& largest = column_sizes[static_cast<std::size_t>(column)];
    for (int row = 0; row < size; ++row) largest = std::max(largest, abs(entry(row, column)));
  }
  for (int pivot = 0; pivot < size; ++pivot) {
    int best = pivot;
    for (int row = pivot + 1; row < size; ++row) {
      if (abs(entry(row, pivot)) > abs(entry(best, pivot))) best = row;
    }
    const Real& column_size = column_sizes[static_cast<std::size_t>(pivot)];
    if (!(abs(entry(best, pivot)) > column_size * column_size.epsilon() * Real(size))) {
      throw Error("a linear system of size " + std::to_string(size) + " is singular: pivot " + std::to_string(pivot) +
                  " is " + entry(best, pivot).to_string(3) + "; unknown " + std::to_string(pivot) +
                  " depends on the ones before it, remove a redundant equation or constraint");
    }
    for (int column = 0; column < size; ++column) std::swap(entry(pivot, column), entry(best, column));
    std::swap(permutation_[static_cast<std::size_t>(pivot)], permutation_[static_cast<std::size_t>(best)]);
    for (int row = pivot + 1; row < size; ++row) {
      entry(row, pivot) /= entry(pivot, pivot);
      for (int column = pivot + 1; column < size; ++column) {
        entry(row, column) -= entry(row, pivot) * entry(pivot, column);
      }
    }
  }
}

std::vector<Real> LuFactorisation::solve(const std::vector<Real>& right_side) const {
  if (right_side.size() != static_cast<std::size_t>(size_)) {
    throw UsageError("a linear system of size " + std::to_string(size_) + " was given a right-hand side of length " +
                     std::to_string(right_side.size()));
  }
  const auto size = static_cast<std::size_t>(size_);
  std::vector<Real> unknowns(size);
  for (std::size_t row = 0; row < size; ++row) {
    const auto source = static_cast<std::size_t>(permutation_[row]);
    const Real& given = right_side[source];
    Real sum = given.is_nan() ? given : scaled(given, row_exponents_[source]);
    for (std::size_t column = 0; column < row; ++column) sum -= factors_[row + column * size] * unknowns[column];
    unknowns[row] = sum;
  }
  for (std::size_t row = size; row-- > 0;) {
    for (std::size_t column = row + 1; column < size; ++column) {
      unknowns[row] -= factors_[row + column * size] * unknowns[column];
    }
    unknowns[row] /= factors_[row + row * size];
  }
  return unknowns;
}

std::vector<Real> LuFactorisation::inverse() const {
  std::vector<Real> entries;
  for (int j = 0; j < size_; ++j) {
    std::vector<Real> unit(static_cast<std::size_t>(size_), Real(0));
    unit[static_cast<std::size_t>(j)] = Real(1);
    const std::vector<Real> column = solve(unit);
    entries.insert(entries.end(), column.begin(), column.end());
  }
  return entries;
}

double norm_of_columns(const std::vector<Real>& column_major, std::size_t rows, std::size_t first) {
  double largest = 0;
  for (std::size_t k = first * rows; k < column_major.size(); k += rows) {
    double column = 0;
    for (std::size_t i = 0; i < rows; ++i) column += std::abs(column_major[k + i].to_double());
    largest = std::max(largest, column);
  }
  return largest;
}

double condition_number(const std::vector<Real>& column_major, int size) {
  const auto rows = static_cast<std::size_t>(size);
  return norm_of_columns(column_major, rows) * norm_of_columns(LuFactorisation(column_major, size).inverse(), rows);
}

std::vector<Real> solve_dense(std::vector<Real> column_major, const std::vector<Real>& right_side) {
  return LuFactorisation(std::move(column_major), static_cast<int>(right_side.size())).solve(right_side);
}

}  // namespace torsor
