// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/surface_contacts.hpp"

#include <array>
#include <utility>
#include <variant>

#include <fmt/format.h>

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

/// Both ends of a solid along z, each with the sign of its z.
constexpr std::array<std::pair<const char*, int>, 2> ends{{{"_top", 1}, {"_base", -1}}};

}  // namespace

SurfaceContacts::SurfaceContacts(Scene& scene, FileIdentifiers& identifiers, const std::string& word,
                                 const Surfaces& surfaces)
    : scene_(scene), identifiers_(identifiers) {
  const auto parameter = [&](const char* what, const Number& value) {
    return scene_.run_time_parameter(identifiers_.symbol(word + what, "parameter"), "1", Expression(value));
  };
  law_.friction = parameter("_friction", surfaces.friction);
  law_.restitution = parameter("_restitution", surfaces.restitution);
}

FrameHandle SurfaceContacts::at(const std::string& name, const FrameReference& parent, const Placement& placement) const {
  return scene_.weld(identifiers_.frame(name, "frame"), parent, placement);
}

void SurfaceContacts::touch(const std::string& name, const ContactShape& shape, const ContactShape& other) const {
  scene_.contact(identifiers_.symbol(name, "contact", suffixes(shape)), shape, other, law_);
}

void SurfaceContacts::cylinder_on_plane(const std::string& name, const FrameHandle& centre, const form::Cylinder& cylinder,
                                        const FrameReference& plane) const {
  for (const auto& [suffix, side] : ends) {
    const FrameHandle rim = at(name + suffix, centre, {.origin = {0, 0, side * cylinder.length / 2}});
    touch(name + suffix, shape::Disc{.frame = rim, .axis = axis::z, .radius = cylinder.radius}, shape::Plane{.frame = plane});
  }
}

void SurfaceContacts::capsule_on_plane(const std::string& name, const FrameHandle& centre, const form::Cylinder& capsule,
                                       const FrameReference& plane) const {
  for (const auto& [suffix, side] : ends) {
    const FrameHandle ball = at(name + suffix, centre, {.origin = {0, 0, side * capsule.length / 2}});
    touch(name + suffix, shape::Sphere{.frame = ball, .radius = capsule.radius}, shape::Plane{.frame = plane});
  }
}

}  // namespace torsor
