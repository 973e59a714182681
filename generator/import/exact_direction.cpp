// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/exact_direction.hpp"

#include <algorithm>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {
namespace {

/// Digits in which angles are compared and halved; far more than any tolerance asks for.
constexpr int digits = 80;
/// Relative error of what is replaced by a shorter rational, well below that of a double.
const Number& relative_error() {
  static const Number error = Number(10).pow(-18);
  return error;
}

/// The rational of smallest denominator in [low, high], 0 ≤ low < high: along the continued fraction both share.
cln::cl_RA simplest_between(const cln::cl_RA& low, const cln::cl_RA& high) {
  const cln::cl_I whole = cln::floor1(low);
  if (whole == low) return whole;
  if (whole + 1 <= high) return whole + 1;
  return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole));
}

/// A short rational within a relative 10⁻¹⁸.
Number shortened(const Real& x) {
  const Number value = x.to_number();
  if (value.is_zero()) return value;
  const Number size = value.abs();
  const Number slack = size * relative_error();
  const Number near = simplest_between((size - slack).part(0), (size + slack).part(0));
  return value.sign() < 0 ? -near : near;
}

/// The integer nearest to x.
cln::cl_I nearest_integer(const Real& x) { return cln::round1(cln::rational(x.raw())); }

int modulo(const cln::cl_I& n, int period) { return cln::cl_I_to_int(cln::mod(n, cln::cl_I(period))); }

/// (1 − t²)/(1 + t²) and 2 t/(1 + t²): cosine and sine of 2 arctan t.
ExactAngle from_half_tangent(const Number& t) {
  const Number square = t * t;
  const Number length = Number(1) + square;
  return {Number(2) * t / length, (Number(1) - square) / length, std::nullopt};
}

/// −1, 0 or 1 when the direction is along one of the axes, by axis.
std::optional<int> aligned_axis(const std::array<Number, 3>& n) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (n[(i + 1) % 3].is_zero() && n[(i + 2) % 3].is_zero()) return static_cast<int>(i);
  }
  return std::nullopt;
}

