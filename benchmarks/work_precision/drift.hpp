// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "torsor/runtime/status.hpp"

namespace work_precision {

/// How far one integrator leaves the energy.
struct Drift {
  static constexpr std::size_t samples = 100;
  std::string name;
  std::array<double, samples> largest{};  ///< |E - E0| / |E0| up to each hundredth of the time
  double seconds = 0.0;
  torsor::runtime::Result<double> result{};
};

/// The energy of the double pendulum from (2, 2.5) over 10^4 s: a table of each integrator's time and largest relative
/// error, drift.csv with that error over time, and drift.svg. No files where `folder` is empty.
std::vector<Drift> measure_drift(const std::filesystem::path& folder);

/// Energy, momentum and constraints over 10^6 steps and over 10^4 s: the heavy top (energy and the momentum of its spin),
/// a rolling hoop (energy and its constraints on velocities) and Andrews' squeezing mechanism (energy and the gaps of its
/// loops), by methods that keep them and by methods that do not.
/// A table, and invariants.csv where there is a folder.
void measure_invariants(const std::filesystem::path& folder);

}  // namespace work_precision
