// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_scenes {

/// A mass in the plane under forces that take every form there is of a selection: a tabulated potential, a stop, drag
/// by |v| v, a force in steps, one whose potential is an angle, a force at most as large as a parameter.
inline Scene golden_selections() {
  using Q = Expression;
  Scene scene("golden_selections", "Mass with stops, tables and steps");
  const Q stop = scene.run_time_parameter("stop", "m", Q::quantity("0.25", "m"));
  const Q most = scene.run_time_parameter("most", "N", Q::quantity("3", "N"));
  const Q x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Q metre = Q::quantity("1", "m"), newton = Q::quantity("1", "N"), joule = Q::quantity("1", "J");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  const FrameHandle mass = scene.prismatic("mass", along, axis::y, y);
  scene.body("mass", mass, Inertia::point(Q::quantity("2", "kg")));
  scene.force_function("table", spline(x, {{-1, 2}, {-0.25, 0.5}, {0.5, 1}, {1.5, -1}}, "J"));
  scene.force_function("angle", joule / 2 * atan2(y - 2 * metre, x));
  scene.generalised_force("stop", y, -Q::quantity("40", "N/m") * sign(y) * max(abs(y) - stop, 0));
  scene.generalised_force("drag", x, -Q::quantity("0.5", "N s^2/m^2") * abs(rate(x)) * rate(x));
  scene.generalised_force("steps", y, piecewise({{x < -metre / 2, newton}, {x <= metre, 2 * newton}}, 0));
  scene.generalised_force("brake", y, max(min(-Q::quantity("5", "N s/m") * rate(y), most), -most));
  scene.initial(x, Q::quantity("0.2", "m"));
  return scene;
}

}  // namespace torsor::testing_scenes
