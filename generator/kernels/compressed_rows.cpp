// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/compressed_rows.hpp"

#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/program/identically_zero.hpp"

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

void CompressedRows::give_to(Kernel& kernel, const Texts& texts) const {
  assign_vector(kernel, {"result", "values"}, values, values.size());
  kernel.structures = {{texts.structure,
                        texts.documentation,
                        {vector_member("values", values.size(), texts.entries)},
                        {{texts.tables + "_nonzeros", values.size(), texts.places},
                         {texts.tables + "_row_start", row_starts},
                         {texts.tables + "_column", columns}}}};
  kernel.results = {{texts.structure, "result"}};
}

}  // namespace torsor
