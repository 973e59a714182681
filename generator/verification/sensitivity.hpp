// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/differential.hpp"

namespace torsor {

/// Derivatives along a few fixed directions.
struct FewSlopes {
  std::array<double, 8> along{};
};

inline FewSlopes combination(double x, const FewSlopes& a, double y, const FewSlopes& b) {
  FewSlopes result;
  for (std::size_t d = 0; d < result.along.size(); ++d) result.along[d] = x * a.along[d] + y * b.along[d];
  return result;
}

/// A number with what it moves by, to first order, when every input x_j is moved by ± x_j: forward derivatives along a
/// few fixed sequences of signs that look random. The mean square of what they give is an unbiased estimate of
/// Σ_j (x_j ∂f/∂x_j)², for the mixed products have the mean 0. (Hutchinson, 1990, for the trace of g gᵀ.)
///
/// That sum's root is what an error of one unit, relative, in each input does to a result, so rounding a result whose
/// terms cancel, or that comes from a nearly singular solve, may fairly be compared with it.
using Sensitivity = Differential<double, FewSlopes>;

/// An input: `number` tells its signs.
inline Sensitivity sensitivity_input(double value, std::uint64_t number) {
  // Finaliser of splitmix64 (Steele, Lea, Flood, 2014): bits of neighbouring numbers are unrelated.
  std::uint64_t bits = (number + 1) * 0x9E3779B97F4A7C15U;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  bits ^= bits >> 31U;
  FewSlopes slopes;
  for (std::size_t d = 0; d < slopes.along.size(); ++d) slopes.along[d] = ((bits >> d) & 1U) != 0 ? value : -value;
  return Sensitivity(value, slopes);
}

inline double mean_square(const Sensitivity& sensitivity) {
  double sum = 0;
  for (const double each : sensitivity.slopes().along) sum += each * each;
  return sum / static_cast<double>(sensitivity.slopes().along.size());
}

/// The derivatives by every input, times the input; empty while none is known not to vanish.
struct AllSlopes {
  std::vector<long double> by_input{};
};

inline AllSlopes combination(long double x, const AllSlopes& a, long double y, const AllSlopes& b) {
  AllSlopes result{std::vector<long double>(std::max(a.by_input.size(), b.by_input.size()), 0)};
  for (std::size_t j = 0; j < a.by_input.size(); ++j) result.by_input[j] = x * a.by_input[j];
  for (std::size_t j = 0; j < b.by_input.size(); ++j) result.by_input[j] += y * b.by_input[j];
  return result;
}

/// A number with x_j ∂f/∂x_j for each input x_j: what its condition is made of.
using Elasticity = Differential<long double, AllSlopes>;

/// Input number j.
inline Elasticity elasticity_input(long double value, std::size_t j) {
  AllSlopes slopes{std::vector<long double>(j + 1, 0)};
  slopes.by_input[j] = value;
  return Elasticity(value, std::move(slopes));
}

}  // namespace torsor
