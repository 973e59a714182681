// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// A sum in which two cosines, or two sines, with nearly one coefficient are written as a product:
/// p cos x + q cos y = (p − q) cos x + 2 q cos((x + y)/2) cos((x − y)/2), and so for differences, for sines, and for
/// 1 + cos y = 2 cos²(y/2).
///
/// Heights of links that fold back on each other are such sums. Where cos x + cos y nearly vanishes next to multiples
/// of π, so does its rate: the angles matter little there, but the roundings of the two cosines do not become smaller
/// with the sum. Those of the product do.
///
/// Pairs are taken where p − q is zero, or below a quarter of p, of numbers; coefficients that hold parameters must be
/// equal. What is too long to be multiplied out stays as it is.
Value with_paired_cosines(Program& program, const Value& sum);

}  // namespace torsor
