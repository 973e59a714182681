// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/kernel_linearisation.hpp"

#include "generator/dynamics/linearisation.hpp"
#include "generator/emission/kernel_parts.hpp"

namespace torsor {

Kernel make_linearisation(const Equations& equations) {
  Kernel kernel;
  const std::size_t n = unknowns(equations);
  const Linearisation linear = linearisation(equations);
  const std::size_t inputs = equations.model().inputs().size();
  kernel.documentation =
      "Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the\n"
      "inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.";
  if (!equations.constraints().empty()) {
    kernel.documentation +=
        "\nAt fixed multipliers and in all coordinates: A' dlambda and the linearised constraints come beside it, and the\n"
        "state matrices, which need independent coordinates, are left out.";
  }
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  Structure structure{"Linearisation",
                      "Matrices of the linearised equations, stored column by column.",
                      {matrix_member("M", n, n, "mass matrix"), matrix_member("C", n, n, "damping and gyroscopic terms"),
                       matrix_member("K", n, n, "stiffness"), matrix_member("F", n, 1, "right-hand side")}};
  assign_matrix(kernel, "result.M", linear.M, n);
  assign_matrix(kernel, "result.C", linear.C, n);
  assign_matrix(kernel, "result.K", linear.K, n);
  assign_vector(kernel, "result.F", linear.F, n);
  if (inputs > 0) {
    structure.members.push_back(matrix_member("E", n, inputs, "effect of the inputs"));
    assign_matrix(kernel, "result.E", linear.E, inputs);
  }
  // State matrices only where the coordinates are independent: x = (e, e'), x' = A x + B du.
  if (equations.constraints().empty()) {
    Program& program = equations.program();
    const Factorisation factorisation(program, linear.M);
    ValueMatrix a(2 * n, std::vector<Value>(2 * n));
    ValueMatrix b(2 * n, std::vector<Value>(inputs));
    const auto column_of = [n](const ValueMatrix& matrix, std::size_t j) {
      std::vector<Value> column;
      for (std::size_t i = 0; i < n; ++i) column.push_back(matrix[i][j]);
      return column;
    };
    for (std::size_t j = 0; j < n; ++j) {
      a[j][n + j] = program.number(Number(1));
      const std::vector<Value> stiffness = factorisation.solve(column_of(linear.K, j));
      const std::vector<Value> damping = factorisation.solve(column_of(linear.C, j));
      for (std::size_t i = 0; i < n; ++i) {
        a[n + i][j] = -stiffness[i];
        a[n + i][n + j] = -damping[i];
      }
    }
    for (std::size_t k = 0; k < inputs; ++k) {
      const std::vector<Value> effect = factorisation.solve(column_of(linear.E, k));
      for (std::size_t i = 0; i < n; ++i) b[n + i][k] = effect[i];
    }
    structure.members.push_back(matrix_member("A", 2 * n, 2 * n, "state matrix of x = (e, e'): x' = A x + B du"));
    assign_matrix(kernel, "result.A", a, 2 * n);
    if (inputs > 0) {
      structure.members.push_back(matrix_member("B", 2 * n, inputs, "input matrix"));
      assign_matrix(kernel, "result.B", b, inputs);
    }
    kernel.pivots = factorisation.pivots();
  }
  kernel.structures = {structure};
  kernel.results = {{"Linearisation", "result"}};
  return kernel;
}

}  // namespace torsor
