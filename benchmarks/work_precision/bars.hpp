// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/work_precision/drift.hpp"
#include "benchmarks/work_precision/measure.hpp"

namespace work_precision {

/// What is promised of the integrators, each with what was measured and whether it holds: ratios of times to reach an
/// error, smallest errors, no wrong end of dp_hard at any tolerance, the energy over 10^4 s. Promises about problems
/// that were not measured are left out; one whose peer is not there, or that no one reached, is missed. Whether all
/// hold.
bool print_bars(const std::vector<Row>& rows, const std::vector<Drift>& drifts);

}  // namespace work_precision
