// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// Pseudo-random values for the symbols of a scene, the same for every program that uses the scene and for every
/// number type: each is a `double`, drawn from [-2, 2] with 20 bits for coordinates, rates, accelerations, inputs and
/// multipliers, from [0, 2] for time. Parameters are scaled from their value by a factor in [1/2, 3/2], one for all moments of inertia; those without
/// a value are in [1/2, 3/2]. Quaternions are normalised in the number type that is asked for.
class RandomState {
 public:
  RandomState(const Scene& scene, std::uint64_t seed);

  double value(const SymbolPointer& symbol) const;
  /// Adapter for Evaluator<double> and Evaluator<Real>: the very same numbers.
  Evaluator<double>::SymbolValue in_double() const;
  Evaluator<Real>::SymbolValue in_real() const;

 private:
  std::map<const Symbol*, double> values_;  // looked up only
};

}  // namespace torsor
