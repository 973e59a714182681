// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/kernels/compressed_rows.hpp"

#include "generator/kernels/kernel_parts.hpp"
#include "generator/program/identically_zero.hpp"

namespace torsor {

CompressedRows::CompressedRows(const ValueMatrix& matrix) {
  std::vector<Value> all;
  for (const std::vector<Value>& row : matrix) all.insert(all.end(), row.begin(), row.end());
  const std::vector<bool> zero = identically_zero_entries(all);
  std::size_t entry = 0;
  for (const std::vector<Value>& row : matrix) {
    for (std::size_t j = 0; j < row.size(); ++j, ++entry) {
      if (zero[entry]) continue;
      values.push_back(row[j]);
      columns.push_back(j);
    }
    row_starts.push_back(columns.size());
  }
}

void CompressedRows::assign(Kernel& kernel, const std::string& result) const {
  for (std::size_t k = 0; k < values.size(); ++k) {
    kernel.assignments.push_back({{result, "values", k}, values[k]});
  }
}

std::vector<ConstantTable> CompressedRows::tables(const std::string& name, const std::string& documentation) const {
  return {{name + "_nonzeros", values.size(), documentation},
          {name + "_row_start", row_starts},
          {name + "_column", columns}};
}

}  // namespace torsor
