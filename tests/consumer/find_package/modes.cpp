// SPDX-License-Identifier: GPL-3.0-or-later
// The program of someone who asks the installed runtime library for the modes of two masses between three springs.
#include <torsor/runtime/small_motions/modes.hpp>

#include <cmath>
#include <cstdio>

int main() {
  Eigen::MatrixXd stiffness(2, 2);
  stiffness << 2, -1, -1, 2;
  const auto modes =
      torsor::runtime::natural_modes(torsor::runtime::undamped(Eigen::MatrixXd::Identity(2, 2), stiffness));
  std::printf("angular frequencies: %.17g %.17g\n", modes.angular_frequency(0), modes.angular_frequency(1));
  return std::abs(modes.angular_frequency(0) - 1.0) + std::abs(modes.angular_frequency(1) - std::sqrt(3.0)) < 1e-14 ? 0
                                                                                                                    : 1;
}
