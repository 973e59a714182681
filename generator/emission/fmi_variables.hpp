// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A variable of a functional mock-up unit. All are continuous, but for parameters, which are tunable.
struct FmiVariable {
  enum class Role { state, derivative, input, parameter, output, local, indicator };
  std::string name, unit;  ///< without a unit: "1"
  Role role;
  std::optional<double> start;
};

/// Names of the event indicators, in their order: three of each contact.
std::vector<std::string> fmi_indicators(const MechanismListing& mechanism);

/// In the order of their value references: states (q, then v), their derivatives, inputs, tunable parameters, multipliers,
/// energies, event indicators. Throws SceneError where a parameter or a state has no value.
std::vector<FmiVariable> fmi_variables(const MechanismListing& mechanism);

/// Unit elements, with their base units, of what the variables are measured in; FMI 2.0 and 3.0 write them alike.
std::string fmi_unit_definitions(const std::vector<FmiVariable>& variables);

/// As an attribute of XML.
std::string xml_escaped(std::string text);

}  // namespace torsor
