// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/virtual_power.hpp"

#include <algorithm>

#include "torsor/generator/program/flattening.hpp"

namespace torsor {
namespace {

/// A tip that looks the same at every angle (a wheel, a rotor): inertia about its axis only, once regrouped. Written in
/// unturned axes it needs neither sine nor cosine of its angle.
bool looks_the_same_turned(const BodyTree& tree, std::size_t k, const std::map<int, Wrench>& wrenches) {
  const Link& link = tree.links()[k];
  if (link.turn != Turn::aligned || wrenches.contains(static_cast<int>(k))) return false;
  for (const Link& other : tree.links()) {
    if (other.parent == static_cast<int>(k)) return false;
  }
  const MassProperties& body = link.mass;
  bool symmetric = body.mass.is_zero() && body.first_moment.is_zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      symmetric = symmetric && (body.inertia(i, j).is_zero() || (i == link.aligned && j == link.aligned));
    }
  }
  return symmetric;
}

}  // namespace

Wrench screw_less_gravity(Program& program, Acceleration& motion, const Link& link) {
  const MassProperties& body = link.mass;
  Wrench screw;
  screw.resultant = body.mass * motion.linear();
  screw.resultant += motion.u_times(body.first_moment);
  const Matrix& j = body.inertia;
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    const int z = (x + 2) % 3;
    Value& n = screw.moment[x];
    if (link.without_line == z) {
      if (!j(x, x).is_zero()) n += j(x, x) * motion.u(z, y);  // S_yy = J_xx
    } else if (link.without_line == y) {
      if (!j(x, x).is_zero()) n -= j(x, x) * motion.u(y, z);  // S_zz = J_xx
    } else {
      n += j(x, x) * motion.angular()[x];
      const Value difference = j(z, z) - j(y, y);
      if (!difference.is_zero()) {
        const Value spread = program.bind(difference);
        n += spread * motion.product(y, z);
      }
    }
    if (!j(x, y).is_zero()) n -= j(x, y) * motion.u(z, x);
    if (!j(x, z).is_zero()) n += j(x, z) * motion.u(y, x);
    if (!j(y, z).is_zero()) {
      const Value square = motion.product(y, y);
      const Value spread = program.bind(square - motion.product(z, z));
      n += j(y, z) * spread;
    }
  }
  screw.moment += cross(body.first_moment, motion.linear());
  return screw;
}

std::vector<Wrench> joint_wrenches(const BodyTree& tree, std::vector<Acceleration>& motion, const std::vector<Axes>& axes,
                                   const std::map<int, Wrench>& wrenches) {
  Program& program = tree.program();
  const auto& links = tree.links();
  std::vector<Wrench> load(links.size());
  const std::string force_note = tree.length_note(", times");
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    const Wrench own = screw_less_gravity(program, motion[k], link);
    load[k].resultant += own.resultant;
    load[k].moment += own.moment;
    if (const auto wrench = wrenches.find(static_cast<int>(k)); wrench != wrenches.end()) {
      const Wrench applied = tree.applied(k, wrench->second);
      load[k].resultant += -applied.resultant;
      load[k].moment += -applied.moment;
    }
    load[k].resultant = bound(program, load[k].resultant, "force on " + link.name + force_note);
    load[k].moment = bound(program, load[k].moment, "moment on " + link.name);
    if (link.parent == 0) continue;
    const auto to_parent = [&](const Vector& v) {
      return axes[k] == Axes::own ? tree.to_parent(link, v) : tree.from_joint(link, v);
    };
    Wrench& parent = load[static_cast<std::size_t>(link.parent)];
    const Vector turned = to_parent(load[k].resultant);
    const Vector origin = bound(program, tree.arm(link));
    parent.resultant += turned;
    parent.moment += to_parent(load[k].moment);
    parent.moment += cross(origin, turned);
  }
  return load;
}

namespace {

std::vector<Axes> cheapest_axes(const BodyTree& tree, const std::map<int, Wrench>& wrenches) {
  std::vector<Axes> axes(tree.links().size(), Axes::own);
  for (std::size_t k = 1; k < axes.size(); ++k) {
    if (looks_the_same_turned(tree, k, wrenches)) axes[k] = Axes::unturned;
  }
  return axes;
}

/// Along every coordinate, of the wrenches that joints carry.
std::vector<Value> along_coordinates(const BodyTree& tree, const std::vector<Wrench>& load) {
  std::vector<Value> forces(tree.coordinates().size());
  for (std::size_t k = load.size(); k-- > 1;) {
    const Link& link = tree.links()[k];
    const bool revolute = link.joint == JointKind::revolute;
    const Value effort = tree.program().bind(dot(link.axis, revolute ? load[k].moment : load[k].resultant));
    for (const auto& [i, partial] : link.partials) forces[static_cast<std::size_t>(i)] += partial * effort;
  }
  if (moves_by_several(tree)) {
    for (Value& force : forces) force = cancelled(tree.program(), force);
  }
  return forces;
}

}  // namespace

bool moves_by_several(const BodyTree& tree) {
  const auto& links = tree.links();
  return std::any_of(links.begin(), links.end(), [](const Link& link) { return link.partials.size() > 1; });
}

std::vector<Value> inertia_forces(const BodyTree& tree, AccelerationInput input, const std::map<int, Wrench>& wrenches) {
  const std::vector<Axes> axes = cheapest_axes(tree, wrenches);
  std::vector<Acceleration> motion = accelerations(tree, input, axes);
  return along_coordinates(tree, joint_wrenches(tree, motion, axes, wrenches));
}

ReferenceForces reference_forces(const BodyTree& tree, const std::map<int, Wrench>& wrenches) {
  const std::vector<Axes> axes = cheapest_axes(tree, wrenches);
  ReferenceMotion motion = reference_motion(tree, axes);
  ReferenceForces result;
  result.forces = along_coordinates(tree, joint_wrenches(tree, motion.links, axes, wrenches));
  result.accelerations.resize(result.forces.size());
  for (std::size_t k = 1; k < tree.links().size(); ++k) {
    for (const auto& [i, partial] : tree.links()[k].partials) {
      result.accelerations[static_cast<std::size_t>(i)] = motion.joints[k];
    }
  }
  return result;
}

}  // namespace torsor
