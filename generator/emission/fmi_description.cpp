// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_description.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/fmi_variables.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

/// What FMI 2.0 and 3.0 say alike.
std::string kind_of(const FmiVariable& variable) {
  using Role = FmiVariable::Role;
  switch (variable.role) {
    case Role::state:
      return fmt::format("causality=\"local\" variability=\"continuous\" initial=\"{}\"",
                         variable.follows_parameters ? "approx" : "exact");
    case Role::input:
      return "causality=\"input\" variability=\"continuous\"";
    case Role::parameter:
      return "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"";
    case Role::output:
      return "causality=\"output\" variability=\"continuous\" initial=\"calculated\"";
    case Role::time:
      return "causality=\"independent\" variability=\"continuous\"";
    default:
      return "causality=\"local\" variability=\"continuous\" initial=\"calculated\"";
  }
}

/// Attributes of the type Real or Float64. `first` is what FMI calls the first variable, by index or by reference.
std::string numbers_of(const FmiVariable& variable, std::size_t first, bool can_be_put_back) {
  std::string text;
  if (variable.unit != "1") text += fmt::format(" unit=\"{}\"", xml_escaped(variable.unit));
  if (variable.start) text += fmt::format(" start=\"{}\"", *variable.start);
  if (variable.role == FmiVariable::Role::state && can_be_put_back) text += " reinit=\"true\"";
  if (variable.state) text += fmt::format(" derivative=\"{}\"", *variable.state + first);
  return text;
}

constexpr const char* both_kinds_of_2 =
    R"(  <ModelExchange modelIdentifier="{0}" canNotUseMemoryManagementFunctions="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/></SourceFiles>
  </ModelExchange>
  <CoSimulation modelIdentifier="{0}" canHandleVariableCommunicationStepSize="true" canNotUseMemoryManagementFunctions="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/></SourceFiles>
  </CoSimulation>)";
constexpr const char* with_contacts_of_2 =
    R"(  <ModelExchange modelIdentifier="{0}" canNotUseMemoryManagementFunctions="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/><File name="{0}_contacts.cpp"/><File name="contact_layer.cpp"/></SourceFiles>
  </ModelExchange>
  <CoSimulation modelIdentifier="{0}" canHandleVariableCommunicationStepSize="true" canNotUseMemoryManagementFunctions="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/><File name="{0}_contacts.cpp"/><File name="contact_layer.cpp"/></SourceFiles>
  </CoSimulation>)";
constexpr const char* both_kinds_of_3 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" needsCompletedIntegratorStep="true"/>
  <CoSimulation modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" canHandleVariableCommunicationStepSize="true"/>)";
constexpr const char* with_contacts_of_3 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" needsCompletedIntegratorStep="true"/>
  <CoSimulation modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" canHandleVariableCommunicationStepSize="true"/>)";

/// What ModelStructure tells: of outputs also what they depend on.
struct ModelStructure {
  std::vector<FmiDependency> outputs;
  std::vector<std::size_t> derivatives, indicators, initial;  ///< references; `initial`: states that follow parameters
};

/// FMI 2.0 counts variables, 3.0 names them by reference.
class StructureText {
 public:
  StructureText(const FmiUnit& unit, const std::vector<FmiVariable>& variables)
      : two_(unit.version == FmiVersion::two), variables_(variables) {
    structure_.outputs = fmi_dependencies(unit, variables);
    for (const FmiVariable& variable : variables) {
      if (variable.role == FmiVariable::Role::indicator) structure_.indicators.push_back(variable.reference);
      if (variable.role == FmiVariable::Role::derivative) structure_.derivatives.push_back(variable.reference);
      if (variable.follows_parameters) structure_.initial.push_back(variable.reference);
    }
  }

  std::string text() const {
    const std::string derivatives = two_ ? "Derivatives" : "ContinuousStateDerivative";
    return section(two_ ? "Outputs" : "Output", outputs(false)) +
           section(derivatives, unknowns(structure_.derivatives)) +
           section(two_ ? "InitialUnknowns" : "InitialUnknown", unknowns(initially()), outputs(true)) +
           (two_ ? "" : section("EventIndicator", unknowns(structure_.indicators)));
  }

  std::size_t indicators() const { return structure_.indicators.size(); }

 private:
  using Attributes = std::vector<std::string>;

  std::vector<std::size_t> initially() const {
    std::vector<std::size_t> all = structure_.initial;
    all.insert(all.end(), structure_.derivatives.begin(), structure_.derivatives.end());
    return all;
  }

  /// References are in the order of variables, and some may be missing.
  std::size_t called(std::size_t reference) const {
    if (!two_) return reference;
    const auto place = std::find_if(variables_.begin(), variables_.end(),
                                    [reference](const FmiVariable& each) { return each.reference == reference; });
    return static_cast<std::size_t>(place - variables_.begin()) + 1;
  }

  std::string unknown(std::size_t reference) const {
    return fmt::format("{}=\"{}\"", two_ ? "index" : "valueReference", called(reference));
  }

  Attributes unknowns(const std::vector<std::size_t>& references) const {
    Attributes all;
    for (const std::size_t reference : references) all.push_back(unknown(reference));
    return all;
  }

  /// Whether one of them is no known at the start, but a function of parameters.
  bool through_start(const std::vector<std::size_t>& references) const {
    return std::any_of(references.begin(), references.end(), [this](std::size_t each) {
      return std::find(structure_.initial.begin(), structure_.initial.end(), each) != structure_.initial.end();
    });
  }

