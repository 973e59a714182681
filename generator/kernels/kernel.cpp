// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/kernels/kernel_contacts.hpp"
#include "torsor/generator/kernels/kernel_derivatives.hpp"
#include "torsor/generator/kernels/kernel_energy.hpp"
#include "torsor/generator/kernels/kernel_frames.hpp"
#include "torsor/generator/kernels/kernel_jets.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/kernels/kernel_linearisation.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/kernels/kernel_percussions.hpp"
#include "torsor/generator/kernels/kernel_poses.hpp"
#include "torsor/generator/kernels/kernel_reactions.hpp"
#include "torsor/generator/kernels/kernel_regressor.hpp"
#include "torsor/generator/kernels/kernel_residual.hpp"
#include "torsor/generator/kernels/kernel_robotics.hpp"
#include "torsor/generator/kernels/kernel_second_derivatives.hpp"
#include "torsor/generator/kernels/kernel_sensitivities.hpp"
#include "torsor/generator/kernels/kernel_sparse_jacobian.hpp"

namespace torsor {
namespace {

/// What multiplies lambda in the equations of motion: A', unless friction works with the multipliers too.
std::string multiplied(const Equations& equations) { return has_friction(equations) ? "B lambda" : "A' lambda"; }

Kernel make_mass_matrix(const Equations& equations) {
  const std::size_t n = unknowns(equations);
  Kernel kernel;
  kernel.documentation = "Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.";
  kernel.results = {{"", "mass", n * n, n}};
  assign_matrix(kernel, {"mass"}, equations.mass(), n);
  return kernel;
}

Kernel make_bias(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive\n"
      "actions included. M a + h = E u + " +
      multiplied(equations) + ".";
  kernel.results = {{"GeneralizedForces", "forces"}};
  assign_vector(kernel, {"forces"}, equations.bias(), unknowns(equations));
  return kernel;
}

Kernel make_inverse_dynamics(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Inverse dynamics: the generalised forces M a + h - " + multiplied(equations) +
      " that motors must supply for the accelerations a.";
  kernel.arguments = {Argument::accelerations, Argument::multipliers};
  kernel.results = {{"GeneralizedForces", "forces"}};
  assign_vector(kernel, {"forces"}, equations.inverse_dynamics(), unknowns(equations));
  return kernel;
}

Kernel make_forward_dynamics(const Equations& equations) {
  const ForwardSolution& solution = equations.forward();
  Kernel kernel;
  kernel.documentation = fmt::format(
      "Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + {}, A a + gamma = 0, by\n"
      "{}. Returns singular when a pivot is not\n"
      "positive relative to its diagonal entry{}.",
      multiplied(equations), solution.method,
      solution.multipliers.empty() || has_friction(equations)
          ? ""
          : ", or one of the Schur complement is below\n2^-40 of those of its unit (a change point), in float 2^-20");
  kernel.arguments = {Argument::inputs};
  kernel.results = {{"Accelerations", "accelerations"}, {"Multipliers", "multipliers"}};
  assign_vector(kernel, {"accelerations"}, solution.accelerations, solution.accelerations.size());
  assign_vector(kernel, {"multipliers"}, solution.multipliers, solution.multipliers.size());
  kernel.pivots = solution.pivots;
  return kernel;
}

Kernel make_first_integrals(const Equations& equations) {
  Kernel kernel;
  const PainleveReport report = painleve(equations);
  kernel.documentation = "First integrals: constant along every motion.";
  Structure structure{"FirstIntegrals", "Quantities that every motion conserves.", {}};
  for (const FirstIntegral& integral : report.first_integrals) {
    structure.members.push_back({integral.name, 1, 1, {integral.meaning, integral.unit}});
    Value value = integral.value;
    if (integral.name == "energy") {  // T − U
      const Energies energies = energies_of(equations);
      value = energies.kinetic - energies.force_function;
    }
    kernel.assignments.push_back({{"result", integral.name}, value});
  }
  kernel.structures = {structure};
  kernel.results = {{"FirstIntegrals", "result"}};
  return kernel;
}

Kernel make_constraints(const Equations& equations) {
  Kernel kernel;
  const std::vector<ConstraintRow>& rows = equations.constraints();
  const std::size_t m = rows.size();
  const std::size_t n = unknowns(equations);
  kernel.documentation = "Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.";
  kernel.structures = {{"Constraints",
                        "Constraints and their derivatives, one entry per multiplier.",
                        {vector_member("value", m, "f(q, t) of holonomic constraints, 0 for the others"),
                         vector_member("rate", m, "A v - b, df/dt for holonomic ones"),
                         matrix_member("jacobian", m, n, "A, stored column by column"),
                         vector_member("gamma", m, "d(A v - b)/dt at zero acceleration: A a + gamma = 0")}}};
  kernel.results = {{"Constraints", "result"}};
  ValueMatrix jacobian;
  for (std::size_t j = 0; j < m; ++j) {
    kernel.assignments.push_back({{"result", "value", j}, rows[j].value});
    kernel.assignments.push_back({{"result", "rate", j}, rows[j].rate});
    kernel.assignments.push_back({{"result", "gamma", j}, rows[j].gamma});
    jacobian.push_back(rows[j].jacobian);
  }
  assign_matrix(kernel, {"result", "jacobian"}, jacobian, n);
  if (has_friction(equations)) {
    kernel.structures[0].members.push_back(
        matrix_member("columns", n, m, "B, generalised forces of unit multipliers with their friction, column by column"));
    ValueMatrix columns(n, std::vector<Value>(m));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < m; ++j) columns[i][j] = rows[j].column[i];
    }
    assign_matrix(kernel, {"result", "columns"}, columns, m);
  }
  return kernel;
}

