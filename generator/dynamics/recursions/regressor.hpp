// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

/// The standard inertial parameters of a link, in this order: mass [kg], first moment [kg m], entries of the inertia
/// operator about the link's origin [kg m²] (a product of inertia with its sign: J_xy = −∫ x y dm), in the link's axes.
inline constexpr std::array<const char*, 10> inertial_parameter_names{"m",    "h_x",  "h_y",  "h_z",  "J_xx",
                                                                      "J_xy", "J_xz", "J_yy", "J_yz", "J_zz"};

/// The links that carry bodies and those of reflected inertias, by index; those that only lie between two joints have nothing
/// to identify.
std::vector<std::size_t> links_with_inertia(const Model& model);

/// π: ten values of each of these links, from the bodies and rotors as the scene gives them.
std::vector<Value> inertial_parameters(const Model& model);

/// Regressor Y(q, v, a) of the forces of inertia and gravity: Y π = M a + h without actions other than gravity, rows
/// the unknown coordinates, columns as in inertial_parameters. By virtual power: with {V_i, Ω_i} the twist of link S
/// per unit rate of q_i at the link's origin, Γ its acceleration less gravity, U = [Ω̇] + [Ω][Ω], e_j unit vectors,
///   Y_i,m = Γ · V_i,   Y_i,h_j = (U e_j) · V_i + (e_j ∧ Γ) · Ω_i,   Y_i,J_jk = (J Ω̇ + Ω ∧ J Ω)(unit J_jk) · Ω_i
/// (Atkeson, An & Hollerbach, Estimation of inertial parameters of manipulator loads and links, 1986, with partial
/// twists carried to the links instead of ten wrenches carried to each joint). Entries that vanish identically are
/// zero.
ValueMatrix regressor(const Model& model);

}  // namespace torsor
