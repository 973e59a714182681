// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/independent_freedoms.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// What errors of data grow by at a state when the equations of a scene are solved there. Numbers ‖X‖₁ ‖X⁻¹‖₁ of
/// matrices in the metric of the diagonal of M: M_ij / √(M_ii M_jj), rows of A and columns of B over √M_ii and then of
/// the length 1, so that units do not matter. (Golub & Van Loan, Matrix Computations, 2.6.2.)

/// Of [M B; A 0], the constraints those that are kept: what accelerations and multipliers are solved with.
double motion_condition(const Equations& equations, Evaluator<Real>& exact);

/// Of the reduction to independent freedoms: three solves in succession, each with what the one before gave, so that
/// their conditions multiply. Dependent coordinates follow with [A_h; S_h], A_h the rows that are holonomic and S_h
/// picking the independent coordinates; velocities with [A; S], and what takes out the multipliers with [Bᵀ; S]; the
/// state matrix with Nᵀ M N, N the basis that [A; S] gives (with friction another one on the left).
double reduction_condition(const Equations& equations, const IndependentFreedoms& freedoms, Evaluator<Real>& exact);

}  // namespace torsor
