// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Whether a value jumps where a selection in it (sign, piecewise) turns from one form to another, or an angle of atan2 goes
/// through its cut. A change of sign of what decides is looked for around pseudo-random states along each symbol that it
/// depends on, up to 1e15, and enclosed in 60 digits: at its two sides a continuous value is the same. What changes its sign
/// nowhere there counts as continuous.
bool jumps(const Value& value);
/// The same where one symbol alone changes, such as the time.
bool jumps_along(const Value& value, const SymbolPointer& symbol);

/// Which selections are looked at.
enum class Deciding {
  any,
  alone,  ///< by one symbol alone: the others may turn at another time in each motion
};
/// Where one of several values jumps along a symbol; also where a root in one touches zero, as that of 1 - cos(t) does, whose
/// slope jumps there. Such places, and cuts of atan2, are sought in tenths of powers of ten, up to 1e4.
std::optional<double> place_of_jump(const std::vector<Value>& values, const SymbolPointer& symbol, Deciding deciding);

}  // namespace torsor
