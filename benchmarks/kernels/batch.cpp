// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/batch.hpp"

#include <random>

namespace kernels {

Batch random_batch(std::size_t freedoms, std::size_t states) {
  Batch batch{freedoms, states, {}, {}, {}, {}};
  std::mt19937_64 random(1);
  const auto fill = [&](std::vector<double>& list, double limit) {
    std::uniform_real_distribution<double> number(-limit, limit);
    list.resize(freedoms * states);
    for (double& each : list) each = number(random);
  };
  fill(batch.q, 3.14);
  fill(batch.v, 1);
  fill(batch.a, 2);
  fill(batch.tau, 5);
  return batch;
}

}  // namespace kernels
