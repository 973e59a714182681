// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/quaternion.hpp"

#include "torsor/generator/geometry/dyad.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {

Quaternion operator*(const Quaternion& p, const Quaternion& q) {
  Quaternion product;
  product.scalar = p.scalar * q.scalar;
  product.scalar -= dot(p.vector, q.vector);
  product.vector = p.scalar * q.vector;
  product.vector += q.scalar * p.vector;
  product.vector += cross(p.vector, q.vector);
  return product;
}

Quaternion conjugate(const Quaternion& p) { return {p.scalar, -p.vector}; }

Value squared_norm(const Quaternion& p) {
  const Value square = p.scalar * p.scalar;
  return square + dot(p.vector, p.vector);
}

Quaternion quaternion(Program& program, const AxisAngle& turn) {
  check_unit_axis(program, turn.axis);
  const Value half = Number::rational(1, 2) * turn.angle;
  const Value cosine = program.cos(half);
  const Value sine = program.sin(half);
  return {cosine, sine * turn.axis};
}

Quaternion quaternion(Program& program, const std::vector<PlaneRotation>& sequence) {
  Quaternion product{program.number(Number(1)), Vector()};
  for (const PlaneRotation& turn : sequence) {
    Vector axis;
    axis[turn.axis] = program.number(Number(1));
    const Quaternion next = quaternion(program, AxisAngle{axis, turn.angle});
    product = product * next;
  }
  return product;
}

Matrix rotation_matrix(Program& program, const Quaternion& p) {
  Value diagonal = p.scalar * p.scalar;
  diagonal -= dot(p.vector, p.vector);
  const Value twice = Number(2) * p.scalar;
  Matrix m = diagonal * identity(program);
  m += program.number(Number(2)) * dyad(p.vector, p.vector);
  m += twice * cross_operator(p.vector);
  return bound(program, m);
}

Vector angular_velocity(const Quaternion& p) {
  const Value scalar_rate = time_derivative(p.scalar);
  const Vector rate = time_derivative(p.vector);
  Vector half = p.scalar * rate;
  half += -(scalar_rate * p.vector);
  half += cross(p.vector, rate);
  for (int i = 0; i < 3; ++i) half[i] = Number(2) * half[i];
  return half;
}

Quaternion rate_of_turn(const Quaternion& p, const Vector& omega) {
  const Quaternion turned = Quaternion{Value(), omega} * p;
  Quaternion rate;
  rate.scalar = Number::rational(1, 2) * turned.scalar;
  for (int i = 0; i < 3; ++i) rate.vector[i] = Number::rational(1, 2) * turned.vector[i];
  return rate;
}

}  // namespace torsor
