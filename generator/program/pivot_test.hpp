// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// A pivot of an elimination, and what it must be positive beside.
struct PivotTest {
  Value pivot, measure;
  /// Whether the measure belongs to other rows too: many roundings of it, and not one, are what a pivot must be beyond.
  bool of_several_rows = false;
};

/// The many roundings of a PivotTest. Four digits of multipliers can be asked of doubles and not of floats: these keep three
/// bits above the rounding.
namespace many_roundings {
inline constexpr int in_double = 4096, in_float = 8;
}

}  // namespace torsor
