// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/base/real_elimination.hpp"

#include <algorithm>
#include <utility>

namespace torsor {
namespace {

Real largest_entry(const RealRows& rows) {
  Real largest;
  for (const RealRow& row : rows) {
    for (const Real& entry : row) largest = std::max(largest, abs(entry));
  }
  return largest;
}

Real product(const RealRow& a, const RealRow& b) {
  Real sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

Real power_of_ten(int exponent) { return Real(Number(10).pow(exponent), Real::working_digits()); }

RowReduction eliminate(RealRows rows, int columns, const Real& tolerance, int largest_rank) {
  RowReduction result;
  const Real floor = largest_entry(rows) * tolerance;
  std::vector<int> origin(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) origin[i] = static_cast<int>(i);
  const auto width = static_cast<std::size_t>(columns);
  for (std::size_t step = 0; step < rows.size(); ++step) {
    if (largest_rank >= 0 && static_cast<int>(step) == largest_rank) break;
    std::size_t best_row = step, best_column = 0;
    Real best;
    for (std::size_t i = step; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        const Real size = abs(rows[i][j]);
        if (size > best) best = size, best_row = i, best_column = j;
      }
    }
    if (!(best > floor)) break;
    std::swap(rows[step], rows[best_row]);
    std::swap(origin[step], origin[best_row]);
    const Real pivot = rows[step][best_column];
    for (Real& entry : rows[step]) entry /= pivot;
    rows[step][best_column] = Real(1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == step || rows[i][best_column].is_zero()) continue;
      const Real factor = rows[i][best_column];
      for (std::size_t j = 0; j < width; ++j) rows[i][j] -= factor * rows[step][j];
      rows[i][best_column] = Real(0);  // what is left there is rounding, and must not become a pivot
    }
    result.pivot_columns.push_back(static_cast<int>(best_column));
    result.pivot_rows.push_back(origin[step]);
    ++result.rank;
  }
  rows.resize(static_cast<std::size_t>(result.rank));
  result.reduced = std::move(rows);
  return result;
}

int rank(const RealRows& rows, int columns, const Real& tolerance) { return eliminate(rows, columns, tolerance).rank; }

RealRows kernel(const RealRows& rows, int columns, const Real& tolerance) {
  const RowReduction found = eliminate(rows, columns, tolerance);
  std::vector<int> row_of(static_cast<std::size_t>(columns), -1);
  for (std::size_t k = 0; k < found.pivot_columns.size(); ++k) {
    row_of[static_cast<std::size_t>(found.pivot_columns[k])] = static_cast<int>(k);
  }
  RealRows basis;
  for (std::size_t free = 0; free < row_of.size(); ++free) {
    if (row_of[free] >= 0) continue;
    RealRow x(row_of.size(), Real(0));
    x[free] = Real(1);
    for (std::size_t j = 0; j < row_of.size(); ++j) {
      if (row_of[j] >= 0) x[j] = -found.reduced[static_cast<std::size_t>(row_of[j])][free];
    }
    basis.push_back(std::move(x));
  }
  return basis;
}

RealRows transposed(const RealRows& rows, int columns) {
  RealRows result(static_cast<std::size_t>(columns), RealRow(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) result[j][i] = rows[i][j];
  }
  return result;
}

std::optional<RealRow> solution(const RealRows& rows, const RealRow& right_side, int columns, const Real& tolerance) {
  RealRows both = rows;
  for (std::size_t i = 0; i < both.size(); ++i) both[i].push_back(right_side[i]);
  const RowReduction found = eliminate(both, columns + 1, tolerance);
  // A combination that vanishes on the left only is a row (0 … 0 | 1): the right side's column is then in the span of
  // no others, which the ranks tell whatever pivots were taken.
  if (found.rank != rank(rows, columns, tolerance)) return std::nullopt;
  return least_norm_solution(rows, right_side, columns, tolerance);
}

RealRow least_norm_solution(const RealRows& rows, const RealRow& right_side, int columns, const Real& tolerance,
                            int largest_rank) {
  // x = Cᵀ y with C the independent rows: C Cᵀ y = c.
  const RowReduction found = eliminate(rows, columns, tolerance, largest_rank);
  const std::size_t n = found.pivot_rows.size();
  RealRows normal(n, RealRow(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(found.pivot_rows[i]);
    for (std::size_t j = 0; j < n; ++j)
      normal[i][j] = product(rows[row], rows[static_cast<std::size_t>(found.pivot_rows[j])]);
    normal[i][n] = right_side[row];
  }
  RealRow x(static_cast<std::size_t>(columns), Real(0));
  for (std::size_t step = 0; step < n; ++step) {  // positive definite: no pivoting needed
    for (std::size_t i = step + 1; i < n; ++i) {
      const Real factor = normal[i][step] / normal[step][step];
      for (std::size_t j = step; j <= n; ++j) normal[i][j] -= factor * normal[step][j];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) normal[i][n] -= normal[i][j] * normal[j][n];
    normal[i][n] /= normal[i][i];
    const RealRow& row = rows[static_cast<std::size_t>(found.pivot_rows[i])];
    for (std::size_t j = 0; j < x.size(); ++j) x[j] += normal[i][n] * row[j];
  }
  return x;
}

}  // namespace torsor
