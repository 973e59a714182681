// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/expression/function.hpp"

namespace torsor {

// Values of the functions in each scalar: those that <cmath> lacks, as generated headers have them.

template <std::floating_point Float>
Float sign(Float x) {
  return x > 0 ? Float(1) : x < 0 ? Float(-1) : x;
}
template <std::floating_point Float>
Float maximum(Float a, Float b) {
  return a >= b ? a : a < b ? b : std::numeric_limits<Float>::quiet_NaN();
}
template <std::floating_point Float>
Float select(Float condition, Float a, Float b) {
  return condition >= 0 ? a : condition < 0 ? b : condition;
}

inline Real sign(const Real& x) { return x > Real(0) ? Real(1) : x < Real(0) ? Real(-1) : x; }
inline Real maximum(const Real& a, const Real& b) { return a >= b ? a : a < b ? b : Real::not_a_number(); }
inline Real select(const Real& condition, const Real& a, const Real& b) {
  return condition >= Real(0) ? a : condition < Real(0) ? b : condition;
}

/// The function at these arguments; any other scalar brings its own under the same names.
template <class Scalar>
Scalar value_of_call(Function function, const std::vector<Scalar>& x) {
  using std::abs, std::atan2, std::cos, std::exp, std::log, std::sin, std::sqrt;
  switch (function) {
    case Function::sin: return sin(x[0]);
    case Function::cos: return cos(x[0]);
    case Function::sqrt: return sqrt(x[0]);
    case Function::exp: return exp(x[0]);
    case Function::log: return log(x[0]);
    case Function::abs: return abs(x[0]);
    case Function::sign: return sign(x[0]);
    case Function::maximum: return maximum(x[0], x[1]);
    case Function::atan2: return atan2(x[0], x[1]);
    case Function::select: return select(x[0], x[1], x[2]);
  }
  return x[0];
}

}  // namespace torsor
