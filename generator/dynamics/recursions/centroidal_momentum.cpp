// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/centroidal_momentum.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/motion/ground_motion.hpp"

namespace torsor {
namespace {

/// By link: it and all that it carries, about its origin, in its axes; lengths in metres.
std::vector<MassProperties> composites(const Model& model) {
  Program& program = model.program();
  const auto& links = model.links();
  std::vector<MassProperties> bodies(links.size());
  const std::vector<bool> is_rotor = rotor_links(model);
  for (std::size_t k = 1; k < links.size(); ++k) {
    if (!is_rotor[k]) bodies[k] = links[k].mass;
  }
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    MassProperties& body = bodies[k];
    body.mass = program.bind(body.mass);
    body.first_moment = bound(program, body.first_moment);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) body.inertia(i, j) = body.inertia(j, i) = program.bind(body.inertia(i, j));
    }
    if (link.parent == 0) continue;
    MassProperties turned;
    turned.mass = body.mass;
    turned.first_moment = bound(program, model.to_parent(link, body.first_moment));
    turned.inertia = model.to_parent(link, body.inertia);
    add_placed(program, bodies[static_cast<std::size_t>(link.parent)], turned,
               {.rotation = {}, .origin = bound(program, model.origin_in_parent(link))});
  }
  return bodies;
}

/// Places relative to the origin of the first link that the ground carries. Along its chain they are sums of distances
/// from joint to joint, and have their digits wherever the mechanism is.
std::vector<Vector> places(const Model& model, const GroundMotion& motion) {
  Program& program = model.program();
  const auto& links = model.links();
  std::vector<Vector> all(links.size());
  int first = 0;
  for (std::size_t k = 1; k < links.size(); ++k) {
    const Link& link = links[k];
    if (link.parent == 0) {
      if (first == 0) first = static_cast<int>(k);
      const bool is_first = first == static_cast<int>(k);
      if (!is_first) all[k] = bound(program, motion.origin(static_cast<int>(k)) - motion.origin(first));
      continue;
    }
    const Vector step = bound(program, model.origin_in_parent(link));
    const Vector turned = bound(program, motion.rotation(link.parent) * step);
    all[k] = bound(program, all[static_cast<std::size_t>(link.parent)] + turned);
  }
  return all;
}

}  // namespace

bool moves_mass(const Model& model) {
  const auto& links = model.links();
  return std::any_of(links.begin() + 1, links.end(), [](const Link& link) { return !link.mass.mass.is_zero(); });
}

CentroidalMomentum centroidal_momentum(const Model& model) {
  Program& program = model.program();
  const auto& links = model.links();
  const GroundMotion motion(model);
  const std::vector<MassProperties> bodies = composites(model);
  const std::vector<Vector> at = places(model, motion);

  Value mass;
  Vector moment;
  int first = 0;
  for (std::size_t k = 1; k < links.size(); ++k) {
    if (links[k].parent != 0) continue;
    if (first == 0) first = static_cast<int>(k);
    const Vector turned = bound(program, motion.rotation(static_cast<int>(k)) * bodies[k].first_moment);
    mass += bodies[k].mass;
    moment += turned;
    moment += bodies[k].mass * at[k];
  }
  mass = program.bind(mass);
  moment = bound(program, moment);
  Vector to_center;  // from the origin of the first link
  for (int i = 0; i < 3; ++i) {
    if (!moment[i].is_zero()) to_center[i] = program.bind(moment[i] / mass);
  }

  CentroidalMomentum result;
  result.center = bound(program, motion.origin(first) + to_center, "centre of mass");
  result.columns.resize(model.coordinates().size());
  for (std::size_t k = 1; k < links.size(); ++k) {
    const Link& link = links[k];
    const MassProperties& body = bodies[k];
    const bool revolute = link.joint == JointKind::revolute;
    // In the link's axes, about its origin
    const Vector linear = bound(program, revolute ? cross(link.axis, body.first_moment) : body.mass * link.axis);
    const Vector angular = bound(program, revolute ? body.inertia * link.axis : cross(body.first_moment, link.axis));
    const Matrix& turn = motion.rotation(static_cast<int>(k));
    MomentumScrew unit;
    unit.resultant = bound(program, turn * linear);
    unit.moment = turn * angular;
    unit.moment += cross(bound(program, at[k] - to_center), unit.resultant);
    unit.moment = bound(program, unit.moment);
    result.momentum.resultant += link.rate * unit.resultant;
    result.momentum.moment += link.rate * unit.moment;
    for (const auto& [i, partial] : link.partials) {
      MomentumScrew& column = result.columns[static_cast<std::size_t>(i)];
      column.resultant += partial * unit.resultant;
      column.moment += partial * unit.moment;
    }
  }
  result.momentum.resultant = bound(program, result.momentum.resultant);
  result.momentum.moment = bound(program, result.momentum.moment);
  for (MomentumScrew& column : result.columns) {
    column.resultant = bound(program, column.resultant);
    column.moment = bound(program, column.moment);
  }
  return result;
}

}  // namespace torsor
