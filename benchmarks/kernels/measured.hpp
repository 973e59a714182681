// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmarks/kernels/batch.hpp"
#include "benchmarks/kernels/way.hpp"

namespace kernels {

/// One generated header, compiled in one way.
struct Measured {
  std::string model;
  std::string header;  ///< path of the generated file
  std::size_t freedoms;
  /// Kernels in double and in float; the batch must outlive them.
  std::vector<Way> (*ways)(Quantity, const Batch&);
};

/// All headers of the build; `native` tells for which processor.
std::vector<Measured> generated_headers(bool native);

}  // namespace kernels
