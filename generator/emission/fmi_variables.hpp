// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/emission/fmi_unit.hpp"

namespace torsor {

/// A variable of a functional mock-up unit. All are continuous, but for parameters, which are tunable.
struct FmiVariable {
  enum class Role { state, derivative, input, parameter, output, indicator, time };
  std::string name, unit;  ///< without a unit: "1"
  Role role;
  std::optional<double> start;
  std::size_t reference = 0;             ///< its value reference
  std::optional<std::size_t> state = {};  ///< reference of the state whose derivative it is
  bool follows_parameters = false;        ///< a state whose start is a function of tunable parameters
};

/// Names of the event indicators, in their order: three of each contact.
std::vector<std::string> fmi_indicators(const MechanismListing& mechanism);

/// In the order of their value references: states (q, then v), their derivatives, inputs, tunable parameters, multipliers
/// (not with contacts, where their references name nothing), energies, points, frames, reactions, event indicators; in
/// FMI 3.0 time is the last. Throws SceneError where a parameter or a state has no value.
std::vector<FmiVariable> fmi_variables(const FmiUnit& unit);

/// References of the states, inputs, parameters and of time that an output is a function of, in their order; none where it
/// depends on the motion, and so on all.
struct FmiDependency {
  std::size_t output;  ///< reference
  std::optional<std::vector<std::size_t>> on;
};
/// Of all outputs.
std::vector<FmiDependency> fmi_dependencies(const FmiUnit& unit, const std::vector<FmiVariable>& variables);

/// The naming convention that the names keep: structured names hold letters, digits and most signs of ASCII; of flat ones
/// nothing is asked.
std::string fmi_naming(const std::vector<FmiVariable>& variables);

/// Unit elements, with their base units, of what the variables are measured in; FMI 2.0 and 3.0 write them alike.
std::string fmi_unit_definitions(const std::vector<FmiVariable>& variables);

/// As an attribute of XML.
std::string xml_escaped(std::string text);

}  // namespace torsor
