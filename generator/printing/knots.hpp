// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// A spline is a cubic of x − k, k the greatest knot below x, which is a selection. Multiplied out, k and the coefficients,
/// which are long selections too, stand many times, and at far knots the terms cancel to their last digits.
class Knots {
 public:
  /// With a name for x − k wherever that makes the sum shorter. May be called again on what became of the sum.
  Sum named(Sum sum);
  /// With (x − k) in the place of the names: a base of its own, which later products multiply out.
  Sum put_back(const Sum& sum) const;

 private:
  struct Distance {
    BasePointer knot;
    Sum name, value;  ///< of x − k
  };
  std::vector<Distance> distances_;
};

}  // namespace torsor::printing
