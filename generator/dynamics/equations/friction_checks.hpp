// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// The multiplier λ of a constraint is the normal force N of a contact that slides only where λ enters the equations as a
/// force λ n, n a unit vector across the slip, at the point that slips: 2 z in place of z halves N and the friction.
/// Looked at in the initial configuration and in one away from it, for each law of friction that acts at a point. A part
/// of n along what cannot move is not seen in a formula. Lengths that have no value are invented, and need not fit the
/// start: it is looked at where `start_is_known`. Throws SceneError otherwise.
void check_friction_normals(const Equations& equations, bool start_is_known);

}  // namespace torsor
