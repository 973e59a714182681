// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/inertia_operations.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::scene_examples {

using namespace torsor::literals;

/// A scene with some parameters. In the end it gets a body on the frame named last, unless it has one, and must be a
/// mechanism that can be solved for its motion.
class SceneExamples : public testing::Test {
 protected:
  void stands() {
    if (scene.content().bodies.empty()) {
      const FrameHandle last{static_cast<int>(scene.content().frames.size()) - 1};
      scene.body("load", last, Inertia::box(m, r, l, h).at({r, l, h}));
    }
    ASSERT_NO_THROW(validate(scene));
    const Equations equations(scene);
    EXPECT_FALSE(equations.inverse_dynamics().empty());
    EXPECT_FALSE(equations.forward().accelerations.empty());
    EXPECT_NO_THROW(emit_header(scene, parse_kernel_list("all")));
  }

  Scene scene{"example"};
  const Expression m = scene.parameter("m", "kg", 2), r = scene.parameter("r", "m", 0.1_r),
                   l = scene.parameter("l", "m", 0.5_r);
  const Expression h = scene.parameter("h", "m", 0.3_r), g = scene.parameter("g", "m/s^2", 9.81_r);
};

}  // namespace torsor::scene_examples
