// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_variables.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/entities.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

double start_value(const MechanismListing& mechanism, const SymbolPointer& symbol, const char* what) {
  try {
    return initial_value(mechanism.scene().content(), symbol).to_double();
  } catch (const SceneError&) {
    throw SceneError(fmt::format("the {} '{}' has no value, and a unit of FMI starts with one: give it in the scene",
                                 what, symbol->name));
  }
}

/// "m" becomes "m/s", "rad" "rad/s".
std::string unit_of_rate(const std::string& unit) {
  if (unit == "rad") return "rad/s";
  return written_unit(Unit::parse(unit) / Unit(0, 0, 1));
}

std::string unit_definition(const std::string& text) {
  const Unit unit = Unit::parse(text);
  static constexpr const char* bases[] = {"kg", "m", "s", "A", "K", "mol", "cd"};
  std::string attributes;
  for (int i = 0; i < Unit::base_count; ++i) {
    const int half = unit.half_exponent(i);
    if (half % 2 != 0) return fmt::format("    <Unit name=\"{}\"/>\n", xml_escaped(text));  // a root: FMI has none
    if (half != 0) attributes += fmt::format(" {}=\"{}\"", bases[i], half / 2);
  }
  if (text.starts_with("rad")) attributes += " rad=\"1\"";
  return fmt::format("    <Unit name=\"{}\"><BaseUnit{}/></Unit>\n", xml_escaped(text), attributes);
}

}  // namespace

std::vector<std::string> fmi_indicators(const MechanismListing& mechanism) {
  std::vector<std::string> names;
  for (const ContactContent& contact : mechanism.scene().content().contacts) {
    for (const char* what : {"opens_or_closes", "sticks_or_slips", "slip_begins_or_fades"}) {
      names.push_back(fmt::format("indicator.{}.{}", contact.name, what));
    }
  }
  return names;
}

std::vector<FmiVariable> fmi_variables(const MechanismListing& mechanism) {
  using Role = FmiVariable::Role;
  std::vector<FmiVariable> all;
  const Layout& layout = mechanism.layout;
  const auto states = [&](const std::string& prefix, const std::vector<SymbolPointer>& symbols) {
    const std::vector<NamedUnit> named = named_units(symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      all.push_back({prefix + named[i].name, named[i].unit, Role::state, start_value(mechanism, symbols[i], "state")});
    }
  };
  states("q.", layout.coordinates);
  states("v.", layout.velocities);
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string unit = i < layout.coordinates.size()
                                 ? unit_of_rate(all[i].unit)
                                 : written_unit(*layout.accelerations[i - layout.coordinates.size()]);
    all.push_back({fmt::format("der({})", all[i].name), unit, Role::derivative, {}});
  }
  for (const auto& [name, unit] : named_units(layout.inputs)) all.push_back({"input." + name, unit, Role::input, 0.0});
  const std::vector<NamedUnit> parameters = named_units(layout.parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    all.push_back({"parameter." + parameters[i].name, parameters[i].unit, Role::parameter,
                   start_value(mechanism, layout.parameters[i], "parameter")});
  }
  for (const auto& [name, unit] : named_units(layout.multipliers)) {
    all.push_back({"multiplier." + name, unit, Role::output, {}});
  }
  for (const char* kind : {"kinetic", "potential", "total"}) {
    all.push_back({fmt::format("energy.{}", kind), "J", Role::local, {}});
  }
  for (const std::string& name : fmi_indicators(mechanism)) all.push_back({name, "1", Role::indicator, {}});
  return all;
}

std::string fmi_unit_definitions(const std::vector<FmiVariable>& variables) {
  std::vector<std::string> names;
  std::string text;
  for (const FmiVariable& variable : variables) {
    if (variable.unit == "1" || std::find(names.begin(), names.end(), variable.unit) != names.end()) continue;
    names.push_back(variable.unit);
    text += unit_definition(variable.unit);
  }
  return text;
}

std::string xml_escaped(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return with_entities(text, "&<>\"");
}

}  // namespace torsor
