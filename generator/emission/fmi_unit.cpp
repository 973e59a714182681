// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_unit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/kernels/kernel_contact_derivatives.hpp"
#include "torsor/generator/kernels/kernel_sizes.hpp"

namespace torsor {
namespace {

std::vector<std::string> kernels_of_unit(const Scene& scene, const ModelOptions& options) {
  std::vector<std::string> names = {"forward_dynamics", "energy"};
  const bool contacts = !scene.content().contacts.empty();
  if (!contacts) names.push_back("forward_dynamics_derivatives");
  if (!contacts && !run_time_parameters(scene, options).empty()) names.push_back("forward_dynamics_sensitivities");
  if (contacts || !scene.content().constraints.empty()) names.push_back("mass_matrix");
  if (!scene.content().constraints.empty()) names.push_back("constraints");
  if (contacts) names.insert(names.end(), {"bias", "contacts", "contact_coefficients"});
  return names;
}

std::vector<FurtherKernel> output_kernels(const OutputNames& names) {
  using Make = Kernel (*)(const Equations&, const OutputNames&);
  std::vector<FurtherKernel> kernels;
  const auto add = [&](const char* name, Make make) {
    kernels.push_back({name, [make, &names](const Equations& equations) { return make(equations, names); }});
  };
  if (names.places()) add("output_places", make_output_places);
  if (!names.reactions.empty()) add("output_reactions", make_output_reactions);
  kernels.push_back({"energy_derivatives", make_energy_derivatives});
  if (names.places()) add("output_place_derivatives", make_output_place_derivatives);
  if (!names.reactions.empty()) add("output_reaction_derivatives", make_output_reaction_derivatives);
  return kernels;
}

void require_motion(const MechanismListing& mechanism) {
  for (const AskedKernel& kernel : mechanism.asked) {
    if (kernel.skipped.empty()) continue;
    throw SceneError(fmt::format("the scene '{}' has no kernel {}, and a unit of FMI moves by it: {}",
                                 mechanism.scene().name(), kernel.name, kernel.skipped));
  }
}

}  // namespace

FmiUnit lower_unit(const Scene& scene, FmiVersion version, const OutputNames& outputs, const ModelOptions& options) {
  if (!outputs.reactions.empty() && !scene.content().contacts.empty()) {
    throw SceneError(
        fmt::format("the scene '{}' has contacts, whose forces share in its reactions: a unit has none of '{}'",
                    scene.name(), outputs.reactions.front()));
  }
  FmiUnit unit;
  unit.version = version;
  unit.outputs = outputs;
  unit.sizes = bounds_that_depend_on(scene.content(), run_time_parameters(scene, options));
  std::vector<FurtherKernel> further = output_kernels(outputs);
  if (!scene.content().contacts.empty()) {
    further.push_back({"contact_motion_derivatives", make_contact_motion_derivatives});
    further.push_back({"contact_row_derivatives", make_contact_row_derivatives});
  }
  if (!unit.sizes.empty()) {
    further.push_back({"run_time_sizes", [&unit](const Equations& equations) { return make_sizes(equations, unit.sizes); }});
  }
  unit.mechanism = lower_mechanism(scene, kernels_of_unit(scene, options), options, further);
  require_motion(unit.mechanism);
  return unit;
}

}  // namespace torsor
