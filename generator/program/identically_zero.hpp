// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Whether a value vanishes identically: exactly when it has no term, else tested with 60 digits at pseudo-random states
/// of numbers around one. At each it must be less than 10^-40, and of what its terms come to without their signs: a small
/// number, however small, is none that vanishes. An identity of analytic functions fails at a random point with
/// probability one; where square roots, exponentials or logarithms enter, which may be silent in one region and act in
/// another (a stop, a wall), numbers between 10^-3 and 10^4 of either sign are tried as well. Where it holds selections
/// (abs, sign, max, piecewise), whose forms may act in a narrow region that no such number falls into, it must vanish
/// whichever form is taken: each is taken at random, whatever its condition says, and one of a piecewise function that
/// does not vanish is an unknown of its own. A value is thus never called zero that is not zero somewhere; one that is
/// zero by a relation between forms may be missed.
bool identically_zero(const Value& value);
/// The same for many values of one program, whose definitions are evaluated once for all.
std::vector<bool> identically_zero_entries(const std::vector<Value>& values);
/// Makes zeros of those that vanish identically without showing it, which would be carried through all that follows: the pass
/// `zero_test`, without which nothing changes.
void clear_identically_zero(std::vector<Value>& values);
void clear_identically_zero(std::vector<std::vector<Value>>& matrix);

}  // namespace torsor
