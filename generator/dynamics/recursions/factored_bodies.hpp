// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"
#include "torsor/generator/dynamics/recursions/joint_coordinates.hpp"

namespace torsor {

/// The method of a solution by `factored_forward`, in words.
inline constexpr const char* name_of_squares = "articulated bodies as sums of squares";

/// Accelerations by articulated bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, §7.3) whose inertias are
/// sums of squares: a body answers a motion X = {Ω, V} of its origin by Σ_r d_r c_r c_rᵀ X, with weights d_r > 0. A link
/// adds those of its matter (velocities of centres of mass, principal rotations) to those that it carries, and nothing is
/// ever subtracted from an inertia. With s the joint's motion, X_j the six unit motions,
///   D = Σ d_r (c_r s)²,   g_j = Σ d_r (c_r s)(c_r X_j)/D,   u = (Q + Σ (c_r s) f_r)/D,
///   c_rj = c_r X_j − g_j c_r s,   f_r ← f_r − d_r (c_r s) u;   s̈ = u − Σ g_j A_j.
/// D is the inertia that is left when all joints beyond are free: a light link that carries a heavy body keeps its digits
/// there, where L D Lᵀ of M and I − I s sᵀ I/D find them as the difference of two large numbers. The squares are then
/// gathered into as many as there are components by the weighted modified Gram-Schmidt process, as in filters by
/// U D Uᵀ (Bierman, Factorization Methods for Discrete Sequential Estimation, 1977; that recursion is a Kalman filter:
/// Rodriguez, Jain & Kreutz-Delgado, A spatial operator algebra for manipulator modeling and control, 1991).
///
/// Instead of X_j, which may move what a link carries far, its joint moves along by ρ_j s so that the next joint stays
/// where it is along that joint's motion: one component vanishes exactly, and what is left is small as the angle is.
///
/// `efforts`: for every unknown the generalised force of everything but inertia, gravity and the wrenches. No constraints.
ForwardSolution factored_forward(const BodyTree& tree, const JointCoordinates& joints, const std::vector<Value>& efforts,
                                 const std::map<int, Wrench>& wrenches);

}  // namespace torsor
