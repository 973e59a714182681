// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "benchmarks/kernels/way.hpp"

namespace kernels {

/// The greatest difference from the first way's results, as a part of the state's greatest number, over some states.
/// Throws std::runtime_error where a way in double differs by more than 1e-9: then nothing is worth timing.
std::vector<double> differences(const std::vector<Way>& ways, Quantity quantity, std::size_t states);

}  // namespace kernels
