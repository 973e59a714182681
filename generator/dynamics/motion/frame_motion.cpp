// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/frame_motion.hpp"

namespace torsor {
Twist relative_twist(const Model& model, int link, int reference) {
  if (link == reference) return {};
  Program& program = model.program();
  const std::vector<Twist> all = twists(model);
  const Twist& own = all[model.turning_link(static_cast<std::size_t>(link))];
  const Twist& other = all[model.turning_link(static_cast<std::size_t>(reference))];
  const Vector arm = bound(program, model.locate(Vector(), link, reference));
  const Vector carried = bound(program, other.linear + cross(other.angular, arm));  // of the reference's point at O
  const Vector carried_turn = model.express(other.angular, reference, link);
  const Vector carried_velocity = model.express(carried, reference, link);
  Twist relative;
  relative.angular = bound(program, own.angular - carried_turn);
  relative.linear = bound(program, own.linear - carried_velocity);
  return relative;
}

Vector angular_velocity(const Model& model, int link, int reference, int axes) {
  return model.express(relative_twist(model, link, reference).angular, link, axes);
}

Vector angular_velocity_from_axes(const Model& model, int link, int reference, int axes) {
  Program& program = model.program();
  Vector sum;  // in the reference's axes, whose rates are the derivatives in it
  for (int i = 0; i < 3; ++i) {
    Vector unit;
    unit[i] = program.number(Number(1));
    const Vector e = bound(program, model.express(unit, link, reference));
    const Vector moved = bound(program, time_derivative(e));
    sum += cross(e, moved);
  }
  for (int i = 0; i < 3; ++i) sum[i] = Number::rational(1, 2) * sum[i];
  return model.express(bound(program, sum), reference, axes);
}

Vector derivative_in(const Model& model, const Vector& v, int link, int reference) {
  const Vector local = time_derivative(v);
  return local + cross(relative_twist(model, link, reference).angular, bound(model.program(), v));
}

Vector BodyMotion::velocity_at(const Vector& place) const { return reduced_at(twist, place).linear; }

Vector BodyMotion::acceleration_at(const Vector& place) const {
  const Vector turn = cross(twist.angular, place);
  const Vector centripetal = cross(twist.angular, turn);
  const Vector tangential = cross(angular_acceleration, place);
  return origin_acceleration + tangential + centripetal;
}

BodyMotion body_motion(const Model& model, int link, int reference) {
  Program& program = model.program();
  BodyMotion motion;
  motion.twist = relative_twist(model, link, reference);
  motion.angular_acceleration = bound(program, time_derivative(motion.twist.angular));
  const Vector acceleration = derivative_in(model, motion.twist.linear, link, reference);
  motion.origin_acceleration = bound(program, acceleration);
  return motion;
}

RigidMotion recognise_motion(const Model& model, int link, int reference) {
  const Twist own = relative_twist(model, link, reference);
  Twist seen;
  seen.angular = model.express(own.angular, link, reference);
  seen.linear = model.express(own.linear, link, reference);
  const Vector origin = model.locate(Vector(), link, reference);
  return recognise(reduced_at(seen, -origin));
}

}  // namespace torsor
