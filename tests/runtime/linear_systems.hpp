// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>

#include "torsor/runtime/small_motions/linear_system.hpp"

// Small linear systems with closed forms, and random ones from a seed that every platform draws alike.
namespace linear_systems {

using torsor::runtime::LinearSystem;

/// Equal masses in a row between walls, equal springs between neighbours; ω_k² = 4 k/m sin²(k π / 2(n+1)).
[[nodiscard]] LinearSystem chain(int n, double mass, double stiffness);

/// The undamped absorber of the literature: m1 = 1, k1 = 100, m2 = 0.1, k2 = 10.
[[nodiscard]] LinearSystem absorber();

/// A unit mass on two springs a and b along axes that turn at a constant speed: centrifugal and Coriolis terms.
[[nodiscard]] LinearSystem rotating_mass(double a, double b, double turn);

[[nodiscard]] Eigen::MatrixXd random_matrix(int n, int seed);

/// M and K symmetric positive definite.
[[nodiscard]] LinearSystem random_system(int n, int seed);

/// By LU decomposition.
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);
[[nodiscard]] double determinant(const Eigen::MatrixXd& matrix);

}  // namespace linear_systems
