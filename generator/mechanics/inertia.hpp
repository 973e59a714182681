// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/expression/expression.hpp"
#include "generator/geometry/triple.hpp"

namespace torsor {

/// Mass [kg], centre of mass [m] and inertia operator about the centre of mass [kg m²], both in the axes of the frame
/// the body is attached to. The operator is J = ∫ (GP² 1 − GP GPᵀ) dm, so products of inertia carry their minus sign:
/// xy = −∫ x y dm.
struct Inertia {
  Expression mass;
  Triple center;  ///< OG, O being the origin of the body's frame
  Expression xx, yy, zz, xy, xz, yz;

  /// A point mass at the origin of the frame.
  static Inertia point(const Expression& mass);
  /// Any rigid body, given about its centre of mass at the origin; move it with `at`.
  static Inertia general(const Expression& mass, const Expression& xx, const Expression& yy, const Expression& zz,
                         const Expression& xy = 0, const Expression& xz = 0, const Expression& yz = 0);
  /// Thin rod of length l along axis 0, 1 or 2, centred: m l²/12 across.
  static Inertia rod(const Expression& mass, const Expression& length, int axis);
  /// Thin disk of radius r, axis along 0, 1 or 2, centred: m r²/4, m r²/4, m r²/2.
  static Inertia disk(const Expression& mass, const Expression& radius, int axis);
  /// Thin ring: m r²/2, m r²/2, m r².
  static Inertia ring(const Expression& mass, const Expression& radius, int axis);
  /// Solid cylinder: m (3 r² + h²)/12 across, m r²/2 along its axis.
  static Inertia cylinder(const Expression& mass, const Expression& radius, const Expression& height, int axis);
  /// Solid sphere: 2 m r²/5.
  static Inertia solid_sphere(const Expression& mass, const Expression& radius);
  /// Thin spherical shell: 2 m r²/3.
  static Inertia hollow_sphere(const Expression& mass, const Expression& radius);
  /// Solid box with edges a, b, c along x, y, z: m (b² + c²)/12 about x.
  static Inertia box(const Expression& mass, const Expression& a, const Expression& b, const Expression& c);
  /// Thin rectangular plate a × b in the x, y plane: m b²/12, m a²/12, m (a² + b²)/12.
  static Inertia plate(const Expression& mass, const Expression& a, const Expression& b);

  /// The same body with its centre of mass at another place of the frame.
  Inertia at(const Triple& new_center) const;
};

}  // namespace torsor
