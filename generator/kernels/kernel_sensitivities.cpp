// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_sensitivities.hpp"

#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

void add_columns(Kernel& kernel, const std::string& name, const ValueMatrix& matrix, const std::string& text) {
  if (matrix.empty()) return;
  const std::size_t columns = matrix[0].size();
  kernel.structures[0].members.push_back(matrix_member(name, matrix.size(), columns, text));
  assign_matrix(kernel, {"result", name}, matrix, columns);
}

/// The structure and what both kernels say.
Kernel common_part(const std::string& type) {
  Kernel kernel;
  kernel.structures = {{type, "Derivatives by the run-time parameters, a column for each, in the order of Parameters.", {}}};
  kernel.results = {{type, "result"}};
  return kernel;
}

}  // namespace

Kernel make_inverse_dynamics_sensitivities(const Equations& equations) {
  Kernel kernel = common_part("InverseDynamicsSensitivities");
  kernel.documentation = "Derivatives of inverse_dynamics by the run-time parameters p at fixed (q, v, a, lambda).";
  kernel.arguments = {Argument::accelerations, Argument::multipliers};
  const ValueMatrix derivatives = inverse_sensitivities(equations);
  add_columns(kernel, "by_parameter", derivatives, "df_i/dp_k");
  return kernel;
}

Kernel make_forward_dynamics_sensitivities(const Equations& equations) {
  Kernel kernel = common_part("ForwardDynamicsSensitivities");
  kernel.documentation =
      "Derivatives of forward_dynamics by the run-time parameters p at fixed (q, v, u), the accelerations and\n"
      "multipliers being those of the motion. Returns singular where forward_dynamics does.";
  kernel.arguments = {Argument::inputs};
  const ForwardSensitivities derivatives = forward_sensitivities(equations);
  add_columns(kernel, "by_parameter", derivatives.accelerations, "da_i/dp_k");
  add_columns(kernel, "multipliers_by_parameter", derivatives.multipliers, "dlambda_i/dp_k");
  kernel.pivots = derivatives.pivots;
  return kernel;
}

}  // namespace torsor
