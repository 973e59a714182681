// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_second_derivatives.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/derivatives/forward_second_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/second_derivatives.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

/// What the pages of a member are, for the reader of the header.
std::string about_pages(const Equations& equations) {
  std::string text =
      "\nEach member x_by_y_z has one page for each z_k, the derivative of a matrix by z_k: the entry of row i and column\n"
      "j of page k is [i + rows * (j + columns * k)].";
  if (has_quaternions(equations.model())) {
    text +=
        "\nAlong an attitude q_j is a turn about its moving axis j, and page k is how the first derivatives change along\n"
        "the turn k: turns of one attitude do not commute, all else is symmetric.";
  }
  return text;
}

void add_pages(Kernel& kernel, const std::string& name, const ValuePages& pages, const std::string& text) {
  if (pages.empty() || pages[0].empty() || pages[0][0].empty()) return;
  const std::size_t rows = pages[0].size(), columns = pages[0][0].size();
  kernel.structures[0].members.push_back(
      matrix_member(name, rows, columns * pages.size(), fmt::format("{}, {} pages", text, pages.size())));
  for (std::size_t k = 0; k < pages.size(); ++k) {
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < rows; ++i) {
        kernel.assignments.push_back({{"result", name, i + rows * (j + columns * k)}, pages[k][i][j]});
      }
    }
  }
}

}  // namespace

Kernel make_inverse_dynamics_second_derivatives(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Second derivatives of inverse_dynamics at (q, v, a, lambda). It is linear in a: d2f/da dq has the derivatives of\n"
      "the mass matrix, and what else has an a is zero." +
      about_pages(equations);
  kernel.arguments = {Argument::accelerations, Argument::multipliers};
  kernel.structures = {
      {"InverseDynamicsSecondDerivatives", "Second derivatives of generalised forces, page by page.", {}}};
  kernel.results = {{"InverseDynamicsSecondDerivatives", "result"}};
  const SecondForceDerivatives second = second_residual_derivatives(equations, Inputs::left_out);
  add_pages(kernel, "by_position_position", second.position_position, "d2f_i/dq_j dq_k");
  add_pages(kernel, "by_position_velocity", second.position_velocity, "d2f_i/dq_j dv_k");
  add_pages(kernel, "by_velocity_velocity", second.velocity_velocity, "d2f_i/dv_j dv_k");
  add_pages(kernel, "by_acceleration_position", second.acceleration_position, "d2f_i/da_j dq_k = dM_ij/dq_k");
  return kernel;
}

Kernel make_forward_dynamics_second_derivatives(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Second derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion;\n"
      "it is linear in u. Returns singular where forward_dynamics does." +
      about_pages(equations);
  kernel.arguments = {Argument::inputs};
  kernel.structures = {{"ForwardDynamicsSecondDerivatives",
                        "Second derivatives of accelerations and multipliers, page by page.",
                        {}}};
  kernel.results = {{"ForwardDynamicsSecondDerivatives", "result"}};
  const ForwardSecondDerivatives second = forward_second_derivatives(equations);
  const auto add = [&](const std::string& prefix, const std::string& what, const ForwardSecondDerivatives::Of& of) {
    add_pages(kernel, prefix + "by_position_position", of.position_position, "d2" + what + "_i/dq_j dq_k");
    add_pages(kernel, prefix + "by_position_velocity", of.position_velocity, "d2" + what + "_i/dq_j dv_k");
    add_pages(kernel, prefix + "by_velocity_velocity", of.velocity_velocity, "d2" + what + "_i/dv_j dv_k");
    add_pages(kernel, prefix + "by_position_input", of.position_input, "d2" + what + "_i/dq_j du_k");
    add_pages(kernel, prefix + "by_velocity_input", of.velocity_input, "d2" + what + "_i/dv_j du_k");
  };
  add("", "a", second.accelerations);
  add("multipliers_", "lambda", second.multipliers);
  kernel.pivots = second.pivots;
  return kernel;
}

}  // namespace torsor
