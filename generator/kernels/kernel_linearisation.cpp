// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_linearisation.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/reduction.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

std::vector<Value> column_of(const ValueMatrix& matrix, std::size_t j) {
  std::vector<Value> column;
  for (const auto& row : matrix) column.push_back(row[j]);
  return column;
}

/// Rows of M⁻¹ X below those of the state matrices that say how e changes.
void assign_state_matrices(Kernel& kernel, Structure& structure, const ValueMatrix& a, const ValueMatrix& b,
                           const std::string& state) {
  const std::size_t size = a.size();
  const std::size_t inputs = b.empty() ? 0 : b[0].size();
  structure.members.push_back(matrix_member("A", size, size, "state matrix of " + state));
  assign_matrix(kernel, {"result", "A"}, a, size);
  if (inputs == 0) return;
  structure.members.push_back(matrix_member("B", size, inputs, "input matrix"));
  assign_matrix(kernel, {"result", "B"}, b, inputs);
}

/// Members M, C, K, F and E, with a suffix to their names.
void assign_equations(Kernel& kernel, Structure& structure, const std::string& suffix, const std::string& text,
                      const ValueMatrix& mass, const ValueMatrix& damping, const ValueMatrix& stiffness,
                      const std::vector<Value>& force, const ValueMatrix& effects) {
  const std::size_t rows = mass.size();
  const std::size_t inputs = rows == 0 ? 0 : effects[0].size();
  const auto assign = [&](const std::string& name, const ValueMatrix& matrix, const std::string& meaning) {
    const std::size_t columns = rows == 0 ? 0 : matrix[0].size();
    structure.members.push_back(matrix_member(name + suffix, rows, columns, text + meaning));
    assign_matrix(kernel, {"result", name + suffix}, matrix, columns);
  };
  assign("M", mass, "mass matrix");
  assign("C", damping, "damping and gyroscopic terms");
  assign("K", stiffness, "stiffness");
  structure.members.push_back(vector_member("F" + suffix, rows, text + "right-hand side"));
  assign_vector(kernel, {"result", "F" + suffix}, force, rows);
  if (inputs > 0) assign("E", effects, "effect of the inputs");
}

/// x = (e, w): the upper rows are given, the lower ones −M⁻¹ K, −M⁻¹ C, M⁻¹ E.
template <class Solver>
std::pair<ValueMatrix, ValueMatrix> state_matrices(const Solver& mass, const ValueMatrix& e_rates_e,
                                                   const ValueMatrix& e_rates_w, const ValueMatrix& damping,
                                                   const ValueMatrix& stiffness, const ValueMatrix& effects) {
  const std::size_t k = e_rates_e.size();
  const std::size_t p = damping.size();
  const std::size_t inputs = p == 0 ? 0 : effects[0].size();
  ValueMatrix a(k + p, std::vector<Value>(k + p));
  ValueMatrix b(k + p, std::vector<Value>(inputs));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) a[i][j] = e_rates_e[i][j];
    for (std::size_t j = 0; j < p; ++j) a[i][k + j] = e_rates_w[i][j];
  }
  const auto below = [&](ValueMatrix& target, std::size_t column, const std::vector<Value>& force, bool negative) {
    const std::vector<Value> solved = mass.solve(force);
    for (std::size_t i = 0; i < p; ++i) target[k + i][column] = negative ? -solved[i] : solved[i];
  };
  for (std::size_t j = 0; j < std::max(k, p); ++j) {
    if (j < k) below(a, j, column_of(stiffness, j), true);
    if (j < p) below(a, k + j, column_of(damping, j), true);
  }
  for (std::size_t j = 0; j < inputs; ++j) below(b, j, column_of(effects, j), false);
  return {a, b};
}

/// M⁻¹ where L D Lᵀ of M loses digits.
class InverseBySquares {
 public:
  InverseBySquares(Program& program, const ForwardDerivatives& motion) : program_(program), motion_(motion) {}
  std::vector<Value> solve(const std::vector<Value>& force) const {
    std::vector<Value> all;
    for (const auto& row : motion_.accelerations.by_force) {
      Value sum;
      for (std::size_t j = 0; j < force.size(); ++j) sum += row[j] * force[j];
      all.push_back(program_.bind(sum));
    }
    return all;
  }

 private:
  Program& program_;
  const ForwardDerivatives& motion_;
};

std::string names(const Model& model, const std::vector<std::size_t>& freedoms) {
  std::string text;
  for (const std::size_t i : freedoms) text += (text.empty() ? "" : ", ") + model.coordinates()[i].q->name;
  return text.empty() ? "none" : text;
}

