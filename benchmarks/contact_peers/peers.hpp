// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "benchmarks/contact_peers/problem.hpp"

namespace torsor::contact_peers {

/// Places of the quadruped's trunk each 0.1 s, to 10 s.
using Path = std::vector<std::array<double, 3>>;
/// The largest distance between two paths [m]; without end where one is shorter.
double distance(const Path& path, const Path& truth);

/// The problem of one instant: u = W r + q with three rows for each contact (N, two T), 0 <= u_N, N >= 0, |T| <= f N.
struct ContactSolve {
  std::vector<std::array<int, 2>> blocks;     ///< places of the blocks of W that are not zero
  std::vector<std::array<double, 9>> values;  ///< of these, row by row
  std::vector<double> q, friction;
  /// The largest defect of the laws over the largest impulse.
  double residual(const std::vector<double>& impulses) const;
};

// What each peer adds, where it is installed.
std::vector<Way> mujoco_billiard(), mujoco_quadruped(const Path&truth);
std::vector<Way> simbody_billiard();
std::vector<Way> siconos_bouncing(), siconos_chain(const std::array<double, 4>&truth);
std::vector<Way> siconos_spheres(const ContactSolve& problem);

}  // namespace torsor::contact_peers
