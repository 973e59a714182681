// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/virtual_power.hpp"

namespace torsor {
namespace {

/// R J Rᵀ for the joint's turn. About an aligned axis z, with d = J_xx − J_yy and u = s d + 2 c J_xy:
/// J'_xx = J_xx − s u, J'_yy = J_yy + s u, J'_xy = c u − J_xy, and (J_xz, J_yz) turns as a vector. 16 operations.
Matrix turned_about_axis(Program& program, const Link& link, const Matrix& j) {
  if (link.joint != JointKind::revolute) return j;
  if (link.aligned < 0) return bound(program, bound(program, link.rotation * j) * transpose(link.rotation));
  const int z = link.aligned;
  const int x = (z + 1) % 3;
  const int y = (z + 2) % 3;
  const Value difference = program.bind(j(x, x) - j(y, y));
  Value u = link.sine * difference;
  u += link.cosine * program.bind(Number(2) * j(x, y));
  u = program.bind(u);
  const Value change = program.bind(link.sine * u);
  Matrix turned = j;
  turned(x, x) = program.bind(j(x, x) - change);
  turned(y, y) = program.bind(j(y, y) + change);
  turned(x, y) = turned(y, x) = program.bind(link.cosine * u - j(x, y));
  const Value xz = link.cosine * j(x, z) - link.sine * j(y, z);
  const Value yz = link.sine * j(x, z) + link.cosine * j(y, z);
  turned(x, z) = turned(z, x) = program.bind(xz);
  turned(y, z) = turned(z, y) = program.bind(yz);
  return turned;
}

/// Mass properties of a composite seen from its parent link: turned by the joint, moved by the joint's origin.
MassProperties in_parent(const Model& model, const Link& link, const MassProperties& body) {
  Program& program = model.program();
  const Vector h = bound(program, model.to_parent(link, body.first_moment));
  const Matrix in_joint = turned_about_axis(program, link, body.inertia);
  const Matrix placement = constant_matrix(program, link.placement_rotation);
  const Matrix turned = bound(program, placement * in_joint * transpose(placement));
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
