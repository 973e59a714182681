// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia.hpp"

#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/number.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"

namespace torsor {
namespace {

Expression fraction(long numerator, long denominator) { return Expression(Number::rational(numerator, denominator)); }

void require_axis(int axis) {
  if (axis >= 0 && axis <= 2) return;
  throw SceneError(fmt::format("axis {} of an inertia does not exist: use 0, 1 or 2 for x, y or z", axis));
}

/// The two axes that follow one, then itself: (x, y, z) for z.
std::array<std::size_t, 3> axes_from(int axis) {
  const auto z = static_cast<std::size_t>(axis);
  return {(z + 1) % 3, (z + 2) % 3, z};
}

Tableau zeros() { return {Triple{0, 0, 0}, Triple{0, 0, 0}, Triple{0, 0, 0}}; }

Tableau tableau(const Inertia& body) {
  return {Triple{body.xx, body.xy, body.xz}, Triple{body.xy, body.yy, body.yz}, Triple{body.xz, body.yz, body.zz}};
}

Inertia of(const Expression& mass, const Triple& center, const Tableau& j) {
  return {mass, center, j[0][0], j[1][1], j[2][2], j[0][1], j[0][2], j[1][2]};
}

Inertia with_sizes(Inertia inertia, std::vector<StatedSize> sizes) {
  inertia.sizes = std::move(sizes);
  return inertia;
}

/// A body of revolution about one axis of its frame.
Inertia revolution(const Expression& mass, const Expression& across, const Expression& along, int axis) {
  require_axis(axis);
  Inertia inertia = Inertia::general({.mass = mass, .xx = across, .yy = across, .zz = across});
  (axis == 0 ? inertia.xx : axis == 1 ? inertia.yy : inertia.zz) = along;
  return inertia;
}

}  // namespace

Inertia Inertia::point(const Expression& mass) { return general({.mass = mass}); }

Inertia Inertia::general(const GeneralInertia& body) {
  return {body.mass, {0, 0, 0}, body.xx, body.yy, body.zz, body.xy, body.xz, body.yz};
}

Inertia Inertia::rod(const Expression& mass, const Expression& length, int axis) {
  return with_sizes(revolution(mass, fraction(1, 12) * mass * pow(length, 2), 0, axis), {{"length of a rod", length}});
}
Inertia Inertia::disk(const Expression& mass, const Expression& radius, int axis) {
  const Expression square = mass * pow(radius, 2);
  return with_sizes(revolution(mass, fraction(1, 4) * square, fraction(1, 2) * square, axis), {{"radius of a disk", radius}});
}
Inertia Inertia::ring(const Expression& mass, const Expression& radius, int axis) {
  const Expression square = mass * pow(radius, 2);
  return with_sizes(revolution(mass, fraction(1, 2) * square, square, axis), {{"radius of a ring", radius}});
}
Inertia Inertia::cylinder(const Expression& mass, const Expression& radius, const Expression& height, int axis) {
  const Expression across = fraction(1, 12) * mass * (3 * pow(radius, 2) + pow(height, 2));
  return with_sizes(revolution(mass, across, fraction(1, 2) * mass * pow(radius, 2), axis),
                    {{"radius of a cylinder", radius}, {"height of a cylinder", height}});
}
Inertia Inertia::hollow_cylinder(const HollowCylinder& tube) {
  const Expression squares = pow(tube.outer_radius, 2) + pow(tube.inner_radius, 2);
  const Expression across = fraction(1, 12) * tube.mass * (3 * squares + pow(tube.height, 2));
  return with_sizes(revolution(tube.mass, across, fraction(1, 2) * tube.mass * squares, tube.axis),
                    {{"inner radius of a hollow cylinder", tube.inner_radius},
                     {"outer radius of a hollow cylinder", tube.outer_radius, StatedSize::Least::other, "inner radius",
                      tube.inner_radius},
                     {"height of a hollow cylinder", tube.height}});
}
Inertia Inertia::cylindrical_shell(const Expression& mass, const Expression& radius, const Expression& height,
                                   int axis) {
  const Expression across = fraction(1, 12) * mass * (6 * pow(radius, 2) + pow(height, 2));
  return with_sizes(revolution(mass, across, mass * pow(radius, 2), axis),
                    {{"radius of a cylindrical shell", radius}, {"height of a cylindrical shell", height}});
}
Inertia Inertia::cone(const Expression& mass, const Expression& base_radius, const Expression& height, int axis) {
  const Expression across = fraction(3, 80) * mass * (4 * pow(base_radius, 2) + pow(height, 2));
  return with_sizes(revolution(mass, across, fraction(3, 10) * mass * pow(base_radius, 2), axis),
                    {{"radius of a cone", base_radius}, {"height of a cone", height}});
}
Inertia Inertia::conical_shell(const Expression& mass, const Expression& base_radius, const Expression& height,
                               int axis) {
  const Expression across = fraction(1, 36) * mass * (9 * pow(base_radius, 2) + 2 * pow(height, 2));
  return with_sizes(revolution(mass, across, fraction(1, 2) * mass * pow(base_radius, 2), axis),
                    {{"radius of a conical shell", base_radius}, {"height of a conical shell", height}});
}
Inertia Inertia::solid_sphere(const Expression& mass, const Expression& radius) {
  const Expression any = fraction(2, 5) * mass * pow(radius, 2);
  return with_sizes(general({.mass = mass, .xx = any, .yy = any, .zz = any}), {{"radius of a sphere", radius}});
}
Inertia Inertia::hollow_sphere(const Expression& mass, const Expression& radius) {
  const Expression any = fraction(2, 3) * mass * pow(radius, 2);
  return with_sizes(general({.mass = mass, .xx = any, .yy = any, .zz = any}), {{"radius of a hollow sphere", radius}});
}
Inertia Inertia::box(const Expression& mass, const Expression& a, const Expression& b, const Expression& c) {
  const Expression k = fraction(1, 12) * mass;
  return with_sizes(general({.mass = mass,
                             .xx = k * (pow(b, 2) + pow(c, 2)),
                             .yy = k * (pow(a, 2) + pow(c, 2)),
                             .zz = k * (pow(a, 2) + pow(b, 2))}),
                    {{"edge of a box", a}, {"edge of a box", b}, {"edge of a box", c}});
}
Inertia Inertia::plate(const Expression& mass, const Expression& a, const Expression& b) {
  const Expression k = fraction(1, 12) * mass;
  return with_sizes(
      general({.mass = mass, .xx = k * pow(b, 2), .yy = k * pow(a, 2), .zz = k * (pow(a, 2) + pow(b, 2))}),
      {{"edge of a plate", a}, {"edge of a plate", b}});
}

Inertia Inertia::half_disk(const Expression& mass, const Expression& radius, int axis) {
  require_axis(axis);
  const Expression square = mass * pow(radius, 2);
  const Expression offset = fraction(16, 9) / pow(pi(), 2);  // (4/(3π))²
  Tableau j = zeros();
  const auto [x, y, z] = axes_from(axis);
  j[x][x] = (fraction(1, 4) - offset) * square;
  j[y][y] = fraction(1, 4) * square;
  j[z][z] = (fraction(1, 2) - offset) * square;
  Triple center{0, 0, 0};
  center[y] = fraction(4, 3) * radius / pi();
  return with_sizes(of(mass, center, j), {{"radius of a half disk", radius}});
}
Inertia Inertia::quarter_disk(const Expression& mass, const Expression& radius, int axis) {
  require_axis(axis);
  const Expression square = mass * pow(radius, 2);
  const Expression offset = fraction(16, 9) / pow(pi(), 2);  // (4/(3π))²
  Tableau j = zeros();
  const auto [x, y, z] = axes_from(axis);
  j[x][x] = (fraction(1, 4) - offset) * square;
  j[y][y] = j[x][x];
  j[z][z] = (fraction(1, 2) - 2 * offset) * square;
  j[x][y] = (offset - fraction(1, 2) / pi()) * square;
  j[y][x] = j[x][y];
  Triple center{0, 0, 0};
  center[x] = fraction(4, 3) * radius / pi();
  center[y] = center[x];
  return with_sizes(of(mass, center, j), {{"radius of a quarter disk", radius}});
}
Inertia Inertia::triangle(const Expression& mass, const Triple& a, const Triple& b, const Triple& c) {
  const Triple center = fraction(1, 3) * (a + b + c);
  Tableau j = zeros();
  for (const Triple& corner : {a, b, c}) {
    const Tableau part = operator_of_point(fraction(1, 12) * mass, corner - center);
    for (std::size_t k = 0; k < 3; ++k) j[k] = j[k] + part[k];
  }
  return of(mass, center, j);
}

Inertia Inertia::rotated(const Rotation& rotation) const {
  Tableau entries;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) entries[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = rotation(i, j);
  }
  return with_sizes(of(mass, entries * center, turned(entries, tableau(*this))), sizes);
}
Inertia Inertia::rotated(const Triple& axis, const Expression& angle) const {
  const Tableau rotation = rotation_about(axis, angle);
  return with_sizes(of(mass, rotation * center, turned(rotation, tableau(*this))), sizes);
}

Inertia Inertia::at(const Triple& new_center) const {
  Inertia moved = *this;
  moved.center = new_center;
  return moved;
}

}  // namespace torsor
