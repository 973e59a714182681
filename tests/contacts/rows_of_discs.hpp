// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "torsor/runtime/contacts/contact_solver.hpp"

// Solid discs of diameter and weight 1, g = 1, in rows above each other on a floor, neighbours touching. A disc of a row lies
// between two of the row below.
namespace rows_of_discs {

using namespace torsor::runtime;

/// Of disc `a` with disc `b` below or beside it, or with the floor: -1. n points to a.
struct Touch {
  int a, b;
  double nx, nz;
};

inline std::vector<Touch> touches(const std::vector<int>& rows) {
  std::vector<Touch> all;
  int first = 0, below = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (int i = 0; i < rows[row]; ++i) {
      const int a = first + i;
      if (row == 0) all.push_back({a, -1, 0, 1});
      if (i + 1 < rows[row]) all.push_back({a, a + 1, -1, 0});
      if (row == 0) continue;
      all.push_back({a, below + i, 0.5, std::sqrt(0.75)});
      if (i + 1 < rows[row - 1]) all.push_back({a, below + i + 1, -0.5, std::sqrt(0.75)});
    }
    below = first;
    first += rows[row];
  }
  return all;
}

inline int discs(const std::vector<int>& rows) {
  int sum = 0;
  for (const int each : rows) sum += each;
  return sum;
}

/// Rows of the velocities (x, z, spin) of all discs: N, then along (n_z, -n_x).
inline Eigen::MatrixXd jacobian(const std::vector<Touch>& all, int discs) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(all.size()), 3 * discs);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const Touch& touch = all[c];
    const double nx = touch.nx, nz = touch.nz;
    const auto row = 2 * static_cast<Eigen::Index>(c);
    const auto add = [&](int disc, double sign) {
      J.block<1, 2>(row, 3 * disc) << sign * nx, sign * nz;
      J.block<1, 3>(row + 1, 3 * disc) << sign * nz, -sign * nx, -0.5;
    };
    add(touch.a, 1);
    if (touch.b >= 0) add(touch.b, -1);
  }
  return J;
}

/// Masses and moments of inertia, and weights.
inline Eigen::VectorXd masses(int discs) {
  Eigen::VectorXd m(3 * discs);
  for (int i = 0; i < discs; ++i) m.segment<3>(3 * i) << 1, 1, 0.125;
  return m;
}
inline Eigen::VectorXd weights(int discs) {
  Eigen::VectorXd F = Eigen::VectorXd::Zero(3 * discs);
  for (int i = 0; i < discs; ++i) F(3 * i + 1) = -1;
  return F;
}

/// Contacts in the order of their rows, or in one that the seed gives.
inline std::vector<Touch> in_order(std::vector<Touch> all, unsigned seed) {
  if (seed > 0) {
    std::mt19937 source(seed);
    std::shuffle(all.begin(), all.end(), source);
    // Which of two discs is named first is no more than an order.
    for (Touch& each : all) {
      if (each.b >= 0 && source() % 2 == 0) each = {each.b, each.a, -each.nx, -each.nz};
    }
  }
  return all;
}

inline ContactProblem problem_of(const std::vector<Touch>& all, int discs, double f) {
  const Eigen::MatrixXd J = jacobian(all, discs);
  const Eigen::VectorXd m = masses(discs);
  ContactProblem problem;
  problem.count = static_cast<int>(all.size());
  for (std::size_t c = 0; c < all.size(); ++c) problem.laws[c] = coulomb(1, f);
  problem.W = J * m.cwiseInverse().asDiagonal() * J.transpose();
  problem.q = J * weights(discs).cwiseQuotient(m);
  return problem;
}

/// Accelerations of all discs that reactions give.
inline Eigen::VectorXd accelerations(const std::vector<Touch>& all, int discs, const ContactVector& r) {
  const Eigen::VectorXd forces = weights(discs) + jacobian(all, discs).transpose() * r;
  return forces.cwiseQuotient(masses(discs));
}

}  // namespace rows_of_discs
