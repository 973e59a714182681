// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Bodies of a scene looked at together, by name.
using BodyNames = std::vector<std::string>;

/// Names of all bodies of the scene, in order of declaration.
BodyNames all_bodies(const Model& model);

/// By link: whether it is a reflected inertia. It has kinetic energy, but no momentum and nothing that holds it.
std::vector<bool> rotor_links(const Model& model);

/// Names of those that no weld makes part of the ground, in order of declaration. Throws SceneError where there are none.
BodyNames moving_bodies(const Model& model);

/// Indices of the bodies in the scene, in order of declaration. Throws SceneError naming an unknown body and the known
/// ones, a body named twice, or an empty list.
std::vector<int> body_indices(const Model& model, const BodyNames& names, const std::string& user);

/// Mass [kg], first moment m OG [kg m] and operator about O [kg m²] of the named bodies on each link that carries one,
/// in the link's axes from its origin O; links in increasing order.
std::vector<std::pair<int, MassProperties>> mass_by_link(const Model& model, const BodyNames& names,
                                                         const std::string& user);

}  // namespace torsor
