// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace work_precision {

/// The energy of the double pendulum from (2, 2.5) over 10^4 s: a table of each integrator's time and largest relative
/// error, drift.csv with that error over time, and drift.svg. No files where `folder` is empty.
void measure_drift(const std::filesystem::path& folder);

}  // namespace work_precision
