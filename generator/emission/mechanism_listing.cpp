// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/mechanism_listing.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/emission/cpp_structures.hpp"
#include "torsor/generator/emission/start_values.hpp"
#include "torsor/generator/geometry/exact_turn.hpp"
#include "torsor/generator/kernels/kernel_kinematics.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {
namespace {

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

AskedKernel as_asked(const Kernel& kernel) {
  AskedKernel asked{kernel.name, kernel.skipped, kernel.assignments.size(), 0, 0};
  SumTable seen;
  for (const Assignment& assignment : kernel.assignments) {
    const Polynomial sum = without_sign(assignment.value.polynomial()).first;
    if (sum.is_zero())
      ++asked.zeros;
    else if (!sum.is_constant() && !seen.add(sum).second)
      ++asked.repeated;
  }
  return asked;
}

/// Operations of what was derived, before products that sums share, factoring, and what is done once for a set of
/// parameters. What vanishes in the end costs nothing.
std::optional<int> unoptimised(const Program& program, std::vector<Value> derived, const Kernel& kernel) {
  if (kernel.series) return std::nullopt;
  for (std::size_t i = 0; i < kernel.assignments.size(); ++i) {
    if (kernel.assignments[i].value.is_zero()) derived[i] = Value();
  }
  return count_unoptimised(program, derived).total();
}

class MechanismLowering {
 public:
  explicit MechanismLowering(MechanismListing& mechanism) : mechanism_(&mechanism) {}

  void add(Kernel kernel) {
    Program& program = mechanism_->equations->program();
    std::vector<Value> derived = kernel.values();
    run_passes_on_results(program, kernel);
    const std::optional<int> before = unoptimised(program, std::move(derived), kernel);
    auto [listing, once] = lower_kernel(program, kernel, mechanism_->layout);
    const std::vector<std::size_t> members = precomputation_.add(once);
    for (Quantity& quantity : listing.quantities) {
      if (quantity.table == Table::precomputed) quantity.index = members[quantity.index];
    }
    for (const Structure& structure : kernel.structures) {  // two kernels may share one when it is the same
      if (mechanism_->structure(structure.name) == nullptr) mechanism_->own.push_back(structure);
    }
    mechanism_->asked.push_back(as_asked(kernel));
    mechanism_->kernels.push_back({std::move(kernel), std::move(listing), before});
  }

  void finish() {
    mechanism_->members = precomputation_.members();
    mechanism_->precompute = precomputation_.listing();
  }

 private:
  MechanismListing* mechanism_;
  Precomputation precomputation_;
};

}  // namespace

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

LoweredKernel lower_kernel(Program& program, const Kernel& kernel, const Layout& all) {
  const Layout layout = layout_of(all, kernel);
  const Schedule schedule = make_schedule(program, kernel.values());
  Listing listing = lower(program, schedule.function, kernel, {&layout, &schedule, kernel.name});
  return {std::move(listing), lower_precompute(program, schedule, all)};
}

const Structure* MechanismListing::structure(const std::string& name) const {
  for (const auto* all : {&common, &own}) {
    const auto place = std::find_if(all->begin(), all->end(), [&](const Structure& each) { return each.name == name; });
    if (place != all->end()) return &*place;
  }
  return nullptr;
}

MechanismListing lower_mechanism(const Scene& scene, const std::vector<std::string>& kernels,
                                 const ModelOptions& options, const std::vector<FurtherKernel>& further) {
  MechanismListing mechanism;
  mechanism.equations = std::make_unique<const Equations>(scene, options);
  mechanism.options = options;
  const Equations& equations = *mechanism.equations;
  const std::vector<SymbolPointer> parameters = run_time_parameters(scene, options);
  mechanism.layout = layout_of(equations, parameters);
  mechanism.common = common_structures(equations, parameters);
  mechanism.default_parameters = default_parameters(scene, parameters);
  mechanism.initial_state = initial_state(equations, options, mechanism.layout);
  MechanismLowering lowering(mechanism);
  if (has_quaternions(equations.model())) {
    lowering.add(make_coordinate_rates(equations));
    mechanism.asked.clear();
  }
  for (const std::string& name : kernels) {
    equations.start_over();
    Kernel kernel = derive_kernel(name, equations);
    if (kernel.skipped.empty())
      lowering.add(std::move(kernel));
    else
      mechanism.asked.push_back(as_asked(kernel));
  }
  const std::vector<AskedKernel> asked = mechanism.asked;
  for (const FurtherKernel& each : further) {
    equations.start_over();
    Kernel kernel = each.make(equations);
    kernel.name = each.name;
    lowering.add(std::move(kernel));
  }
  mechanism.asked = asked;  // a command asks for these alone
  equations.start_over();
  lowering.finish();
  for (const auto* structures : {&mechanism.common, &mechanism.own}) {
    for (const Structure& structure : *structures) check_names(structure);
  }
  return mechanism;
}

namespace {

std::string note_on_frames(const BodyTree& tree) {
  if (!tree.is_reframed()) return {};
  std::string text =
      "Frames: in here links have their own, in which turns between joints cost less (--without reframing: those of the\n"
      "scene). Coordinates, inputs, parameters and results are those of the scene. An angle to which a constant is added\n"
      "is rounded once more than its coordinate, by half a unit in the last place of the sum.\n";
  if (tree.rounded_directions() > 0) {
    text += fmt::format(
        "Of the constants {} directions and angles are irrational: rational numbers stand for them, within 1e-{} rad "
        "each.\n",
        tree.rounded_directions(), direction_digits);
  }
  return text;
}

}  // namespace

Provenance provenance_of(const MechanismListing& mechanism, const std::string& language,
                         const std::string& extension) {
  const Scene& scene = mechanism.scene();
  Provenance provenance{&scene, mechanism.options, mechanism.asked, mechanism.layout.parameters, {}};
  provenance.notes = notes(mechanism.equations->redundancy(), scene);
  provenance.frames = note_on_frames(mechanism.equations->model().regrouped());
  provenance.language = language;
  provenance.extension = extension;
  if (const OperationCount once = count(mechanism.precompute); once.total() > 0) {
    provenance.operations.push_back({"precompute", once, std::nullopt});
  }
  for (const KernelListing& each : mechanism.kernels) {
    if (each.kernel.name == "coordinate_rates") continue;
    provenance.operations.push_back({each.kernel.name, count(each.listing), each.before});
  }
  return provenance;
}

}  // namespace torsor