  /// Known are inputs, states and time; parameters, in FMI 2.0, at the start alone.
  Attributes outputs(bool initially) const {
    Attributes all;
    for (const FmiDependency& output : structure_.outputs) {
      all.push_back(unknown(output.output));
      if (!output.on || (initially && through_start(*output.on))) continue;
      std::string known;
      for (const FmiVariable& variable : variables_) {
        if (std::find(output.on->begin(), output.on->end(), variable.reference) == output.on->end()) continue;
        if (variable.role == FmiVariable::Role::parameter && two_ && !initially) continue;
        known += fmt::format("{}{}", known.empty() ? "" : " ", called(variable.reference));
      }
      all.back() += fmt::format(" dependencies=\"{}\"", known);
    }
    return all;
  }

  std::string section(const std::string& name, Attributes attributes, const Attributes& more = {}) const {
    attributes.insert(attributes.end(), more.begin(), more.end());
    std::string text;
    for (const std::string& each : attributes) {
      text += two_ ? fmt::format("      <Unknown {}/>\n", each) : fmt::format("    <{} {}/>\n", name, each);
    }
    return two_ && !text.empty() ? fmt::format("    <{0}>\n{1}    </{0}>\n", name, text) : text;
  }

  bool two_;
  const std::vector<FmiVariable>& variables_;
  ModelStructure structure_;
};

std::string variable_text(const FmiVariable& v, bool two, bool can_be_put_back) {
  const std::string name = xml_escaped(v.name), numbers = numbers_of(v, two ? 1 : 0, can_be_put_back);
  return two ? fmt::format("    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}><Real{}/></ScalarVariable>\n",
                           name, v.reference, kind_of(v), numbers)
             : fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" {}{}/>\n", name, v.reference, kind_of(v),
                           numbers);
}

const char* role_text(FmiVariable::Role role) {
  using Role = FmiVariable::Role;
  switch (role) {
    case Role::state:
      return "state";
    case Role::derivative:
      return "derivative";
    case Role::input:
      return "input";
    case Role::parameter:
      return "tunable parameter";
    case Role::output:
      return "output";
    case Role::indicator:
      return "event indicator";
    default:
      return "time";
  }
}

}  // namespace

std::string fmi_token(const FmiUnit& unit) {
  Fnv interface;
  using Files = std::vector<const char*>;
  for (const char* file : unit.version == FmiVersion::two ? Files{"fmi/fmi2.c.in", "fmi/fmi2_names.h.in"}
                                                          : Files{"fmi/fmi3.c.in", "fmi/fmi3_names.h.in",
                                                                  "fmi/fmi3_types.h.in", "fmi/fmi3_absent.h.in"}) {
    interface.add(embedded_template(file));
  }
  for (const char* file : {"fmi/model.h.in", "fmi/sizes.h.in", "fmi/derivatives.h.in", "fmi/motion.h.in", "fmi/contacts.cpp.in"}) {
    interface.add(embedded_template(file));
  }
  for (const FmiVariable& variable : fmi_variables(unit)) interface.add(variable.name).add("\n");
  return fmt::format("{{{:016x}-{:016x}}}", header_fingerprint(unit.mechanism), interface.value());
}

std::string fmi_licence(const FmiUnit& unit) { return unit.has_contacts() ? "MIT-0 AND MIT AND MPL-2.0" : "MIT-0"; }

std::string fmi_description(const FmiUnit& unit) {
  const bool two = unit.version == FmiVersion::two, contacts = unit.has_contacts();
  const Layout& layout = unit.mechanism.layout;
  const std::vector<FmiVariable> variables = fmi_variables(unit);
  const bool can_be_put_back =
      contacts || !layout.multipliers.empty() || layout.coordinates.size() > layout.velocities.size();
  std::string list;
  for (const FmiVariable& variable : variables) list += variable_text(variable, two, can_be_put_back);
  const StructureText structure(unit, variables);
  const char* const kinds =
      two ? (contacts ? with_contacts_of_2 : both_kinds_of_2) : (contacts ? with_contacts_of_3 : both_kinds_of_3);
  const char* const file = two ? "fmi/modelDescription2.xml.in" : "fmi/modelDescription3.xml.in";
  std::map<std::string, std::string> texts = {{"name", unit.name()},
                                              {"title", xml_escaped(unit.scene().content().title)},
                                              {"version", TORSOR_VERSION},
                                              {"licence", fmi_licence(unit)},
                                              {"token", fmi_token(unit)},
                                              {"kinds", fmt::format(fmt::runtime(kinds), unit.name())},
                                              {"naming", fmi_naming(variables)},
                                              {"units", fmi_unit_definitions(variables)},
                                              {"variables", list},
                                              {"structure", structure.text()}};
  if (two) texts["indicators"] = std::to_string(structure.indicators());
  return fill_template(file, embedded_template(file), texts);
}

std::string fmi_documentation(const FmiUnit& unit) {
  std::string rows;
  for (const FmiVariable& variable : fmi_variables(unit)) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", xml_escaped(variable.name),
                        role_text(variable.role), xml_escaped(variable.unit),
                        variable.start ? fmt::format("{}", *variable.start) : "");
  }
  const char* const file = "fmi/index.html.in";
  return fill_template(file, embedded_template(file),
                       {{"name", unit.name()},
                        {"title", xml_escaped(unit.scene().content().title)},
                        {"fmi", unit.version == FmiVersion::two ? "2.0" : "3.0"},
                        {"version", TORSOR_VERSION},
                        {"variables", rows}});
}

}  // namespace torsor
