// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace kernels {

enum class Quantity { inverse_dynamics, mass_matrix, forward_dynamics };
constexpr std::array<Quantity, 3> quantities = {Quantity::inverse_dynamics, Quantity::mass_matrix,
                                                Quantity::forward_dynamics};

inline const char* name_of(Quantity quantity) {
  constexpr std::array<const char*, 3> names = {"inverse_dynamics", "mass_matrix", "forward_dynamics"};
  return names[static_cast<std::size_t>(quantity)];
}

/// One way to compute a quantity of a mechanism at the states of a batch.
struct Way {
  std::string competitor;  ///< torsor, or a peer
  std::string build;       ///< options it was compiled with
  std::string scalar;      ///< double or float
  std::string functions;   ///< what is called for one state
  /// Computes states first to last - 1 of the batch, one after the other.
  std::function<void(std::size_t first, std::size_t last)> run;
  /// What the last state gave: n forces or accelerations, or n x n entries. Throws where it failed.
  std::function<std::vector<double>()> result;
  std::string without = {};  ///< of torsor: the pass that its generator left out, or nothing

  std::string label() const {
    return competitor + (without.empty() ? "" : " without " + without) + " " + build + " " + scalar;
  }
};

}  // namespace kernels
