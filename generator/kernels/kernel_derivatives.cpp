// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_derivatives.hpp"

#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

std::string about_attitudes(const Equations& equations) {
  return has_quaternions(equations.model()) ? "\nAlong an attitude q_j is a turn about its moving axis j." : "";
}

void add_matrix(Kernel& kernel, const std::string& name, const ValueMatrix& matrix, const std::string& text) {
  const std::size_t columns = matrix.empty() ? 0 : matrix[0].size();
  if (columns == 0) return;
  kernel.structures[0].members.push_back(matrix_member(name, matrix.size(), columns, text));
  assign_matrix(kernel, {"result", name}, matrix, columns);
}

}  // namespace

Kernel make_inverse_dynamics_derivatives(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix." +
      about_attitudes(equations);
  kernel.arguments = {Argument::accelerations, Argument::multipliers};
  kernel.structures = {{"InverseDynamicsDerivatives", "Derivatives of generalised forces, stored column by column.", {}}};
  kernel.results = {{"InverseDynamicsDerivatives", "result"}};
  const ForceDerivatives derivatives = residual_derivatives(equations, Inputs::left_out);
  add_matrix(kernel, "by_position", derivatives.by_position, "df_i/dq_j");
  add_matrix(kernel, "by_velocity", derivatives.by_velocity, "df_i/dv_j");
  return kernel;
}

Kernel make_forward_dynamics_derivatives(const Equations& equations) {
  Kernel kernel;
  const ForwardDerivatives derivatives = forward_derivatives(equations);
  kernel.documentation =
      "Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by\n" +
      derivatives.method + ". Returns singular where forward_dynamics does." + about_attitudes(equations);
  kernel.arguments = {Argument::inputs};
  kernel.structures = {
      {"ForwardDynamicsDerivatives", "Derivatives of accelerations and multipliers, stored column by column.", {}}};
  kernel.results = {{"ForwardDynamicsDerivatives", "result"}};
  const auto add = [&](const std::string& prefix, const std::string& what, const ForwardDerivatives::Of& of) {
    add_matrix(kernel, prefix + "by_position", of.by_position, "d" + what + "_i/dq_j");
    add_matrix(kernel, prefix + "by_velocity", of.by_velocity, "d" + what + "_i/dv_j");
    add_matrix(kernel, prefix + "by_force", of.by_force, "d" + what + "_i/df_j, f generalised forces added to E u");
    add_matrix(kernel, prefix + "by_input", of.by_input, "d" + what + "_i/du_j");
  };
  add("", "a", derivatives.accelerations);
  add("multipliers_", "lambda", derivatives.multipliers);
  kernel.pivots = derivatives.pivots;
  return kernel;
}

}  // namespace torsor
