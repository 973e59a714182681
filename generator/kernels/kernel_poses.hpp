// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// What a picture of the mechanism needs: poses of all frames, places and axes of joints, points, bodies, gravity; all in
/// ground axes.
Kernel make_poses(const Equations& equations);

}  // namespace torsor
