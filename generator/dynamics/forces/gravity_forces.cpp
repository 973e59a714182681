// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/gravity_forces.hpp"

#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/program/flattening.hpp"

namespace torsor {
namespace {

/// −g (over the tree's length unit, where it has one) in the axes of each link.
std::vector<Vector> upward_in_links(const BodyTree& tree) {
  std::vector<Vector> all;
  all.push_back(tree.upward_gravity());
  for (std::size_t k = 1; k < tree.links().size(); ++k) {
    const Link& link = tree.links()[k];
    const Vector turned = tree.from_parent(link, all[static_cast<std::size_t>(link.parent)]);
    all.push_back(bound(tree.program(), turned, "minus gravity in the axes of " + link.name + tree.length_note()));
  }
  return all;
}

}  // namespace

std::vector<Value> gravity_forces(const BodyTree& tree) {
  Program& program = tree.program();
  const auto& links = tree.links();
  const std::vector<Vector> upward = upward_in_links(tree);
  std::vector<Value> mass(links.size());
  std::vector<Vector> moment(links.size());
  std::vector<Value> forces(tree.coordinates().size());
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    mass[k] += link.mass.mass;
    mass[k] = program.bind(mass[k]);
    moment[k] += link.mass.first_moment;
    moment[k] = bound(program, moment[k], "first moment of " + link.name + " and what it carries");
    if (link.parent != 0) {
      const auto parent = static_cast<std::size_t>(link.parent);
      const Vector origin = bound(program, tree.arm(link));
      mass[parent] += mass[k];
      moment[parent] += tree.to_parent(link, moment[k]);
      moment[parent] += mass[k] * origin;
    }
    const bool revolute = link.joint == JointKind::revolute;
    const Vector effect = revolute ? cross(moment[k], upward[k]) : mass[k] * upward[k];
    const Value effort = program.bind(dot(link.axis, effect));
    for (const auto& [i, partial] : link.partials) forces[static_cast<std::size_t>(i)] += partial * effort;
  }
  for (Value& force : forces) {
    if (moves_by_several(tree)) force = cancelled(program, force);
    force = program.bind(force);
  }
  return forces;
}

}  // namespace torsor
