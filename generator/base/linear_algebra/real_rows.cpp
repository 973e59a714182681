// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/real_rows.hpp"

#include "torsor/generator/base/linear_algebra/orthonormal_rows.hpp"

namespace torsor {
namespace {

Real largest_entry(const RealRows& rows) {
  Real largest;
  for (const RealRow& row : rows) {
    for (const Real& entry : row) largest = std::max(largest, abs(entry));
  }
  return largest;
}

}  // namespace

Real power_of_ten(int exponent) { return Real(Number(10).pow(exponent), Real::working_digits()); }

Real product(const RealRow& a, const RealRow& b) {
  Real sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Real length(const RealRow& a) { return sqrt(product(a, a)); }

RealRow combination(const RealRow& weights, const RealRows& rows, std::size_t columns) {
  RealRow sum(columns, Real(0));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < columns; ++i) sum[i] += weights[k] * rows[k][i];
  }
  return sum;
}

RealRows transposed(const RealRows& rows, std::size_t columns) {
  RealRows result(columns, RealRow(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) result[j][i] = rows[i][j];
  }
  return result;
}

RowReduction<Real> reduced_by_size(const RealRows& rows, std::size_t columns, const Real& tolerance,
                                   std::size_t largest_rank) {
  RowReduction<Real> reduction(rows, columns);
  reduction.take_largest(largest_entry(rows) * tolerance, largest_rank);
  return reduction;
}

std::size_t rank(const RealRows& rows, std::size_t columns, const Real& tolerance) {
  return reduced_by_size(rows, columns, tolerance).rank();
}

RealRows null_space(const RealRows& rows, std::size_t columns, const Real& tolerance) {
  return reduced_by_size(rows, columns, tolerance).null_space();
}

RealRow least_norm_solution(const RealSystem& system, const Real& tolerance, std::size_t largest_rank) {
  const auto& [rows, right_side, columns] = system;
  OrthonormalRows independent(columns, Real(0), Real(0));  // the pivots have told which rows those are
  RealRow wanted;
  const RowReduction<Real> reduction = reduced_by_size(rows, columns, tolerance, largest_rank);
  for (const auto& [row, column] : reduction.pivots()) {
    independent.add(row, rows[row]);
    wanted.push_back(right_side[row]);
  }
  return independent.least(wanted);
}

std::optional<RealRow> solution(const RealSystem& system, const Real& tolerance) {
  const auto& [rows, right_side, columns] = system;
  RealRows both = rows;
  for (std::size_t i = 0; i < both.size(); ++i) both[i].push_back(right_side[i]);
  // A combination that vanishes on the left only is a row (0 … 0 | 1): the right side's column is then in the span of
  // no others, which the ranks tell whatever pivots were taken.
  if (rank(both, columns + 1, tolerance) != rank(rows, columns, tolerance)) return std::nullopt;
  return least_norm_solution(system, tolerance);
}

}  // namespace torsor
