// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "benchmarks/kernels/way.hpp"

namespace kernels {

/// Half of the measured numbers lie between the quartiles.
struct Spread {
  double median, lower, upper;
};
Spread spread_of(std::vector<double> numbers);

struct Timing {
  Spread nanoseconds;  ///< for one state
  Spread ratio;        ///< to the first way's, both of the same turn
};

/// In each turn every way goes through some states, one way after the other: what else the machine does meets all
/// alike, and a ratio compares neighbours. A way's share begins with one state that is not timed, which loads its code,
/// and takes a fifth of a millisecond at most: few are interrupted by other programs, which would take several.
std::vector<Timing> time_in_turns(const std::vector<Way>& ways, std::size_t states, int turns);

}  // namespace kernels
