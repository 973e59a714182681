// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/point_motion.hpp"

namespace torsor {

GeometricPoint geometric_point(const Model& model, const PointReference& point, const std::string& user) {
  const SceneContent& scene = model.scene();
  const auto index = static_cast<std::size_t>(scene.point_index(point, user));
  const int link = model.place(scene.points[index].frame, user).link;
  return {link, bound(model.program(), model.locate(point, link, user))};
}

Vector velocity(const Model& model, const GeometricPoint& point, int reference) {
  Program& program = model.program();
  const Twist twist = relative_twist(model, point.link, reference);
  const Vector carried = reduced_at(twist, point.place).linear;
  return bound(program, carried + time_derivative(point.place));
}

Vector acceleration(const Model& model, const GeometricPoint& point, int reference) {
  const Vector v = velocity(model, point, reference);
  return bound(model.program(), derivative_in(model, v, point.link, reference));
}

GeometricPoint hodograph(const Model& model, const GeometricPoint& point, int reference, const Vector& from) {
  Program& program = model.program();
  const Vector v = bound(program, model.express(velocity(model, point, reference), point.link, reference));
  const Value second = program.number(Number(1), units::second);
  return {reference, bound(program, from + second * v)};
}

GeometricPoint hodograph(const Model& model, const PointReference& point, const FrameReference& reference) {
  const std::string user = "a hodograph";
  const int link = model.place(reference, user).link;
  return hodograph(model, geometric_point(model, point, user), link);
}

PointMotion point_motion(const Model& model, const GeometricPoint& point, const MotionLinks& links) {
  const int moving = links.moving, reference = links.reference, axes = links.axes;
  Program& program = model.program();
  const auto seen = [&](const Vector& v, int link) { return bound(program, model.express(v, link, axes)); };
  const Vector from_reference = model.locate(point.place, point.link, reference);
  const Vector from_moving = bound(program, model.locate(point.place, point.link, moving));
  const BodyMotion frame = body_motion(model, moving, reference);
  const Vector relative = velocity(model, point, moving);
  const Vector relative_there = bound(program, model.express(relative, point.link, moving));
  const Value two = program.number(Number(2));
  PointMotion motion;
  motion.position = seen(from_reference, reference);
  motion.absolute_velocity = seen(velocity(model, point, reference), point.link);
  motion.relative_velocity = seen(relative, point.link);
  motion.transport_velocity = seen(frame.velocity_at(from_moving), moving);
  motion.absolute_acceleration = seen(acceleration(model, point, reference), point.link);
  motion.relative_acceleration = seen(acceleration(model, point, moving), point.link);
  motion.transport_acceleration = seen(frame.acceleration_at(from_moving), moving);
  motion.coriolis_acceleration = seen(two * cross(frame.twist.angular, relative_there), moving);
  return motion;
}

PointMotion point_motion(const Model& model, const PointReference& point, const FrameReference& moving,
                         const FrameReference& reference) {
  const std::string user = "a point's motion";
  const int moving_link = model.place(moving, user).link;
  const int reference_link = model.place(reference, user).link;
  return point_motion(model, geometric_point(model, point, user), {.moving = moving_link, .reference = reference_link});
}

}  // namespace torsor
