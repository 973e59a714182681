// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "torsor/generator/dynamics/motion/motion.hpp"

namespace torsor {

/// Generalised forces of inertia and gravity along every coordinate of the tree (unknowns, then released ones) by
/// virtual power: P_i − Q_i(gravity, given wrenches) = Σ_S (dynamic screw of S − wrench on S) · partial twist of S,
/// accumulated from the tips to the ground (mechanics: second derivation of Lagrange's equations; recursion of
/// Luh, Walker & Paul, On-line computational scheme for mechanical manipulators, 1980).
/// `wrenches`: applied wrenches by link, as BodyTree::applied takes them. By itself a tree without lines of mass costs
/// least.
std::vector<Value> inertia_forces(const BodyTree& tree, AccelerationInput input, const std::map<int, Wrench>& wrenches);

/// Dynamic screw of a link at its origin minus gravity: {m (Γ − g) + U h, δ_O}. The moment J Ω̇ + Ω ∧ J Ω is written
/// with U = [Ω̇] + [Ω][Ω], whose entries the resultant needs anyhow:
/// N_x = J_xx Ω̇_x + (J_zz − J_yy) Ω_y Ω_z − J_xy U_zx + J_xz U_yx + J_yz (Ω_y² − Ω_z²), and so on cyclically. With
/// S = ∫ r r dm the first two terms are S_yy U_zy − S_zz U_yz: one term, where S vanishes along the axis Link::without_line.
Wrench screw_less_gravity(Program& program, Acceleration& motion, const Link& link);

/// The same about the reference motion: P_i − Q_i at its accelerations q̈, which are given back too, by unknown. Each
/// unknown is the displacement of one joint (has_simple_joints).
struct ReferenceForces {
  std::vector<Value> accelerations, forces;
};
ReferenceForces reference_forces(const BodyTree& tree, const std::map<int, Wrench>& wrenches);

/// What each joint carries: the sum, over the link and all that it carries, of dynamic screws minus gravity minus
/// applied wrenches, at the link's origin, in its axes as `axes` says. With regrouped inertia only what
/// works on the joints is that of the mechanism.
std::vector<Wrench> joint_wrenches(const BodyTree& tree, std::vector<Acceleration>& motion, const std::vector<Axes>& axes,
                                   const std::map<int, Wrench>& wrenches);

/// Whether some joint's displacement depends on several coordinates: of absolute angles it is a difference. Most of what
/// neighbouring joints give to a generalised force then cancels identically, and is left out: moments of long links
/// would take all digits of those of short ones with them.
bool moves_by_several(const BodyTree& tree);

/// Mass matrix M (row by row, symmetric) of the unknowns by composite bodies (Walker & Orin, 1982).
std::vector<std::vector<Value>> mass_matrix(const BodyTree& tree);

}  // namespace torsor
