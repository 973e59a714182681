// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/bearing_loads.hpp"

#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"

namespace torsor {

std::vector<Vector> across_axis(Program& program, const Link& link) {
  const auto basis = [&program](int i) {
    Vector e;
    e[i] = program.number(Number(1));
    return e;
  };
  if (link.aligned) return {basis((*link.aligned + 1) % 3), basis((*link.aligned + 2) % 3)};
  const Value one = program.number(Number(1));
  const Value side = link.axis[2].is_zero() ? one : program.select(link.axis[2], one, -one);
  const Vector half = bound(program, link.axis + side * basis(2));
  const Value scale = program.bind(side * pow(half[2], -1));
  std::vector<Vector> across;
  for (const int i : {0, 1}) {
    const Value part = program.bind(scale * link.axis[i]);
    across.push_back(bound(program, basis(i) - part * half));
  }
  return across;
}

std::vector<bool> carried_links(const Model& model, int link) {
  std::vector<bool> carried(model.links().size(), false);
  carried[static_cast<std::size_t>(link)] = true;
  for (std::size_t k = static_cast<std::size_t>(link) + 1; k < carried.size(); ++k) {
    carried[k] = carried[static_cast<std::size_t>(model.links()[k].parent)];
  }
  return carried;
}

std::vector<std::vector<Value>> constraint_loads(const Model& model, int link) {
  Program& program = model.program();
  const std::vector<bool> inside = carried_links(model, link);
  const std::vector<Vector> across = across_axis(program, model.links()[static_cast<std::size_t>(link)]);
  std::vector<std::vector<Value>> loads(across.size());
  for (std::size_t j = 0; j < model.scene().constraints.size(); ++j) {
    Vector force;
    if (const auto unit = constraint_wrench(model, static_cast<int>(j))) {
      for (const auto& [on, wrench] : *unit) {
        if (!inside[static_cast<std::size_t>(on)]) continue;
        force = force - model.express(bound(program, wrench.resultant), on, link);
      }
    }
    force = bound(program, force);
    for (std::size_t k = 0; k < across.size(); ++k) loads[k].push_back(program.bind(dot(force, across[k])));
  }
  return loads;
}

}  // namespace torsor
