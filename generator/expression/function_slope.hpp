// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/expression/function.hpp"

namespace torsor {

/// ∂y/∂x_i of y = f(x_0, x_1, ...) in any algebra that has + − * / and pow; `constant` makes a number of it.
/// Derivatives of programs and of displacements of joints come from here. Not for sines and cosines, which are each
/// other's slopes, nor for what selects one of several forms.
template <class T, class Constant>
T slope_of(Function function, const T& y, const std::vector<T>& x, std::size_t i, const Constant& constant) {
  using std::pow;
  switch (function) {
    case Function::sqrt: return constant(Number::rational(1, 2)) * pow(y, -1);
    case Function::exp: return y;
    case Function::log: return pow(x[0], -1);
    case Function::atan2: {
      const T square = x[1] * x[1] + x[0] * x[0];
      return i == 0 ? x[1] / square : constant(Number(-1)) * x[0] / square;
    }
    case Function::sin:
    case Function::cos:
    case Function::abs:
    case Function::sign:
    case Function::maximum:
    case Function::select: break;
  }
  return constant(Number());
}

}  // namespace torsor