// Why there is nothing to compute, found without deriving the kernel.
std::string never(const Equations&) { return ""; }

std::string no_unknowns(const Equations& equations) {
  return unknowns(equations) == 0 ? "the scene has no unknown coordinates" : "";
}

std::string no_sensitivities(const Equations& equations) {
  if (!sensitivity_parameters(equations).empty()) return no_unknowns(equations);
  return "no parameter is set at run time (run_time_parameter, or --run-time)";
}

std::string no_first_integrals(const Equations& equations) {
  const PainleveReport report = painleve(equations);
  return report.first_integrals.empty() ? fmt::format("{}", fmt::join(report.failing_conditions, "; ")) : "";
}

std::string no_constraints(const Equations& equations) {
  return equations.constraints().empty() ? "the scene has no constraints" : "";
}

struct Entry {
  std::string name;
  std::function<Kernel(const Equations&)> make;
  std::function<std::string(const Equations&)> absence;
  bool solves = false;  ///< with the mass matrix
  bool named = false;   ///< made when it is named only
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"kinematics", make_kinematics, never},
      {"mass_matrix", make_mass_matrix, never},
      {"bias", make_bias, never},
      {"inverse_dynamics", make_inverse_dynamics, never},
      {"forward_dynamics", make_forward_dynamics, never, true},
      {"energy", make_energy, never},
      {"first_integrals", make_first_integrals, no_first_integrals},
      {"constraints", make_constraints, no_constraints},
      {"reactions", make_reactions, no_reactions},
      {"contacts", make_contacts, no_contacts},
      {"contact_coefficients", make_contact_coefficients, no_contacts},
      {"linearisation", make_linearisation, no_linearisation, true},
      {"inverse_dynamics_derivatives", make_inverse_dynamics_derivatives, never},
      {"forward_dynamics_derivatives", make_forward_dynamics_derivatives, never, true},
      {"regressor", make_regressor, no_regressor},
      {"jets", make_jets, no_jets, true},
      {"sparse_constraint_jacobian", make_sparse_constraint_jacobian, no_sparse_constraint_jacobian},
      {"residual", make_residual, no_unknowns, false, true},
      {"residual_jacobian", make_residual_jacobian, no_unknowns, false, true},
      {"inverse_dynamics_second_derivatives", make_inverse_dynamics_second_derivatives, no_unknowns, false, true},
      {"forward_dynamics_second_derivatives", make_forward_dynamics_second_derivatives, no_unknowns, true, true},
      {"inverse_dynamics_sensitivities", make_inverse_dynamics_sensitivities, no_sensitivities, false, true},
      {"forward_dynamics_sensitivities", make_forward_dynamics_sensitivities, no_sensitivities, true, true},
      {"gravity", make_gravity, no_gravity, false, true},
      {"centroidal_momentum", make_centroidal_momentum, no_moving_mass, false, true},
      {"frames", make_frames, no_points, false, true},
      {"operational_inertia", make_operational_inertia, no_operational_inertia, true, true},
      {"delassus", make_delassus, no_contacts, true, true},
      {"impact", make_impact, no_contacts, true, true},
      {"poses", make_poses, never, false, true}};
  return all;
}

