// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What rounding may change of the results of kernels.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "tests/headers/stress/kernels.hpp"
#include "tests/verification/right_to_rounding.hpp"

namespace worst_states {

/// How many solves with the matrix of the motion, [M -B; A 0], follow one another in a kernel: each passes on what the one
/// before has lost. The linearisation of constrained motion reduces to independent freedoms by three.
inline int solves(const std::string& kernel, bool constrained) {
  if (kernel == "forward_dynamics" || kernel == "multipliers" || kernel == "jets") return 1;
  if (kernel == "linearisation") return constrained ? 3 : 1;
  if (kernel == "forward_dynamics_derivatives" || kernel == "forward_dynamics_sensitivities") return 2;
  return kernel == "forward_dynamics_second_derivatives" ? 3 : 0;
}

/// ‖K‖₁ ‖K⁻¹‖₁ of a square matrix, row by row, by Gauss and Jordan with partial pivoting; infinite without rank.
inline double condition_number(Values K, std::size_t n) {
  const auto norm = [n](const Values& matrix) {
    double largest = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i) sum += std::abs(matrix[i * n + j]);
      largest = std::max(largest, sum);
    }
    return largest;
  };
  const double of_matrix = norm(K);
  Values inverse(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) inverse[i * n + i] = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) pivot = std::abs(K[i * n + k]) > std::abs(K[pivot * n + k]) ? i : pivot;
    if (!(std::abs(K[pivot * n + k]) > 0.0)) return infinite;
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(K[k * n + j], K[pivot * n + j]);
      std::swap(inverse[k * n + j], inverse[pivot * n + j]);
    }
    const double over = 1.0 / K[k * n + k];
    for (std::size_t j = 0; j < n; ++j) K[k * n + j] *= over, inverse[k * n + j] *= over;
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = i == k ? 0.0 : K[i * n + k];
      for (std::size_t j = 0; j < n && factor != 0.0; ++j) {
        K[i * n + j] -= factor * K[k * n + j];
        inverse[i * n + j] -= factor * inverse[k * n + j];
      }
    }
  }
  return of_matrix * norm(inverse);
}

/// Of the matrix of the motion, over the roots of M's diagonal, and rows and columns of constraints over their lengths,
/// so that units do not matter. Constraints that repeat others have the multiplier 0, and no row.
inline double motion_condition(const Results& at, std::size_t n, std::size_t m) {
  const auto of = [&at](const char* name) {
    for (std::size_t k = 0; k < at.names.size(); ++k) {
      if (std::strcmp(at.names[k], name) == 0) return at.values.data() + at.begin(k);
    }
    return static_cast<const double*>(nullptr);
  };
  const double* mass = of("mass_matrix");
  const double* rows = of("constraint_jacobian");        // m x n
  const double* columns = of("constraint_columns");      // n x m; without friction the rows, transposed
  const double* multiplier = of("multipliers");
  if (mass == nullptr || (m > 0 && rows == nullptr)) return infinite;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < m; ++k) {
    if (multiplier == nullptr || multiplier[k] != 0.0) kept.push_back(k);  // without forward dynamics all of them
  }
  const std::size_t size = n + kept.size();
  Values K(size * size, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) K[i * size + j] = mass[i + j * n] / std::sqrt(mass[i * n + i] * mass[j * n + j]);
  }
  for (std::size_t place = n; place < size; ++place) {
    const std::size_t k = kept[place - n];
    double of_row = 0.0, of_column = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double root = std::sqrt(mass[i * n + i]);
      K[place * size + i] = rows[k + i * m] / root;
      K[i * size + place] = (columns != nullptr ? columns[i + k * n] : rows[k + i * m]) / root;
      of_row += K[place * size + i] * K[place * size + i];
      of_column += K[i * size + place] * K[i * size + place];
    }
    for (std::size_t i = 0; i < n; ++i) {
      K[place * size + i] /= std::sqrt(of_row);
      K[i * size + place] /= std::sqrt(of_column);
    }
  }
  const double condition = condition_number(std::move(K), size);
  return std::isfinite(condition) ? condition : infinite;
}

/// What a result may be off by rounding: `ulps` of what a change of each input by a rounding makes of it, at least of
/// the largest result of its kernel. The sizes are those of a kernel's results, of one order of magnitude each.
class Bound {
 public:
  Bound(Kernels& kernels, const Values& in)
      : nearest_(kernels(in)), condition_(nearest_.names.size(), 0.0), unknowns_(kernels.unknowns()),
        constraints_(kernels.constraints()) {
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      Values up = in, down = in;
      const double step = 1e-6 * std::max(1e-3, std::abs(in[i]));
      up[i] += step;
      down[i] -= step;
      const Results above = kernels(up);
      const Results& below = kernels(down);
      for (std::size_t k = 0; k < condition_.size(); ++k) {
        double change = 0.0;
        for (std::size_t j = above.begin(k); j < above.end(k); ++j) {
          change = std::max(change, std::abs(above.values[j] - below.values[j]));
        }
        condition_[k] += change / (up[i] - down[i]) * std::abs(in[i]);
      }
    }
    for (std::size_t k = 0; k < condition_.size(); ++k) {
      for (std::size_t j = nearest_.begin(k); j < nearest_.end(k); ++j) {
        condition_[k] = std::max(condition_[k], std::abs(nearest_.values[j]));
      }
    }
  }

  [[nodiscard]] const Results& nearest() const { return nearest_; }
  [[nodiscard]] std::size_t constraints() const { return constraints_; }
  [[nodiscard]] double unknowns() const { return static_cast<double>(unknowns_); }
  /// Condition of the matrix of the motion.
  [[nodiscard]] double of_motion() const { return motion_condition(nearest_, unknowns_ - constraints_, constraints_); }
  /// The largest difference from other results, in units of the bound's rounding.
  [[nodiscard]] double roundings(const Results& other, std::size_t kernel) const {
    double worst = 0.0;
    for (std::size_t j = nearest_.begin(kernel); j < nearest_.end(kernel); ++j) {
      using torsor::testing_rounding::roundings;
      worst = std::max(worst, roundings(other.values[j], nearest_.values[j], condition_[kernel], epsilon));
    }
    return worst;
  }

 private:
  Results nearest_;
  Values condition_;
  std::size_t unknowns_, constraints_;
};

/// How far accelerations and multipliers found without inputs miss M a + h = Aᵀ λ, in roundings of what a rounding of
/// each number in it changes. A backward stable solution misses by some roundings times the number of unknowns,
/// whatever the condition of M.
inline double backward(Kernels& kernels, const Values& in, const Results& found) {
  Values back = in;
  std::size_t force = found.names.size();
  for (std::size_t k = 0; k < found.names.size(); ++k) {
    const std::string name = found.names[k];
    if (name == "inverse_dynamics") force = k;
    if (name != "forward_dynamics" && name != "multipliers") continue;
    if (found.status[k] > 0) return 0.0;
    std::copy(found.values.begin() + static_cast<std::ptrdiff_t>(found.begin(k)),
              found.values.begin() + static_cast<std::ptrdiff_t>(found.end(k)),
              back.begin() +
                  static_cast<std::ptrdiff_t>(kernels.begin(name == "multipliers" ? multipliers : accelerations)));
  }
  if (force == found.names.size()) return 0.0;
  const Bound bound(kernels, back);
  Results nothing = bound.nearest();
  std::fill(nothing.values.begin(), nothing.values.end(), 0.0);
  return bound.roundings(nothing, force);
}

}  // namespace worst_states
