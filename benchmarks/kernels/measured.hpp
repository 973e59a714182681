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
  std::string without;  ///< the pass that was left out, or nothing
  std::string header;   ///< path of the generated file
  /// Kernels in double and, with all passes, in float; the batch must outlive them.
  std::vector<Way> (*ways)(Quantity, const Batch&);
};

/// All headers of the build: for this processor with all passes first, then by the other compiler, then for any
/// processor, then with passes left out.
std::vector<Measured> generated_headers();

}  // namespace kernels
