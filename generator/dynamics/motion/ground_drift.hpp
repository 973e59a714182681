// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/ground_motion.hpp"

namespace torsor {

/// What the links accelerate by while no velocity of an unknown changes, in the axes of the ground: J̇ v, of laws of time
/// their own acceleration too. With Ω and d of GroundMotion, along a chain
///   Ω̇_k = Ω̇_p + ṡ Ω_p ∧ n + s̈ n,   Γ(O_k) = Γ(O_p) + Ω̇_p ∧ d + Ω_p ∧ (Ω_p ∧ d),
/// and 2 ṡ Ω_p ∧ n + s̈ n added to Γ instead where the joint slides. s̈ is what is left of it without v̇.
class GroundDrift {
 public:
  GroundDrift(const Model& model, const GroundMotion& motion);

  const Vector& angular(int link) const { return at(link).angular; }  ///< Ω̇ [rad/s²]
  /// Γ of the link's own point at `arm` from its origin, both in the axes of the ground [m/s²].
  Vector linear(int link, const Vector& arm) const;

 private:
  struct Place {
    Vector angular, linear;
  };
  const Place& at(int link) const { return places_[static_cast<std::size_t>(link)]; }

  const Model* model_;
  const GroundMotion* motion_;
  std::vector<Place> places_;  ///< by link
};

}  // namespace torsor
