// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

namespace torsor::runtime {

/// What rounding took from a state while increments were added to it, given back with the next ones (compensated
/// summation: Hairer-Lubich-Wanner VIII.5; the exact error of a sum: Knuth, The Art of Computer Programming II, 4.2.2,
/// theorem B). Not to be compiled with options that let sums be reassociated.
template <class Scalar, std::size_t size>
struct CompensatedState {
  std::array<Scalar, size> rest{};

  /// y_i + increment, rounded; `rest` keeps what was rounded away.
  [[nodiscard]] Scalar add(std::size_t i, Scalar y, Scalar increment) noexcept {
    const Scalar term = increment + rest[i];
    const Scalar sum = y + term;
    const Scalar taken = sum - y;
    rest[i] = (y - (sum - taken)) + (term - taken);
    return sum;
  }
};

}  // namespace torsor::runtime