/// In the plane of axes a and b: the multiple of π/12 within the tolerance, if there is one.
std::optional<std::array<Number, 3>> plane_direction(const std::array<Number, 3>& v, std::size_t a, std::size_t b,
                                                     const Number& tolerance) {
  const Real x(v[a], digits);
  const Real y(v[b], digits);
  const Real length = sqrt(x * x + y * y);
  const Real slack(tolerance, digits);
  for (int k = 0; k < 24; ++k) {
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(k));
    const Real along = x * Real(cosine, digits) + y * Real(sine, digits);
    const Real across = y * Real(cosine, digits) - x * Real(sine, digits);
    if (!(along > Real(0)) || abs(across) > slack * length) continue;
    std::array<Number, 3> exact;
    exact[a] = cosine;
    exact[b] = sine;
    return exact;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Number> twelfths_of_pi(const Number& angle, const Number& tolerance) {
  const Real x(angle, digits);
  const Real step = Real::pi(digits) / Real(Number(12), digits);
  const cln::cl_I k = nearest_integer(x / step);
  if (abs(x - Real(Number(cln::cl_RA(k)), digits) * step) > Real(tolerance, digits)) return std::nullopt;
  return Number(cln::cl_RA(k));
}

ExactAngle exact_angle(const Number& angle, const Number& tolerance) {
  if (const std::optional<Number> k = twelfths_of_pi(angle, tolerance)) {
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(*k);
    return {sine, cosine, k};
  }
  const Real quarter = Real::pi(digits) / Real(Number(2), digits);
  const Real x(angle, digits);
  const cln::cl_I turns = nearest_integer(x / quarter);
  const Real rest = x - Real(Number(cln::cl_RA(turns)), digits) * quarter;
  const ExactAngle small = from_half_tangent(shortened(sin(rest) / (Real(Number(1), digits) + cos(rest))));
  switch (modulo(turns, 4)) {
    case 0:
      return small;
    case 1:
      return {small.cosine, -small.sine, std::nullopt};
    case 2:
      return {-small.sine, -small.cosine, std::nullopt};
    default:
      return {-small.cosine, small.sine, std::nullopt};
  }
}

Rotation rotation_about(int axis, const ExactAngle& angle) {
  const auto a = static_cast<std::size_t>((axis + 1) % 3);
  const auto b = static_cast<std::size_t>((axis + 2) % 3);
  std::array<Number, 9> entries;
  entries[static_cast<std::size_t>(4 * axis)] = Number(1);
  entries[3 * a + a] = angle.cosine;
  entries[3 * a + b] = -angle.sine;
  entries[3 * b + a] = angle.sine;
  entries[3 * b + b] = angle.cosine;
  return Rotation::matrix(entries);
}

ExactDirection exact_direction(const std::array<Number, 3>& v, const Number& tolerance) {
  ExactDirection result{v, false};
  std::array<Number, 3>& n = result.components;
  const Number largest = std::max({v[0].abs(), v[1].abs(), v[2].abs()});
  for (Number& component : n) {
    if (component.is_zero() || component.abs() > tolerance * largest) continue;
    component = Number();
    result.changed = true;
  }
  if (const std::optional<int> i = aligned_axis(n)) {
    Number& only = n[static_cast<std::size_t>(*i)];
    only = Number(only.sign());
    return result;
  }
  const auto norm_squared = [&n] { return n[0] * n[0] + n[1] * n[1] + n[2] * n[2]; };
  for (std::size_t i = 0; i < 3; ++i) {
    if (!n[i].is_zero()) continue;
    if (const auto exact = plane_direction(n, (i + 1) % 3, (i + 2) % 3, tolerance)) {
      // Equal components need no change to be exact.
      result.changed = result.changed || !(n[(i + 1) % 3].abs() == n[(i + 2) % 3].abs());
      n = *exact;
      return result;
    }
  }
  const Number smallest = std::min({n[0].abs(), n[1].abs(), n[2].abs()});
  if (largest - smallest <= tolerance * largest) {
    result.changed = result.changed || !(largest == smallest);
    for (Number& component : n) component = Number(component.sign()) / Number::sqrt3();
    return result;
  }
  if (const std::optional<Number> norm = norm_squared().square_root()) {
    for (Number& component : n) component /= *norm;
    return result;
  }
  std::size_t pole = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (n[i].abs() > n[pole].abs()) pole = i;
  }
  const std::size_t a = (pole + 1) % 3;
  const std::size_t b = (pole + 2) % 3;
  const Number sign(n[pole].sign());
  const Real below = sqrt(Real(norm_squared(), digits)) + Real(n[pole].abs(), digits);
  const Number x = shortened(Real(n[a], digits) / below);
  const Number y = shortened(Real(n[b], digits) / below);
  const Number squares = x * x + y * y;
  const Number length = Number(1) + squares;
  n[a] = Number(2) * x / length;
  n[b] = Number(2) * y / length;
  n[pole] = sign * (Number(1) - squares) / length;
  return result;
}

Rotation rotation_to(const std::array<Number, 3>& n) {
  std::array<Number, 9> entries;
  if (const std::optional<int> axis = aligned_axis(n)) {
    const auto z = static_cast<std::size_t>(*axis);
    const Number& sign = n[z];
    entries[3 * ((z + 1) % 3)] = Number(1);
    entries[3 * ((z + 2) % 3) + 1] = sign;
    entries[3 * z + 2] = sign;
    return Rotation::matrix(entries);
  }
  // With z ∧ n = (−n_y, n_x, 0) and c = n_z: R = 1 + [z ∧ n] + [z ∧ n]²/(1 + c).
  const Number k = Number(1) / (Number(1) + n[2]);
  entries = {Number(1) - k * n[0] * n[0],
             -(k * n[0] * n[1]),
             n[0],
             -(k * n[0] * n[1]),
             Number(1) - k * n[1] * n[1],
             n[1],
             -n[0],
             -n[1],
             n[2]};
  return Rotation::matrix(entries);
}

}  // namespace torsor
