// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/equations/independent_freedoms.hpp"
#include "torsor/generator/program/pivot_test.hpp"

namespace torsor {

/// The linearised equations of a constrained scene in independent freedoms:
///   M ẇ + C w + K e = F + E δu,   ė = e_rates_e e + e_rates_w w,
/// e the deviations along the independent coordinates (k of them), w of the independent velocities (p).
///
/// With δπ deviations along all n freedoms (of a coordinate itself; of an attitude the turn in its moving axes, so that
/// δω = δπ̇ + ω ∧ δπ), the rows kept of A v = b and their derivatives give, by elimination of the dependent freedoms,
///   δπ = Z e,  δv = N w + V e,  δv̇ = N ẇ + P w + Q e + s,
/// from  A_h δπ = 0,  A δv + ∂(A v − b) δπ = 0,  A δv̇ + ∂γ/∂v δv + ∂(A a + γ) δπ = −(A a + γ).
/// Nᵀ applied to M δv̇ + C δv + K δπ − Aᵀ δλ = F + E δu takes out δλ (with friction, where the columns of λ are not
/// those of A, the basis that annihilates them instead). Everything is algebraic: no derivative of N with respect to
/// time is needed. Dependent coordinates and velocities follow the independent ones to first order, as they must: held
/// fixed, they give another K (Meijaard et al., Proc. R. Soc. A 463, 2007, on the bicycle).
struct ReducedLinearisation {
  IndependentFreedoms freedoms;
  Linearisation full;  ///< in all freedoms, at fixed multipliers
  ValueMatrix M, C, K, E;
  std::vector<Value> F;
  ValueMatrix e_rates_e, e_rates_w;
  std::vector<PivotTest> pivots;  ///< of the elimination: (pivot², what it is compared with)
  bool symmetric = true;                        ///< M: not with friction
};
ReducedLinearisation reduced_linearisation(const Equations& equations);

/// Row i of Ω X, Ω δπ = ω ∧ δπ for the freedoms of an attitude and zero for coordinates: ė = δv − Ω δπ.
std::vector<Value> turned_row(const Model& model, std::size_t i, const ValueMatrix& x);

}  // namespace torsor
