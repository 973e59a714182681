// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/dynamics/derivatives/second_derivatives.hpp"
#include "torsor/generator/program/pivot_test.hpp"

namespace torsor {

/// Second derivatives of the accelerations and multipliers of the motion, functions of (q, v, u, t) where constraints
/// hold or not: ∂²a_i/∂x_j∂y_k is entry [k][i][j] of x_y, attitudes as in SecondForceDerivatives. The motion is linear
/// in u.
struct ForwardSecondDerivatives {
  struct Of {
    ValuePages position_position, position_velocity, velocity_velocity, position_input, velocity_input;
  };
  Of accelerations, multipliers;
  std::vector<PivotTest> pivots;
};

/// With r = M a + h − B λ − E u = 0 and g = A a + γ = 0 along the motion, a_x and λ_x its first derivatives:
///   M a_xy − B λ_xy = −(r_xy + M_x a_y + M_y a_x − B_x λ_y − B_y λ_x),   A a_xy = −(g_xy + A_x a_y + A_y a_x),
/// r_xy and g_xy at fixed accelerations and multipliers: second derivatives of the inverse dynamics and one solve for each
/// pair (after Singh, Russell & Wensing, On second-order derivatives of rigid-body dynamics: theory & implementation,
/// IEEE Trans. Robotics 40, 2024, here with constraints). No second derivative of M is formed.
ForwardSecondDerivatives forward_second_derivatives(const Equations& equations);

}  // namespace torsor
