// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/ground_drift.hpp"

#include "torsor/generator/program/derivative.hpp"

namespace torsor {

GroundDrift::GroundDrift(const Model& model, const GroundMotion& motion) : model_(&model), motion_(&motion), places_(1) {
  Program& program = model.program();
  Substitution steady(program, [&program](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol->kind != SymbolKind::acceleration) return std::nullopt;
    return program.number(Number(), symbol->unit);
  });
  Vector carried;  // Ω of the parent of an attitude's links: their axes turn with it and not with one another
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    const Link& link = model.links()[k];
    const int self = static_cast<int>(k);
    const Vector& axis = motion.axis(self);
    const Vector& omega = motion.angular(link.parent);
    const Value s_ddot = steady(link.acceleration);
    Vector angular = at(link.parent).angular;
    Vector linear = this->linear(link.parent, motion.from_parent(self));
    if (link.joint == JointKind::prismatic) {
      linear += Number(2) * link.rate * bound(program, cross(omega, axis));
      linear += s_ddot * axis;
    } else if (link.joint == JointKind::revolute) {
      if (link.in_group == 0) carried = omega;
      angular += link.rate * bound(program, cross(carried, axis));
      angular += s_ddot * axis;
    }
    places_.push_back({bound(program, angular), bound(program, linear)});
  }
}

Vector GroundDrift::linear(int link, const Vector& arm) const {
  Program& program = model_->program();
  const Vector& omega = motion_->angular(link);
  const Vector turning = bound(program, cross(omega, arm));
  return bound(program, at(link).linear + cross(at(link).angular, arm) + cross(omega, turning));
}

}  // namespace torsor
