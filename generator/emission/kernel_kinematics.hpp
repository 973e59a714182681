// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/emission/kernel.hpp"

namespace torsor {

/// Poses and twists of bodies, positions, velocities and Jacobians of named points, all in ground axes.
Kernel make_kinematics(const Equations& equations);

}  // namespace torsor
