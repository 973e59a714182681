// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel as a compiler of C makes it.
#include "robot.h"

void in_c(const double* state, const double* accelerations, double* forces);

void in_c(const double* state, const double* accelerations, double* forces) {
  static const robot_precomputed precomputed;  // of a robot without parameters that are set at run time
  const double none[1] = {0};
  robot_inverse_dynamics(&precomputed, (const robot_state*)state, accelerations, none, forces);
}
