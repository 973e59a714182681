// SPDX-License-Identifier: GPL-3.0-or-later
// Where bodies are in a tree of links, and what inertia they give to those.
#include <array>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"

namespace torsor {

const FramePlace& BodyTree::place(const FrameReference& frame, const std::string& user) const {
  return places_[static_cast<std::size_t>(scene_->frame_index(frame, user))];
}

void add_placed(Program& program, MassProperties& sum, const MassProperties& part, const PartPlace& at) {
  const auto& [rotation, origin] = at;
  const Matrix r = constant_matrix(program, rotation);
  const Vector h = rotation * part.first_moment;
  const Matrix turned = r * part.inertia * transpose(r);
  // About the new origin: J + 2 (p·h) 1 − p hᵀ − h pᵀ + m (p² 1 − p pᵀ)
  Value scalar = Number(2) * dot(origin, h);
  scalar += part.mass * dot(origin, origin);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Value entry = turned(i, j);
      if (i == j) entry += scalar;
      entry -= origin[i] * h[j];
      entry -= h[i] * origin[j];
      entry -= part.mass * (origin[i] * origin[j]);
      sum.inertia(i, j) = program.bind(sum.inertia(i, j) + entry);
    }
  }
  sum.first_moment = bound(program, sum.first_moment + h + part.mass * origin);
  sum.mass = program.bind(sum.mass + part.mass);
}

void BodyTree::gather_bodies() {
  for (Link& link : links_) link.mass = {};
  for (const BodyContent* each : scene_->inertias()) {
    const BodyContent& body = *each;
    const std::string user = scene_->name_of(body);
    const FramePlace& at = place(body.frame, user);
    const Inertia& given = body.inertia;
    MassProperties central;
    const auto require = [&](const Value& value, const Unit& unit, const std::string& what) {
      if (!value.is_zero() && !(value.unit() == unit)) {
        const std::string text = to_string(value);
        throw UnitError(fmt::format("{}: {} is {} [{}] and must be in {}{}", user, what, text,
                                    value.unit().to_string(), unit.to_string(), unit_remedy(text, value.unit(), unit)));
      }
      return value;
    };
    central.mass = require(program_->lower(given.mass), units::kilogram, "its mass");
    const std::array<const Expression*, 9> entries{&given.xx, &given.xy, &given.xz, &given.xy, &given.yy,
                                                   &given.yz, &given.xz, &given.yz, &given.zz};
    for (int i = 0; i < 9; ++i) {
      central.inertia(i / 3, i % 3) = require(program_->lower(*entries[static_cast<std::size_t>(i)]),
                                              units::kilogram_metre_squared, "an entry of its inertia operator");
    }
    Vector center = lower(*program_, given.center);
    for (int i = 0; i < 3; ++i) require(center[i], units::metre, "its centre of mass");
    const Vector origin = at.origin + at.rotation * center;
    add_placed(*program_, links_[static_cast<std::size_t>(at.link)].mass, central,
               {.rotation = at.rotation, .origin = origin});
  }
}

}  // namespace torsor
