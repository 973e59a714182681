// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_linearisation.hpp"

#include <algorithm>

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

/// x' = A x + B du: rows of M⁻¹ X below those that say how e changes.
struct StateMatrices {
  ValueMatrix a, b;
};

void assign_state_matrices(Kernel& kernel, Structure& structure, const StateMatrices& matrices, const std::string& state) {
  const auto& [a, b] = matrices;
  const std::size_t size = a.size();
  const std::size_t inputs = b.empty() ? 0 : b[0].size();
  structure.members.push_back(matrix_member("A", size, size, "state matrix of " + state));
  assign_matrix(kernel, {"result", "A"}, a, size);
  if (inputs == 0) return;
  structure.members.push_back(matrix_member("B", size, inputs, "input matrix"));
  assign_matrix(kernel, {"result", "B"}, b, inputs);
}

/// How the members of the full and of the reduced equations are told apart.
struct MemberNames {
  std::string suffix, text;
};

/// Members M, C, K, F and E of the full or the reduced equations.
template <class Matrices>
void assign_equations(Kernel& kernel, Structure& structure, const Matrices& linear, const MemberNames& names = {}) {
  const std::string& suffix = names.suffix;
  const std::string& text = names.text;
  const std::size_t rows = linear.M.size();
  const std::size_t inputs = rows == 0 ? 0 : linear.E[0].size();
  const auto assign = [&](const std::string& name, const ValueMatrix& matrix, const std::string& meaning) {
    const std::size_t columns = rows == 0 ? 0 : matrix[0].size();
    structure.members.push_back(matrix_member(name + suffix, rows, columns, text + meaning));
    assign_matrix(kernel, {"result", name + suffix}, matrix, columns);
  };
  assign("M", linear.M, "mass matrix");
  assign("C", linear.C, "damping and gyroscopic terms");
  assign("K", linear.K, "stiffness");
  structure.members.push_back(vector_member("F" + suffix, rows, text + "right-hand side"));
  assign_vector(kernel, {"result", "F" + suffix}, linear.F, rows);
  if (inputs > 0) assign("E", linear.E, "effect of the inputs");
}

/// e' by e and by w.
struct RatesOfE {
  const ValueMatrix& by_e;
  const ValueMatrix& by_w;
};

/// x = (e, w): the upper rows are given, the lower ones −M⁻¹ K, −M⁻¹ C, M⁻¹ E.
template <class Solver, class Matrices>
StateMatrices state_matrices(const Solver& mass, const RatesOfE& rates, const Matrices& linear) {
  const std::size_t k = rates.by_e.size();
  const std::size_t p = linear.C.size();
  const std::size_t inputs = p == 0 ? 0 : linear.E[0].size();
  ValueMatrix a(k + p, std::vector<Value>(k + p));
  ValueMatrix b(k + p, std::vector<Value>(inputs));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) a[i][j] = rates.by_e[i][j];
    for (std::size_t j = 0; j < p; ++j) a[i][k + j] = rates.by_w[i][j];
  }
  const auto below = [&](ValueMatrix& target, std::size_t column, const std::vector<Value>& force, bool negative) {
    const std::vector<Value> solved = mass.solve(force);
    for (std::size_t i = 0; i < p; ++i) target[k + i][column] = negative ? -solved[i] : solved[i];
  };
  for (std::size_t j = 0; j < std::max(k, p); ++j) {
    if (j < k) below(a, j, column_of(linear.K, j), true);
    if (j < p) below(a, k + j, column_of(linear.C, j), true);
  }
  for (std::size_t j = 0; j < inputs; ++j) below(b, j, column_of(linear.E, j), false);
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
  assign_equations(kernel, structure, linear);
  Program& program = equations.program();
  ValueMatrix e_rates_e(n, std::vector<Value>(n));
  ValueMatrix e_rates_w = e_rates_e;
  for (std::size_t j = 0; j < n; ++j) e_rates_w[j][j] = program.number(Number(1));
  for (std::size_t i = 0; turning && i < n; ++i) {
    const std::vector<Value> turned = turned_row(model, i, e_rates_w);
    for (std::size_t j = 0; j < n; ++j) e_rates_e[i][j] = -turned[j];
  }
  const auto state = [&](const auto& mass) { return state_matrices(mass, {e_rates_e, e_rates_w}, linear); };
  StateMatrices matrices;
  if (equations.differentiates_squares()) {
    // −M⁻¹ C and M⁻¹ E are what the accelerations change by, whatever these are.
    const ForwardDerivatives motion = forward_derivatives(equations);
    matrices = state(InverseBySquares(program, motion));
    auto& [a, b] = matrices;
    for (std::size_t i = 0; i < n; ++i) {
      std::copy_n(motion.accelerations.by_velocity[i].begin(), n, a[n + i].begin() + static_cast<std::ptrdiff_t>(n));
      b[n + i] = motion.accelerations.by_input[i];
    }
    kernel.pivots = motion.pivots;
  } else {
    const Factorisation factorisation(program, linear.M);
    matrices = state(factorisation);
    kernel.pivots = factorisation.pivots();
  }
  assign_state_matrices(kernel, structure, matrices,
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
  assign_equations(kernel, structure, linear.full);
  assign_equations(kernel, structure, linear, {"_r", "reduced "});
  kernel.pivots = linear.pivots;
  const auto assign_states = [&](const auto& mass) {
    const StateMatrices matrices = state_matrices(mass, {linear.e_rates_e, linear.e_rates_w}, linear);
    assign_state_matrices(kernel, structure, matrices, "x = (e, w): x' = A x + B du");
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
