// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/forces/virtual_power.hpp"
#include "generator/dynamics/recursions/composite_bodies.hpp"
#include "generator/expression/flattening.hpp"

namespace torsor {

std::vector<std::vector<Value>> mass_matrix(const Model& model) {
  Program& program = model.program();
  const auto& links = model.links();
  const CompositeBodies composites = composite_bodies(model);
  const auto n = static_cast<std::size_t>(model.unknown_count());
  std::vector<std::vector<Value>> joints(n, std::vector<Value>(n));
  for (std::size_t k = links.size(); k-- > 1;) {
    for (const WrenchAt& unit : composites.unit_wrenches[k]) {
      const Link& here = links[unit.link];
      const bool turns = here.joint == JointKind::revolute;
      const Value effort = program.bind(dot(here.axis, turns ? unit.wrench.moment : unit.wrench.resultant));
      for (const auto& [i, partial_i] : here.partials) {
        for (const auto& [j, partial_j] : links[k].partials) {
          if (i >= model.unknown_count() || j >= model.unknown_count()) continue;
          const auto row = static_cast<std::size_t>(i);
          const auto column = static_cast<std::size_t>(j);
          const Value entry = program.bind(partial_i * effort) * partial_j;
          joints[row][column] += entry;
          if (unit.link != k) joints[column][row] += entry;
        }
      }
    }
  }
  const bool several = moves_by_several(model);
  for (auto& row : joints) {
    for (Value& entry : row) entry = program.bind(several ? cancelled(program, entry) : entry);
  }
  return joints;
}

}  // namespace torsor
