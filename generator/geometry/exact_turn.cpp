// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/exact_turn.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

namespace torsor {
namespace {

/// Digits in which roots and angles are found before they are shortened.
constexpr int guard_digits = direction_digits + 30;

Number abs_slack() { return Number(10).pow(-direction_digits); }

/// The rational of smallest denominator in [low, high], 0 ≤ low < high.
cln::cl_RA shortest_between(const cln::cl_RA& low, const cln::cl_RA& high) {
  const cln::cl_I whole = cln::floor1(low);
  if (whole == low) return whole;
  if (whole + 1 <= high) return whole + 1;
  return whole + 1 / shortest_between(1 / (high - whole), 1 / (low - whole));
}

/// The shortest rational within a quarter of 10⁻ⁿ: an angle of which it is half the tangent moves by no more than twice
/// that.
Number shortest(const Real& x) {
  const Number value = x.to_number();
  const Number size = value.abs();
  const Number slack = abs_slack() / Number(4);
  if (size <= slack) return {};
  const Number near = shortest_between((size - slack).part(0), (size + slack).part(0));
  return value.sign() < 0 ? -near : near;
}

Real real(const Number& x) { return {x, guard_digits}; }

/// The turn of 2 arctan t.
ExactTurn of_half_tangent(const Number& t) {
  const Number square = t * t;
  const Number length = Number(1) + square;
  return {(Number(1) - square) / length, Number(2) * t / length};
}

/// Of (x, y) on the unit circle, by the half tangent of the angle to the nearer axis.
ExactTurn rational_turn(const Real& x, const Real& y) {
  const bool along_x = abs(x) >= abs(y);
  const Real& near = along_x ? x : y;
  const Real& far = along_x ? y : x;
  const ExactTurn small = of_half_tangent(shortest(far / (Real(Number(1), guard_digits) + abs(near))));
  const bool back = near < Real(0);
  const Number main = back ? -small.cosine : small.cosine;
  return along_x ? ExactTurn{main, small.sine} : ExactTurn{small.sine, main};
}

bool is_unit(const Number& x) { return x.is_zero() || x.abs().is_one(); }

}  // namespace

ExactTurn turn_towards(const Number& x, const Number& y, int& rounded) {
  if (y.is_zero()) return {Number(x.sign()), Number()};
  if (x.is_zero()) return {Number(), Number(y.sign())};
  const Number square = x * x + y * y;
  if (const std::optional<Number> size = square.square_root()) return {x / *size, y / *size};
  ++rounded;
  const Real size = sqrt(real(square));
  return rational_turn(real(x) / size, real(y) / size);
}

ExactTurn turn_with_cosine(const Number& cosine, int& rounded) {
  const Number square = Number(1) - cosine * cosine;
  if (const std::optional<Number> sine = square.square_root()) return {cosine, *sine};
  ++rounded;
  return rational_turn(real(cosine), sqrt(real(square)));
}

AngleParts angle_of(const ExactTurn& turn, int& rounded) {
  for (int k = -11; k <= 12; ++k) {
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(k));
    if (turn.cosine == cosine && turn.sine == sine) return {k, {}};
  }
  ++rounded;
  const Real angle = atan2(real(turn.sine), real(turn.cosine));
  const Real quarter = Real::pi(guard_digits) / real(Number(2));
  const int quarters = cln::cl_I_to_int(cln::round1(cln::rational((angle / quarter).raw())));
  return {6 * quarters, shortest(angle - real(Number(quarters)) * quarter)};
}

Rotation turned_about(int axis, const ExactTurn& turn) {
  std::array<Number, 9> entries;
  const auto at = [&entries](int row, int column) -> Number& {
    return entries[static_cast<std::size_t>(3 * row + column)];
  };
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  at(axis, axis) = Number(1);
  at(a, a) = at(b, b) = turn.cosine;
  at(a, b) = -turn.sine;
  at(b, a) = turn.sine;
  return Rotation::matrix(entries);
}

Rotation rotation_onto(const std::array<Number, 3>& n) {
  if (n[2].sign() < 0) {
    const Rotation opposite = rotation_onto({-n[0], -n[1], -n[2]});
    return opposite * Rotation::about(0, 12);
  }
  if (n[0].abs().is_one() || n[1].abs().is_one()) {
    const Number one(1), zero;
    const bool along_x = n[1].is_zero();
    const Rotation cyclic = along_x ? Rotation::matrix({zero, zero, one, one, zero, zero, zero, one, zero})
                                    : Rotation::matrix({zero, one, zero, zero, zero, one, one, zero, zero});
    return (along_x ? n[0] : n[1]).sign() > 0 ? cyclic : cyclic * Rotation::about(0, 12);
  }
  const Number part = (Number(1) + n[2]).pow(-1);
  const Number mixed = -(n[0] * n[1] * part);
  return Rotation::matrix(
      {Number(1) - n[0] * n[0] * part, mixed, n[0], mixed, Number(1) - n[1] * n[1] * part, n[1], -n[0], -n[1], n[2]});
}

std::array<Number, 3> rational_direction(const std::array<Real, 3>& n, int& rounded) {
  ++rounded;
  const bool back = n[2] < Real(0);
  const Real length = Real(Number(1), guard_digits) + abs(n[2]);
  const Number u = shortest(n[0] / length), v = shortest(n[1] / length);
  const Number square = u * u + v * v;
  const Number scale = (Number(1) + square).pow(-1);
  const Number along = (Number(1) - square) * scale;
  return {Number(2) * u * scale, Number(2) * v * scale, back ? -along : along};
}

bool is_permutation(const Rotation& r) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!is_unit(r(i, j))) return false;
    }
  }
  return true;
}

std::optional<int> axis_of_turn(const Rotation& r) {
  if (is_permutation(r)) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (r(i, i).is_one()) return i;
  }
  return std::nullopt;
}

std::optional<std::vector<Rotation>> plane_factors(const Rotation& r) {
  if (r.is_identity()) return std::vector<Rotation>();
  if (is_permutation(r) || axis_of_turn(r)) return std::vector<Rotation>{r};
  if (!r(2, 0).is_zero()) return std::nullopt;
  const Rotation about_z = turned_about(2, {r(0, 0), r(1, 0)});
  const Rotation about_x = turned_about(0, {r(2, 2), r(2, 1)});
  return std::vector<Rotation>{about_z, about_x};
}

}  // namespace torsor
