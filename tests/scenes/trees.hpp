// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>

#include "tests/scenes/bodies.hpp"

namespace torsor::testing_mechanisms {

/// A trunk with two branches: a skew and a negative axis, a slanted slide, a driven joint.
struct BranchingTree {
  Scene scene;
  Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "m"), c = scene.coordinate("c", "rad"),
             d = scene.coordinate("d", "rad"), driven = scene.coordinate("driven", "rad");
  FrameHandle trunk = scene.revolute("trunk", scene.ground(), axis::z, a, {.origin = {metres("0.1"), 0, 0}});
  FrameHandle slide = scene.prismatic("slide", trunk, {0, 1, 1}, b, {.rotation = Rotation::about(0, 2)});
  FrameHandle rotor = scene.revolute("rotor", slide, axis::x, driven);
  FrameHandle tip = scene.revolute("tip", rotor, {1, 2, 2}, c, {.origin = {0, 0, metres("0.3")}});
  FrameHandle branch = scene.revolute("branch", trunk, -axis::y, d, {.origin = {0, metres("0.2"), 0}});

  explicit BranchingTree(const std::string& name) : scene(name) {
    scene.drive(driven, pow(scene.time() / quantity("1", "s"), 2));
    scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
    add_bodies({trunk, slide, rotor, tip, branch});
  }
  void add_bodies(std::initializer_list<FrameHandle> frames) {
    for (const FrameHandle& frame : frames) scene.body("body" + std::to_string(frame.index), frame, generic_body());
  }
};

}  // namespace torsor::testing_mechanisms
