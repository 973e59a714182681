// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Whether a value jumps where a selection in it (sign, piecewise) turns from one form to another. A change of sign of what
/// decides is looked for around pseudo-random states along each symbol that it depends on, up to 1e15, and enclosed in 60
/// digits: at its two sides a continuous value is the same. What changes its sign nowhere there counts as continuous.
bool jumps(const Value& value);
/// The same where one symbol alone changes, such as the time.
bool jumps_along(const Value& value, const SymbolPointer& symbol);

}  // namespace torsor
