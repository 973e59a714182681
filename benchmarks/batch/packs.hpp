// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/kernels/batch.hpp"
#include "benchmarks/kernels/way.hpp"

/// The kernels of the panda in packs, in double and in float, on one thread; one such function for each kind of
/// registers that this processor has and each compiler, named packed_ways_<kind>_<compiler>. The batch must outlive the
/// ways.
using PackedWays = std::vector<kernels::Way>(kernels::Quantity quantity, const kernels::Batch& batch);

// Written by the build: PACKED(<kind>_<compiler>) for each, narrow registers first.
#define PACKED(kind) PackedWays packed_ways_##kind;
#include "packs.inc"
#undef PACKED
