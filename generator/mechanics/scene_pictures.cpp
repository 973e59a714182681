// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {
namespace {

void require_lengths(const form::Box& box) { require_unit(box.edges, units::metre, "an edge of a box that is shown"); }
void require_lengths(const form::Cylinder& cylinder) {
  require_unit(cylinder.radius, units::metre, "the radius of a cylinder that is shown");
  require_unit(cylinder.length, units::metre, "the length of a cylinder that is shown");
}
void require_lengths(const form::Cone& cone) {
  require_unit(cone.radius, units::metre, "the radius of a cone that is shown");
  require_unit(cone.length, units::metre, "the length of a cone that is shown");
}
void require_lengths(const form::Sphere& sphere) {
  require_unit(sphere.radius, units::metre, "the radius of a sphere that is shown");
}
void require_lengths(const form::Segment& segment) {
  require_unit(segment.from, units::metre, "an end of a segment that is shown");
  require_unit(segment.to, units::metre, "an end of a segment that is shown");
  require_unit(segment.radius, units::metre, "the radius of a segment that is shown");
}
void require_lengths(const form::Torus& torus) {
  require_unit(torus.radius, units::metre, "the radius of a torus that is shown");
  require_unit(torus.tube, units::metre, "the radius of the tube of a torus that is shown");
}
void require_lengths(const form::Mesh& mesh) {
  if (mesh.file.empty()) throw SceneError("a mesh that is shown has no file: name one, e.g. \"arm.stl\"");
}

}  // namespace

void Scene::show(const Shown& shown) {
  std::visit([](const auto& form) { require_lengths(form); }, shown.form);
  require_unit(shown.placement.origin, units::metre, "the origin of a form that is shown");
  if (shown.colour) {
    for (const double share : {shown.colour->red, shown.colour->green, shown.colour->blue}) {
      if (share >= 0 && share <= 1) continue;
      throw SceneError(fmt::format("a colour has the share {} and must have red, green and blue between 0 and 1", share));
    }
  }
  content_.shown.push_back(shown);
}

}  // namespace torsor
