// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <vector>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// Small deviations from a steady motion whose cyclic coordinates are kept at their rates by motors: their rows and
/// columns are left out.
[[nodiscard]] LinearSystem reduced_at_constant_rate(const LinearSystem& system,
                                                    const std::vector<Eigen::Index>& cyclic);

/// Small deviations from a steady motion at the same momenta of its cyclic coordinates (Routh; Pommier, §7.4): with the
/// parts n (others) and c (cyclic), momenta p = M_cn x_n' + M_cc x_c' + C_cn x_n = 0 give x_c', and then
///   M = M_nn − M_nc M_cc⁻¹ M_cn,  C = C_nn − M_nc M_cc⁻¹ C_cn − C_nc M_cc⁻¹ M_cn,  K = K_nn − C_nc M_cc⁻¹ C_cn.
/// Without this the cyclic coordinates, which nothing brings back, give zero roots and no criterion concludes. K is the
/// Hessian of the reduced potential, for Lejeune-Dirichlet; stability is that of the other coordinates and of the
/// rates. Throws std::invalid_argument when the momenta are not conserved: forces along a cyclic coordinate that depend
/// on its value or rate (C_cc, K_cc, K_cn, K_nc not zero), or a constant one, which nothing balances (F_c).
[[nodiscard]] LinearSystem reduced_at_constant_momentum(const LinearSystem& system,
                                                        const std::vector<Eigen::Index>& cyclic);

}  // namespace torsor::runtime
