// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"

namespace torsor {

/// A matrix for each variable: page k is the derivative of a matrix by variable k.
using ValuePages = std::vector<ValueMatrix>;

/// Second derivatives of generalised forces f(q, v, a), unknowns only, ∂²f_i/∂x_j∂y_k being entry [k][i][j] of x_y. Along
/// an attitude ∂/∂q_j is a turn about its moving axis j, and page k is the derivative along the turn k of the first
/// derivatives: turns of one attitude do not commute, all else is symmetric.
struct SecondForceDerivatives {
  ValuePages position_position, position_velocity, velocity_velocity;
  ValuePages acceleration_position;  ///< ∂M/∂q_k
};

/// Of the residual r = M a + h − B λ [− E u] at accelerations, multipliers and inputs as symbols: residual_derivatives
/// and M, differentiated definition by definition. Of ∂²/∂q_j∂q_k the joint nearer to the ground is taken last: what it
/// changes are motions of links, which hold for all joints beyond, not the wrenches that are carried back to each.
/// Where v = dq/dt, the part of inertia that is of second degree in v follows from M,
///   ∂²r_i/∂v_j∂v_k = ∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i
/// (twice Christoffel's symbols; Featherstone, Rigid Body Dynamics Algorithms, 2008, §2.14 for their part in h).
SecondForceDerivatives second_residual_derivatives(const Equations& equations, Inputs inputs);

/// n pages of rows × columns zeros.
ValuePages zero_pages(std::size_t pages, std::size_t rows, std::size_t columns);

}  // namespace torsor
