// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/body_screws.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

DynamicScrew dynamic_screw_at_origin(Program& program, const MassProperties& body, const BodyMotion& motion) {
  const Vector& omega = motion.twist.angular;
  const Vector& turning = motion.angular_acceleration;
  DynamicScrew screw;
  screw.resultant = body.mass * motion.origin_acceleration;
  screw.resultant += cross(turning, body.first_moment);
  const Vector carried = bound(program, cross(omega, body.first_moment));
  screw.resultant += cross(omega, carried);
  screw.moment = body.inertia * turning;
  const Vector spin = bound(program, body.inertia * omega);
  screw.moment += cross(omega, spin);
  screw.moment += cross(body.first_moment, motion.origin_acceleration);
  return screw;
}

MomentumScrew momentum_screw(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  const std::string user = "a momentum screw";
  const int observer = model.place(query.observer, user).link;
  MomentumScrew sum;
  for (const auto& [link, mass] : mass_by_link(model, bodies, user)) {
    const MomentumScrew own = momentum(mass, relative_twist(model, link, observer));
    sum = sum + as_asked(model, own, link, query);
  }
  return {bound(model.program(), sum.resultant), bound(model.program(), sum.moment)};
}

DynamicScrew dynamic_screw(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  const std::string user = "a dynamic screw";
  const int observer = model.place(query.observer, user).link;
  DynamicScrew sum;
  for (const auto& [link, mass] : mass_by_link(model, bodies, user)) {
    const BodyMotion motion = body_motion(model, link, observer);
    const DynamicScrew own = dynamic_screw_at_origin(model.program(), mass, motion);
    sum = sum + as_asked(model, own, link, query);
  }
  return {bound(model.program(), sum.resultant), bound(model.program(), sum.moment)};
}

Value kinetic_energy(const Model& model, const BodyNames& bodies, const FrameReference& observer) {
  const std::string user = "a kinetic energy";
  const int reference = model.place(observer, user).link;
  Value doubled;
  for (const auto& [link, mass] : mass_by_link(model, bodies, user)) {
    const Twist twist = relative_twist(model, link, reference);
    doubled += reciprocal_product(momentum(mass, twist), twist);
  }
  return Number::rational(1, 2) * doubled;
}

Value kinetic_energy_at(const Model& model, const BodyNames& bodies, const PointReference& point,
                        const FrameReference& observer) {
  const std::string user = "a kinetic energy";
  Program& program = model.program();
  const auto all = mass_by_link(model, bodies, user);
  if (all.size() != 1) {
    throw SceneError(
        fmt::format("the kinetic energy at a point is that of one rigid body, and the bodies asked for move on {} "
                    "links ({}, {}, ...): ask for each, or for kinetic_energy",
                    all.size(), model.links()[static_cast<std::size_t>(all[0].first)].name,
                    model.links()[static_cast<std::size_t>(all[1].first)].name));
  }
  const auto& [link, mass] = all[0];
  const Vector q = bound(program, model.locate(point, link, user));
  const Twist twist = reduced_at(relative_twist(model, link, model.place(observer, user).link), q);
  const Vector velocity = bound(program, twist.linear);
  const Vector& omega = twist.angular;
  const Vector first = bound(program, mass.first_moment - mass.mass * q);  // m QG
  // J_Q Ω = ∫ QP ∧ (Ω ∧ QP) dm with QP = OP − OQ: J_O Ω − OQ ∧ (Ω ∧ h) − m QG ∧ (Ω ∧ OQ).
  const Vector turned_h = bound(program, cross(omega, mass.first_moment));
  const Vector turned_q = bound(program, cross(omega, q));
  Vector spin = mass.inertia * omega;
  spin += -cross(q, turned_h);
  spin += -cross(first, turned_q);
  Value doubled = mass.mass * dot(velocity, velocity);
  doubled += dot(omega, bound(program, spin));
  doubled += Number(2) * dot(velocity, bound(program, cross(omega, first)));
  return Number::rational(1, 2) * doubled;
}

}  // namespace torsor
