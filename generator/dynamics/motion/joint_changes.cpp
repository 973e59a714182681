// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/joint_changes.hpp"

#include <array>

#include "torsor/generator/base/as_index.hpp"

namespace torsor {
namespace {

/// [2 Ω] ∫ r rᵀ dm, and ∫ r rᵀ dm = ½ tr(J) 1 − J.
Matrix omega_times_second_moment(Program& program, const Vector& omega, const Matrix& j) {
  Matrix second;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    Value diagonal = j(b, b) + j(c, c);
    diagonal -= j(a, a);
    second(a, a) = program.bind(Number::rational(1, 2) * diagonal);
    second(b, c) = second(c, b) = program.bind(-j(b, c));
  }
  std::array<Value, 3> mixed;  // each is in two of the diagonal's entries
  for (int a = 0; a < 3; ++a) mixed[as_index(a)] = program.bind(omega[a] * second((a + 1) % 3, (a + 2) % 3));
  Matrix product;
  for (int column = 0; column < 3; ++column) {
    const Vector r = cross(omega, Vector(second(0, column), second(1, column), second(2, column)));
    for (int row = 0; row < 3; ++row) product(row, column) = r[row];
    product(column, column) = mixed[as_index((column + 1) % 3)] - mixed[as_index((column + 2) % 3)];
  }
  return product;
}

}  // namespace

Vector JointChanges::doubled(const Vector& v) const {
  return bound(program_, Vector(Number(2) * v[0], Number(2) * v[1], Number(2) * v[2]));
}

Vector JointChanges::doubled_velocity(const Link& link) const {
  const Acceleration& parent = motion_[static_cast<std::size_t>(link.parent)];
  Vector v = cross(doubled(parent.omega()), bound(program_, tree_.arm(link)));
  if (link.joint == JointKind::prismatic) {
    v += program_.bind(Number(2) * link.rate) * tree_.axis_in_parent(link);
  }
  return bound(program_, v);
}

Vector JointChanges::parent_omega_cross_axis(std::size_t k) const {
  const Link& link = tree_.links()[k];
  if (!in_attitude(k)) return bound(program_, cross(motion_[k].omega(), link.axis));
  const Link& first = tree_.links()[first_of_group(k)];
  const Vector carried = tree_.from_parent(first, motion_[static_cast<std::size_t>(first.parent)].omega());
  return bound(program_, cross(bound(program_, carried), link.axis));
}

MotionChange JointChanges::by_position(std::size_t k) const {
  const Link& link = tree_.links()[k];
  MotionChange change;
  if (link.joint == JointKind::prismatic) {
    change.beta = bound(program_, motion_[k].u_times(link.axis));
    return change;
  }
  change.w = parent_omega_cross_axis(k);
  change.beta = bound(program_, cross(motion_[tree_.turning_link(k)].linear(), link.axis));
  if (in_attitude(k)) {
    const Link& first = tree_.links()[first_of_group(k)];
    const Vector axis = bound(program_, tree_.to_parent(first, link.axis));
    const Vector turned = bound(program_, motion_[static_cast<std::size_t>(first.parent)].u_times(axis));
    change.alpha = bound(program_, tree_.from_parent(first, turned));
  } else {
    change.alpha = bound(program_, motion_[k].u_times(link.axis));  // U s = U_p s
  }
  return change;
}

MotionChange JointChanges::by_velocity(std::size_t k) const {
  const Link& link = tree_.links()[k];
  MotionChange change;
  if (link.joint == JointKind::prismatic) {
    change.beta = bound(program_, cross(doubled(motion_[k].omega()), link.axis));
    return change;
  }
  change.w = link.axis;
  if (in_attitude(k)) {
    const Vector own = bound(program_, cross(motion_[tree_.turning_link(k)].omega(), link.axis));
    change.alpha = bound(program_, parent_omega_cross_axis(k) + own);
  } else {
    change.alpha = bound(program_, cross(doubled(motion_[k].omega()), link.axis));
  }
  return change;
}

Matrix PointFlow::answer(Program& program) const {
  Matrix w;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    w(i, i) = program.bind(q(j, j) + q(k, k));
    w(i, j) = -q(i, j);
    w(i, k) = -q(i, k);
  }
  return w;
}

PointFlow rigid_flow(Program& program, const MassProperties& body, const Vector& doubled_omega) {
  PointFlow flow;
  flow.l = cross(doubled_omega, body.first_moment);
  flow.q = omega_times_second_moment(program, doubled_omega, body.inertia);
  return flow;
}

}  // namespace torsor
