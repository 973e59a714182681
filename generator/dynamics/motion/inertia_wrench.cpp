// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/inertia_wrench.hpp"

namespace torsor {
namespace {

/// Motion of R's own matter at a link's origin, in the link's axes.
BodyMotion carried(const Model& model, int link, int observer) {
  Program& program = model.program();
  const BodyMotion own = body_motion(model, observer, 0);
  const Vector place = bound(program, model.locate(Vector(), link, observer));
  const Vector velocity = bound(program, own.velocity_at(place));
  const Vector acceleration = bound(program, own.acceleration_at(place));
  BodyMotion motion;
  motion.twist.angular = model.express(own.twist.angular, observer, link);
  motion.twist.linear = model.express(velocity, observer, link);
  motion.angular_acceleration = model.express(own.angular_acceleration, observer, link);
  motion.origin_acceleration = model.express(acceleration, observer, link);
  return motion;
}

Wrench sum_over(const Model& model, const BodyNames& bodies, const ScrewQuery& query, const std::string& user,
                Wrench (*of_link)(const Model&, int, int, const MassProperties&)) {
  const int observer = model.place(query.observer, user).link;
  Wrench sum;
  for (const auto& [link, mass] : mass_by_link(model, bodies, user)) {
    const Wrench own = of_link(model, link, observer, mass);
    sum = sum + as_asked(model, own, link, query);
  }
  return {bound(model.program(), sum.resultant), bound(model.program(), sum.moment)};
}

Wrench transport_of(const Model& model, int link, int observer, const MassProperties& mass) {
  const DynamicScrew screw = dynamic_screw_at_origin(model.program(), mass, carried(model, link, observer));
  return {-screw.resultant, -screw.moment};
}

/// About the link's origin O instead of G: ∫ OP ∧ (Ω ∧ V) dm = h ∧ (Ω ∧ V_O) + ω ∧ J_O Ω + ½ tr(J_O) Ω ∧ ω.
Wrench coriolis_of(const Model& model, int link, int observer, const MassProperties& mass) {
  Program& program = model.program();
  const Vector turning = model.express(relative_twist(model, observer, 0).angular, observer, link);
  const Twist seen = relative_twist(model, link, observer);
  const Vector momentum_seen = bound(program, momentum(mass, seen).resultant);
  const Vector of_origin = bound(program, cross(turning, seen.linear));
  const Vector operated = bound(program, mass.inertia * turning);
  const Value trace_of_j = program.bind(mass.inertia(0, 0) + mass.inertia(1, 1) + mass.inertia(2, 2));
  Wrench wrench;
  wrench.resultant = program.number(Number(-2)) * cross(turning, momentum_seen);
  wrench.moment = program.number(Number(-2)) * cross(mass.first_moment, of_origin);
  wrench.moment += program.number(Number(-2)) * cross(seen.angular, operated);
  wrench.moment += -(trace_of_j * cross(turning, seen.angular));
  return wrench;
}

}  // namespace

Wrench inertia_wrench_at_origin(const Model& model, const MassProperties& mass, int link, int observer) {
  const Wrench transport = transport_of(model, link, observer, mass);
  return transport + coriolis_of(model, link, observer, mass);
}

Wrench transport_inertia_wrench(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  return sum_over(model, bodies, query, "a transport inertia wrench", transport_of);
}

Wrench coriolis_inertia_wrench(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  return sum_over(model, bodies, query, "a Coriolis inertia wrench", coriolis_of);
}

}  // namespace torsor
