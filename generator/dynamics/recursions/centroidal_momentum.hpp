// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// Momentum of all bodies that move, about their common centre of mass C, in the axes of the ground: {p, σ_C} = A v + b,
/// A the centroidal momentum matrix (Orin, Goswami & Lee, Centroidal dynamics of a humanoid robot, 2013), b of what laws
/// of time drive. Joint k gives what it carries, of mass m, first moment h and inertia J about the joint's origin O,
/// {s ∧ h, J s} about O for a turn about s and {m s, h ∧ s} for a slide.
struct CentroidalMomentum {
  Vector center;                       ///< C [m]
  MomentumScrew momentum;              ///< {p, σ_C} [kg m/s], [kg m²/s]
  std::vector<MomentumScrew> columns;  ///< of A, for every coordinate (unknowns, then released ones)
};

/// Throws nothing where some body that moves has a mass; there is no centre of mass otherwise.
CentroidalMomentum centroidal_momentum(const Model& model);

/// Whether some body that moves has a mass.
bool moves_mass(const Model& model);

}  // namespace torsor
