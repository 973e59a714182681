// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/fmi_description.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/base/fnv.hpp"
#include "generator/base/unit.hpp"
#include "generator/emission/c_header.hpp"
#include "generator/emission/description.hpp"
#include "generator/emission/embedded_templates.hpp"
#include "generator/emission/header.hpp"
#include "generator/emission/text_template.hpp"
#include "generator/mechanics/parameter_value.hpp"
#include "generator/program/written_unit.hpp"

namespace torsor {
namespace {

bool has_kernel_named(const MechanismListing& mechanism, const std::string& name) {
  return std::any_of(mechanism.kernels.begin(), mechanism.kernels.end(),
                     [&name](const KernelListing& each) { return each.kernel.name == name; });
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

/// What stands in ScalarVariable and Real.
struct Variable {
  std::string name, unit, attributes, real;
};

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

std::vector<Variable> variables_of(const MechanismListing& mechanism) {
  std::vector<Variable> all;
  const Layout& layout = mechanism.layout;
  const auto state = [&](const std::string& prefix, const std::vector<SymbolPointer>& symbols) {
    const std::vector<NamedUnit> named = named_units(symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      all.push_back({prefix + named[i].name, named[i].unit,
                     "causality=\"local\" variability=\"continuous\" initial=\"exact\"",
                     fmt::format(" start=\"{}\"", start_value(mechanism, symbols[i], "state"))});
    }
  };
  state("q.", layout.coordinates);
  state("v.", layout.velocities);
  const std::size_t states = all.size();
  for (std::size_t i = 0; i < states; ++i) {
    const std::string unit = i < layout.coordinates.size()
                                 ? unit_of_rate(all[i].unit)
                                 : written_unit(*layout.accelerations[i - layout.coordinates.size()]);
    all.push_back({fmt::format("der({})", all[i].name), unit,
                   "causality=\"local\" variability=\"continuous\" initial=\"calculated\"",
                   fmt::format(" derivative=\"{}\"", i + 1)});
  }
  for (const auto& [name, unit] : named_units(layout.inputs)) {
    all.push_back({"input." + name, unit, "causality=\"input\" variability=\"continuous\"", " start=\"0\""});
  }
  const std::vector<NamedUnit> parameters = named_units(layout.parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    all.push_back({"parameter." + parameters[i].name, parameters[i].unit,
                   "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"",
                   fmt::format(" start=\"{}\"", start_value(mechanism, layout.parameters[i], "parameter"))});
  }
  for (const auto& [name, unit] : named_units(layout.multipliers)) {
    all.push_back(
        {"multiplier." + name, unit, "causality=\"output\" variability=\"continuous\" initial=\"calculated\"", ""});
  }
  for (const char* kind : {"kinetic", "potential", "total"}) {
    all.push_back({fmt::format("energy.{}", kind), "J",
                   "causality=\"local\" variability=\"continuous\" initial=\"calculated\"", ""});
  }
  return all;
}

std::string unit_definition(const std::string& text) {
  const Unit unit = Unit::parse(text);
  static constexpr const char* bases[] = {"kg", "m", "s", "A", "K", "mol", "cd"};
  std::string attributes;
  for (int i = 0; i < Unit::base_count; ++i) {
    const int half = unit.half_exponent(i);
    if (half % 2 != 0) return fmt::format("    <Unit name=\"{}\"/>\n", escaped(text));  // a root: FMI has none
    if (half != 0) attributes += fmt::format(" {}=\"{}\"", bases[i], half / 2);
  }
  if (text.starts_with("rad")) attributes += " rad=\"1\"";
  return fmt::format("    <Unit name=\"{}\"><BaseUnit{}/></Unit>\n", escaped(text), attributes);
}

std::string unit_definitions(const std::vector<Variable>& variables) {
  std::vector<std::string> names;
  std::string text;
  for (const Variable& variable : variables) {
    if (variable.unit == "1" || std::find(names.begin(), names.end(), variable.unit) != names.end()) continue;
    names.push_back(variable.unit);
    text += unit_definition(variable.unit);
  }
  return text;
}

std::string unknowns(std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t i = first; i < first + count; ++i) text += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
  return text;
}

std::string list_of(const char* name, const std::string& entries) {
  return entries.empty() ? "" : fmt::format("    <{0}>\n{1}    </{0}>\n", name, entries);
}

}  // namespace

std::vector<std::string> fmi_kernels(const Scene& scene) {
  std::vector<std::string> names = {"forward_dynamics", "energy", "forward_dynamics_derivatives"};
  if (!scene.content().constraints.empty()) names.insert(names.end(), {"mass_matrix", "constraints"});
  return names;
}

std::string fmi_token(const MechanismListing& mechanism) {
  Fnv interface;
  for (const char* file : {"fmi/model.h.in", "fmi/fmi2.c.in"}) interface.add(embedded_template(file));
  return fmt::format("{{{:016x}-{:016x}}}", header_fingerprint(mechanism), interface.value());
}

std::string fmi_description(const MechanismListing& mechanism) {
  for (const char* kernel : {"forward_dynamics", "forward_dynamics_derivatives", "energy"}) {
    if (!has_kernel_named(mechanism, kernel)) {
      throw SceneError(
          fmt::format("the scene '{}' has no kernel {}, and a unit of FMI moves by it; `list` tells why it is absent",
                      mechanism.scene().name(), kernel));
    }
  }
  const std::string& name = mechanism.scene().name();
  const std::vector<Variable> variables = variables_of(mechanism);
  std::string list;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const Variable& v = variables[i];
    const std::string unit = v.unit == "1" ? "" : fmt::format(" unit=\"{}\"", escaped(v.unit));
    list += fmt::format("    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}><Real{}{}/></ScalarVariable>\n",
                        v.name, i, v.attributes, unit, v.real);
  }
  const std::size_t states = mechanism.layout.coordinates.size() + mechanism.layout.velocities.size();
  const std::size_t outputs = mechanism.layout.multipliers.size();
  const std::size_t first_output = 2 * states + mechanism.layout.inputs.size() + mechanism.layout.parameters.size();
  const std::string derivatives = unknowns(states, states), results = unknowns(first_output, outputs);
  const std::string structure = list_of("Outputs", results) + list_of("Derivatives", derivatives) +
                                list_of("InitialUnknowns", derivatives + results);
  return fill_template("fmi/modelDescription2.xml.in", embedded_template("fmi/modelDescription2.xml.in"),
                       {{"name", name},
                        {"title", escaped(mechanism.scene().content().title)},
                        {"version", TORSOR_VERSION},
                        {"token", fmi_token(mechanism)},
                        {"units", unit_definitions(variables)},
                        {"variables", list},
                        {"structure", structure}});
}

std::vector<SourceFile> fmi_sources(const MechanismListing& mechanism) {
  const std::string& name = mechanism.scene().name();
  const auto flag = [](bool holds) { return std::string(holds ? "1" : "0"); };
  return {
      {name + "_fmi2.c", fill_template("fmi/fmi2.c.in", embedded_template("fmi/fmi2.c.in"),
                                       {{"name", name}, {"version", TORSOR_VERSION}, {"token", fmi_token(mechanism)}})},
      {"fmi_model.h", fill_template("fmi/model.h.in", embedded_template("fmi/model.h.in"),
                                    {{"name", name},
                                     {"version", TORSOR_VERSION},
                                     {"has_rates", flag(has_kernel_named(mechanism, "coordinate_rates"))},
                                     {"has_inputs", flag(!mechanism.layout.inputs.empty())},
                                     {"has_multipliers", flag(!mechanism.layout.multipliers.empty())}})},
      {name + ".h", emit_c(mechanism).header}};
}

}  // namespace torsor
