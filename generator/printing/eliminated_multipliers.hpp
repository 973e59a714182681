// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/printing/lagrange_equations.hpp"

namespace torsor::printing {

/// An equation of motion that holds no multiplier: `residual` = 0.
struct FreeEquation {
  CoordinateContent coordinate;
  Sum residual;
};

/// What is left of Lagrange's equations when those of `dependent` have given the multipliers.
struct FreeEquations {
  std::vector<FreeEquation> equations;
  std::vector<std::string> dependent;  ///< coordinates
  Sum determinant;  ///< of C: where it is zero, the multipliers cannot be taken from those equations

  /// Whether the determinant may be zero: it is no number and no product of parameters.
  bool can_fail() const;
};

/// P_i − Q_i − c_i C⁻¹ (P − Q)_dependent, c_i and C the columns of the multipliers. Nothing where there are no constraints,
/// more than three, as many as coordinates, repeated ones, or equations that are too long to be read.
std::optional<FreeEquations> without_multipliers(LagrangeEquations& equations);

}  // namespace torsor::printing
