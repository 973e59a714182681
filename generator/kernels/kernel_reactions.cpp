// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_reactions.hpp"

#include <fmt/format.h>

#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {

Value released_reaction(const Equations& equations, std::size_t coordinate) {
  const std::vector<SymbolPointer> inputs = equations.model().inputs();
  Value reaction = equations.inverse_dynamics()[coordinate];
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Value& partial = equations.actions().inputs[k][coordinate];
    if (!partial.is_zero()) reaction -= partial * equations.program().symbol(inputs[k]);
  }
  return reaction;
}

Kernel make_reactions(const Equations& equations) {
  Kernel kernel;
  const Model& model = equations.model();
  kernel.documentation =
      "Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released\n"
      "direction, at accelerations, multipliers and inputs that belong to the motion.";
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  Structure structure{"Reactions", "Reactions of joints along released directions.", {}};
  for (std::size_t i = unknowns(equations); i < model.coordinates().size(); ++i) {
    const SymbolPointer& q = model.coordinates()[i].q;
    const Unit unit = units::joule / q->unit;
    structure.members.push_back({q->name, 1, 1, {fmt::format("reaction along '{}'", q->name), written_unit(unit)}});
    kernel.assignments.push_back({{"result", q->name}, released_reaction(equations, i)});
  }
  kernel.structures = {structure};
  kernel.results = {{"Reactions", "result"}};
  return kernel;
}

std::string no_reactions(const Equations& equations) {
  return equations.model().released_count() == 0 ? "the scene releases no joint direction (released_coordinate)" : "";
}

}  // namespace torsor
