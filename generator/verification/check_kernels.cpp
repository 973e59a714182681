// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/condition.hpp"
#include "torsor/generator/verification/kernel_text.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/sensitivity.hpp"
#include "torsor/generator/verification/worst.hpp"

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

NumbersOf<double> numbers_in_double() {
  return {[](const Number& number) { return number.to_double(); },
          [](const RoundedConstant& constant) { return constant.in_double; }, std::numbers::pi};
}

/// A kernel as it is emitted, beside its exact results.
class KernelCheck {
 public:
  KernelCheck(const Scene& scene, OwnKernel own)
      : own_(std::move(own)),
        text_(scene, {}, own_, numbers_in_double()),
        exact_(own_.equations->program(), {}),
        sensitive_(own_.equations->program(), {}),
        groups_(groups_by_unit(own_.kernel)) {}

  const std::string& name() const { return own_.kernel.name; }
  bool solves() const { return !own_.kernel.pivots.empty(); }
  double worst() const { return worst_; }

  /// `allowance`: how many times the bound is allowed.
  void at(const RandomState& state, double allowance) {
    text_.move_to(state.in_double());
    exact_.move_to(state.in_real());
    sensitive_.move_to(with_sensitivity(state));
    for (const std::vector<std::size_t>& group : groups_) {
      const double relative = relative_error(group, allowance * worst_) / allowance;
      if (is_worse(relative, worst_)) worst_ = relative;
    }
  }

 private:
  /// |double - exact| of the results of one unit, relative to their norm. Where that is above `enough` the terms of
  /// the result may cancel, or a solve be nearly singular at this state: the error is then compared with what as large an
  /// error of the inputs would do, if that is larger.
  double relative_error(const std::vector<std::size_t>& group, double enough) {
    double difference = 0;
    double size = 0;
    for (const std::size_t index : group) {
      const Real truth = exact_(own_.kernel.assignments[index].value);
      const double error = (Real::from_double(text_.results()[index]) - truth).to_double();
      difference += error * error;
      size += truth.to_double() * truth.to_double();
    }
    if (difference == 0) return 0;
    const double relative = std::sqrt(difference / size);
    if (relative <= enough) return relative;
    double moved = 0;
    for (const std::size_t index : group) moved += mean_square(sensitive_(own_.kernel.assignments[index].value));
    return std::min(relative, std::sqrt(difference / moved));
  }

  OwnKernel own_;
  KernelText<double> text_;
  Evaluator<Real> exact_;
  Evaluator<Sensitivity> sensitive_;
  std::vector<std::vector<std::size_t>> groups_;
  double worst_ = 0;
};

}  // namespace

std::vector<CheckResult> check_kernels(const Scene& scene, const CheckOptions& options) {
  const WorkingDigits precision(options.digits + 10);
  std::vector<KernelCheck> kernels;
  for (OwnKernel& own : make_own_kernels(scene, {}, options.kernels.empty() ? usual_kernel_names() : options.kernels)) {
    if (!own.kernel.series) kernels.emplace_back(scene, std::move(own));  // series: check_jets
  }
  const Equations equations(scene);
  const auto reduces = [](const KernelCheck& kernel) { return kernel.name() == "linearisation"; };
  const bool solved = equations.massless().empty();
  std::optional<IndependentFreedoms> reduction;
  if (!equations.constraints().empty() && std::any_of(kernels.begin(), kernels.end(), reduces)) {
    reduction = independent_freedoms(equations);
  }
  Evaluator<Real> exact(equations.program(), {});
  for (int k = 0; k < options.states; ++k) {
    const RandomState state(scene, static_cast<std::uint64_t>(k) + 1);
    exact.move_to(state.in_real());
    const double of_motion = solved ? motion_condition(equations, exact) : 1.0;
    const double of_reduction = reduction ? reduction_condition(equations, *reduction, exact) : of_motion;
    for (KernelCheck& kernel : kernels) {
      // Solves lose what the condition of their matrix costs: 1e-14 of it, expressed against the common bound of 1e-13.
      double condition = reduces(kernel) ? of_reduction : of_motion;
      // Two solves in succession: the second with what the first gave.
      if (kernel.name() == "forward_dynamics_derivatives" || kernel.name() == "forward_dynamics_sensitivities") {
        condition *= of_motion;
      }
      if (kernel.name() == "forward_dynamics_second_derivatives") condition *= of_motion * of_motion;
      kernel.at(state, kernel.solves() ? std::max(1.0, condition / 10) : 1);
    }
  }
  std::vector<CheckResult> results;
  for (const KernelCheck& kernel : kernels) {
    const std::string against = kernel.solves() ? "double against CLN, as a multiple of max(1, condition/10)" : "double against CLN";
    results.push_back({"double." + kernel.name(), against, kernel.worst(), 1e-13});
  }
  return results;
}

}  // namespace torsor
