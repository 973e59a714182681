// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/virtual_power.hpp"

namespace torsor {
namespace {

/// Mass properties of a composite seen from its parent link: turned by the joint, moved by the joint's origin.
MassProperties in_parent(const Model& model, const Link& link, const MassProperties& body) {
  Program& program = model.program();
  const Vector h = bound(program, model.to_parent(link, body.first_moment));
  const Matrix turned = model.to_parent(link, body.inertia);
  MassProperties placed;
  placed.mass = body.mass;
  placed.first_moment = h;
  placed.inertia = turned;
  MassProperties sum;
  add_placed(program, sum, placed, Rotation(), bound(program, model.origin_in_parent(link)));
  return sum;
}

}  // namespace

std::vector<std::vector<Value>> mass_matrix(const Model& model) {
  Program& program = model.program();
  const auto& links = model.links();
  std::vector<MassProperties> composite(links.size());
  for (std::size_t k = 1; k < links.size(); ++k) composite[k] = links[k].effective;
  const auto n = static_cast<std::size_t>(model.unknown_count());
  std::vector<std::vector<Value>> joints(n, std::vector<Value>(n));
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    // Wrench that gives the composite the unit acceleration of joint k.
    Wrench unit;
    const MassProperties& body = composite[k];
    if (link.joint == JointKind::revolute) {
      unit.resultant = cross(link.axis, body.first_moment);
      unit.moment = body.inertia * link.axis;
    } else {
      unit.resultant = body.mass * link.axis;
      unit.moment = cross(body.first_moment, link.axis);
    }
    std::size_t at = k;
    while (true) {
      const Link& here = links[at];
      const Value effort =
          program.bind(dot(here.axis, here.joint == JointKind::revolute ? unit.moment : unit.resultant));
      for (const auto& [i, partial_i] : here.partials) {
        for (const auto& [j, partial_j] : link.partials) {
          if (i >= model.unknown_count() || j >= model.unknown_count()) continue;
          const auto row = static_cast<std::size_t>(i);
          const auto column = static_cast<std::size_t>(j);
          const Value entry = program.bind(partial_i * effort) * partial_j;
          joints[row][column] += entry;
          if (at != k) joints[column][row] += entry;
        }
      }
      if (here.parent == 0) break;
      const Vector force = bound(program, model.to_parent(here, bound(program, unit.resultant)));
      const Vector moment = model.to_parent(here, bound(program, unit.moment));
      const Vector origin = bound(program, model.origin_in_parent(here));
      unit.resultant = force;
      unit.moment = moment + cross(origin, force);
      at = static_cast<std::size_t>(here.parent);
    }
    if (link.parent != 0) {
      const MassProperties seen = in_parent(model, link, body);
      MassProperties& parent = composite[static_cast<std::size_t>(link.parent)];
      parent.mass = program.bind(parent.mass + seen.mass);
      parent.first_moment = bound(program, parent.first_moment + seen.first_moment);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
          parent.inertia(i, j) = parent.inertia(j, i) = program.bind(parent.inertia(i, j) + seen.inertia(i, j));
        }
      }
    }
  }
  for (auto& row : joints) {
    for (Value& entry : row) entry = program.bind(entry);
  }
  return joints;
}

}  // namespace torsor
