// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_collisions.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {

UrdfCollisions::UrdfCollisions(const UrdfContactScene& around, const std::string& word, const Surfaces& surfaces)
    : around_(around), contacts_(around.scene, around.identifiers, word, surfaces) {}

std::vector<const UrdfCollision*> UrdfCollisions::of_link(const std::string& link, const std::string& option) const {
  std::vector<const UrdfCollision*> found;
  std::vector<std::string> able;
  for (const UrdfCollision& each : around_.robot.collisions) {
    if (each.link == link) found.push_back(&each);
    if (!around_.frames.contains(each.link)) continue;
    if (std::find(able.begin(), able.end(), each.link) == able.end()) able.push_back(each.link);
  }
  if (!found.empty() && !around_.frames.contains(link)) {
    throw UsageError(fmt::format("the link '{}' in {} belongs to no part that moves and is left out: name others, those "
                                 "with a <collision> are {}",
                                 link, option, able.empty() ? "none" : fmt::format("{}", fmt::join(able, ", "))));
  }
  if (found.empty()) {
    throw UsageError(fmt::format("the link '{}' in {} {}: {}those with a <collision> are {}", link, option,
                                 around_.frames.contains(link) ? "has no <collision>" : "is unknown", did_you_mean(link, able),
                                 able.empty() ? "none" : fmt::format("{}", fmt::join(able, ", "))));
  }
  for (const UrdfCollision* each : found) {
    if (each->form && each->placement && !std::holds_alternative<form::Mesh>(*each->form)) continue;
    each->place.fail(
        fmt::format("the <collision> of the link '{}' is no sphere, box or cylinder with a size and an origin that "
                    "can be read, as {} asks: write one of these in its place, with one <origin> of xyz and either rpy or "
                    "quat_xyzw",
                    link, option));
  }
  return found;
}

void UrdfCollisions::touch_plane(const std::string& name, const UrdfCollision& collision,
                                 const FrameReference& plane) const {
  const FrameHandle centre = at(name + "_centre", frame(collision.link), *collision.placement);
  if (const auto* sphere = std::get_if<form::Sphere>(&*collision.form)) {
    contacts_.touch(name, shape::Sphere{.frame = centre, .radius = sphere->radius}, shape::Plane{.frame = plane});
  } else if (const auto* box = std::get_if<form::Box>(&*collision.form)) {
    const Triple half{box->edges[0] / 2, box->edges[1] / 2, box->edges[2] / 2};
    contacts_.touch(name, shape::Box{.frame = centre, .half_edges = half}, shape::Plane{.frame = plane});
  } else {
    contacts_.cylinder_on_plane(name, centre, std::get<form::Cylinder>(*collision.form), plane);
  }
}

void UrdfCollisions::touch_each_other(const std::string& name, const UrdfCollision& sphere,
                                      const UrdfCollision& other) const {
  const auto ball = [&](const UrdfCollision& collision, const char* suffix) {
    return shape::Sphere{.frame = at(name + suffix, frame(collision.link), *collision.placement),
                         .radius = std::get<form::Sphere>(*collision.form).radius};
  };
  const shape::Sphere first = ball(sphere, "_first"), second = ball(other, "_second");
  contacts_.touch(name, first, second);
}

}  // namespace torsor
