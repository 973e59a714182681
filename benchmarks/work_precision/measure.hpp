// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/work_precision/problem.hpp"

namespace work_precision {

/// One integrator with one setting on one problem.
struct Row {
  std::string problem;
  const Way* way = nullptr;
  double setting = 0.0;
  Outcome outcome{};
  double median = 0.0, lower = 0.0, upper = 0.0;  ///< µs of the processor for one run, and its quartiles
};

/// Times all settings of all ways in turns, one run after the other: what else the machine does meets all alike. A run
/// that takes longer is repeated less often: up to so many seconds for each row, at least three times, and at most
/// `turns`. Rows stand in the order of the ways; a problem must outlive them.
std::vector<Row> measure(const Problem& problem, int turns, double seconds);

}  // namespace work_precision
