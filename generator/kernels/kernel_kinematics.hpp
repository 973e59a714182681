// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Poses and twists of bodies, positions, velocities and Jacobians of named points, all in ground axes.
Kernel make_kinematics(const Equations& equations);

bool has_quaternions(const Model& model);
/// dq/dt from v for a scene with unit quaternions; in the header of every such scene.
Kernel make_coordinate_rates(const Equations& equations);

}  // namespace torsor
