// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/error.hpp"

namespace torsor {

/// A denominator that vanishes identically: of a formula, or once a state is put into it.
class DivisionByZero : public Error {
 public:
  DivisionByZero() : Error("division by zero: a denominator vanishes identically") {}
};

inline constexpr const char* no_value_at_state =
    "the formulas divide by zero at this state, by the length of a spring whose ends meet, the speed that gives a drag its "
    "direction, or a rate at a dead centre: choose a state beside it";

}  // namespace torsor
