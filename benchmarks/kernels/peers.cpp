// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/peers.hpp"

namespace kernels {

std::vector<Way> peer_ways([[maybe_unused]] const std::string& folder, [[maybe_unused]] const Chain& chain,
                           [[maybe_unused]] Quantity quantity, [[maybe_unused]] const Batch& batch) {
  std::vector<Way> ways;
#ifdef BENCHMARK_MUJOCO
  ways = mujoco_ways(folder + "/mjcf/" + chain.name + ".xml", chain, quantity, batch);
#endif
#ifdef BENCHMARK_KDL
  ways.push_back(kdl_way(chain, quantity, batch));
#endif
#ifdef BENCHMARK_SIMBODY
  ways.push_back(simbody_way(chain, quantity, batch));
#endif
  return ways;
}

std::vector<std::string> missing_peers() {
  std::vector<std::string> missing;
#ifndef BENCHMARK_MUJOCO
  missing.emplace_back("MuJoCo");
#endif
#ifndef BENCHMARK_KDL
  missing.emplace_back("KDL");
#endif
#ifndef BENCHMARK_SIMBODY
  missing.emplace_back("Simbody");
#endif
  return missing;
}

}  // namespace kernels
