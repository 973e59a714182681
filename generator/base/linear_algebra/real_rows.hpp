// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "torsor/generator/base/linear_algebra/row_reduction.hpp"

namespace torsor {

using RealRow = std::vector<Real>;
using RealRows = Rows<Real>;

/// 10^exponent at the working precision.
Real power_of_ten(int exponent);

/// Σ a_i b_i, and the root of Σ a_i².
Real product(const RealRow& a, const RealRow& b);
Real length(const RealRow& a);

/// Σ_k weights_k rows_k of rows of that length.
RealRow combination(const RealRow& weights, const RealRows& rows, std::size_t columns);

/// The same rows as columns.
RealRows transposed(const RealRows& rows, std::size_t columns);

// `columns` is the length of every row (an array may have no row). Pivots are taken by size, none that is not above
// `tolerance` times the largest entry of the whole array: ranks are as sure as the gap between what was kept and what
// was dropped.

RowReduction<Real> reduced_by_size(const RealRows& rows, std::size_t columns, const Real& tolerance,
                                   std::size_t largest_rank = std::numeric_limits<std::size_t>::max());

std::size_t rank(const RealRows& rows, std::size_t columns, const Real& tolerance);

/// Basis of the x with A x = 0, one vector for each column without pivot, in the order of those columns.
RealRows null_space(const RealRows& rows, std::size_t columns, const Real& tolerance);

/// A x = b.
struct RealSystem {
  const RealRows& rows;  ///< A
  const RealRow& right_side;
  std::size_t columns;
};

/// The x of least norm with A x = b on `largest_rank` independent rows of A.
RealRow least_norm_solution(const RealSystem& system, const Real& tolerance,
                            std::size_t largest_rank = std::numeric_limits<std::size_t>::max());

/// Some x with A x = b for all rows; nothing when there is none.
std::optional<RealRow> solution(const RealSystem& system, const Real& tolerance);

}  // namespace torsor
