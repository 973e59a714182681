// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_description.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/fmi_variables.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

void require_kernels(const MechanismListing& mechanism) {
  for (const char* kernel : {"forward_dynamics", "forward_dynamics_derivatives", "energy"}) {
    const bool found = std::any_of(mechanism.kernels.begin(), mechanism.kernels.end(),
                                   [kernel](const KernelListing& each) { return each.kernel.name == kernel; });
    if (!found) {
      throw SceneError(
          fmt::format("the scene '{}' has no kernel {}, and a unit of FMI moves by it; `list` tells why it is absent",
                      mechanism.scene().name(), kernel));
    }
  }
}

/// What FMI 2.0 and 3.0 say alike.
std::string kind_of(const FmiVariable& variable) {
  using Role = FmiVariable::Role;
  switch (variable.role) {
    case Role::state:
      return "causality=\"local\" variability=\"continuous\" initial=\"exact\"";
    case Role::input:
      return "causality=\"input\" variability=\"continuous\"";
    case Role::parameter:
      return "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"";
    case Role::output:
      return "causality=\"output\" variability=\"continuous\" initial=\"calculated\"";
    default:
      return "causality=\"local\" variability=\"continuous\" initial=\"calculated\"";
  }
}

/// Attributes of the type Real or Float64. `first` is what FMI calls the first variable, by index or by reference.
std::string numbers_of(const FmiVariable& variable, std::size_t place, std::size_t states, std::size_t first,
                       bool can_be_put_back) {
  std::string text;
  if (variable.unit != "1") text += fmt::format(" unit=\"{}\"", xml_escaped(variable.unit));
  if (variable.start) text += fmt::format(" start=\"{}\"", *variable.start);
  if (variable.role == FmiVariable::Role::state && can_be_put_back) text += " reinit=\"true\"";
  if (variable.role == FmiVariable::Role::derivative) text += fmt::format(" derivative=\"{}\"", place - states + first);
  return text;
}

constexpr const char* both_kinds_of_2 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/></SourceFiles>
  </ModelExchange>
  <CoSimulation modelIdentifier="{0}" canHandleVariableCommunicationStepSize="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative="true">
    <SourceFiles><File name="{0}_fmi2.c"/></SourceFiles>
  </CoSimulation>)";
constexpr const char* with_contacts_of_2 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUstate="true" canSerializeFMUstate="true"/>
  <CoSimulation modelIdentifier="{0}" canHandleVariableCommunicationStepSize="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true"/>)";
constexpr const char* both_kinds_of_3 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" needsCompletedIntegratorStep="true"/>
  <CoSimulation modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives="true" providesAdjointDerivatives="true" canHandleVariableCommunicationStepSize="true"/>)";
constexpr const char* with_contacts_of_3 =
    R"(  <ModelExchange modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" needsCompletedIntegratorStep="true"/>
  <CoSimulation modelIdentifier="{0}" canGetAndSetFMUState="true" canSerializeFMUState="true" canHandleVariableCommunicationStepSize="true"/>)";

struct UnknownPlaces {
  std::vector<std::size_t> outputs, derivatives, indicators;
};

UnknownPlaces unknowns_of(const std::vector<FmiVariable>& variables, bool contacts) {
  UnknownPlaces structure;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i].role == FmiVariable::Role::indicator) structure.indicators.push_back(i);
    if (variables[i].role == FmiVariable::Role::output && !contacts) structure.outputs.push_back(i);
    if (variables[i].role == FmiVariable::Role::derivative) structure.derivatives.push_back(i);
  }
  return structure;
}

std::string structure_of_2(const UnknownPlaces& structure) {
  const auto unknowns = [](const std::vector<std::size_t>& places) {
    std::string text;
    for (const std::size_t i : places) text += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
    return text;
  };
  const auto list = [](const char* name, const std::string& entries) {
    return entries.empty() ? "" : fmt::format("    <{0}>\n{1}    </{0}>\n", name, entries);
  };
  const std::string outputs = unknowns(structure.outputs), derivatives = unknowns(structure.derivatives);
  return list("Outputs", outputs) + list("Derivatives", derivatives) +
         list("InitialUnknowns", derivatives + outputs);
}

