// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/c_header.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/emission/c_language.hpp"
#include "generator/emission/comment_text.hpp"
#include "generator/emission/cpp_names.hpp"
#include "generator/emission/description.hpp"
#include "generator/emission/embedded_templates.hpp"
#include "generator/emission/formula_printer.hpp"
#include "generator/emission/listing_printer.hpp"
#include "generator/emission/text_template.hpp"

namespace torsor {
namespace {

/// Arrays have one entry at least.
std::string array_size(std::size_t entries) { return std::to_string(std::max<std::size_t>(entries, 1)); }

/// Structures whose members all are numbers of one vector are passed as arrays.
bool is_vector(const MechanismListing& mechanism, const Structure& structure) {
  return std::any_of(mechanism.common.begin(), mechanism.common.end(),
                     [&](const Structure& each) { return each.name == structure.name; });
}

std::string c_structure(const std::string& scene, const Structure& structure) {
  std::string text = "/// " + comment_text(structure.documentation) + "\ntypedef struct {\n";
  if (structure.members.empty()) text += "  torsor_real nothing_;\n";
  for (const Member& member : structure.members) {
    const std::string shape =
        member.scalar || member.columns == 1 ? "" : fmt::format(" ({} x {})", member.rows, member.columns);
    const std::string size =
        member.scalar ? "" : fmt::format("[{}]", array_size(static_cast<std::size_t>(member.rows * member.columns)));
    text +=
        fmt::format("  torsor_real {}{};  ///< {}{}\n", member.name, size, comment_text(member.documentation), shape);
  }
  return text + fmt::format("}} {}_{};\n\n", scene, structure.name);
}

/// Places of symbols in their arrays: arm7_q_shoulder.
std::string places_text(const std::string& scene, const Layout& layout) {
  std::string text;
  for (const auto& [table, prefix] :
       {std::pair(Table::coordinate, "q"), std::pair(Table::velocity, "v"), std::pair(Table::input, "input"),
        std::pair(Table::multiplier, "multiplier"), std::pair(Table::parameter, "parameter")}) {
    std::string list;
    for (const SymbolPointer& symbol : layout.of(table)) {
      list += fmt::format("{}{}_{}_{}", list.empty() ? "" : ", ", scene, prefix, member_name(*symbol));
    }
    if (!list.empty()) text += wrapped(fmt::format("enum {{ {} }};", list), 0) + "\n";
  }
  return text;
}

std::string c_function(const MechanismListing& mechanism, const KernelListing& given) {
  const KernelSignature& kernel = given.kernel;
  const Listing& listing = given.listing;
  const std::string& scene = mechanism.scene().name();
  std::string arguments = fmt::format("const {0}_precomputed* precomputed, const {0}_state* state", scene);
  std::string unused = "(void)precomputed, (void)state";
  const auto add = [&](const std::string& type, const std::string& name) {
    arguments += fmt::format(", {}* {}", type, name);
    unused += ", (void)" + name;
  };
  for (const Argument argument : kernel.arguments) add("const torsor_real", name_of(argument));
  for (const Result& result : kernel.results) {
    const Structure* const structure = mechanism.structure(result.structure);
    const bool array = structure == nullptr || is_vector(mechanism, *structure);
    add(array ? "torsor_real" : fmt::format("{}_{}", scene, structure->name), result.name);
  }
  if (listing.recurrence) arguments += ", int order, torsor_real* coefficients";
  const std::string body = print(listing, CLanguage(mechanism, "precomputed->parameters"));
  const std::string type = listing.has_status ? "torsor_status" : "void";
  const std::string signature =
      fmt::format("TORSOR_UNUSED static inline {} {}_{}({}) {{", type, scene, kernel.name, arguments);
  return documentation_comment(kernel.documentation) + wrapped(signature, 0) + "\n  " + unused + ";\n" +
         indented(body, "  ") + "}\n";
}

}  // namespace

std::string emit_c(const MechanismListing& mechanism) {
  const std::string& scene = mechanism.scene().name();
  require_cpp_name(scene, "scene");
  const Layout& layout = mechanism.layout;
  std::string functions, structures, members;
  for (const Structure& each : mechanism.own) structures += c_structure(scene, each);
  for (const KernelListing& each : mechanism.kernels) {
    functions += (functions.empty() ? "" : "\n") + c_function(mechanism, each);
  }
  for (const PrecomputedMember& each : mechanism.members) members += fmt::format("torsor_real {};\n", each.name);
  std::string copies;
  for (std::size_t i = 0; i < layout.parameters.size(); ++i) {
    copies += fmt::format("precomputed->parameters[{0}] = parameters[{0}];\n", i);
  }
  const CLanguage language(mechanism, "parameters");
  const std::string_view support = embedded_template("support.h");
  const auto size = [](const auto& list) { return std::to_string(list.size()); };
  return fill_template("mechanism.h.in", embedded_template("mechanism.h.in"),
                       {{"provenance", provenance_comment(provenance_of(mechanism, "c99", "h"))},
                        {"guard", "TORSOR_" + scene + "_H"},
                        {"support", std::string(support.substr(support.find('\n') + 1))},
                        {"scene_name", scene},
                        {"coordinate_count", size(layout.coordinates)},
                        {"velocity_count", size(layout.velocities)},
                        {"input_count", size(layout.inputs)},
                        {"parameter_count", size(layout.parameters)},
                        {"multiplier_count", size(layout.multipliers)},
                        {"coordinate_size", array_size(layout.coordinates.size())},
                        {"velocity_size", array_size(layout.velocities.size())},
                        {"parameter_size", array_size(layout.parameters.size())},
                        {"places", places_text(scene, layout)},
                        {"precomputed_members", members},
                        {"structures", structures},
                        {"default_parameters", print(mechanism.default_parameters, language)},
                        {"copy_parameters", copies},
                        {"precompute", print(mechanism.precompute, language)},
                        {"initial_state", print(mechanism.initial_state, language)},
                        {"kernels", functions}});
}

}  // namespace torsor
