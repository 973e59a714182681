// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/virtual_power.hpp"

namespace torsor {
namespace {

/// Dynamic screw of a link at its origin minus gravity: {m (Γ − g) + U h, δ_O}. The moment J Ω̇ + Ω ∧ J Ω is written
/// with U = [Ω̇] + [Ω][Ω], whose entries the resultant needs anyhow:
/// N_x = J_xx Ω̇_x + (J_zz − J_yy) Ω_y Ω_z − J_xy U_zx + J_xz U_yx + J_yz (Ω_y² − Ω_z²), and so on cyclically.
Wrench dynamic_screw(Program& program, Acceleration& motion, const MassProperties& body) {
  Wrench screw;
  screw.resultant = body.mass * motion.linear();
  screw.resultant += motion.u_times(body.first_moment);
  const Matrix& j = body.inertia;
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    const int z = (x + 2) % 3;
    Value& n = screw.moment[x];
    n += j(x, x) * motion.angular()[x];
    const Value difference = j(z, z) - j(y, y);
    if (!difference.is_zero()) {
      const Value spread = program.bind(difference);
      n += spread * motion.product(y, z);
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

}  // namespace

std::vector<Value> inertia_forces(const Model& model, AccelerationInput input, const std::map<int, Wrench>& wrenches) {
  Program& program = model.program();
  std::vector<Acceleration> motion = accelerations(model, input);
  const auto& links = model.links();
  std::vector<Wrench> load(links.size());
  std::vector<Value> forces(model.coordinates().size());
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    const Wrench own = dynamic_screw(program, motion[k], link.effective);
    load[k].resultant += own.resultant;
    load[k].moment += own.moment;
    if (const auto wrench = wrenches.find(static_cast<int>(k)); wrench != wrenches.end()) {
      load[k].resultant += -wrench->second.resultant;
      load[k].moment += -wrench->second.moment;
    }
    const bool revolute = link.joint == JointKind::revolute;
    const Vector force = bound(program, load[k].resultant, "force on " + link.name);
    const Vector moment = bound(program, load[k].moment, "moment on " + link.name);
    const Value effort = program.bind(dot(link.axis, revolute ? moment : force));
    for (const auto& [i, partial] : link.partials) forces[static_cast<std::size_t>(i)] += partial * effort;
    if (link.parent == 0) continue;
    Wrench& parent = load[static_cast<std::size_t>(link.parent)];
    const Vector turned = model.to_parent(link, force);
    const Vector origin = bound(program, model.origin_in_parent(link));
    parent.resultant += turned;
    parent.moment += model.to_parent(link, moment);
    parent.moment += cross(origin, turned);
  }
  return forces;
}

}  // namespace torsor
