// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/library_sources.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/emission/embedded_runtime_texts.hpp"
#include "generator/emission/embedded_templates.hpp"
#include "generator/emission/header.hpp"
#include "generator/emission/text_template.hpp"

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

}  // namespace

std::vector<SourceFile> library_sources(const MechanismListing& mechanism) {
  const std::string name = mechanism.scene().name();
  std::vector<SourceFile> files;
  files.push_back(
      {"library.cpp",
       fill_template("library.cpp.in", embedded_template("library.cpp.in"),
                     {{"version", TORSOR_VERSION},
                      {"name", name},
                      {"constraints", holds_constraints(mechanism) ? "#define TORSOR_ABI_WITH_CONSTRAINTS\n" : ""}})});
  files.push_back({name + ".hpp", emit_header(mechanism)});
  for (const std::string_view header : embedded_runtime_text_names()) {
    if (header.starts_with("contacts/") || header.starts_with("events/") || header.starts_with("library.")) continue;
    files.push_back({fmt::format("runtime/{}", header), std::string(embedded_runtime_text(header))});
  }
  return files;
}

}  // namespace torsor
