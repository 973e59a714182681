// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/kernels/batch.hpp"
#include "benchmarks/kernels/chain.hpp"
#include "benchmarks/kernels/way.hpp"

namespace kernels {

// Each peer does what the quantity needs and nothing more: the cheapest of its public functions are called for one
// state, from copying the state to having the result. The batch must outlive the way.

/// `path` names the chain's MJCF file. Where it has them, its general functions are a second way.
std::vector<Way> mujoco_ways(const std::string& path, const Chain& chain, Quantity quantity, const Batch& batch);
Way kdl_way(const Chain& chain, Quantity quantity, const Batch& batch);
Way simbody_way(const Chain& chain, Quantity quantity, const Batch& batch);

/// Ways of the peers this program was built with. MJCF files lie in `folder`/mjcf.
std::vector<Way> peer_ways(const std::string& folder, const Chain& chain, Quantity quantity, const Batch& batch);

/// Peers that were not found when the program was built.
std::vector<std::string> missing_peers();

}  // namespace kernels
