// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

/// Refuses a formula that is not in `unit`; zero fits any. `whose` names the object and the quantity: "the stiffness of
/// the spring 'hinge'". Throws UnitError with those, the formula, its unit and the unit that is wanted.
void require_unit(const Expression& given, const Unit& unit, const std::string& whose);
/// The same of three components.
void require_unit(const Triple& given, const Unit& unit, const std::string& whose);
/// How to write a plain number that stands for a length, a mass or what else has a unit: `: write quantity("2", "kg")`. Empty
/// for what is no plain number.
std::string unit_remedy(const std::string& number, const Unit& given, const Unit& wanted);
/// Refuses components that are not all of one unit, whichever that is; zeros fit any.
void require_one_unit(const Triple& given, const std::string& whose);

}  // namespace torsor
