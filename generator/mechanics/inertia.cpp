// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/inertia.hpp"

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/expression/number.hpp"

namespace torsor {
namespace {

Expression fraction(long numerator, long denominator) { return Expression(Number::rational(numerator, denominator)); }

/// A body of revolution about one axis of its frame.
Inertia revolution(const Expression& mass, const Expression& across, const Expression& along, int axis) {
  if (axis < 0 || axis > 2) {
    throw SceneError(fmt::format("axis {} of an inertia does not exist: use 0, 1 or 2 for x, y or z", axis));
  }
  Inertia inertia = Inertia::general(mass, across, across, across);
  (axis == 0 ? inertia.xx : axis == 1 ? inertia.yy : inertia.zz) = along;
  return inertia;
}

}  // namespace

Inertia Inertia::point(const Expression& mass) { return general(mass, 0, 0, 0); }

Inertia Inertia::general(const Expression& mass, const Expression& xx, const Expression& yy, const Expression& zz,
                         const Expression& xy, const Expression& xz, const Expression& yz) {
  return {mass, {0, 0, 0}, xx, yy, zz, xy, xz, yz};
}

Inertia Inertia::rod(const Expression& mass, const Expression& length, int axis) {
  return revolution(mass, fraction(1, 12) * mass * pow(length, 2), 0, axis);
}
Inertia Inertia::disk(const Expression& mass, const Expression& radius, int axis) {
  const Expression square = mass * pow(radius, 2);
  return revolution(mass, fraction(1, 4) * square, fraction(1, 2) * square, axis);
}
Inertia Inertia::ring(const Expression& mass, const Expression& radius, int axis) {
  const Expression square = mass * pow(radius, 2);
  return revolution(mass, fraction(1, 2) * square, square, axis);
}
Inertia Inertia::cylinder(const Expression& mass, const Expression& radius, const Expression& height, int axis) {
  const Expression across = fraction(1, 12) * mass * (3 * pow(radius, 2) + pow(height, 2));
  return revolution(mass, across, fraction(1, 2) * mass * pow(radius, 2), axis);
}
Inertia Inertia::solid_sphere(const Expression& mass, const Expression& radius) {
  const Expression any = fraction(2, 5) * mass * pow(radius, 2);
  return general(mass, any, any, any);
}
Inertia Inertia::hollow_sphere(const Expression& mass, const Expression& radius) {
  const Expression any = fraction(2, 3) * mass * pow(radius, 2);
  return general(mass, any, any, any);
}
Inertia Inertia::box(const Expression& mass, const Expression& a, const Expression& b, const Expression& c) {
  const Expression k = fraction(1, 12) * mass;
  return general(mass, k * (pow(b, 2) + pow(c, 2)), k * (pow(a, 2) + pow(c, 2)), k * (pow(a, 2) + pow(b, 2)));
}
Inertia Inertia::plate(const Expression& mass, const Expression& a, const Expression& b) {
  const Expression k = fraction(1, 12) * mass;
  return general(mass, k * pow(b, 2), k * pow(a, 2), k * (pow(a, 2) + pow(b, 2)));
}

Inertia Inertia::at(const Triple& new_center) const {
  Inertia moved = *this;
  moved.center = new_center;
  return moved;
}

}  // namespace torsor
