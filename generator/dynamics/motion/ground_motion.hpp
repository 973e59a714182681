// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Poses and twists of all links in the axes of the ground, from the ground outwards: with R_k the axes of link k, O_k
/// its origin, n_k the axis of its joint and d_k = O_p O_k from its parent p,
///   R_k = R_p R(s_k),   O_k = O_p + d_k,   Ω_k = Ω_p + ṡ_k n_k,   V(O_k) = V(O_p) + Ω_p ∧ d_k,
/// and ṡ_k n_k added to V(O_k) instead where the joint slides (Pommier, Dynamique des systèmes de solides, §3.2). Vectors
/// between points of one chain are sums of its d_k and never differences of places: they have the digits of the chain
/// wherever its first link is. Ω ∧ d is formed in the link's axes, where a spin about an axis through the point shows
/// that it does not move it.
class GroundMotion {
 public:
  explicit GroundMotion(const Model& model);

  const Matrix& rotation(int link) const { return at(link).rotation; }  ///< from the link's axes to the ground's
  const Vector& origin(int link) const { return at(link).origin; }      ///< [m]
  const Vector& angular(int link) const { return at(link).angular; }    ///< [rad/s]
  const Vector& linear(int link) const { return at(link).linear; }      ///< of the link's origin [m/s]

  const Vector& axis(int link) const { return at(link).axis; }                ///< of the link's joint
  const Vector& from_parent(int link) const { return at(link).from_parent; }  ///< from the parent's origin [m]

  /// Velocity of the link's own point at `place` from its origin, in the link's axes; the velocity in the ground's.
  Vector velocity(int link, const Vector& place) const;
  /// ∂V/∂v_i of the point at `arm` from the link's origin, for every coordinate; all in the axes of the ground.
  std::vector<Vector> partial_velocities(int link, const Vector& arm) const;
  /// ∂Ω/∂v_i of the link, for every coordinate.
  std::vector<Vector> partial_angular_velocities(int link) const;

 private:
  struct Place {
    Matrix rotation;
    Vector origin, angular, linear;
    Vector axis;         ///< of the joint
    Vector from_parent;  ///< from the parent's origin
    Vector turning;      ///< the angular velocity in the link's own axes
  };
  const Place& at(int link) const { return places_[static_cast<std::size_t>(link)]; }
  Matrix turned(const Link& link) const;
  Vector carried(const Place& place, const Vector& point) const;

  const Model* model_;
  std::vector<Place> places_;  ///< by link
};

}  // namespace torsor
