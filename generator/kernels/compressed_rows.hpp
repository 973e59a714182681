// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/kernels/kernel.hpp"

namespace torsor {

/// A matrix without the entries that vanish identically, as most sparse solvers read it: those of row i from
/// row_starts[i] to row_starts[i + 1], each with its column.
struct CompressedRows {
  std::vector<std::size_t> row_starts{0}, columns;
  std::vector<Value> values;

  /// What vanishes is decided in sixty digits at random states (identically_zero.hpp), so that the pattern is a constant.
  explicit CompressedRows(const ValueMatrix& matrix);
  /// `result.values[k] = ...` of a kernel, in the order of the rows.
  void assign(Kernel& kernel, const std::string& result) const;
  /// `<name>_nonzeros`, `<name>_row_start[]` and `<name>_column[]`.
  std::vector<ConstantTable> tables(const std::string& name, const std::string& documentation) const;
};

}  // namespace torsor