std::string structure_of_3(const UnknownPlaces& structure) {
  const auto list = [](const char* name, const std::vector<std::size_t>& places) {
    std::string text;
    for (const std::size_t i : places) text += fmt::format("    <{} valueReference=\"{}\"/>\n", name, i);
    return text;
  };
  return list("Output", structure.outputs) + list("ContinuousStateDerivative", structure.derivatives) +
         list("InitialUnknown", structure.derivatives) + list("InitialUnknown", structure.outputs) +
         list("EventIndicator", structure.indicators);
}

}  // namespace

std::string fmi_token(const MechanismListing& mechanism, FmiVersion version) {
  Fnv interface;
  using Files = std::vector<const char*>;
  for (const char* file : version == FmiVersion::two
                              ? Files{"fmi/fmi2.c.in"}
                              : Files{"fmi/fmi3.c.in", "fmi/fmi3_types.h.in", "fmi/fmi3_absent.h.in"}) {
    interface.add(embedded_template(file));
  }
  for (const char* file : {"fmi/model.h.in", "fmi/motion.h.in", "fmi/contacts.cpp.in"}) interface.add(embedded_template(file));
  return fmt::format("{{{:016x}-{:016x}}}", header_fingerprint(mechanism), interface.value());
}

std::string fmi_description(const MechanismListing& mechanism, FmiVersion version) {
  require_kernels(mechanism);
  const bool two = version == FmiVersion::two;
  // What changes at the events of contacts has no derivatives, and reactions of contacts change multipliers.
  const bool contacts = !mechanism.scene().content().contacts.empty();
  const std::vector<FmiVariable> variables = fmi_variables(mechanism);
  const std::size_t states = mechanism.layout.coordinates.size() + mechanism.layout.velocities.size();
  const bool can_be_put_back = contacts || !mechanism.layout.multipliers.empty() ||
                               mechanism.layout.coordinates.size() > mechanism.layout.velocities.size();
  std::string list;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const FmiVariable& v = variables[i];
    if (contacts && v.role == FmiVariable::Role::output) continue;
    const std::string numbers = numbers_of(v, i, states, two ? 1 : 0, can_be_put_back);
    list += two ? fmt::format("    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}><Real{}/></ScalarVariable>\n", v.name,
                              i, kind_of(v), numbers)
                : fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" {}{}/>\n", v.name, i, kind_of(v), numbers);
  }
  if (!two) {
    list += fmt::format(
        "    <Float64 name=\"time\" valueReference=\"{}\" causality=\"independent\" variability=\"continuous\" unit=\"s\"/>\n",
        variables.size());
  }
  std::vector<FmiVariable> measured = variables;
  if (!two) measured.push_back({"time", "s", FmiVariable::Role::local, {}});
  const char* const file = two ? "fmi/modelDescription2.xml.in" : "fmi/modelDescription3.xml.in";
  const UnknownPlaces structure = unknowns_of(variables, contacts);
  const char* const kinds = two ? (contacts ? with_contacts_of_2 : both_kinds_of_2)
                                : (contacts ? with_contacts_of_3 : both_kinds_of_3);
  std::map<std::string, std::string> texts = {
      {"name", mechanism.scene().name()},
      {"title", xml_escaped(mechanism.scene().content().title)},
      {"version", TORSOR_VERSION},
      {"token", fmi_token(mechanism, version)},
      {"kinds", fmt::format(fmt::runtime(kinds), mechanism.scene().name())},
      {"units", fmi_unit_definitions(measured)},
      {"variables", list},
      {"structure", two ? structure_of_2(structure) : structure_of_3(structure)}};
  if (two) texts["indicators"] = std::to_string(structure.indicators.size());
  return fill_template(file, embedded_template(file), texts);
}

}  // namespace torsor
