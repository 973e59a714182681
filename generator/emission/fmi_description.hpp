// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/fmi_unit.hpp"

namespace torsor {

/// What tells the unit from others: guid of FMI 2.0, instantiation token of 3.0. It changes with the equations, with the
/// variables and with the interface.
std::string fmi_token(const FmiUnit& unit);

/// The licences of all that the unit holds, as an expression of SPDX.
std::string fmi_licence(const FmiUnit& unit);

/// modelDescription.xml, with the variables of fmi_variables(). Throws SceneError where a parameter has no value.
std::string fmi_description(const FmiUnit& unit);

/// The page documentation/index.html: what the unit is, and its variables.
std::string fmi_documentation(const FmiUnit& unit);

}  // namespace torsor
