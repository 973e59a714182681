// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// Laws of contacts that no surface can have: a negative friction or bound, a static one below it, a restitution outside
/// [0, 1], a radius that is not positive, a lower stop above the upper one, at the values that parameters have. Throws
/// SceneError naming the contact.
void check_surfaces(const SceneContent& scene);

/// What a scene's contacts start from: none that penetrates at t = 0. Nothing is said where parameters have no values.
/// Throws SceneError.
void check_contacts(const Equations& equations);

/// Throws SceneError for a scene with contacts or dry friction, which motions of `user` ("a reference") do not have.
void refuse_contacts(const Scene& scene, const std::string& user);

}  // namespace torsor
