// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace kernels {

/// Random states of one mechanism, the same for every competitor; each list holds `freedoms` numbers per state.
struct Batch {
  std::size_t freedoms = 0;
  std::size_t states = 0;
  std::vector<double> q;    ///< angles within a turn [rad]
  std::vector<double> v;    ///< rates [rad/s]
  std::vector<double> a;    ///< accelerations, for inverse dynamics [rad/s^2]
  std::vector<double> tau;  ///< torques of the joints, for forward dynamics [N m]

  /// The numbers of one state in a list.
  const double* of(const std::vector<double>& list, std::size_t state) const { return list.data() + state * freedoms; }
};

Batch random_batch(std::size_t freedoms, std::size_t states);

}  // namespace kernels
