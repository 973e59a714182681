// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/kernels/timing.hpp"
#include "benchmarks/kernels/way.hpp"

namespace kernels {

/// What was measured of one way for one mechanism.
struct Row {
  std::string model;
  std::size_t joints = 0;
  Quantity quantity = Quantity::inverse_dynamics;
  Way way;
  Timing timing{};
  double difference = 0;            ///< from the first way
  std::string operations{};         ///< of a generated kernel, as its header counts them
  std::uintmax_t header_bytes = 0;  ///< of the generated header; 0 for a peer
};

/// Total of a kernel's operations in the head comment of a generated header; empty where it is not there.
std::string operations_in(const std::filesystem::path& header, Quantity quantity);

void print_heading();
void print(const Row& row);

/// kernels.csv with all there is; for each quantity nanoseconds_<quantity>.csv, one column a way, and its picture.
void write_files(const std::vector<Row>& rows, const std::filesystem::path& folder);

}  // namespace kernels