std::string known_names() {
  std::string known;
  for (const Entry& entry : entries()) known += (known.empty() ? "" : ", ") + entry.name;
  return known;
}

std::string absence(const Entry& entry, const Equations& equations) {
  const std::string reason = entry.solves ? lack_of_mass(equations) : "";
  return reason.empty() ? entry.absence(equations) : reason;
}

const Entry& entry_of(const std::string& name) {
  for (const Entry& entry : entries()) {
    if (entry.name == name) return entry;
  }
  throw UsageError(fmt::format("unknown kernel '{}': {}known are {}", name, did_you_mean(name, kernel_names()), known_names()));
}

}  // namespace

const std::vector<std::string>& kernel_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& entry : entries()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

bool solves_with_mass_matrix(const std::string& name) {
  return std::any_of(entries().begin(), entries().end(),
                     [&name](const Entry& entry) { return entry.solves && entry.name == name; });
}

const std::vector<std::string>& usual_kernel_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& entry : entries()) {
      if (!entry.named) all.push_back(entry.name);
    }
    return all;
  }();
  return names;
}

Kernel derive_kernel(const std::string& name, const Equations& equations) {
  const Entry& entry = entry_of(name);
  Kernel kernel;
  kernel.skipped = absence(entry, equations);
  if (kernel.skipped.empty()) kernel = entry.make(equations);
  kernel.name = name;
  return kernel;
}

Kernel make_kernel(const std::string& name, const Equations& equations) {
  Kernel kernel = derive_kernel(name, equations);
  run_passes_on_results(equations.program(), kernel);
  return kernel;
}

void run_passes_on_results(Program& program, Computation& computation) {
  run_passes(program.passes(), program, computation);
  take_limits_at_roots(program, computation);
}

std::vector<OwnKernel> make_own_kernels(const Scene& scene, const ModelOptions& options,
                                        const std::vector<std::string>& names) {
  std::vector<OwnKernel> kernels;
  for (const std::string& name : names) {
    auto equations = std::make_unique<const Equations>(scene, options);
    Kernel kernel = make_kernel(name, *equations);
    if (kernel.skipped.empty()) kernels.push_back({std::move(equations), std::move(kernel)});
  }
  return kernels;
}

std::string why_absent(const std::string& name, const Equations& equations) {
  return absence(entry_of(name), equations);
}

std::vector<std::string> parse_kernel_list(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    begin = end + 1;
    if (name == "all") {
      for (const std::string& each : usual_kernel_names()) names.push_back(each);
      continue;
    }
    const auto& known = kernel_names();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError(fmt::format("unknown kernel '{}': {}known are {}, or all", name, did_you_mean(name, known),
                                   known_names()));
    }
    names.push_back(name);
  }
  std::vector<std::string> ordered;  // in the order of the header, each once
  for (const std::string& name : kernel_names()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) ordered.push_back(name);
  }
  return ordered;
}

}  // namespace torsor
