// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/scenes/bodies.hpp"

namespace torsor::testing_mechanisms {

/// A point mass that slides in a plane, along x and along y.
struct SlidingPoint {
  Scene scene;
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  FrameHandle point = scene.prismatic("point", slide, axis::y, y);
  PointHandle place = scene.point("P", point, {0, 0, 0});

  explicit SlidingPoint(const std::string& name, const char* mass = "1") : scene(name) {
    scene.body("point", point, Inertia::point(kilograms(mass)));
  }
};

/// A block of 2 kg on the plane z = 0; the multiplier of `floor` is the normal force.
struct Block {
  Scene scene{"block"};
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  FrameHandle block = scene.prismatic(
      "block", scene.prismatic("across", scene.prismatic("along", scene.ground(), axis::x, x), axis::y, y), axis::z, z);
  PointHandle contact = scene.point("I", block, {0, 0, 0});
  ConstraintHandle floor = scene.holonomic("floor", z);

  Block() { scene.body("block", block, Inertia::point(kilograms("2"))); }
  void name_the_normal_force() {
    scene.reaction(floor, "N", {.body = block, .contact = contact, .direction = axis::z, .axes = scene.ground()});
  }
  /// Coulomb's friction against a slip along `direction`.
  void slide(const Expression& coefficient, const Triple& direction, const char* name = "slide") {
    scene.sliding_friction(name, floor,
                           {.coefficient = coefficient, .body = block, .point = contact, .direction = direction,
                            .axes = scene.ground()});
  }
};

/// A block on a spring along x.
struct SpringBlock {
  Expression mass = kilograms("1"), stiffness = quantity("1", "N/m"), rest = metres("0"), start = metres("0"),
             speed = 0;
};
inline Scene block_on_a_spring(const SpringBlock& given) {
  Scene scene("block");
  const Expression x = scene.coordinate("x", "m");
  scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(given.mass));
  scene.spring("spring", x, given.stiffness, given.rest);
  scene.initial(x, given.start, given.speed);
  return scene;
}

/// A disk of 2 kg and 0.3 m that slides along x and turns about it, as a nut on a thread of 0.1 m.
inline Scene nut_on_a_thread() {
  Scene scene("nut");
  const Expression x = scene.coordinate("x", "m"), q = scene.coordinate("q", "rad");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle nut = scene.revolute("nut", slide, axis::x, q);
  scene.body("nut", nut, Inertia::disk(kilograms("2"), metres("0.3"), 0));
  scene.loop_joint("thread", {.type = JointType::helical, .a = scene.ground(), .b = nut, .pitch = metres("0.1")});
  return scene;
}

}  // namespace torsor::testing_mechanisms
