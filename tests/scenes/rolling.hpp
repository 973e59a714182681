// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/scenes/bodies.hpp"

namespace torsor::testing_mechanisms {

/// A ball of 0.5 m that rolls on the plane z = 0 of a frame, placed by x, y, z and the unit quaternion e.
inline FrameHandle add_rolling_ball(Scene& scene, const FrameHandle& table, const Inertia& inertia) {
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.free("ball", scene.ground(), {x, y, z}, scene.attitude("e"));
  scene.initial(z, metres("0.5"));
  const PointHandle low = scene.sphere_contact("low", ball, metres("0.5"), table);
  scene.body("ball", ball, inertia);
  scene.point_in_plane("floor", low, table);
  scene.rolling("rolling", {.body = ball, .on = table, .contact = low, .tangents = table});
  return ball;
}

/// A thin disc of 2 kg and 0.5 m that touches the ground and rolls on it, upright at the start.
struct RollingDisc {
  Scene scene{"disc"};
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  AttitudeHandle e = scene.attitude("e");
  FrameHandle disc = scene.free("disc", scene.ground(), {x, y, z}, e);

  RollingDisc() {
    scene.body("disc", disc, Inertia::disk(kilograms("2"), metres("0.5"), 2));
    scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
    const PointHandle low =
        scene.disc_contact("low", {.frame = disc, .axis = axis::z, .radius = metres("0.5"), .plane = scene.ground()});
    scene.point_in_plane("floor", low, scene.ground());
    scene.rolling("rolling", {.body = disc, .on = scene.ground(), .contact = low, .tangents = scene.ground()});
    scene.initial(e, {1, 1, 0, 0});  // turned by a right angle about x
    scene.initial(z, metres("0.5"));
  }
};

}  // namespace torsor::testing_mechanisms
