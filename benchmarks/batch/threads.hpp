// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmarks/kernels/timing.hpp"

/// Nanoseconds for one of many states of the panda: forward dynamics of a batch that leaves the caches, in packs that
/// fill a register, on so many threads.
struct ThreadTimes {
  unsigned threads = 1;
  std::string scalar;      ///< double or float
  std::size_t lanes = 0;   ///< of a pack
  kernels::Timing timing;  ///< the ratio is to one thread, of the same scalar
};

/// On 1 and 2 threads and on as many as the processor runs at once. Throws where the bits of a result depend on that.
std::vector<ThreadTimes> thread_times(std::size_t states, int turns);
