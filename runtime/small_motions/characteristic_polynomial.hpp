// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// det(M s² + C s + K) / det M: coefficients from 1, of s^{2n}, down to that of s⁰, each with a bound of its error.
struct CharacteristicPolynomial {
  std::vector<double> coefficients;
  std::vector<double> uncertainties;
};

/// By interpolation: the determinant in normalised coordinates at the 2 n + 1 roots of unity, where a discrete Fourier
/// transform gives every coefficient with the same absolute error, some n² roundings of Hadamard's bound. No eigenvalue
/// is computed, so that a stability verdict from this polynomial is independent of one from eigenvalues.
/// Throws std::invalid_argument as `normalised` does.
[[nodiscard]] CharacteristicPolynomial characteristic_polynomial(const LinearSystem& system);

}  // namespace torsor::runtime
