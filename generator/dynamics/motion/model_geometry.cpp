// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/model.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

Vector Model::locate(const PointReference& reference, int link, const std::string& user) const {
  return locate(see(reference, link, user), link);
}

Vector Model::locate(const SeenPoint& point, int link) const {
  const Vector base = locate(point.base.place, point.base.link, link);
  return point.beyond.is_zero() ? base : base + express(point.beyond, point.axes, link);
}

SeenPoint Model::see(const PointReference& reference, int axes, const std::string& user) const {
  const PointContent& point = scene_->points[static_cast<std::size_t>(scene_->point_index(reference, user))];
  if (point.lowest) return lowest(point, axes, user);
  const FramePlace& at = place(point.frame, name_of(point));
  return {{at.link, at.origin + at.rotation * lower(*program_, point.components)}, axes};
}

Vector Model::arm_of(int joint, const SeenPoint& point) const {
  return bound(*program_, between({joint, {}}, point.base, point.axes) + point.beyond);
}

Vector Model::down_in(const PointContent& point, const FramePlace& at, const std::string& user) const {
  const Vector normal = bound(*program_, express(axis::z, point.lowest->plane, at.link, user));
  return bound(*program_, -(at.rotation.transpose() * normal));
}

std::pair<Value, Vector> Model::supported(const PointContent& point, const Vector& down) const {
  const SupportFunction& support = *point.lowest->support;
  Substitution in_direction(*program_, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    for (int i = 0; i < 3; ++i) {
      if (support.direction[static_cast<std::size_t>(i)] == symbol) return down[i];
    }
    return std::nullopt;
  });
  const Value h = program_->bind(program_->lower(support.h));
  Vector place;
  for (int i = 0; i < 3; ++i) {
    const SymbolPointer& u = support.direction[static_cast<std::size_t>(i)];
    place[i] = program_->bind(in_direction(partial_derivation(*program_, u)(h)));
  }
  return {program_->bind(in_direction(h)), place};
}

SeenPoint Model::lowest(const PointContent& point, int link, const std::string& user) const {
  Program& program = *program_;
  const FramePlace& at = place(point.frame, name_of(point));
  if (point.lowest->support) {
    const Vector place = supported(point, down_in(point, at, user)).second;
    return {{at.link, at.origin + at.rotation * place}, link};
  }
  const GeometricPoint center{at.link, at.origin};
  const Vector down = bound(program, -express(axis::z, point.lowest->plane, link, user));
  const Value radius = program.lower(point.lowest->radius);
  if (point.lowest->axis) {
    // The part of it in the disc is k × (down × k): a difference down - (down . k) k has no digits left where the disc
    // lies flat.
    const Vector k = bound(program, express(*point.lowest->axis, point.frame, link, user));
    const Vector across = bound(program, cross(down, k)), steepest = bound(program, cross(k, across));
    const Value square = dot(across, across);
    if (square.is_zero()) {
      throw SceneError(fmt::format("the axis of {} is along the normal of its plane in every position: its rim lies flat, and "
                                   "touches at no single point; let points of the rim, a box or spheres touch instead",
                                   name_of(point)));
    }
    const Value scale = program.bind(radius / program.sqrt(square));
    if (point.lowest->tube.is_zero()) return {center, link, scale * steepest};
    const Value tube = program.lower(point.lowest->tube);
    const Vector normal = bound(program, express(axis::z, point.lowest->plane, link, user));
    return {center, link, scale * steepest - tube * normal};
  }
  return {center, link, radius * down};
}

Value Model::lowest_height(const PointContent& point, int link, const std::string& user) const {
  Program& program = *program_;
  const FramePlace& at = place(point.frame, name_of(point));
  const FramePlace& plane = place(point.lowest->plane, user);
  const Vector normal = bound(program, express(axis::z, point.lowest->plane, link, user));
  const Vector center = locate(at.origin, at.link, link);
  const Vector origin = locate(plane.origin, plane.link, link);
  const Value height = program.bind(dot(bound(program, center - origin), normal));
  if (point.lowest->support) return height - supported(point, down_in(point, at, user)).first;
  const Value radius = program.lower(point.lowest->radius);
  if (!point.lowest->axis) return height - radius;
  const Vector k = bound(program, express(*point.lowest->axis, point.frame, link, user));
  const Vector across = bound(program, cross(normal, k));
  const Value over_rim = height - radius * program.sqrt(dot(across, across));
  return point.lowest->tube.is_zero() ? over_rim : over_rim - program.lower(point.lowest->tube);
}

Vector Model::express(const Triple& direction, const FrameReference& axes, int link, const std::string& user) const {
  const FramePlace& at = place(axes, user);
  return express(at.rotation * lower(*program_, direction), at.link, link);
}

}  // namespace torsor
