// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_sources.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "torsor/generator/emission/c_header.hpp"
#include "torsor/generator/emission/embedded_runtime_texts.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/fmi_variables.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

std::string source_name(const MechanismListing& mechanism, FmiVersion version) {
  return fmt::format("{}_fmi{}.c", mechanism.scene().name(), version == FmiVersion::two ? 2 : 3);
}

/// "1, 0": for each multiplier whether its constraint is f(q, t) = 0.
std::string holonomic_rows(const MechanismListing& mechanism) {
  if (mechanism.layout.multipliers.empty()) return {};
  std::string text;
  for (const ConstraintRow& row : mechanism.equations->constraints()) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", row.holonomic ? 1 : 0);
  }
  return text;
}

}  // namespace

std::vector<std::string> fmi_kernels(const Scene& scene) {
  std::vector<std::string> names = {"forward_dynamics", "energy", "forward_dynamics_derivatives"};
  const bool contacts = !scene.content().contacts.empty();
  if (contacts || !scene.content().constraints.empty()) names.push_back("mass_matrix");
  if (!scene.content().constraints.empty()) names.push_back("constraints");
  if (contacts) names.insert(names.end(), {"bias", "contacts", "contact_coefficients"});
  return names;
}

std::vector<SourceFile> fmi_contact_sources(const MechanismListing& mechanism) {
  const std::string& name = mechanism.scene().name();
  std::vector<SourceFile> files = {{name + "_contacts.cpp",
                                    fill_template("fmi/contacts.cpp.in", embedded_template("fmi/contacts.cpp.in"),
                                                  {{"name", name},
                                                   {"version", TORSOR_VERSION},
                                                   {"has_inputs", mechanism.layout.inputs.empty() ? "0" : "1"}})},
                                   {name + ".hpp", emit_header(mechanism)}};
  for (const std::string_view text : embedded_runtime_text_names()) {
    files.push_back({fmt::format("torsor/runtime/{}", text), std::string(embedded_runtime_text(text))});
  }
  return files;
}

std::vector<SourceFile> fmi_sources(const MechanismListing& mechanism, FmiVersion version) {
  const std::string& name = mechanism.scene().name();
  const auto flag = [](bool holds) { return std::string(holds ? "1" : "0"); };
  const bool has_rates =
      std::any_of(mechanism.kernels.begin(), mechanism.kernels.end(),
                  [](const KernelListing& each) { return each.kernel.name == "coordinate_rates"; });
  using Texts = std::map<std::string, std::string>;
  const std::string has_contacts = flag(!mechanism.scene().content().contacts.empty());
  const std::string has_multipliers = flag(!mechanism.layout.multipliers.empty());
  const auto filled = [&name](const std::string& file, Texts texts) {
    texts.insert({{"name", name}, {"version", TORSOR_VERSION}});
    return fill_template(file, embedded_template(file), texts);
  };
  const bool two = version == FmiVersion::two;
  std::vector<SourceFile> sources = {
      {source_name(mechanism, version),
       filled(two ? "fmi/fmi2.c.in" : "fmi/fmi3.c.in", {{"token", fmi_token(mechanism, version)}})},
      {"fmi_model.h", filled("fmi/model.h.in", {{"has_rates", flag(has_rates)},
                                                {"indicators", std::to_string(fmi_indicators(mechanism).size())},
                                                {"has_inputs", flag(!mechanism.layout.inputs.empty())},
                                                {"has_multipliers", has_multipliers}})},
      {"fmi_motion.h",
       filled("fmi/motion.h.in", {{"has_multipliers", has_multipliers},
                                  {"has_contacts", has_contacts},
                                  {"holonomic", holonomic_rows(mechanism)}})},
      {name + ".h", emit_c(mechanism).header}};
  for (const char* file : {"fmi3_types.h", "fmi3_absent.h"}) {
    const std::string of = fmt::format("fmi/{}.in", file);
    if (!two) sources.push_back({file, fill_template(of, embedded_template(of), {{"version", TORSOR_VERSION}})});
  }
  return sources;
}

std::string fmi_build_description(const MechanismListing& mechanism) {
  return fill_template("fmi/buildDescription.xml.in", embedded_template("fmi/buildDescription.xml.in"),
                       {{"name", mechanism.scene().name()}, {"source", source_name(mechanism, FmiVersion::three)}});
}

}  // namespace torsor
