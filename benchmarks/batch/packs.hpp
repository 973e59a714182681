// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/kernels/batch.hpp"
#include "benchmarks/kernels/way.hpp"

/// The kernels of the panda in packs that fill this processor's registers, in double and in float; on one thread. The
/// batch must outlive them.
std::vector<kernels::Way> packed_ways(kernels::Quantity quantity, const kernels::Batch& batch);
