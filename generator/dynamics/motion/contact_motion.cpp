// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/motion/contact_motion.hpp"

#include "generator/base/error.hpp"

namespace torsor {

ContactMotion contact_motion(const Model& model, int body_1, int body_2, const GeometricPoint& contact,
                             const Vector& normal, int axes) {
  if (identically_zero(normal))
    throw SceneError("the normal of a contact is the null vector: give the direction from S2 to S1");
  Program& program = model.program();
  const Vector n = bound(program, model.express(normal, contact.link, axes));
  const Value length = program.sqrt(dot(normal, normal));
  const Vector place = bound(program, model.locate(contact.place, contact.link, body_1));
  const Twist twist = reduced_at(relative_twist(model, body_1, body_2), place);
  const Vector velocity = bound(program, model.express(bound(program, twist.linear), body_1, axes));
  const Vector turn = bound(program, model.express(twist.angular, body_1, axes));
  ContactMotion motion;
  motion.normal = bound(program, pow(length, -1) * n);
  motion.separation = program.bind(dot(motion.normal, velocity));
  motion.spinning = program.bind(dot(motion.normal, turn));
  motion.sliding = bound(program, velocity - motion.separation * motion.normal);
  motion.rolling = bound(program, turn - motion.spinning * motion.normal);
  return motion;
}

ContactMotion contact_motion(const Model& model, const FrameReference& body_1, const FrameReference& body_2,
                             const PointReference& contact, const Triple& normal, const FrameReference& normal_axes) {
  const std::string user = "a contact's motion";
  const GeometricPoint point = geometric_point(model, contact, user);
  const Vector n = bound(model.program(), model.express(normal, normal_axes, point.link, user));
  const int first = model.place(body_1, user).link;
  const int second = model.place(body_2, user).link;
  return contact_motion(model, first, second, point, n, 0);
}

}  // namespace torsor
