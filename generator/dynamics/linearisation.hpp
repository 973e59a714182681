// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/dynamics/equations.hpp"

namespace torsor {

/// M ε̈ + C ε̇ + K ε = F + E u about a state (q, q̇, q̈ = 0 unless accelerations are kept), ε = deviation from it:
/// C = ∂h/∂q̇, K = ∂(M q̈ + h − Aᵀλ)/∂q, F = −(h at the state), E = ∂Q/∂u.
struct Linearisation {
  ValueMatrix M, C, K, E;
  std::vector<Value> F;
};
Linearisation linearisation(const Equations& equations);

}  // namespace torsor
