// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/function.hpp"

#include <fmt/format.h>

#include "generator/base/error.hpp"

namespace torsor {

const std::vector<FunctionTraits>& functions() {
  static const std::vector<FunctionTraits> all{
      {Function::sin, "sin", "traits::sin", 1, UnitRule::dimensionless, Parity::odd, false},
      {Function::cos, "cos", "traits::cos", 1, UnitRule::dimensionless, Parity::even, false},
      {Function::sqrt, "sqrt", "traits::sqrt", 1, UnitRule::root, Parity::none, false},
      {Function::exp, "exp", "traits::exp", 1, UnitRule::dimensionless, Parity::none, false},
      {Function::log, "log", "traits::log", 1, UnitRule::dimensionless, Parity::none, false},
      {Function::abs, "abs", "torsor::Selections<Scalar>::absolute", 1, UnitRule::same, Parity::even, true},
      {Function::sign, "sign", "torsor::Selections<Scalar>::sign", 1, UnitRule::ratio, Parity::odd, true},
      {Function::maximum, "max", "torsor::Selections<Scalar>::maximum", 2, UnitRule::same, Parity::none, true},
      {Function::atan2, "atan2", "torsor::Selections<Scalar>::arctangent", 2, UnitRule::ratio, Parity::odd, false},
      {Function::select, "select", "torsor::Selections<Scalar>::chosen", 3, UnitRule::choice, Parity::none, true},
  };
  return all;
}

const FunctionTraits& traits_of(Function function) { return functions()[static_cast<std::size_t>(function)]; }

std::string_view to_string(Function function) { return traits_of(function).name; }

Unit unit_of_call(Function function, const std::vector<Unit>& arguments, const std::vector<bool>& fits_any,
                  const std::function<std::string()>& text, std::string_view remedy) {
  const UnitRule rule = traits_of(function).units;
  const auto refuse = [&](std::size_t i, const std::string& reason) {
    throw UnitError(fmt::format("the argument {}of {} has the unit {} and {}",
                                arguments.size() > 1 ? fmt::format("{} ", i + 1) : "", text(), arguments[i].to_string(),
                                reason));
  };
  if (rule == UnitRule::dimensionless) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!fits_any[i] && !arguments[i].is_dimensionless()) {
        refuse(i, fmt::format("must be dimensionless{}", remedy));
      }
    }
    return Unit();
  }
  if (rule == UnitRule::root) return arguments[0].root();
  Unit common;
  bool known = false;
  for (std::size_t i = rule == UnitRule::choice ? 1 : 0; i < arguments.size(); ++i) {
    if (fits_any[i]) continue;
    if (known && !(arguments[i] == common)) refuse(i, fmt::format("another one {}: give them one unit", common.to_string()));
    common = arguments[i];
    known = true;
  }
  if (rule == UnitRule::ratio) return Unit();
  return known ? common : arguments.back();  // zeros may carry a unit all the same
}

std::vector<Unit> argument_units(Function function, const Unit& result) {
  const FunctionTraits& traits = traits_of(function);
  std::vector<Unit> units(traits.arity);
  switch (traits.units) {
    case UnitRule::dimensionless:
    case UnitRule::ratio: break;
    case UnitRule::root: units[0] = result.pow(2); break;
    case UnitRule::same:
    case UnitRule::choice:
      for (std::size_t i = traits.units == UnitRule::choice ? 1 : 0; i < units.size(); ++i) units[i] = result;
      break;
  }
  return units;
}

}  // namespace torsor
