// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/inertia.hpp"

namespace torsor {

/// A symmetry of the matter of a body (shape and density) about the origin of its frame. What follows for x, y, z the
/// named axis and the two after it (Pommier, Dynamique des systèmes de solides, §4.2.2):
enum class MaterialSymmetry {
  plane,       ///< the plane through O with normal x: OG·x = 0, J_xy = J_xz = 0
  half_turn,   ///< the axis (O, x), by half a turn: OG·y = OG·z = 0, J_xy = J_xz = 0
  revolution,  ///< all turns about (O, x), or any by a third of a turn or less: in addition J_yz = 0, J_yy = J_zz
};

/// Whether a body can have that symmetry: all that follows from it for centre of mass and operator holds identically in
/// the parameters. The converse is not decidable from these: unlike matter may have like inertia.
bool allows(const Inertia& body, MaterialSymmetry symmetry, int axis);

/// The body with what its symmetry settles set: products and components of the centre of mass that vanish, and for
/// revolution both moments across made J_yy, y being the next axis. For bodies whose remaining entries are measured or
/// left as parameters.
Inertia with_symmetry(const Inertia& body, MaterialSymmetry symmetry, int axis);

/// Whether the operator about G is that of a sphere: J_xx = J_yy = J_zz and no products.
bool is_spherical(const Inertia& body);
/// Whether the operator about G is unchanged by turns about an axis through G: equal moments across and no products.
bool is_of_revolution(const Inertia& body, int axis);
/// Whether the axis through G is principal: the two products with it vanish.
bool is_principal(const Inertia& body, int axis);

}  // namespace torsor
