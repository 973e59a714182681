// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/mechanism_listing.hpp"

#include <algorithm>

#include "generator/emission/cpp_structures.hpp"
#include "generator/emission/kernel_kinematics.hpp"
#include "generator/emission/start_values.hpp"

namespace torsor {
namespace {

Layout layout_of(const Equations& equations, const std::vector<SymbolPointer>& parameters) {
  const Model& model = equations.model();
  Layout layout;
  layout.coordinates = model.positions();
  for (int i = 0; i < model.unknown_count(); ++i) {
    const CoordinateContent& coordinate = model.coordinates()[static_cast<std::size_t>(i)];
    layout.velocities.push_back(coordinate.v);
    layout.accelerations.push_back(coordinate.a);
  }
  layout.inputs = model.inputs();
  for (const ConstraintContent& constraint : model.scene().constraints)
    layout.multipliers.push_back(constraint.multiplier);
  layout.parameters = parameters;
  return layout;
}

/// What a kernel may read.
Layout layout_of(const Layout& all, const Kernel& kernel) {
  const auto is_given = [&kernel](Argument argument) {
    return std::find(kernel.arguments.begin(), kernel.arguments.end(), argument) != kernel.arguments.end();
  };
  Layout layout = all;
  if (!is_given(Argument::accelerations)) layout.accelerations.clear();
  if (!is_given(Argument::multipliers)) layout.multipliers.clear();
  if (!is_given(Argument::inputs)) layout.inputs.clear();
  return layout;
}

Listing lower_kernel(Program& program, const Kernel& kernel, const Block& block, const MechanismListing& mechanism) {
  Request request;
  for (const Assignment& each : kernel.assignments) request.results.push_back({each.target, each.value});
  request.pivots = kernel.pivots;
  request.has_status = kernel.series || !kernel.pivots.empty();
  if (kernel.series) request.series = &*kernel.series;
  const Layout layout = layout_of(mechanism.layout, kernel);
  return lower(program, block, request, {&layout, &mechanism.schedule, kernel.name});
}

}  // namespace

const Structure* MechanismListing::structure(const std::string& name) const {
  for (const auto* all : {&common, &own}) {
    const auto place = std::find_if(all->begin(), all->end(), [&](const Structure& each) { return each.name == name; });
    if (place != all->end()) return &*place;
  }
  return nullptr;
}

MechanismListing lower_mechanism(const Equations& equations, const std::vector<Kernel>& kernels,
                                 const ModelOptions& options) {
  MechanismListing mechanism;
  mechanism.equations = &equations;
  mechanism.options = options;
  Program& program = equations.program();
  const std::vector<SymbolPointer> parameters = run_time_parameters(equations.scene(), options);
  mechanism.layout = layout_of(equations, parameters);
  mechanism.common = common_structures(equations, parameters);
  mechanism.asked = kernels;
  std::vector<Kernel> present;
  if (has_quaternions(equations.model())) present.push_back(make_coordinate_rates(equations));
  std::copy_if(kernels.begin(), kernels.end(), std::back_inserter(present),
               [](const Kernel& kernel) { return kernel.skipped.empty(); });
  std::vector<std::vector<Value>> values;
  for (const Kernel& kernel : present) {
    values.push_back(kernel.values());
    for (const Structure& structure : kernel.structures) {  // two kernels may share one when it is the same
      if (mechanism.structure(structure.name) == nullptr) mechanism.own.push_back(structure);
    }
  }
  for (const auto* structures : {&mechanism.common, &mechanism.own}) {
    for (const Structure& structure : *structures) check_names(structure);
  }
  mechanism.schedule = make_schedule(program, values);
  const Schedule& schedule = mechanism.schedule;
  for (std::size_t k = 0; k < precomputed_count(schedule); ++k) {
    const std::string meaning = k < schedule.members.size() ? program[schedule.members[k]].name : "";
    mechanism.members.push_back({precomputed_name(program, schedule, k), meaning});
  }
  mechanism.default_parameters = default_parameters(equations.scene(), parameters);
  mechanism.precompute = lower_precompute(program, schedule, mechanism.layout);
  mechanism.initial_state = initial_state(equations, options, mechanism.layout);
  for (std::size_t k = 0; k < present.size(); ++k) {
    Listing listing = lower_kernel(program, present[k], schedule.functions[k], mechanism);
    mechanism.kernels.push_back({std::move(present[k]), std::move(listing)});
  }
  return mechanism;
}

Provenance provenance_of(const MechanismListing& mechanism, const std::vector<OperationCount>& of_kernels,
                         const std::string& language, const std::string& extension) {
  const Equations& equations = *mechanism.equations;
  const Scene& scene = equations.scene();
  Provenance provenance{&scene, mechanism.options, mechanism.asked, mechanism.layout.parameters, {}};
  provenance.notes = notes(equations.redundancy(), scene);
  provenance.language = language;
  provenance.extension = extension;
  if (const OperationCount once = count(mechanism.precompute); once.total() > 0) {
    provenance.operations.push_back({"precompute", once, std::nullopt});
  }
  // Before: no inertia moved across joints, no products shared, no factoring, nothing done once for a set of
  // parameters.
  const Equations unoptimised(scene, as_given(mechanism.options));
  for (std::size_t k = 0; k < mechanism.kernels.size(); ++k) {
    const Kernel& kernel = mechanism.kernels[k].kernel;
    if (kernel.name == "coordinate_rates") continue;
    std::optional<int> before;  // recurrences have nothing to be compared with
    if (!kernel.series) {
      const std::vector<Value> values = make_kernel(kernel.name, unoptimised).values();
      before = count_unoptimised(unoptimised.program(), values).total();
    }
    provenance.operations.push_back({kernel.name, of_kernels[k], before});
  }
  return provenance;
}

}  // namespace torsor
