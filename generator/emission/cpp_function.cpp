// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_function.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "generator/emission/cpp_language.hpp"
#include "generator/emission/cpp_names.hpp"
#include "generator/emission/description.hpp"
#include "generator/emission/formula_printer.hpp"
#include "generator/emission/listing_printer.hpp"
#include "generator/emission/text_template.hpp"

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

std::string type_of(const Result& result) {
  return result.structure.empty() ? fmt::format("std::array<Scalar, {}>", result.size) : result.structure;
}

}  // namespace

std::string cpp_function(const MechanismListing& mechanism, const KernelListing& given) {
  const KernelSignature& kernel = given.kernel;
  const Listing& listing = given.listing;
  std::vector<std::string> members;
  for (const PrecomputedMember& each : mechanism.members) members.push_back(each.name);
  std::map<std::string, const Structure*> vectors;
  for (const Result& result : kernel.results) {
    if (const Structure* structure = mechanism.structure(result.structure)) vectors.emplace(result.name, structure);
  }
  const std::string body = print(listing, CppLanguage(mechanism.layout, "precomputed.parameters.", members, vectors));

  // An argument that this scene does not need has no name, so that nobody looks for it and no compiler warns.
  const auto parameter = [](const std::string& type, const std::string& name, bool used) {
    return used ? type + " " + name : type;
  };
  std::string signature =
      fmt::format("TORSOR_DEVICE static {} {}(", listing.has_status ? "torsor::Status" : "void", kernel.name);
  signature += parameter("const Precomputed&", "precomputed",
                         listing.reads(Table::precomputed) || listing.reads(Table::parameter));
  const bool reads_state =
      listing.reads(Table::time) || listing.reads(Table::coordinate) || listing.reads(Table::velocity);
  signature += ", " + parameter("const State&", "state", listing.recurrence || reads_state);
  for (const Argument argument : kernel.arguments) {
    const ArgumentText& text = *std::find_if(argument_texts.begin(), argument_texts.end(),
                                             [&](const ArgumentText& each) { return each.argument == argument; });
    signature += ", " + parameter(fmt::format("const {}&", text.type), text.name, listing.reads(text.table));
  }
  for (const Result& result : kernel.results) {
    const bool used = std::any_of(listing.outputs.begin(), listing.outputs.end(),
                                  [&](const Output& each) { return each.target.result == result.name; });
    signature += ", " + parameter(type_of(result) + "&", result.name, used);
  }
  if (listing.recurrence) {
    signature += fmt::format(", int order, std::array<Scalar, {}>* coefficients", listing.recurrence->rates.size());
  }
  signature += ") noexcept {";
  return documentation_comment(kernel.documentation) + wrapped(signature, 2) + "\n" + indented(body, "  ") + "}\n";
}

}  // namespace torsor
