// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/library_sources.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/emission/embedded_runtime_texts.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/size_table.hpp"
#include "torsor/generator/emission/text_template.hpp"
#include "torsor/generator/kernels/kernel_sizes.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

bool has_kernel(const MechanismListing& mechanism, const std::string& name) {
  return std::any_of(mechanism.kernels.begin(), mechanism.kernels.end(),
                     [&name](const KernelListing& each) { return each.kernel.name == name; });
}

/// Whether it has motions that are held on constraints.
bool holds_constraints(const MechanismListing& mechanism) {
  return !mechanism.layout.multipliers.empty() && has_kernel(mechanism, "forward_dynamics");
}

/// The table of contacts, as runtime/abi.h has them: `{"foot", "m", "N", 1, 2}`.
std::string contact_table(const MechanismListing& mechanism) {
  if (mechanism.scene().content().contacts.empty()) return {};
  std::string entries;
  for (const ContactRows& contact : contact_rows(mechanism.equations->model())) {
    const Unit& gap = contact.gap.unit();
    const std::string gap_unit = !contact.normal ? "" : gap.is_dimensionless() ? "rad" : written_unit(gap);
    entries += fmt::format("{}\n      {{\"{}\", \"{}\", \"{}\", {}, {}}}", entries.empty() ? "" : ",", contact.name,
                           gap_unit,
                           written_unit(units::joule / (contact.rows[0].rate.unit() * units::second)),
                           contact.normal ? 1 : 0, contact.tangents());
  }
  return "{" + entries + "}";
}

std::vector<SizeBound> bounds_of(const Scene& scene, const ModelOptions& options) {
  return bounds_that_depend_on(scene.content(), run_time_parameters(scene, options));
}

/// The sizes that run-time parameters bear on, as the library compares them.
std::string size_structure(const MechanismListing& mechanism) {
  const std::vector<SizeBound> bounds = bounds_of(mechanism.scene(), mechanism.options);
  if (bounds.empty()) return "using Sizes = torsor::runtime::abi::NoSizes;\n";
  constexpr const char* type = "torsor::runtime::abi::SizeCheck";
  return fmt::format("struct Sizes {{\n  static constexpr std::size_t numbers = {};\n"
                     "  static constexpr std::array<{}, {}> sizes{{{{{}}}}};\n}};\n",
                     count_of_numbers(bounds), type, bounds.size(), size_table(bounds, std::string(type) + "::"));
}

}  // namespace

MechanismListing lower_library(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options) {
  std::vector<FurtherKernel> further;
  if (std::vector<SizeBound> bounds = bounds_of(scene, options); !bounds.empty()) {
    further.push_back({"run_time_sizes", [bounds](const Equations& equations) { return make_sizes(equations, bounds); }});
  }
  return lower_mechanism(scene, kernels, options, further);
}

std::string contact_layer_includes() {
  std::string text =
      "#if !__has_include(<Eigen/Core>)\n#error \"what moves contacts needs the folder of Eigen/Core, Eigen 3, among those "
      "that are searched for headers\"\n#endif\n#ifndef TORSOR_CONTACT_LAYER_APART\n";
  for (const std::string_view name : embedded_runtime_text_names()) {
    if (name.ends_with(".cpp")) text += fmt::format("#include \"torsor/runtime/{}\"\n", name);
  }
  return text + "#endif\n";
}

std::vector<SourceFile> contact_layer_sources() {
  std::vector<SourceFile> files = {{"contact_layer.cpp", contact_layer_includes()}};
  for (const std::string_view name : embedded_runtime_text_names()) {
    files.push_back({fmt::format("torsor/runtime/{}", name), std::string(embedded_runtime_text(name))});
  }
  return files;
}

std::size_t room_for_contacts(const Scene& scene) {
  std::size_t room = 2;
  while (room < scene.content().contacts.size()) room *= 2;
  return room;
}

std::vector<SourceFile> library_sources(const MechanismListing& mechanism) {
  const std::string name = mechanism.scene().name();
  const std::size_t contacts = mechanism.scene().content().contacts.size();
  std::vector<SourceFile> files;
  files.push_back({name + ".hpp", emit_header(mechanism)});
  std::string sources;
  for (const std::string_view text : embedded_runtime_text_names()) {
    const bool of_contacts = text.starts_with("contacts/") || text.starts_with("events/") || text.starts_with("library.") ||
                             text == "abi/contact_call.hpp";
    if (of_contacts && contacts == 0) continue;
    files.push_back({fmt::format("torsor/runtime/{}", text), std::string(embedded_runtime_text(text))});
  }
  if (contacts > 0) sources = contact_layer_includes();
  const std::string definitions = std::string(holds_constraints(mechanism) ? "#define TORSOR_ABI_WITH_CONSTRAINTS\n" : "") +
                                  (contacts > 0 ? "#define TORSOR_ABI_WITH_CONTACTS\n" : "");
  files.insert(files.begin(), {"library.cpp", fill_template("library.cpp.in", embedded_template("library.cpp.in"),
                                                            {{"version", TORSOR_VERSION},
                                                             {"name", name},
                                                             {"definitions", definitions},
                                                             {"sources", sources},
                                                             {"contact_count", std::to_string(contacts)},
                                                             {"contacts", contact_table(mechanism)},
                                                             {"sizes", size_structure(mechanism)}})});
  return files;
}

}  // namespace torsor
