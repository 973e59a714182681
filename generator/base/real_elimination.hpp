// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/base/high_precision.hpp"

namespace torsor {

using RealRow = std::vector<Real>;
using RealRows = std::vector<RealRow>;

/// 10^exponent at the working precision.
Real power_of_ten(int exponent);

/// What Gauss-Jordan elimination with complete pivoting finds: the largest entry left is the next pivot, and
/// elimination stops when it is not above `tolerance` times the largest entry of the whole array. (Golub & Van Loan,
/// Matrix Computations, 3.4.8.) Ranks are as sure as the gap between what was kept and what was dropped.
struct RowReduction {
  int rank = 0;
  RealRows reduced;                ///< `rank` rows, one for each pivot column, which is 1 there and 0 in the others
  std::vector<int> pivot_columns;  ///< in the order of `reduced`
  std::vector<int> pivot_rows;     ///< independent rows of the array given
};

/// `columns` is the length of every row (an array may have no row). At most `largest_rank` pivots are taken when it is
/// not negative.
RowReduction eliminate(RealRows rows, int columns, const Real& tolerance, int largest_rank = -1);

int rank(const RealRows& rows, int columns, const Real& tolerance);

/// Basis of the x with A x = 0, one vector for each column without pivot, in the order of those columns.
RealRows kernel(const RealRows& rows, int columns, const Real& tolerance);

/// The same rows as columns.
RealRows transposed(const RealRows& rows, int columns);

/// The x of least norm with A x = b on `largest_rank` independent rows of A.
RealRow least_norm_solution(const RealRows& rows, const RealRow& right_side, int columns, const Real& tolerance,
                            int largest_rank = -1);

/// Some x with A x = b for all rows; nothing when there is none.
std::optional<RealRow> solution(const RealRows& rows, const RealRow& right_side, int columns, const Real& tolerance);

}  // namespace torsor
