// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_collisions.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// Names that a contact of that shape takes besides its own.
std::vector<std::string> suffixes(const ContactShape& shape) {
  if (!std::holds_alternative<shape::Box>(shape)) return {"", "_point"};
  std::vector<std::string> all{""};
  for (int corner = 1; corner <= 8; ++corner) {
    all.push_back(fmt::format("_{}", corner));
    all.push_back(fmt::format("_{}_point", corner));
  }
  return all;
}

}  // namespace

UrdfCollisions::UrdfCollisions(const UrdfContactScene& around, const std::string& word, const UrdfSurfaces& surfaces)
    : around_(around) {
  const auto parameter = [&](const char* what, const Number& value) {
    return around.scene.run_time_parameter(around.take(word + what, "parameter", {""}), "1", Expression(value));
  };
  law_.friction = parameter("_friction", surfaces.friction);
  law_.restitution = parameter("_restitution", surfaces.restitution);
}

std::vector<const UrdfCollision*> UrdfCollisions::of_link(const std::string& link, const std::string& option) const {
  std::vector<const UrdfCollision*> found;
  std::vector<std::string> able;
  for (const UrdfCollision& each : around_.robot.collisions) {
    if (each.link == link) found.push_back(&each);
    if (std::find(able.begin(), able.end(), each.link) == able.end()) able.push_back(each.link);
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
                    "can be read, as {} asks: write one of these in its place",
                    link, option));
  }
  return found;
}

FrameHandle UrdfCollisions::at(const std::string& name, const FrameReference& parent,
                               const Placement& placement) const {
  return around_.scene.weld(around_.take(name, "frame", {""}), parent, placement);
}

void UrdfCollisions::touch_plane(const std::string& name, const UrdfCollision& collision,
                                 const FrameReference& plane) const {
  const auto touches = [&](const std::string& contact, const ContactShape& shape) {
    around_.scene.contact(around_.take(contact, "contact", suffixes(shape)), shape, shape::Plane{.frame = plane}, law_);
  };
  const FrameHandle centre = at(name + "_centre", frame(collision.link), *collision.placement);
  if (const auto* sphere = std::get_if<form::Sphere>(&*collision.form)) {
    touches(name, shape::Sphere{.frame = centre, .radius = sphere->radius});
  } else if (const auto* box = std::get_if<form::Box>(&*collision.form)) {
    touches(name, shape::Box{.frame = centre, .half_edges = {box->edges[0] / 2, box->edges[1] / 2, box->edges[2] / 2}});
  } else {
    const auto& cylinder = std::get<form::Cylinder>(*collision.form);
    for (const auto& [suffix, side] : {std::pair("_top", 1), std::pair("_base", -1)}) {
      const FrameHandle rim = at(name + suffix, centre, {.origin = {0, 0, side * cylinder.length / 2}});
      touches(name + suffix, shape::Disc{.frame = rim, .axis = axis::z, .radius = cylinder.radius});
    }
  }
}

void UrdfCollisions::touch_each_other(const std::string& name, const UrdfCollision& sphere,
                                      const UrdfCollision& other) const {
  const auto ball = [&](const UrdfCollision& collision, const char* suffix) {
    return shape::Sphere{.frame = at(name + suffix, frame(collision.link), *collision.placement),
                         .radius = std::get<form::Sphere>(*collision.form).radius};
  };
  const shape::Sphere first = ball(sphere, "_first"), second = ball(other, "_second");
  around_.scene.contact(around_.take(name, "contact", {""}), first, second, law_);
}

}  // namespace torsor
