// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"

namespace torsor {

/// What works on a formula of coordinates (constraints, actions, stops, dry frictions, reflected inertias), and what makes
/// joints of one coordinate move together, has no place in space: virtual displacements across a joint, which would tell what
/// it adds to the joint's reaction, are none of the formula's. Its generalised forces are efforts τ_j in joints,
/// Q_i = Σ τ_j ∂s_j/∂q_i. They add nothing to the force R that a joint k transmits across its axis where they act
/// * in joint k alone: as a motor does, along the axis or about it;
/// * only in joints of what k carries, or only in others: forces between bodies on one side of k.
/// Elsewhere, as of a rope from a pulley to a weight, R would miss what bears on the joint, and friction in proportion to R
/// with it. So it would where a formula tells a force at a point, not an effort: by its unit, a length along a joint that
/// turns, or as it measures a place or a velocity across joint k.
class PlacelessLoads {
 public:
  /// What the checks look at.
  struct Formula {
    std::string name;                           ///< "constraint 'rope'"
    std::vector<RealRows> forces;               ///< by state: Q, or the coordinates along which it may be
    std::optional<Unit> unit;                   ///< of the displacement with which it works
    std::vector<std::pair<int, int>> measured;  ///< links between which it measures places or velocities
  };

  PlacelessLoads(const Equations& equations, const std::vector<ContactRows>& contacts);

  /// Throws SceneError where the friction is in proportion to what a joint transmits and one of those may load it.
  void refuse(const ContactRows& friction) const;

 private:
  struct Sides {
    std::vector<std::size_t> own, carried, others;  ///< links
    std::vector<bool> inside;                       ///< by link: own or carried
  };
  Sides sides(int joint) const;
  /// Why it may load the joint; null: it does not.
  const char* reason(const Sides& sides, const Formula& formula) const;
  const char* reason(const Sides& sides, std::size_t state, const Formula& formula) const;
  void refuse_shared_coordinates(const ContactRows& friction) const;
  RealRows rows_of(const std::vector<std::size_t>& links, std::size_t state) const;
  bool has_unit_of(const std::vector<std::size_t>& links, std::size_t state, const Formula& formula) const;

  const Model& model_;
  std::vector<Formula> formulas_;
  std::vector<RealRows> joints_;  ///< ∂s/∂q by state and link; empty rows of links that no joint carries
  std::vector<Unit> units_;       ///< of s, by link
};

}  // namespace torsor
