// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/measure.hpp"

#include <algorithm>
#include <cstddef>

#include "benchmarks/work_precision/processor_time.hpp"

namespace work_precision {
namespace {

double microseconds_of_run(Row& row) {
  const double start = processor_seconds();
  row.outcome = row.way->run(row.setting);
  return (processor_seconds() - start) * 1e6;
}

}  // namespace

std::vector<Row> measure(const Problem& problem, int turns, double seconds) {
  std::vector<Row> rows;
  std::vector<std::vector<double>> times;
  std::vector<int> wanted;
  for (const Way& way : problem.ways) {
    for (const double setting : way.settings) {
      Row row{problem.name, &way, setting};
      const double first = microseconds_of_run(row);  // not counted: it loads the code
      rows.push_back(row);
      wanted.push_back(std::clamp(static_cast<int>(seconds * 1e6 / first), 3, turns));
    }
  }
  times.resize(rows.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (turn < wanted[i]) times[i].push_back(microseconds_of_run(rows[i]));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    const std::size_t n = times[i].size();
    rows[i].median = times[i][n / 2];
    rows[i].lower = times[i][n / 4];
    rows[i].upper = times[i][3 * n / 4];
  }
  return rows;
}

}  // namespace work_precision
