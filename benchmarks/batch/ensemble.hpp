// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/kernels/timing.hpp"

/// Nanoseconds for one Runge-Kutta step of one member of an ensemble of pandas that fall, on one thread.
struct EnsembleTimes {
  std::string name;        ///< alone, or in packs of so many
  std::string scalar;      ///< double or float
  kernels::Timing timing;  ///< the ratio is to members alone in double
  double difference = 0;   ///< of the last states from those of members alone in double, relative to the greatest
};

std::vector<EnsembleTimes> ensemble_times(int turns);
