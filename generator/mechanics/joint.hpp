// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

class NaturalLanguage;

/// Ideal joints between two frames a and b (the standard table of mechanical joints). Axes are those of frame a unless
/// said otherwise; "locked" directions transmit force or moment, free ones transmit none.
enum class JointType {
  weld,                ///< 0 freedoms
  revolute,            ///< turns about x
  prismatic,           ///< slides along x
  helical,             ///< turns about x and advances by the pitch p per radian: v = p ω
  cylindrical,         ///< turns about x and slides along x
  universal,           ///< turns about x of a and y of b (pinned ball)
  spherical,           ///< turns about a point
  planar,              ///< slides in the plane x, y and turns about its normal z
  line_contact,        ///< the line x of b stays in the plane x, y of a
  sphere_in_cylinder,  ///< the origin of b stays on the axis x of a
  point_contact,       ///< the origin of b stays in the plane x, y of a
  free,                ///< 6 freedoms: no joint at all
};

/// Degrees of freedom f of the joint; the ideal wrench it transmits has 6 − f independent components.
int freedom_count(JointType type);
std::string_view to_string(JointType type);
/// The same in the language.
std::string name_of(JointType type, const NaturalLanguage& say);

}  // namespace torsor
