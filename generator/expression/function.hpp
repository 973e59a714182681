// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/base/unit.hpp"

namespace torsor {

/// Functions of a program. `functions()` tells all that is common to them, names in generated texts included; what only
/// one of them has stands in function_slope.hpp (its slope), function_values.hpp (its value) and series_lowering.cpp (its
/// Taylor series).
enum class Function { sin, cos, sqrt, exp, log, abs, sign, maximum, atan2, select };

/// What the units of arguments and result must be.
enum class UnitRule {
  dimensionless,  ///< arguments and result
  root,           ///< any argument; the result has the root of its unit
  same,           ///< arguments and result have one unit
  ratio,          ///< arguments have one unit, the result none
  choice,         ///< any first argument; the others and the result have one unit
};

/// How signs leave a function's first argument.
enum class Parity { none, odd, even };

/// Names in generated texts; empty in languages in which sines and cosines come in pairs.
struct EmittedNames {
  const char *cpp, *c, *javascript;
};

struct FunctionTraits {
  Function function;
  const char* name;      ///< in formulas that a person reads or writes
  EmittedNames emitted;
  std::size_t arity;
  UnitRule units;
  Parity parity;
  bool selects;          ///< takes one of several forms, which meet at a kink or a jump: not analytic
  std::optional<int> at_zero;  ///< of one argument: its value at zero, where it has one
};

/// In the order of the enumeration.
const std::vector<FunctionTraits>& functions();
const FunctionTraits& traits_of(Function function);

std::string_view to_string(Function function);

/// An argument of a call, as far as its unit is concerned.
struct ArgumentUnit {
  Unit unit;
  bool fits_any = false;  ///< a literal zero
};

/// Unit of the result. Throws UnitError when those of the arguments do not fit. `text` is the call as the message
/// quotes it, `remedy` what it says of an argument that must be dimensionless.
Unit unit_of_call(Function function, const std::vector<ArgumentUnit>& arguments,
                  const std::function<std::string()>& text, std::string_view remedy = {});
/// Units of arguments with which the result has that unit; what may be anything is dimensionless.
std::vector<Unit> argument_units(Function function, const Unit& result);

}  // namespace torsor
