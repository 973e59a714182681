// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <vector>

/// How far inside all bounds z can be: the largest least of concave functions, by the method of ellipsoids. It needs
/// slopes alone and bounds what is left. Source: Grötschel, Lovász & Schrijver, Geometric Algorithms and Combinatorial
/// Optimization, chapter 3.
namespace deepest_inside {

/// given + slope · z - |T + C z|
struct Bound {
  double given;
  Eigen::VectorXd slope;
  Eigen::Vector2d T;
  Eigen::Matrix<double, 2, Eigen::Dynamic> C;
};

struct Deepest {
  double least;
  Eigen::VectorXd z;
};

/// In the ball |z| <= reach; the search ends where all bounds are left by `enough`, and where that has no hope.
inline Deepest deepest(const std::vector<Bound>& bounds, Eigen::Index n, double reach, double enough) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(n), up;
  Eigen::MatrixXd P = reach * reach * Eigen::MatrixXd::Identity(n, n);
  Deepest best{-INFINITY, z};
  const auto size = static_cast<double>(n);
  for (int step = 0; step < 5000; ++step) {
    double least = INFINITY;
    for (const Bound& bound : bounds) {
      const Eigen::Vector2d T = bound.T + bound.C * z;
      const double length = T.norm(), value = bound.given + bound.slope.dot(z) - length;
      if (value >= least) continue;
      least = value;
      up = bound.slope;
      if (length > 0) up -= bound.C.transpose() * T / length;
    }
    if (least > best.least) best = {least, z};
    const double beyond = std::sqrt(up.dot(P * up));  // nowhere in the ellipsoid is the least larger by more
    if (best.least >= enough || least + beyond < -1e-6 || !(least + beyond > best.least + 1e-9)) break;
    const Eigen::VectorXd d = P * up / beyond;
    z += d / (size + 1);
    P = n == 1 ? Eigen::MatrixXd(P / 4) : size * size / (size * size - 1) * (P - 2 / (size + 1) * d * d.transpose());
  }
  return best;
}

}  // namespace deepest_inside
