// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// A matrix without the entries that vanish identically, as most sparse solvers read it: those of row i from
/// row_starts[i] to row_starts[i + 1], each with its column.
struct CompressedRows {
  std::vector<std::size_t> row_starts{0}, columns;
  std::vector<Value> values;

  /// What vanishes is decided in sixty digits at random states (identically_zero.hpp), so that the pattern is a constant.
  explicit CompressedRows(const ValueMatrix& matrix);

  /// What the structure of the values is called, and the tables beside it: `<tables>_nonzeros`, `<tables>_row_start[]`
  /// and `<tables>_column[]`.
  struct Texts {
    std::string structure, documentation, entries;
    std::string tables, places;
  };
  /// The result of a kernel: `result.values[k] = ...`, in the order of the rows.
  void give_to(Kernel& kernel, const Texts& texts) const;
};

}  // namespace torsor
