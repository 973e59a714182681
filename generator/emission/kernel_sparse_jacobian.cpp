// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/kernel_sparse_jacobian.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/emission/formula_printer.hpp"
#include "generator/emission/kernel_parts.hpp"
#include "generator/expression/vanishing.hpp"

namespace torsor {
namespace {

std::string table(const std::string& name, const std::vector<std::size_t>& entries) {
  return wrapped(fmt::format("static constexpr int {}[] = {{{}}};", name, fmt::join(entries, ", ")), 2) + "\n";
}

}  // namespace

Kernel make_sparse_constraint_jacobian(const Equations& equations) {
  Kernel kernel;
  const std::vector<ConstraintRow>& rows = equations.constraints();
  if (rows.empty()) {
    kernel.skipped = "the scene has no constraints";
    return kernel;
  }
  const std::size_t n = unknowns(equations);
  std::vector<Value> all;
  for (const ConstraintRow& row : rows) {
    for (std::size_t i = 0; i < n; ++i) all.push_back(row.jacobian[i]);
  }
  const std::vector<bool> zero = vanish(all);
  std::vector<std::size_t> row_starts{0}, columns;
  for (std::size_t e = 0; e < all.size(); ++e) {
    if (!zero[e]) {
      kernel.assignments.push_back({element("result.values", columns.size()), all[e]});
      columns.push_back(e % n);
    }
    if (e % n == n - 1) row_starts.push_back(columns.size());
  }
  if (columns.empty()) {
    kernel.assignments.clear();
    kernel.skipped = "the constraint Jacobian vanishes identically";
    return kernel;
  }
  kernel.documentation =
      "Jacobian A(q, t) of the constraints without the entries that vanish identically: `values` of compressed rows.";
  Structure structure{"SparseConstraintJacobian", "Entries of A in compressed rows.", {}};
  structure.members = {matrix_member("values", columns.size(), 1, "entries of A, row by row")};
  structure.tables = fmt::format(
      "/// Where the values of SparseConstraintJacobian stand: those of row i, in the order of the multipliers, from\n"
      "/// row_start[i] to row_start[i + 1], each in its column, an index in v.\n"
      "static constexpr int constraint_jacobian_nonzeros = {};\n",
      columns.size());
  structure.tables += table("constraint_jacobian_row_start", row_starts);
  structure.tables += table("constraint_jacobian_column", columns);
  kernel.structures = {structure};
  kernel.results = {{"SparseConstraintJacobian", "result"}};
  return kernel;
}

}  // namespace torsor
