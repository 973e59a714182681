// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_mechanisms {

inline Expression quantity(const char* value, const char* unit) { return Expression::quantity(value, unit); }
inline Expression kilograms(const char* value) { return quantity(value, "kg"); }
inline Expression metres(const char* value) { return quantity(value, "m"); }
inline Expression moment(const char* value) { return quantity(value, "kg m^2"); }

/// A body without any symmetry: no product of inertia vanishes, and the centre of mass lies on no axis.
inline Inertia generic_body(const char* mass = "1.5") {
  return Inertia::general({.mass = kilograms(mass), .xx = moment("0.3"), .yy = moment("0.5"), .zz = moment("0.4"),
                           .xy = moment("0.1"), .xz = moment("-0.02"), .yz = moment("0.03")})
      .at({metres("-0.1"), metres("0.2"), metres("0.05")});
}

/// A body of the moments 1, 2, 3 kg m² turning about its centre of mass, placed by the unit quaternion e.
inline Scene torque_free_body() {
  Scene scene("torque_free_body");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle body = scene.spherical("body", scene.ground(), e);
  scene.body("body", body,
             Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("2"), .zz = moment("3")}));
  return scene;
}

}  // namespace torsor::testing_mechanisms
