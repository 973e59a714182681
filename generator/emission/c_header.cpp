// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/c_header.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/comment_text.hpp"
#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/emission/c_language.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/formula_printer.hpp"
#include "torsor/generator/emission/listing_printer.hpp"
#include "torsor/generator/emission/support.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

/// Arrays have one entry at least.
std::string array_size(std::size_t entries) { return std::to_string(std::max<std::size_t>(entries, 1)); }

std::string c_structure(const std::string& scene, const Structure& structure) {
  std::string text = "/// " + comment_text(structure.documentation) + "\ntypedef struct {\n";
  if (structure.members.empty()) text += "  torsor_real nothing_;\n";
  for (const Member& member : structure.members) {
    const std::string shape =
        member.is_scalar() || member.columns == 1 ? "" : fmt::format(" ({} x {})", member.rows, member.columns);
    const std::string size =
        member.is_scalar() ? "" : fmt::format("[{}]", array_size(static_cast<std::size_t>(member.rows * member.columns)));
    text +=
        fmt::format("  torsor_real {}{};  ///< {}{}\n", member.name, size, comment_text(member.meaning.with_unit()), shape);
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

/// A function or a table: its definition is the declaration with something behind.
struct CItem {
  std::string documentation, declaration, definition;
  bool is_table = false;
};

/// The parts of a table's text.
struct CTable {
  std::string type, name;
  std::vector<std::string> entries;
  std::string nothing;  ///< the one entry of a table that would have none: C knows no empty array
  std::string documentation = {};
};

CItem c_table(const CTable& table) {
  const std::string entries = fmt::format("{}", fmt::join(table.entries, ", "));
  return {table.documentation, fmt::format("const {} {}[{}]", table.type, table.name, array_size(table.entries.size())),
          fmt::format(" = {{{}}};", table.entries.empty() ? table.nothing : entries), true};
}

/// What the mechanism says of itself.
std::vector<CItem> c_description(const MechanismListing& mechanism) {
  const std::string& scene = mechanism.scene().name();
  std::vector<CItem> items;
  for (const DescribedTable& described : described_tables) {
    items.push_back(c_table({"torsor_quantity", scene + "_" + described.name,
                            quantity_entries(mechanism.layout.of(described.table)), "{\"\", \"\"}"}));
  }
  items.front().documentation = "Names and units of what the vectors hold.";
  std::vector<std::string> quaternions;
  for (const std::size_t place : quaternion_places(mechanism)) quaternions.push_back(std::to_string(place));
  items.push_back(c_table({"int", scene + "_quaternions", quaternions, "0",
                          "Places in q of the first components (w) of the unit quaternions (w, x, y, z)."}));
  const KernelEntries entries = kernel_entries(mechanism, scene + "_results", {"0", "1"});
  items.push_back(c_table({"torsor_result", scene + "_results", entries.results, "{\"\", \"\", 0, 0, 0, \"\"}",
                          "What kernels write, and what they read."}));
  items.push_back(c_table({"torsor_kernel", scene + "_kernels", entries.kernels, "{\"\", 0, 0, 0, 0, 0, 0}"}));
  return items;
}

/// What comes along with a structure: a number as an enumerator, which has no definition, else a table.
std::vector<CItem> c_tables(const std::string& scene, const Structure& structure) {
  std::vector<CItem> items;
  for (const ConstantTable& each : structure.tables) {
    const std::string name = scene + "_" + each.name;
    if (const auto* number = std::get_if<std::size_t>(&each.value)) {
      items.push_back({each.documentation, fmt::format("enum {{ {} = {} }}", name, *number), "", true});
    } else if (const auto* indices = std::get_if<ConstantTable::Indices>(&each.value)) {
      std::vector<std::string> entries;
      for (const auto index : *indices) entries.push_back(std::to_string(index));
      items.push_back(c_table({"int", name, entries, "0", each.documentation}));
    } else {
      std::vector<std::string> factors;
      for (const double factor : std::get<ConstantTable::Factors>(each.value)) {
        factors.push_back(
            fmt::format("TORSOR_NUMBER({}, {})", literal(factor), literal(static_cast<float>(factor))));
      }
      items.push_back(c_table({"torsor_real", name, factors, "0", each.documentation}));
    }
  }
  return items;
}

/// The parts of a function's text.
struct CFunction {
  std::string type, name, arguments, documentation;
  std::string unused;  ///< what keeps compilers silent about arguments that nothing reads
  std::string body;
};

CItem c_item(const CFunction& function) {
  return {function.documentation, fmt::format("{} {}({})", function.type, function.name, function.arguments),
          " {\n  " + function.unused + ";\n" + indented(function.body, "  ") + "}"};
}

CItem c_function(const MechanismListing& mechanism, const KernelListing& given) {
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
  return c_item({.type = listing.has_status ? "torsor_status" : "void",
                 .name = scene + "_" + kernel.name,
                 .arguments = arguments,
                 .documentation = kernel.documentation,
                 .unused = unused,
                 .body = body});
}

/// Functions of parameters.
std::vector<CItem> preparations(const MechanismListing& mechanism) {
  const std::string& scene = mechanism.scene().name();
  const CLanguage language(mechanism, "parameters");
  std::string copies;
  for (std::size_t i = 0; i < mechanism.layout.parameters.size(); ++i) {
    copies += fmt::format("precomputed->parameters[{0}] = parameters[{0}];\n", i);
  }
  return {c_item({.type = "void",
                  .name = scene + "_default_parameters",
                  .arguments = "torsor_real* parameters",
                  .documentation = "Values of the scene.",
                  .unused = "(void)parameters",
                  .body = print(mechanism.default_parameters, language)}),
          c_item({.type = "void",
                  .name = scene + "_precompute",
                  .arguments = fmt::format("const torsor_real* parameters, {}_precomputed* precomputed", scene),
                  .documentation = "To be called again when a parameter changes.",
                  .unused = "(void)parameters, (void)precomputed",
                  .body = copies + print(mechanism.precompute, language)}),
          c_item({.type = "void",
                  .name = scene + "_initial_state",
                  .arguments = fmt::format("const torsor_real* parameters, {}_state* state", scene),
                  .documentation = "The state the scene starts from, for these parameters.",
                  .unused = "(void)parameters, (void)state",
                  .body = print(mechanism.initial_state, language)})};
}

std::vector<CItem> all_items(const MechanismListing& mechanism) {
  const std::string& scene = mechanism.scene().name();
  std::vector<CItem> items = c_description(mechanism);
  const auto add = [&items](const std::vector<CItem>& more) { items.insert(items.end(), more.begin(), more.end()); };
  for (const Structure& structure : mechanism.own) add(c_tables(scene, structure));
  add(preparations(mechanism));
  for (const KernelListing& each : mechanism.kernels) items.push_back(c_function(mechanism, each));
  return items;
}

/// All in the header.
std::string as_inline(const CItem& item) {
  if (item.definition.empty()) return documentation_comment(item.documentation) + item.declaration + ";\n";
  const std::string signature = (item.is_table ? "TORSOR_UNUSED static " : "TORSOR_UNUSED static inline ") + item.declaration;
  return documentation_comment(item.documentation) +
         (item.is_table ? wrapped(signature + item.definition, 0) : wrapped(signature + " {", 0) + item.definition.substr(2)) +
         "\n";
}

std::string as_declaration(const CItem& item) {
  const bool external = item.is_table && !item.definition.empty();
  return documentation_comment(item.documentation) + wrapped((external ? "extern " : "") + item.declaration + ";", 0) + "\n";
}

std::string as_definition(const CItem& item) {
  if (item.definition.empty()) return "";
  return (item.is_table ? wrapped(item.declaration + item.definition, 0)
                        : wrapped(item.declaration + " {", 0) + item.definition.substr(2)) +
         "\n";
}

template <class Text>
std::string texts(const std::vector<CItem>& items, const Text& text) {
  std::string all;
  for (const CItem& item : items) {
    const std::string one = text(item);
    const bool apart = !all.empty() && !one.empty() && (!item.is_table || !item.documentation.empty());
    all += (apart ? "\n" : "") + one;
  }
  return all;
}

std::string functions_support() {
  return fill_template("support.h.in", template_without_licence("support.h.in"), {{"sines", template_without_licence("sines_registers.h")}});
}

}  // namespace

std::string shared_c_support() {
  return fill_template("shared_support.h.in", embedded_template("shared_support.h.in"),
                       {{"version", TORSOR_VERSION}, {"support", template_without_licence("support_types.h") + functions_support()}});
}

CText emit_c(const MechanismListing& mechanism, const COptions& options) {
  const std::string& scene = mechanism.scene().name();
  require_cpp_name(scene, "scene");
  const Layout& layout = mechanism.layout;
  std::string structures, members;
  for (const Structure& each : mechanism.own) structures += c_structure(scene, each);
  for (const PrecomputedMember& each : mechanism.members) members += fmt::format("torsor_real {};\n", each.name);
  const std::vector<CItem> items = all_items(mechanism);
  Provenance provenance = provenance_of(mechanism, "c99", "h");
  provenance.support = options.support;
  provenance.source = options.included_header.empty() ? "" : options.source;
  const bool apart = !options.included_header.empty();
  const std::string support =
      options.support.empty() ? template_without_licence("support_types.h") + (apart ? "" : functions_support())
                              : fmt::format("#include \"{}\"\n", options.support);
  const auto size = [](const auto& list) { return std::to_string(list.size()); };
  CText text;
  text.header = fill_template("mechanism.h.in", embedded_template("mechanism.h.in"),
                              {{"provenance", provenance_comment(provenance)},
                               {"guard", "TORSOR_" + scene + "_H"},
                               {"support", support},
                               {"scene_name", scene},
                               {"coordinate_count", size(layout.coordinates)},
                               {"velocity_count", size(layout.velocities)},
                               {"input_count", size(layout.inputs)},
                               {"parameter_count", size(layout.parameters)},
                               {"multiplier_count", size(layout.multipliers)},
                               {"quaternion_count", size(quaternion_places(mechanism))},
                               {"kernel_count", size(mechanism.kernels)},
                               {"coordinate_size", array_size(layout.coordinates.size())},
                               {"velocity_size", array_size(layout.velocities.size())},
                               {"parameter_size", array_size(layout.parameters.size())},
                               {"places", places_text(scene, layout)},
                               {"precomputed_members", members},
                               {"structures", structures},
                               {"items", apart ? texts(items, as_declaration) : texts(items, as_inline)}});
  if (apart) {
    text.source = fill_template("mechanism.c.in", embedded_template("mechanism.c.in"),
                                {{"header", options.included_header},
                                 {"support", options.support.empty() ? functions_support() : ""},
                                 {"items", texts(items, as_definition)}});
  }
  return text;
}

}  // namespace torsor
