// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/function.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

const std::vector<FunctionTraits>& functions() {
  using enum UnitRule;
  using enum Parity;
  static const std::vector<FunctionTraits> all{
      {Function::sin, "sin", {"traits::sin", "", ""}, 1, dimensionless, odd, false, 0},
      {Function::cos, "cos", {"traits::cos", "", ""}, 1, dimensionless, even, false, 1},
      {Function::sqrt, "sqrt", {"traits::sqrt", "TORSOR_FUNCTION(sqrt)", "Math.sqrt"}, 1, root, none, false, 0},
      {Function::exp, "exp", {"traits::exp", "TORSOR_FUNCTION(exp)", "Math.exp"}, 1, dimensionless, none, false, 1},
      {Function::log, "log", {"traits::log", "TORSOR_FUNCTION(log)", "Math.log"}, 1, dimensionless, none, false, {}},
      {Function::abs, "abs", {"torsor::Selections<Scalar>::absolute", "torsor_absolute", "absolute"},
       1, same, even, true, 0},
      {Function::sign, "sign", {"torsor::Selections<Scalar>::sign", "torsor_sign", "sign"}, 1, ratio, odd, true, 0},
      {Function::maximum, "max", {"torsor::Selections<Scalar>::maximum", "torsor_maximum", "maximum"},
       2, same, none, true, {}},
      {Function::atan2, "atan2", {"torsor::Selections<Scalar>::arctangent", "torsor_arctangent", "arctangent"},
       2, ratio, odd, false, {}},
      {Function::select, "select", {"torsor::Selections<Scalar>::chosen", "torsor_chosen", "chosen"},
       3, choice, none, true, {}},
  };
  return all;
}

const FunctionTraits& traits_of(Function function) { return functions()[static_cast<std::size_t>(function)]; }

std::string_view to_string(Function function) { return traits_of(function).name; }

Unit unit_of_call(Function function, const std::vector<ArgumentUnit>& arguments,
                  const std::function<std::string()>& text, std::string_view remedy) {
  const UnitRule rule = traits_of(function).units;
  const auto refuse = [&](std::size_t i, const std::string& reason) {
    throw UnitError(fmt::format("the argument {}of {} has the unit {} and {}",
                                arguments.size() > 1 ? fmt::format("{} ", i + 1) : "", text(),
                                arguments[i].unit.to_string(), reason));
  };
  if (rule == UnitRule::dimensionless) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!arguments[i].fits_any && !arguments[i].unit.is_dimensionless()) {
        refuse(i, fmt::format("must be dimensionless{}", remedy));
      }
    }
    return Unit();
  }
  if (rule == UnitRule::root) return arguments[0].unit.root();
  Unit common;
  bool known = false;
  for (std::size_t i = rule == UnitRule::choice ? 1 : 0; i < arguments.size(); ++i) {
    if (arguments[i].fits_any) continue;
    if (known && !(arguments[i].unit == common))
      refuse(i, fmt::format("another one {}: give them one unit", common.to_string()));
    common = arguments[i].unit;
    known = true;
  }
  if (rule == UnitRule::ratio) return Unit();
  return known ? common : arguments.back().unit;  // zeros may carry a unit all the same
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
