// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/contact_motion.hpp"

#include "torsor/generator/base/error.hpp"

namespace torsor {

ContactMotion contact_motion(const Model& model, const ContactBetween& between) {
  Program& program = model.program();
  const std::string user = "a contact's motion";
  const GeometricPoint contact = geometric_point(model, between.contact, user);
  const Vector normal = bound(program, model.express(between.normal, between.normal_axes, contact.link, user));
  if (identically_zero(normal))
    throw SceneError("the normal of a contact is the null vector: give the direction from S2 to S1");
  const int body_1 = model.place(between.body_1, user).link, body_2 = model.place(between.body_2, user).link;
  const Vector n = bound(program, model.express(normal, contact.link, 0));
  const Value length = program.sqrt(dot(normal, normal));
  const Vector place = bound(program, model.locate(contact.place, contact.link, body_1));
  const Twist twist = reduced_at(relative_twist(model, body_1, body_2), place);
  const Vector velocity = bound(program, model.express(bound(program, twist.linear), body_1, 0));
  const Vector turn = bound(program, model.express(twist.angular, body_1, 0));
  ContactMotion motion;
  motion.normal = bound(program, pow(length, -1) * n);
  motion.separation = program.bind(dot(motion.normal, velocity));
  motion.spinning = program.bind(dot(motion.normal, turn));
  motion.sliding = bound(program, velocity - motion.separation * motion.normal);
  motion.rolling = bound(program, turn - motion.spinning * motion.normal);
  return motion;
}

}  // namespace torsor
