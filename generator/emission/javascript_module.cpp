// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/javascript_module.hpp"

#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/formula_printer.hpp"
#include "torsor/generator/emission/javascript_language.hpp"
#include "torsor/generator/emission/listing_printer.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

std::string javascript_function(const MechanismListing& mechanism, const KernelListing& given) {
  const KernelSignature& kernel = given.kernel;
  const Listing& listing = given.listing;
  std::map<std::string, const Structure*> results;
  std::string arguments = "precomputed, state";
  for (const Argument argument : kernel.arguments) arguments += fmt::format(", {}", name_of(argument));
  for (const Result& result : kernel.results) {
    arguments += ", " + result.name;
    results.emplace(result.name, mechanism.structure(result.structure));
  }
  if (listing.recurrence) arguments += ", order, coefficients";
  const std::string body = print(listing, JavascriptLanguage(mechanism, "precomputed", results));
  return documentation_comment(kernel.documentation) +
         wrapped(fmt::format("export function {}({}) {{", kernel.name, arguments), 0) + "\n" + indented(body, "  ") +
         "}\n";
}

/// What comes along with structures.
std::string tables_text(const MechanismListing& mechanism) {
  std::string text;
  for (const Structure& structure : mechanism.own) {
    for (const ConstantTable& table : structure.tables) {
      const bool number = std::holds_alternative<std::size_t>(table.value);
      text += documentation_comment(table.documentation) +
              wrapped(fmt::format("export const {} = {};", table.name,
                                  number ? numbers_text(table) : "[" + numbers_text(table) + "]"),
                      0) +
              "\n";
    }
  }
  return text;
}

}  // namespace

std::string emit_javascript(const MechanismListing& mechanism) {
  const JavascriptLanguage language(mechanism, "parameters");
  std::string functions;
  for (const KernelListing& each : mechanism.kernels) {
    functions += (functions.empty() ? "" : "\n") + javascript_function(mechanism, each);
  }
  const Layout& layout = mechanism.layout;
  std::string places;
  for (std::size_t k = 0; k < mechanism.members.size(); ++k) {
    places += fmt::format("const {} = {};\n", mechanism.members[k].name, layout.parameters.size() + k);
  }
  if (!places.empty()) places = "// Where precompute puts what it has computed.\n" + places + "\n";
  const std::string_view support = embedded_template("support.js");
  std::map<std::string, std::string> values = {
      {"provenance", provenance_comment(provenance_of(mechanism, "javascript", "mjs"))},
      {"scene_name", mechanism.scene().name()},
      {"quaternions", nlohmann::ordered_json(quaternion_places(mechanism)).dump()},
      {"state_size", std::to_string(1 + layout.coordinates.size() + layout.velocities.size())},
      {"precomputed_size", std::to_string(layout.parameters.size() + mechanism.members.size())},
      {"parameter_count", std::to_string(layout.parameters.size())},
      {"kernel_table", lines_of(kernels_json(mechanism))},
      {"tables", tables_text(mechanism)},
      {"precomputed_places", places},
      {"support", std::string(support.substr(support.find('\n') + 1))},
      {"default_parameters", print(mechanism.default_parameters, language)},
      {"precompute", print(mechanism.precompute, language)},
      {"initial_state", print(mechanism.initial_state, language)},
      {"kernels", functions}};
  for (const DescribedTable& described : described_tables) {
    values.emplace(described.name, lines_of(quantities_json(layout.of(described.table))));
  }
  return fill_template("mechanism.js.in", embedded_template("mechanism.js.in"), values);
}

}  // namespace torsor
