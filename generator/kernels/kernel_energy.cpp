// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_energy.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include "torsor/generator/dynamics/equations/forward_choice.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/program/paired_cosines.hpp"

namespace torsor {

Energies energies_of(const Equations& equations) {
  const Model& model = equations.model();
  Energies energies;
  if (light_matter_may_carry_heavy(model)) {
    energies.kinetic = kinetic_energy_about_centres(model);
    energies.force_function = with_paired_cosines(equations.program(), gravity_force_function(model));
  } else {
    energies.kinetic = kinetic_energy(model);
    energies.force_function = gravity_force_function(model);
  }
  energies.force_function += equations.actions().spring_force_function;
  return energies;
}

Kernel make_energy(const Equations& equations) {
  Kernel kernel;
  kernel.documentation = "Kinetic energy, force function (potential energy = -U) and power of what has no force function.";
  kernel.arguments = {Argument::inputs};
  const auto& actions = equations.scene().content().actions;
  const bool further = std::any_of(actions.begin(), actions.end(), [](const ActionContent& action) {
    return std::holds_alternative<GivenForceFunction>(action) || std::holds_alternative<Gravitation>(action);
  });
  const std::string u = further ? "force function U of gravity, springs, attractions and given functions"
                                : "force function U of gravity and springs";
  const std::string power = has_friction(equations)
                                ? "power of friction (by the multipliers of the motion), dampers, given forces and motors"
                                : "power of dampers, given forces and motors";
  kernel.structures = {{"Energy",
                        "Energies of the mechanism.",
                        {{"kinetic", 1, 1, {"kinetic energy T", "J"}},
                         {"force_function", 1, 1, {u, "J"}},
                         {"power", 1, 1, {power, "W"}}}}};
  kernel.results = {{"Energy", "result"}};
  const Energies energies = energies_of(equations);
  kernel.assignments = {{{"result", "kinetic"}, energies.kinetic},
                        {{"result", "force_function"}, energies.force_function},
                        {{"result", "power"}, equations.power()}};
  return kernel;
}

}  // namespace torsor
