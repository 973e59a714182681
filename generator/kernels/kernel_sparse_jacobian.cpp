// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_sparse_jacobian.hpp"

#include "torsor/generator/kernels/compressed_rows.hpp"

namespace torsor {

namespace {

CompressedRows rows_of_jacobian(const Equations& equations) {
  ValueMatrix jacobian;
  for (const ConstraintRow& row : equations.constraints()) {
    jacobian.emplace_back(row.jacobian.begin(), row.jacobian.begin() + equations.model().unknown_count());
  }
  return CompressedRows(jacobian);
}

}  // namespace

std::string no_sparse_constraint_jacobian(const Equations& equations) {
  if (equations.constraints().empty()) return "the scene has no constraints";
  return rows_of_jacobian(equations).values.empty() ? "the constraint Jacobian vanishes identically" : "";
}

Kernel make_sparse_constraint_jacobian(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Jacobian A(q, t) of the constraints without the entries that vanish identically: `values` of compressed rows.";
  rows_of_jacobian(equations).give_to(
      kernel, {"SparseConstraintJacobian", "Entries of A in compressed rows.", "entries of A, row by row",
               "constraint_jacobian",
               "Where the values of SparseConstraintJacobian stand: those of row i, in the order of the multipliers, from\n"
               "row_start[i] to row_start[i + 1], each in its column, an index in v."});
  return kernel;
}

}  // namespace torsor
