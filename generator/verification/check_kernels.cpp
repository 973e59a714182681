// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "generator/kernels/kernel.hpp"
#include "generator/verification/condition.hpp"
#include "generator/verification/random_state.hpp"
#include "generator/verification/sensitivity.hpp"
#include "generator/verification/worst.hpp"

namespace torsor {
namespace {

/// Indices of a kernel's assignments gathered by unit: numbers of different units have no common norm.
std::vector<std::vector<std::size_t>> groups_by_unit(const Kernel& kernel) {
  std::vector<std::pair<Unit, std::vector<std::size_t>>> groups;
  for (std::size_t i = 0; i < kernel.assignments.size(); ++i) {
    const Value& value = kernel.assignments[i].value;
    if (value.is_zero()) continue;
    auto place = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == value.unit(); });
    if (place == groups.end()) place = groups.insert(groups.end(), {value.unit(), {}});
    place->second.push_back(i);
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& [unit, members] : groups) result.push_back(std::move(members));
  return result;
}

Evaluator<Sensitivity>::SymbolValue with_sensitivity(const RandomState& state) {
  return [value = state.in_double()](const SymbolPointer& symbol) {
    return sensitivity_input(value(symbol), static_cast<std::uint64_t>(symbol->index));
  };
}

/// |double - exact| of the assignments of one unit, relative to their norm. Where that is above `enough` the terms of
/// the result may cancel, or a solve be nearly singular at this state: the error is then compared with what as large an
/// error of the inputs would do, if that is larger.
double relative_error(const Kernel& kernel, const std::vector<std::size_t>& group, Evaluator<double>& fast,
                      Evaluator<Real>& exact, Evaluator<Sensitivity>& sensitive, double enough) {
  double difference = 0;
  double size = 0;
  for (const std::size_t index : group) {
    const Value& value = kernel.assignments[index].value;
    const Real truth = exact(value);
    const double error = (Real::from_double(fast(value)) - truth).to_double();
    difference += error * error;
    size += truth.to_double() * truth.to_double();
  }
  if (difference == 0) return 0;
  const double relative = std::sqrt(difference / size);
  if (relative <= enough) return relative;
  double moved = 0;
  for (const std::size_t index : group) moved += mean_square(sensitive(kernel.assignments[index].value));
  return std::min(relative, std::sqrt(difference / moved));
}

}  // namespace

std::vector<CheckResult> check_kernels(const Scene& scene, const CheckOptions& options) {
  const WorkingDigits precision(options.digits + 10);
  const Equations equations(scene);
  std::vector<Kernel> kernels;
  for (const std::string& name : options.kernels.empty() ? usual_kernel_names() : options.kernels) {
    Kernel kernel = make_kernel(name, equations);
    if (kernel.skipped.empty() && !kernel.series) kernels.push_back(std::move(kernel));  // series: check_jets
  }
  std::vector<double> worst(kernels.size(), 0);
  const Program& program = equations.program();
  const auto reduces = [](const Kernel& kernel) { return kernel.name == "linearisation"; };
  const bool solved = equations.massless().empty();
  std::optional<IndependentFreedoms> reduction;
  if (!equations.constraints().empty() && std::any_of(kernels.begin(), kernels.end(), reduces)) {
    reduction = independent_freedoms(equations);
  }
  Evaluator<double> fast(program, {});
  Evaluator<Real> exact(program, {});
  Evaluator<Sensitivity> sensitive(program, {});
  for (int k = 0; k < options.states; ++k) {
    const RandomState state(scene, static_cast<std::uint64_t>(k) + 1);
    fast.move_to(state.in_double());
    exact.move_to(state.in_real());
    sensitive.move_to(with_sensitivity(state));
    const double of_motion = solved ? motion_condition(equations, exact) : 1.0;
    const double of_reduction = reduction ? reduction_condition(equations, *reduction, exact) : of_motion;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      const Kernel& kernel = kernels[i];
      // Solves lose what the condition of their matrix costs: 1e-14 of it, expressed against the common bound of 1e-13.
      double condition = kernel.name == "linearisation" ? of_reduction : of_motion;
      // Two solves in succession: the second with what the first gave.
      if (kernel.name == "forward_dynamics_derivatives" || kernel.name == "forward_dynamics_sensitivities") {
        condition *= of_motion;
      }
      if (kernel.name == "forward_dynamics_second_derivatives") condition *= of_motion * of_motion;
      const double allowance = kernel.pivots.empty() ? 1 : std::max(1.0, condition / 10);
      for (const auto& group : groups_by_unit(kernel)) {
        const double relative = relative_error(kernel, group, fast, exact, sensitive, allowance * worst[i]) / allowance;
        if (is_worse(relative, worst[i])) worst[i] = relative;
      }
    }
  }
  std::vector<CheckResult> results;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const bool solves = !kernels[i].pivots.empty();
    results.push_back({"double." + kernels[i].name,
                       solves ? "double against CLN, as a multiple of max(1, condition/10)" : "double against CLN",
                       worst[i], 1e-13});
  }
  return results;
}

}  // namespace torsor
