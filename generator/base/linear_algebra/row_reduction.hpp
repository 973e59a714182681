// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/base/number.hpp"

namespace torsor {

template <class Field>
using Rows = std::vector<std::vector<Field>>;

/// Gaussian elimination of an array of Number, which is exact, or of Real. Pivots are taken one by one; who takes them
/// by size says what is too small to be one, for an exact array nothing but zero. (Golub & Van Loan, Matrix
/// Computations, 3.4.)
template <class Field>
class RowReduction {
 public:
  struct Pivot {
    std::size_t row, column;  ///< in the array given
  };

  /// `columns` is the length of every row; an array may have no row.
  RowReduction(Rows<Field> rows, std::size_t columns)
      : rows_(std::move(rows)), columns_(columns), order_(rows_.size()), has_pivot_(columns, false) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
  }

  /// Solves a row without pivot for a column without pivot: divides it by its entry there, and takes it from the other
  /// rows without pivot.
  void take(const Pivot& pivot) {
    std::vector<Field>& own = rows_[pivot.row];
    const Field entry = own[pivot.column];
    std::vector<std::size_t> filled;
    for (std::size_t j = 0; j < columns_; ++j) {
      if (own[j].is_zero()) continue;
      own[j] /= entry;
      filled.push_back(j);
    }
    own[pivot.column] = Field(1);
    std::iter_swap(order_.begin() + static_cast<std::ptrdiff_t>(rank()), std::find(order_.begin(), order_.end(), pivot.row));
    pivots_.push_back(pivot);
    has_pivot_[pivot.column] = true;
    for (std::size_t k = rank(); k < order_.size(); ++k) subtract(rows_[order_[k]], pivot.column, own, filled);
  }

  /// The largest entry left is the next pivot, as long as it is above `negligible`: complete pivoting.
  void take_largest(const Field& negligible, std::size_t most = std::numeric_limits<std::size_t>::max()) {
    while (rank() < most) {
      std::optional<Pivot> best;
      Field size = negligible;
      for (std::size_t k = rank(); k < order_.size(); ++k) {
        for (std::size_t j = 0; j < columns_; ++j) keep_larger({order_[k], j}, size, best);
      }
      if (!best) return;
      take(*best);
    }
  }

  /// Column after column in that order, the largest entry left in it where that is above `negligible`.
  void take_in_order(const std::vector<std::size_t>& columns, const Field& negligible = Field(0)) {
    for (const std::size_t column : columns) {
      std::optional<Pivot> best;
      Field size = negligible;
      for (std::size_t k = rank(); k < order_.size(); ++k) keep_larger({order_[k], column}, size, best);
      if (best) take(*best);
    }
  }

  const std::vector<Pivot>& pivots() const { return pivots_; }
  std::size_t rank() const { return pivots_.size(); }
  /// Whether a pivot stands in that column.
  bool has_pivot(std::size_t column) const { return has_pivot_[column]; }
  /// Rows without pivot, as the pivots have left them.
  std::vector<std::size_t> rows_left() const {
    return {order_.begin() + static_cast<std::ptrdiff_t>(rank()), order_.end()};
  }
  const Field& operator()(std::size_t row, std::size_t column) const { return rows_[row][column]; }

  /// The rows of the pivots in their order, each 1 in its own column and 0 in those of the others.
  Rows<Field> reduced() const {
    Rows<Field> result;
    for (const Pivot& pivot : pivots_) result.push_back(rows_[pivot.row]);
    for (std::size_t k = result.size(); k-- > 1;) {
      std::vector<std::size_t> filled;
      for (std::size_t j = 0; j < columns_; ++j) {
        if (!result[k][j].is_zero()) filled.push_back(j);
      }
      for (std::size_t i = 0; i < k; ++i) subtract(result[i], pivots_[k].column, result[k], filled);
    }
    return result;
  }

  /// Basis of the x for which all rows with a pivot give 0: one vector for each column without pivot, where it is 1.
  Rows<Field> null_space() const {
    const Rows<Field> solved = reduced();
    Rows<Field> basis;
    for (std::size_t free = 0; free < columns_; ++free) {
      if (has_pivot(free)) continue;
      std::vector<Field> x(columns_, Field(0));
      x[free] = Field(1);
      for (std::size_t k = 0; k < pivots_.size(); ++k) x[pivots_[k].column] = -solved[k][free];
      basis.push_back(std::move(x));
    }
    return basis;
  }

 private:
  static Number size_of(const Number& x) { return x.abs(); }
  static Real size_of(const Real& x) { return abs(x); }

  void keep_larger(const Pivot& place, Field& size, std::optional<Pivot>& best) const {
    Field here = size_of(rows_[place.row][place.column]);
    if (!(here > size)) return;
    size = std::move(here);
    best = place;
  }

  static void subtract(std::vector<Field>& row, std::size_t column, const std::vector<Field>& solved,
                       const std::vector<std::size_t>& filled) {
    if (row[column].is_zero()) return;
    const Field factor = row[column];
    for (const std::size_t j : filled) row[j] -= factor * solved[j];
    row[column] = Field(0);  // what is left there is rounding, and must not become a pivot
  }

  Rows<Field> rows_;
  std::size_t columns_;
  std::vector<std::size_t> order_;  ///< rows with pivots in the order of these, then the others
  std::vector<Pivot> pivots_;
  std::vector<bool> has_pivot_;     ///< by column
};

/// The columns 0, 1, … of an array.
inline std::vector<std::size_t> in_order(std::size_t columns) {
  std::vector<std::size_t> order(columns);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Each row with those of the identity matrix behind it.
template <class Field>
Rows<Field> beside_identity(Rows<Field> rows, std::size_t columns) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].resize(columns + rows.size(), Field(0));
    rows[k][columns + k] = Field(1);
  }
  return rows;
}

}  // namespace torsor
