// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/geometry/triple.hpp"
#include "torsor/generator/mechanics/stated_size.hpp"

namespace torsor {

/// Mass [kg], moments and products of inertia [kg m²] of any rigid body; those that are not given are zero.
struct GeneralInertia { Expression mass, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0; };
/// A thick tube along axis 0, 1 or 2 [kg, m].
struct HollowCylinder { Expression mass, outer_radius, inner_radius, height; int axis; };

/// Mass [kg], centre of mass [m] and inertia operator about the centre of mass [kg m²], both in the axes of the frame
/// the body is attached to. The operator is J = ∫ (GP² 1 − GP GPᵀ) dm, so products of inertia carry their minus sign:
/// xy = −∫ x y dm.
struct Inertia {
  Expression mass;
  Triple center;  ///< OG, O being the origin of the body's frame
  Expression xx, yy, zz, xy, xz, yz;
  std::vector<StatedSize> sizes{};  ///< of the bodies that it was made from

  /// A point mass at the origin of the frame.
  /// Equation: J = 0 about the point.
  static Inertia point(const Expression& mass);
  /// Any rigid body, given about its centre of mass at the origin; move it with `at`.
  /// Equation: J v = (xx v_x + xy v_y + xz v_z, xy v_x + yy v_y + yz v_z, xz v_x + yz v_y + zz v_z).
  static Inertia general(const GeneralInertia& body);
  /// Thin rod of length l along axis 0, 1 or 2, centred.
  /// Equation: J = m l²/12 across, 0 along its axis.
  static Inertia rod(const Expression& mass, const Expression& length, int axis);
  /// Thin disk of radius r, axis along 0, 1 or 2, centred.
  /// Equation: J = m r²/4 across, m r²/2 along its axis.
  static Inertia disk(const Expression& mass, const Expression& radius, int axis);
  /// Thin ring of radius r, axis along 0, 1 or 2, centred.
  /// Equation: J = m r²/2 across, m r² along its axis.
  static Inertia ring(const Expression& mass, const Expression& radius, int axis);
  /// Solid cylinder of radius r and height h, centred.
  /// Equation: J = m (3 r² + h²)/12 across, m r²/2 along its axis.
  static Inertia cylinder(const Expression& mass, const Expression& radius, const Expression& height, int axis);
  /// Thick tube between the radii r < R, centred.
  /// Equation: J = m (3 (R² + r²) + h²)/12 across, m (R² + r²)/2 along its axis.
  static Inertia hollow_cylinder(const HollowCylinder& tube);
  /// Thin cylindrical shell without its ends, centred.
  /// Equation: J = m (6 r² + h²)/12 across, m r² along its axis.
  static Inertia cylindrical_shell(const Expression& mass, const Expression& radius, const Expression& height,
                                   int axis);
  /// Solid cone about its centre of mass, which is h/4 from the base and 3 h/4 from the apex.
  /// Equation: J = 3 m (4 r² + h²)/80 across, 3 m r²/10 along its axis.
  static Inertia cone(const Expression& mass, const Expression& base_radius, const Expression& height, int axis);
  /// Thin conical shell without its base about its centre of mass, which is h/3 from the base.
  /// Equation: J = m (9 r² + 2 h²)/36 across, m r²/2 along its axis.
  static Inertia conical_shell(const Expression& mass, const Expression& base_radius, const Expression& height,
                               int axis);
  /// Solid sphere of radius r, centred.
  /// Equation: J = 2 m r²/5 about every axis.
  static Inertia solid_sphere(const Expression& mass, const Expression& radius);
  /// Thin spherical shell of radius r, centred.
  /// Equation: J = 2 m r²/3 about every axis.
  static Inertia hollow_sphere(const Expression& mass, const Expression& radius);
  /// Solid box with edges a, b, c along x, y, z, centred.
  /// Equation: J = m (b² + c²)/12 about x, m (a² + c²)/12 about y, m (a² + b²)/12 about z.
  static Inertia box(const Expression& mass, const Expression& a, const Expression& b, const Expression& c);
  /// Thin rectangular plate a × b in the x, y plane, centred.
  /// Equation: J = m b²/12 about x, m a²/12 about y, m (a² + b²)/12 about z.
  static Inertia plate(const Expression& mass, const Expression& a, const Expression& b);

  /// Thin half disk with normal `axis`. Its diameter is centred at the origin along the next axis (x for axis 2). The
  /// half lies on the positive side of the one after (y), with its centre of mass at 4 r/(3π) there.
  /// Equation: J = m r²/4 about x and y, m r²/2 about z, no product, all about the origin (for axis 2).
  static Inertia half_disk(const Expression& mass, const Expression& radius, int axis);
  /// Thin quarter disk with normal `axis`. Its corner is at the origin, its edges lie along the two axes that follow,
  /// on their positive sides (x and y for axis 2). The centre of mass is at 4 r/(3π) along both (course, exercise 8.2.1).
  /// Equation: J = m r²/4 about x and y, m r²/2 about z, xy = −m r²/(2π), all about the corner (for axis 2).
  static Inertia quarter_disk(const Expression& mass, const Expression& radius, int axis);
  /// Thin triangular plate with its corners at a, b, c [m], anywhere in space.
  /// Equation: OG = (a + b + c)/3; J is that of three masses m/12 at the corners and one of 3 m/4 at G.
  static Inertia triangle(const Expression& mass, const Triple& a, const Triple& b, const Triple& c);

  /// The same body with its centre of mass at another place of the frame.
  /// Equation: J about G stays; about the origin O it is J + m (OG² 1 − OG OGᵀ).
  Inertia at(const Triple& new_center) const;
  /// The body turned about the frame's origin: a vector of it with components v gets components R v. This is also a body
  /// given in a frame turned by R, seen in the outer axes.
  /// Equation: J becomes R J Rᵀ, OG becomes R OG.
  Inertia rotated(const Rotation& rotation) const;
  /// Turned about the frame's origin by an angle [rad] about an axis (components along the frame's axes, any length),
  /// e.g. a blade by its pitch. The angle may be a formula of parameters; a motion needs a joint.
  /// Equation: R v = v cos a + n ∧ v sin a + n (n · v) (1 − cos a), n the unit axis, a the angle.
  Inertia rotated(const Triple& axis, const Expression& angle) const;
};

}  // namespace torsor
