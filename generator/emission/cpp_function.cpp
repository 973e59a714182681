// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/cpp_function.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/emission/cpp_language.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/formula_printer.hpp"
#include "torsor/generator/emission/listing_printer.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

struct ArgumentText {
  Argument argument;
  Table table;
  const char* type;
  const char* name;
};
constexpr std::array<ArgumentText, 3> argument_texts{
    {{Argument::accelerations, Table::acceleration, "Accelerations", "accelerations"},
     {Argument::multipliers, Table::multiplier, "Multipliers", "multipliers"},
     {Argument::inputs, Table::input, "Inputs", "inputs"}}};

struct ParameterText {
  std::string type, name;
  bool used;              ///< one that this scene does not need has no name: nobody looks for it, no compiler warns
  std::string empty{};    ///< the structure without members that it is, which a caller may leave out
  bool is_result = false;
};

std::vector<ParameterText> parameters_behind_state(const MechanismListing& mechanism, const KernelListing& given) {
  const KernelSignature& kernel = given.kernel;
  const Listing& listing = given.listing;
  const auto empty = [&mechanism](const std::string& structure) {
    const Structure* const found = mechanism.structure(structure);
    const bool optional = structure == "Inputs" || structure == "Multipliers";
    return optional && found->members.empty() ? structure : std::string();
  };
  std::vector<ParameterText> all;
  for (const Argument argument : kernel.arguments) {
    const ArgumentText& text = *std::find_if(argument_texts.begin(), argument_texts.end(),
                                             [&](const ArgumentText& each) { return each.argument == argument; });
    all.push_back({fmt::format("const {}&", text.type), text.name, listing.reads(text.table), empty(text.type)});
  }
  for (const Result& result : kernel.results) {
    const bool used = std::any_of(listing.outputs.begin(), listing.outputs.end(),
                                  [&](const Output& each) { return each.target.result == result.name; });
    const std::string type =
        result.structure.empty() ? fmt::format("std::array<Scalar, {}>", result.size) : result.structure;
    all.push_back({type + "&", result.name, used, empty(result.structure), true});
  }
  if (listing.recurrence) {
    all.push_back({"int", "order", true});
    all.push_back({fmt::format("std::array<Scalar, {}>*", listing.recurrence->rates.size()), "coefficients", true, "", true});
  }
  return all;
}

/// The same function without arguments that have no members; empty where all have some.
std::string short_form(const KernelSignature& kernel, const char* type, const std::vector<ParameterText>& parameters) {
  const auto is_empty = [](const ParameterText& each) { return !each.empty.empty(); };
  if (std::none_of(parameters.begin(), parameters.end(), is_empty)) return "";
  std::string signature = fmt::format("TORSOR_DEVICE static {} {}(const Precomputed& precomputed, const State& state",
                                      type, kernel.name);
  std::string call = "precomputed, state", locals;
  for (const ParameterText& each : parameters) {
    if (!is_empty(each)) signature += ", " + each.type + " " + each.name;
    if (is_empty(each) && each.is_result) locals += fmt::format("  {} {}{{}};\n", each.empty, each.name);
    call += ", " + (is_empty(each) && !each.is_result ? each.empty + "()" : each.name);
  }
  return "\n/// The same for this mechanism, which has nothing in the arguments left out.\n" +
         wrapped(signature + ") noexcept {", 2) + "\n" + locals +
         fmt::format("  {}Mechanism::{}({});\n}}\n", std::string(type) == "void" ? "" : "return ", kernel.name, call);
}

}  // namespace

FunctionText cpp_function(const MechanismListing& mechanism, const KernelListing& given) {
  const KernelSignature& kernel = given.kernel;
  const Listing& listing = given.listing;
  FunctionText function;
  std::vector<std::string> members;
  for (const PrecomputedMember& each : mechanism.members) members.push_back(each.name);
  std::map<std::string, const Structure*> vectors;
  for (const Result& result : kernel.results) {
    if (const Structure* structure = mechanism.structure(result.structure)) vectors.emplace(result.name, structure);
  }
  function.body = print(listing, CppLanguage(mechanism.layout, "precomputed.parameters.", members, vectors));

  const auto parameter = [](const std::string& type, const std::string& name, bool used) {
    return used ? type + " " + name : type;
  };
  const char* const type = listing.has_status ? "torsor::Status" : "void";
  std::string signature = fmt::format("TORSOR_DEVICE static {} {}(", type, kernel.name);
  signature += parameter("const Precomputed&", "precomputed",
                         listing.reads(Table::precomputed) || listing.reads(Table::parameter));
  const bool reads_state =
      listing.reads(Table::time) || listing.reads(Table::coordinate) || listing.reads(Table::velocity);
  signature += ", " + parameter("const State&", "state", listing.recurrence || reads_state);
  const std::vector<ParameterText> parameters = parameters_behind_state(mechanism, given);
  std::string types = type;
  for (const ParameterText& each : parameters) {
    signature += ", " + parameter(each.type, each.name, each.used);
    types += ", " + each.type;
  }
  signature += ") noexcept {";
  function.pointer = fmt::format("KernelFunction<{}>({})", types, kernel.name);
  function.body = documentation_comment(kernel.documentation) + wrapped(signature, 2) + "\n" +
                  indented(function.body, "  ") + "}\n" + short_form(kernel, type, parameters);
  return function;
}

}  // namespace torsor
