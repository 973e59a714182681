// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "benchmarks/work_precision/measure.hpp"

namespace work_precision {

void print(const Problem& problem, const std::vector<Row>& rows);

/// For each problem: time of the cheapest setting of each way whose error is at most 1e-9 and 1e-12, as a multiple of
/// the quickest of all, and the smallest error a way reached.
void print_reach(const std::vector<Row>& rows);

/// work_precision.csv with all there is; for each problem work_precision_<problem>.csv, two columns a way, and its
/// picture: time over error.
void write_files(const Problem& problem, const std::vector<Row>& rows, const std::filesystem::path& folder);
void write_all(const std::vector<Row>& rows, const std::filesystem::path& folder);

}  // namespace work_precision
