// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// The digits in which some pivots or rows are looked at, and the power of ten below which one counts as zero.
struct ZeroTest {
  int digits, exponent;

  /// 10^-exponent
  Real bound() const { return Real(Number(10).pow(-exponent), digits); }
};

/// What a rank decided in numbers takes for zero. Rounding leaves some hundreds of units of the last digit; numbers of
/// a scene have fifteen digits at most, and what depends on them in a mechanism that is no singular one differs by
/// products of a few. The bounds lie between.
namespace zero_tests {

/// Twists of joints, relative to the largest entry: lengths are divided by the size of the mechanism.
inline constexpr ZeroTest twists{50, 20};
/// Components of reactions and motions at a generic state, whose numbers are of the order of 1: fewer operations than
/// twists, and units as the author took them.
inline constexpr ZeroTest reactions{50, 30};
/// Pivots of the mass matrix relative to the diagonal entry, at states where any may vanish: masses and lengths of one
/// mechanism differ by less than 10^50.
inline constexpr ZeroTest masses{80, 50};
/// The same at the initial state: what is smaller than that, no scalar of a header tells from a singular matrix.
inline constexpr ZeroTest masses_at_start{50, 30};
/// Columns of a regressor relative to their largest entries. Lengths and angles that are small, and products of them,
/// make columns nearly dependent: what 50 digits do not tell from rounding, the further ones do.
inline constexpr ZeroTest regressor{50, 20}, regressor_of_small_lengths{200, 90};
/// A row of a constraint beside the longest one, in the metric of the mass matrix: rounding of terms that cancel.
inline constexpr ZeroTest constraint_rows{50, 25};

/// Of a constraint's row, what stands out of those before it. Initial values that close a loop are decimals of ten or
/// more digits: rows that their author means to be dependent are so to that many.
inline constexpr double constraint_part = 1e-9;
/// A freedom is no choice for a constraint to be solved for where its part of the row is less: the dependent velocities
/// would be some 10^4 times the independent ones.
inline constexpr double freedom_part = 1e-4;
/// Pivots that are larger by less are as large: the first one is taken, whatever the rounding.
inline constexpr double as_large = 1.000001;

}  // namespace zero_tests

}  // namespace torsor
