// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/rotor.hpp"

namespace torsor {

void add_rotor(Scene& scene, const std::string& frame, const Rotor& rotor) {
  const auto& [displacement, turns, armature] = rotor;
  const Expression angle = turns ? displacement : displacement / Expression::quantity(Number(1), units::metre);
  const Expression moment = turns ? armature : armature * Expression::quantity(Number(1), units::metre * units::metre);
  const FrameHandle turned = scene.revolute(frame, scene.ground(), axis::z, angle);
  scene.body(frame, turned, Inertia::general({.mass = 0, .zz = moment}));
}

}  // namespace torsor
