// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/rigid_motion.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {

void check_equiprojective(const std::vector<PointVelocity>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Vector arm = points[j].position - points[i].position;
      const Value stretch = dot(arm, points[j].velocity - points[i].velocity);
      if (identically_zero(stretch)) continue;
      throw SceneError(
          fmt::format("points '{0}' and '{1}' do not move as points of one body: {0}{1}·(V_{1} − V_{0}) "
                      "must vanish, their distance would change; correct one of the velocities",
                      points[i].name, points[j].name));
    }
  }
}

Twist twist_of_velocities(const PointVelocity& a, const PointVelocity& b, const PointVelocity& c) {
  check_equiprojective({a, b, c});
  const Vector ab = b.position - a.position;
  const Vector ac = c.position - a.position;
  const Vector n = cross(ab, ac);
  if (identically_zero(n)) {
    throw SceneError(
        fmt::format("points '{}', '{}' and '{}' are aligned: their velocities leave the turn about their "
                    "line open; take a point off the line",
                    a.name, b.name, c.name));
  }
  const Vector beta = b.velocity - a.velocity;
  const Vector gamma = c.velocity - a.velocity;
  const Value inverse = pow(dot(n, n), -1);
  const Value bb = dot(ab, ab);
  const Value bc = dot(ab, ac);
  const Value cc = dot(ac, ac);
  const Value beta_n = dot(beta, n);
  const Value gamma_n = dot(gamma, n);
  Value along_b = bb * gamma_n;
  along_b -= bc * beta_n;
  along_b = along_b * inverse;
  Value along_c = bc * gamma_n;
  along_c -= cc * beta_n;
  along_c = along_c * inverse;
  const Value along_n = dot(beta, ac);
  // Any vector is [(Ω·b) c ∧ n + (Ω·c) n ∧ b + (Ω·n) n] / n².
  Vector omega = along_b * cross(ac, n);
  omega += along_c * cross(n, ab);
  omega += along_n * n;
  return {inverse * omega, a.velocity};
}

std::string_view to_string(MotionKind kind) {
  switch (kind) {
    case MotionKind::rest:
      return "rest";
    case MotionKind::translation:
      return "translation";
    case MotionKind::rotation:
      return "rotation";
    case MotionKind::screw:
      return "screw motion";
  }
  return "";
}

RigidMotion recognise(const Twist& twist) {
  RigidMotion motion;
  if (identically_zero(twist.angular)) {
    motion.kind = identically_zero(twist.linear) ? MotionKind::rest : MotionKind::translation;
    return motion;
  }
  motion.kind = identically_zero(scalar_invariant(twist)) ? MotionKind::rotation : MotionKind::screw;
  motion.axis = central_axis(twist, "twist");
  const Vector turn = time_derivative(twist.angular);
  const Vector shift = time_derivative(motion.axis->ah);
  motion.fixed_axis = identically_zero(cross(turn, twist.angular)) && identically_zero(cross(shift, twist.angular));
  return motion;
}

}  // namespace torsor
