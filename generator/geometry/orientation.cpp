// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/orientation.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/geometry/dyad.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

struct PlaneTurn {
  Value sine, one_minus_cosine, cosine;
};

PlaneTurn turn_by(Program& program, const Value& angle) {
  PlaneTurn turn;
  turn.sine = program.sin(angle);
  turn.cosine = program.cos(angle);
  turn.one_minus_cosine = program.number(Number(1)) - turn.cosine;
  return turn;
}

}  // namespace

Matrix rotation_matrix(Program& program, const PlaneRotation& turn) {
  if (turn.axis < 0 || turn.axis > 2) {
    throw SceneError(fmt::format("axis {} of a plane rotation does not exist: use 0, 1 or 2 for x, y or z", turn.axis));
  }
  const Value sine = program.sin(turn.angle);
  const Value cosine = program.cos(turn.angle);
  const int a = (turn.axis + 1) % 3;
  const int b = (turn.axis + 2) % 3;
  Matrix m;
  m(turn.axis, turn.axis) = program.number(Number(1));
  m(a, a) = cosine;
  m(a, b) = -sine;
  m(b, a) = sine;
  m(b, b) = cosine;
  return m;
}

Matrix rotation_matrix(Program& program, const std::vector<PlaneRotation>& sequence) {
  Matrix product = identity(program);
  for (const PlaneRotation& turn : sequence) {
    const Matrix plane = rotation_matrix(program, turn);
    product = bound(program, product * plane);
  }
  return product;
}

Vector angular_velocity(Program& program, const std::vector<PlaneRotation>& sequence) {
  Matrix before = identity(program);
  Vector sum;
  for (const PlaneRotation& turn : sequence) {
    const Matrix plane = rotation_matrix(program, turn);
    const Value rate = time_derivative(turn.angle);
    for (int i = 0; i < 3; ++i) sum[i] += rate * before(i, turn.axis);
    before = bound(program, before * plane);
  }
  return sum;
}

std::vector<PlaneRotation> euler(const Value& psi, const Value& theta, const Value& phi) {
  return {{2, psi}, {0, theta}, {2, phi}};
}
std::vector<PlaneRotation> cardan(const Value& alpha, const Value& beta, const Value& gamma) {
  return {{0, alpha}, {1, beta}, {2, gamma}};
}

void check_unit_axis(Program& program, const Vector& axis) {
  const Value square = dot(axis, axis);
  if (identically_zero(square - program.number(Number(1)))) return;
  throw SceneError(
      fmt::format("the axis ({}, {}, {}) of a rotation has the square {} and must be a unit vector: divide "
                  "it by its length",
                  to_string(axis[0]), to_string(axis[1]), to_string(axis[2]), to_string(square)));
}

Matrix rotation_matrix(Program& program, const AxisAngle& turn) {
  check_unit_axis(program, turn.axis);
  const PlaneTurn t = turn_by(program, turn.angle);
  Matrix m = t.cosine * identity(program);
  m += t.one_minus_cosine * dyad(turn.axis, turn.axis);
  m += t.sine * cross_operator(turn.axis);
  return bound(program, m);
}

Vector angular_velocity(Program& program, const AxisAngle& turn) {
  check_unit_axis(program, turn.axis);
  const PlaneTurn t = turn_by(program, turn.angle);
  const Vector moved = time_derivative(turn.axis);
  Vector sum = time_derivative(turn.angle) * turn.axis;
  sum += t.sine * moved;
  sum += t.one_minus_cosine * cross(turn.axis, moved);
  return sum;
}

Vector angular_velocity(const Matrix& rotation) {
  Vector sum;
  for (int j = 0; j < 3; ++j) {
    const Vector e(rotation(0, j), rotation(1, j), rotation(2, j));
    const Vector moved = time_derivative(e);
    sum += cross(e, moved);
  }
  for (int i = 0; i < 3; ++i) sum[i] = Number::rational(1, 2) * sum[i];
  return sum;
}

}  // namespace torsor
