// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/composite_bodies.hpp"

namespace torsor {
namespace {

/// Mass properties of a composite seen from its parent link: turned by the joint, moved by the joint's origin.
MassProperties in_parent(const BodyTree& tree, const Link& link, const MassProperties& body) {
  Program& program = tree.program();
  const Vector h = bound(program, tree.to_parent(link, body.first_moment));
  const Matrix turned = tree.to_parent(link, body.inertia);
  MassProperties placed;
  placed.mass = body.mass;
  placed.first_moment = h;
  placed.inertia = turned;
  MassProperties sum;
  add_placed(program, sum, placed, {.rotation = {}, .origin = bound(program, tree.arm(link))});
  return sum;
}

void add(Program& program, MassProperties& sum, const MassProperties& part) {
  sum.mass = program.bind(sum.mass + part.mass);
  sum.first_moment = bound(program, sum.first_moment + part.first_moment);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      sum.inertia(i, j) = sum.inertia(j, i) = program.bind(sum.inertia(i, j) + part.inertia(i, j));
    }
  }
}

}  // namespace

Wrench in_parent(const BodyTree& tree, const Link& link, const Wrench& wrench) {
  Program& program = tree.program();
  Wrench seen;
  seen.resultant = bound(program, tree.to_parent(link, wrench.resultant));
  seen.moment = tree.to_parent(link, wrench.moment);
  const Vector origin = bound(program, tree.arm(link));
  seen.moment = bound(program, seen.moment + cross(origin, seen.resultant));
  return seen;
}

CompositeBodies composite_bodies(const BodyTree& tree, UnitWrenches carried) {
  Program& program = tree.program();
  const auto& links = tree.links();
  CompositeBodies result;
  result.bodies.resize(links.size());
  result.unit_wrenches.resize(links.size());
  for (std::size_t k = 1; k < links.size(); ++k) result.bodies[k] = links[k].mass;
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    const MassProperties& body = result.bodies[k];
    Wrench unit;
    if (link.joint == JointKind::revolute) {
      unit.resultant = bound(program, cross(link.axis, body.first_moment));
      unit.moment = bound(program, body.inertia * link.axis);
    } else {
      unit.resultant = bound(program, body.mass * link.axis);
      unit.moment = bound(program, cross(body.first_moment, link.axis));
    }
    result.unit_wrenches[k].push_back({k, unit});
    for (std::size_t at = k; links[at].parent != 0 && carried == UnitWrenches::to_the_first_link;) {
      unit = in_parent(tree, links[at], unit);
      at = static_cast<std::size_t>(links[at].parent);
      result.unit_wrenches[k].push_back({at, unit});
    }
    if (link.parent != 0) {
      add(program, result.bodies[static_cast<std::size_t>(link.parent)], in_parent(tree, link, body));
    }
  }
  return result;
}

}  // namespace torsor
