// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_residual.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "torsor/generator/kernels/compressed_rows.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

bool repeats_others(const Equations& equations, std::size_t constraint) {
  const std::vector<std::size_t>& dropped = equations.redundancy().dropped;
  return std::find(dropped.begin(), dropped.end(), constraint) != dropped.end();
}

/// Rows and columns in words; the same for both kernels.
std::string rows_of(const Equations& equations) {
  if (equations.constraints().empty()) return "r = M a + h - E u";
  const bool friction = !equations.scene().content().frictions.empty();
  std::string text = fmt::format("r = (M a + h - {} - E u, A a + gamma)", friction ? "B lambda" : "A' lambda");
  if (equations.redundancy().redundant()) text += ", its row lambda_j for a constraint j that repeats others";
  return text;
}

}  // namespace

Kernel make_residual(const Equations& equations) {
  const std::size_t n = unknowns(equations);
  const std::size_t m = equations.constraints().size();
  Kernel kernel;
  kernel.documentation = "Residual of the equations of motion, zero along motions:\n" + rows_of(equations) + ".";
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  kernel.results = {{"", "residual", n + m}};
  std::vector<Value> rows(equations.inverse_dynamics().begin(),
                          equations.inverse_dynamics().begin() + equations.model().unknown_count());
  const std::vector<Value> of_motors = equations.of_inputs();
  for (std::size_t i = 0; i < n; ++i) rows[i] -= of_motors[i];
  const std::vector<Value> rates = constraint_accelerations(equations);
  for (std::size_t j = 0; j < m; ++j) {
    const bool repeated = repeats_others(equations, j);
    rows.push_back(repeated ? equations.program().symbol(equations.constraints()[j].multiplier) : rates[j]);
  }
  assign_vector(kernel, {"residual"}, rows, n + m);
  return kernel;
}

Kernel make_residual_jacobian(const Equations& equations) {
  const std::size_t n = unknowns(equations);
  const std::size_t m = equations.constraints().size();
  Program& program = equations.program();
  const ForceDerivatives of_motion = residual_derivatives(equations, Inputs::act);
  ValueMatrix jacobian(n + m, std::vector<Value>(3 * n + m));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      jacobian[i][j] = of_motion.by_position[i][j];
      jacobian[i][n + j] = of_motion.by_velocity[i][j];
      jacobian[i][2 * n + j] = equations.mass()[i][j];
    }
    for (std::size_t k = 0; k < m; ++k) jacobian[i][3 * n + k] = -equations.constraints()[k].column[i];
  }
  const std::vector<Value> rates = constraint_accelerations(equations);
  for (std::size_t j = 0; j < n; ++j) {
    // One for all rows: each remembers the definitions that it has met.
    Derivation by_position = equations.model().along(static_cast<int>(j));
    Derivation by_velocity = partial_derivation(program, equations.model().coordinates()[j].v);
    for (std::size_t k = 0; k < m; ++k) {
      if (repeats_others(equations, k)) continue;
      std::vector<Value>& row = jacobian[n + k];
      row[j] = by_position(rates[k]);
      row[n + j] = by_velocity(rates[k]);
      row[2 * n + j] = equations.constraints()[k].jacobian[j];
    }
  }
  for (const std::size_t k : equations.redundancy().dropped) jacobian[n + k][3 * n + k] = program.number(Number(1));
  Kernel kernel;
  kernel.documentation = "Derivatives of residual by (q, v, a, lambda) without those that vanish identically: `values` of\n"
                         "compressed rows. " + rows_of(equations) + ".";
  if (has_quaternions(equations.model())) {
    kernel.documentation += "\nAlong an attitude q_j is a turn about its moving axis j.";
  }
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  CompressedRows(jacobian).give_to(
      kernel, {"ResidualJacobian", "Derivatives of the residual in compressed rows.", "entries, row by row",
               "residual_jacobian",
               "Where the values of ResidualJacobian stand: those of row i from row_start[i] to row_start[i + 1], each in its\n"
               "column: of unknown j by position j, by velocity n + j, by acceleration 2 n + j, by multiplier k 3 n + k."});
  return kernel;
}

}  // namespace torsor
