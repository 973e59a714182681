// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// A number rounded once to each of the two binary formats of a header.
struct RoundedConstant {
  double in_double = 0;
  float in_float = 0;
};

/// Value of a value number that depends on numbers only (sin(3/10), a sum of such, π), rounded from CLN: precision grows until
/// two evaluations, at d and 2 d digits, agree beyond what rounding needs. What stays below 1e-500 is taken for zero.
/// Throws Error for a value number of a later stage, and when there is no value (0 in a denominator, a root or logarithm of a
/// negative number), naming the definition.
RoundedConstant rounded_constant(Program& program, ValueNumber value_number);

}  // namespace torsor
