// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Gaps, rows of normals and tangents, velocities along them and drifts, of every contact of the scene.
Kernel make_contacts(const Equations& equations);
/// Coefficients of friction and restitution and bounds of dry friction, of every contact.
Kernel make_contact_coefficients(const Equations& equations);
std::string no_contacts(const Equations& equations);

}  // namespace torsor
