// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/import/xml_element.hpp"
#include "torsor/generator/mechanics/scene_arguments.hpp"

namespace torsor {

/// A form that a URDF file shows of a link.
struct UrdfVisual {
  std::string link;
  Form form;
  Placement placement;  ///< in the link
  std::optional<Colour> colour;
};

/// The <visual> elements of a robot. A picture decides nothing about the motion: whatever of it cannot be read is left out
/// without a word. Each angle within the tolerance of a multiple of π/12 is that multiple, here and in collisions.
std::vector<UrdfVisual> read_visuals(const XmlElement& robot, const Number& angle_tolerance);

/// A <collision> element: what a link touches others with. A form or a placement that cannot be read is none.
struct UrdfCollision {
  XmlPlace place;
  std::string link;
  std::optional<Form> form;
  std::optional<Placement> placement;  ///< in the link
};
std::vector<UrdfCollision> read_collisions(const XmlElement& robot, const Number& angle_tolerance);

}  // namespace torsor
