// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// A direction of a contact: w = Σ J_i v_i + b, dw/dt = Σ J_i v̇_i + drift.
struct ContactRow {
  Value rate;                   ///< w [m/s], the rate of a displacement, or an angular velocity
  std::vector<Value> jacobian;  ///< J_i, of the unknowns
  Value drift;                  ///< dw/dt at zero accelerations
  std::size_t tangent = 0;      ///< of a slip or a roll: which of the two tangents
};

/// A contact of the scene: what opens it first, then along what it slips.
struct ContactRows {
  std::string name;
  bool normal = true;  ///< false: dry friction alone, or resistance to a turn
  std::optional<std::size_t> pressed_by = std::nullopt;  ///< of a turn: the contact whose N bounds its moment
  std::optional<int> joint = std::nullopt;  ///< of friction in proportion to a joint's reaction: the link that it carries
  Value gap;           ///< [m], or in the unit of a stopped coordinate; its rate is that of the first row
  std::vector<ContactRow> rows;

  std::size_t tangents() const { return rows.size() - (normal ? 1 : 0); }
};

/// Rows for all contacts of the scene, in the order of declaration. n points from the second body to the first, and slip
/// is that of the first on the second: V(P ∈ first/second) · t. Of a contact without friction there is no tangent, nor
/// one along which nothing can slip.
///
/// Tangents at a plane are the axes x, y of its frame. Between spheres, with p the axis of the ground that n has no
/// component along (the first of y, z, x), there is one in a plane mechanism: p ∧ n. Elsewhere there are two:
/// t_x = e_x − n_x (n + e_z)/(1 + n_z) and the same of y, smooth but where n = −e_z.
///
/// Rows of a turn are Ω(first/second) · t of both tangents (rolling) or Ω · n (spinning), but for those about which nothing
/// can turn.
/// Throws SceneError where a contact involves no coordinate.
std::vector<ContactRows> contact_rows(const Model& model);

/// What a picture of a contact needs, in the axes of the ground.
struct ContactPlace {
  Vector point;                    ///< where the surfaces are nearest to each other, from the ground's origin [m]
  std::vector<Vector> directions;  ///< of each row: its reaction r is the force r · direction on the first body
};
/// Those of all contacts, in the order of their rows. What works with a coordinate (a stop, dry friction) or is a moment has no
/// force at a point: its directions are zero.
std::vector<ContactPlace> contact_places(const Model& model);

/// f, f_s, e and the bounds b, b_s of dry friction, formulas of parameters. Of a turn, and of a joint that turns, f and f_s
/// are lengths [m].
struct ContactCoefficients { Value friction, static_friction, restitution, bound, static_bound; };
std::vector<ContactCoefficients> contact_coefficients(const Model& model);

}  // namespace torsor