Kernel unconstrained(const Equations& equations) {
  Kernel kernel;
  const std::size_t n = unknowns(equations);
  const Model& model = equations.model();
  const Linearisation linear = linearisation(equations);
  kernel.documentation =
      "Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the\n"
      "inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.";
  const bool turning = has_quaternions(model);
  if (turning) {
    kernel.documentation +=
        "\nAlong an attitude e is a turn in its moving axes, e' stands for w, the deviation of the angular velocity\n"
        "omega, and w = de/dt + omega x e: A says so.";
  }
  Structure structure{"Linearisation", "Matrices of the linearised equations, stored column by column.", {}};
  assign_equations(kernel, structure, "", "", linear.M, linear.C, linear.K, linear.F, linear.E);
  Program& program = equations.program();
  ValueMatrix e_rates_e(n, std::vector<Value>(n));
  ValueMatrix e_rates_w = e_rates_e;
  for (std::size_t j = 0; j < n; ++j) e_rates_w[j][j] = program.number(Number(1));
  for (std::size_t i = 0; turning && i < n; ++i) {
    const std::vector<Value> turned = turned_row(model, i, e_rates_w);
    for (std::size_t j = 0; j < n; ++j) e_rates_e[i][j] = -turned[j];
  }
  const auto state = [&](const auto& mass) {
    return state_matrices(mass, e_rates_e, e_rates_w, linear.C, linear.K, linear.E);
  };
  ValueMatrix a, b;
  if (equations.differentiates_squares()) {
    // −M⁻¹ C and M⁻¹ E are what the accelerations change by, whatever these are.
    const ForwardDerivatives motion = forward_derivatives(equations);
    std::tie(a, b) = state(InverseBySquares(program, motion));
    for (std::size_t i = 0; i < n; ++i) {
      std::copy_n(motion.accelerations.by_velocity[i].begin(), n, a[n + i].begin() + static_cast<std::ptrdiff_t>(n));
      b[n + i] = motion.accelerations.by_input[i];
    }
    kernel.pivots = motion.pivots;
  } else {
    const Factorisation factorisation(program, linear.M);
    std::tie(a, b) = state(factorisation);
    kernel.pivots = factorisation.pivots();
  }
  assign_state_matrices(kernel, structure, a, b,
                        turning ? "x = (e, w): x' = A x + B du" : "x = (e, e'): x' = A x + B du");
  kernel.structures = {structure};
  return kernel;
}

Kernel reduced(const Equations& equations) {
  Kernel kernel;
  const Model& model = equations.model();
  Program& program = equations.program();
  const ReducedLinearisation linear = reduced_linearisation(equations);
  const IndependentFreedoms& freedoms = linear.freedoms;
  kernel.documentation = fmt::format(
      "Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, "
      "at\n"
      "fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:\n"
      "M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of {},\n"
      "w those of the rates of {};\n"
      "the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r "
      "vanishes.\n"
      "Returns singular where the constraints do not determine the dependent freedoms.",
      names(model, freedoms.coordinates), names(model, freedoms.velocities));
  if (has_quaternions(model)) {
    kernel.documentation += "\nThe deviation along an attitude is a turn in its moving axes.";
  }
  Structure structure{"Linearisation", "Matrices of the linearised equations, stored column by column.", {}};
  structure.tables = {
      {"independent_coordinate_count", freedoms.coordinates.size(),
       "Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes)."},
      {"independent_coordinates", freedoms.coordinates},
      {"independent_velocity_count", freedoms.velocities.size(),
       "Velocities that w of the linearisation deviates: places in v."},
      {"independent_velocities", freedoms.velocities}};
  assign_equations(kernel, structure, "", "", linear.full.M, linear.full.C, linear.full.K, linear.full.F,
                   linear.full.E);
  assign_equations(kernel, structure, "_r", "reduced ", linear.M, linear.C, linear.K, linear.F, linear.E);
  kernel.pivots = linear.pivots;
  const auto assign_states = [&](const auto& mass) {
    const auto [a, b] = state_matrices(mass, linear.e_rates_e, linear.e_rates_w, linear.C, linear.K, linear.E);
    assign_state_matrices(kernel, structure, a, b, "x = (e, w): x' = A x + B du");
    kernel.pivots.insert(kernel.pivots.end(), mass.pivots().begin(), mass.pivots().end());
  };
  if (linear.symmetric)
    assign_states(Factorisation(program, linear.M));
  else
    assign_states(UnsymmetricFactorisation(program, linear.M));
  kernel.structures = {structure};
  return kernel;
}

}  // namespace

std::string no_linearisation(const Equations& equations) {
  if (equations.constraints().empty() || !independent_freedoms(equations).velocities.empty()) return "";
  return "the constraints leave no freedom";
}

Kernel make_linearisation(const Equations& equations) {
  Kernel kernel = equations.constraints().empty() ? unconstrained(equations) : reduced(equations);
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  kernel.results = {{"Linearisation", "result"}};
  return kernel;
}

}  // namespace torsor
