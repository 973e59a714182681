// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace kernels {

/// One revolute joint of a chain and the link that it moves; SI units.
struct Joint {
  std::array<double, 9> rotation;  ///< from the joint's axes to its parent's, row by row
  std::array<double, 3> origin;    ///< of the joint, in its parent's axes
  int axis;                        ///< 0, 1, 2: it turns about x, y or z
  double mass;
  std::array<double, 3> mass_centre;  ///< of the link, in the joint's axes
  std::array<double, 6> inertia;      ///< about the centre of mass: xx, xy, xz, yy, yz, zz
};

/// A serial chain, from the ground outwards.
struct Chain {
  std::string name;
  std::array<double, 3> gravity;
  std::vector<Joint> joints;
};

/// Chains of a file like tests/reference/models.json. Throws std::runtime_error naming the file.
std::vector<Chain> read_chains(const std::string& path);

}  // namespace kernels
