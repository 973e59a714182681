// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Part of `validate`: formulas depend on no more than what is differentiated where they stand. Placements, axes,
/// radii and pitches are formulas of parameters; displacements of joints, places of points, elongations, holonomic
/// conditions and directions of constraints are formulas of coordinates, time and parameters; laws of time and
/// conditions on velocities depend on no accelerations, inputs or multipliers. Throws SceneError that names the object,
/// its formula and the symbol.
void check_dependences(const Scene& scene);

}  // namespace torsor
