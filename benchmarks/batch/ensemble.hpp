// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/kernels/timing.hpp"

/// Nanoseconds for one member of an ensemble, on one thread: for one Runge-Kutta step of pandas that fall, or for a
/// whole second by Taylor's method, to 1e-12, of double pendulums that turn over.
struct EnsembleTimes {
  std::string quantity;    ///< "step" or "Taylor"
  std::string name;        ///< alone, or in packs of so many
  std::string scalar;      ///< double or float
  kernels::Timing timing;  ///< the ratio is to members alone in double
  double difference = 0;   ///< of the last states from those of members alone in double, relative to the greatest
};

std::vector<EnsembleTimes> ensemble_times(int turns);
