// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/base/number.hpp"
#include "torsor/generator/geometry/rotation.hpp"

namespace torsor {

/// A constant turn in a plane by its cosine and sine, exactly on the unit circle.
struct ExactTurn {
  Number cosine = Number(1), sine;

  bool is_none() const { return cosine.is_one(); }
  ExactTurn inverse() const { return {cosine, -sine}; }
  friend ExactTurn operator*(const ExactTurn& a, const ExactTurn& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }
};

/// Directions that are not in Q(√2, √3) become points of the unit circle or sphere with rational components, angles
/// rational numbers, each within 10⁻ⁿ rad with this n. `rounded` counts them.
inline constexpr int direction_digits = 80;

/// The turn from the first axis to the direction of (x, y), which are not both zero.
ExactTurn turn_towards(const Number& x, const Number& y, int& rounded);

/// The turn by an angle in [0, π] that has this cosine.
ExactTurn turn_with_cosine(const Number& cosine, int& rounded);

/// The angle in (−π, π] as quarter + rest: twelfths π/12 + rest, rest = 0 where the angle is a multiple of π/12, |rest|
/// ≤ π/4 and twelfths a multiple of 6 elsewhere.
struct AngleParts {
  int twelfths = 0;
  Number rest;
};
AngleParts angle_of(const ExactTurn& turn, int& rounded);

/// Rotation about axis 0, 1 or 2 (x, y, z).
Rotation turned_about(int axis, const ExactTurn& turn);

/// A rotation whose third column is the direction n, of unit length: a permutation of axes where n is along one, the
/// smallest turn from ± z elsewhere.
Rotation rotation_onto(const std::array<Number, 3>& n);

/// The point of the unit sphere with rational components near a direction of unit length given by many digits.
std::array<Number, 3> rational_direction(const std::array<Real, 3>& n, int& rounded);

/// Whether all entries are 0, 1 or −1: such a rotation costs no operation.
bool is_permutation(const Rotation& r);

/// Turns about axes whose product, first to last, is the rotation: Rz(a) Rx(b), one of both, or permutations in place
/// of one or both. Nothing where it has no such form.
std::optional<std::vector<Rotation>> plane_factors(const Rotation& r);

/// Axis of a rotation about x, y or z that is no permutation; nothing for others.
std::optional<int> axis_of_turn(const Rotation& r);

}  // namespace torsor
