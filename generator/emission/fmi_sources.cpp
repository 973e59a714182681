// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_sources.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"
#include "torsor/generator/emission/c_header.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/embedded_licence_texts.hpp"
#include "torsor/generator/emission/embedded_runtime_texts.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/fmi_description.hpp"
#include "torsor/generator/emission/fmi_variables.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/size_table.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

std::string source_name(const FmiUnit& unit) {
  return fmt::format("{}_fmi{}.c", unit.name(), unit.version == FmiVersion::two ? 2 : 3);
}

std::string contact_source_name(const FmiUnit& unit) { return unit.name() + "_contacts.cpp"; }

/// "1, 0": for each multiplier whether its constraint is f(q, t) = 0.
std::string holonomic_rows(const MechanismListing& mechanism) {
  if (mechanism.layout.multipliers.empty()) return {};
  std::string text;
  for (const ConstraintRow& row : mechanism.equations->constraints()) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", row.holonomic ? 1 : 0);
  }
  return text;
}

/// `"foot", "stop_lower"`.
std::string names_of_contacts(const Scene& scene) {
  std::string names;
  for (const ContactContent& contact : scene.content().contacts) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", contact.name);
  }
  return names;
}

/// "1, 0": for each velocity whether it is that of a turn.
std::string turning_velocities(const Model& model) {
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", freedom_turns(model, i) ? 1 : 0);
  }
  return text;
}

/// What is said of each quaternion where it is zero.
std::string zero_quaternions(const MechanismListing& mechanism) {
  std::string texts;
  for (const std::size_t place : quaternion_places(mechanism)) {
    std::string names;
    for (std::size_t k = place; k < place + 4; ++k) {
      names += fmt::format("{}q.{}", k == place ? "" : ", ", mechanism.layout.coordinates[k]->name);
    }
    texts += (texts.empty() ? "" : ", ") +
             sentence_literal("the quaternion (" + names + ") is zero, which is no attitude: set one of norm 1");
  }
  return texts;
}

}  // namespace

std::vector<SourceFile> fmi_contact_sources(const FmiUnit& unit) {
  // Told in the text, for version 2.0 has no place for definitions that a compiler is to be given.
  const std::string room = fmt::format("#ifndef TORSOR_MOST_CONTACTS\n#define TORSOR_MOST_CONTACTS {}\n#endif\n",
                                       room_for_contacts(unit.scene()));
  const auto filled = [&](const std::string& file, std::map<std::string, std::string> texts) {
    texts.insert({{"name", unit.name()}, {"version", TORSOR_VERSION}, {"room", room}});
    return fill_template(file, embedded_template(file), texts);
  };
  std::vector<SourceFile> files = contact_layer_sources();
  SourceFile& layer = files.front();
  layer.text = filled("fmi/contact_layer.cpp.in", {{"layer", layer.text}});
  std::erase_if(files, [](const SourceFile& file) { return file.path.starts_with("torsor/runtime/abi"); });
  const std::string has_inputs = unit.mechanism.layout.inputs.empty() ? "0" : "1";
  const std::string moving = filled("fmi/contacts.cpp.in", {{"has_inputs", has_inputs}, {"contacts", names_of_contacts(unit.scene())}});
  files.insert(files.begin(), {contact_source_name(unit), moving});
  files.push_back({unit.name() + ".hpp", emit_header(unit.mechanism)});
  return files;
}

std::vector<SourceFile> fmi_sources(const FmiUnit& unit) {
  const std::string& name = unit.name();
  const MechanismListing& mechanism = unit.mechanism;
  const auto flag = [](bool holds) { return std::string(holds ? "1" : "0"); };
  const bool has_rates = std::any_of(mechanism.kernels.begin(), mechanism.kernels.end(),
                                     [](const KernelListing& each) { return each.kernel.name == "coordinate_rates"; });
  using Texts = std::map<std::string, std::string>;
  const Texts all = {{"name", name},
                     {"version", TORSOR_VERSION},
                     {"token", fmi_token(unit)},
                     {"has_rates", flag(has_rates)},
                     {"has_inputs", flag(!mechanism.layout.inputs.empty())},
                     {"has_parameters", flag(!mechanism.layout.parameters.empty())},
                     {"has_multipliers", flag(!mechanism.layout.multipliers.empty())},
                     {"has_contacts", flag(unit.has_contacts())},
                     {"indicators", std::to_string(fmi_indicators(mechanism).size())},
                     {"places", std::to_string(unit.place_count())},
                     {"reactions", std::to_string(unit.outputs.reactions.size())},
                     {"holonomic", holonomic_rows(mechanism)},
                     {"size_count", std::to_string(unit.sizes.size())},
                     {"size_numbers", std::to_string(count_of_numbers(unit.sizes))},
                     {"sizes", size_table(unit.sizes, "torsor_fmi_")},
                     {"quaternion_count", std::to_string(quaternion_places(mechanism).size())},
                     {"no_attitudes", zero_quaternions(mechanism)},
                     {"turns", turning_velocities(mechanism.equations->model())}};
  const auto filled = [&all](const std::string& file, const std::vector<std::string>& placeholders) {
    Texts texts = {{"name", all.at("name")}, {"version", all.at("version")}};
    for (const std::string& each : placeholders) texts.emplace(each, all.at(each));
    return fill_template(file, embedded_template(file), texts);
  };
  const bool two = unit.version == FmiVersion::two;
  std::vector<SourceFile> sources = {
      {source_name(unit), two ? filled("fmi/fmi2.c.in", {}) : filled("fmi/fmi3.c.in", {})},
      {"fmi_model.h", filled("fmi/model.h.in", {"token", "has_rates", "indicators", "places", "reactions"})},
      {"fmi_sizes.h", filled("fmi/sizes.h.in", {"size_count", "size_numbers", "sizes"})},
      {"fmi_attitudes.h", filled("fmi/attitudes.h.in", {"has_contacts", "quaternion_count", "no_attitudes"})},
      {"fmi_derivatives.h", filled("fmi/derivatives.h.in", {"has_rates", "has_inputs", "has_parameters",
                                                            "has_multipliers", "has_contacts", "places", "reactions"})},
      {"fmi_motion.h", filled("fmi/motion.h.in", {"has_multipliers", "has_contacts", "holonomic", "turns"})},
      {name + ".h", emit_c(mechanism).header}};
  using Names = std::vector<const char*>;
  for (const char* file : two ? Names{"fmi2_names.h"} : Names{"fmi3_names.h", "fmi3_types.h", "fmi3_absent.h"}) {
    const std::string of = fmt::format("fmi/{}.in", file);
    sources.push_back({file, fill_template(of, embedded_template(of), {{"version", TORSOR_VERSION}})});
  }
  return sources;
}

std::string fmi_build_description(const FmiUnit& unit) {
  // Functions of math.h are a library of their own, but for Windows. Options differ by compiler, and none is needed.
  std::string all;
  for (const char* platform : {"x86_64-windows", "x86-windows", ""}) {
    const bool windows = *platform != '\0';
    all += fmt::format("  <BuildConfiguration modelIdentifier=\"{}\"{}{}>\n", unit.name(),
                       windows ? fmt::format(" platform=\"{}\"", platform) : "",
                       unit.has_contacts() ? " description=\"needs the headers of Eigen 3 where the compiler finds them\"" : "");
    all += fmt::format("    <SourceFileSet language=\"C99\">\n      <SourceFile name=\"{}\"/>\n    </SourceFileSet>\n",
                       source_name(unit));
    if (unit.has_contacts()) {
      all += fmt::format("    <SourceFileSet language=\"C++20\">\n      <SourceFile name=\"{}\"/>\n"
                         "      <SourceFile name=\"contact_layer.cpp\"/>\n      <IncludeDirectory name=\".\"/>\n"
                         "    </SourceFileSet>\n", contact_source_name(unit));
    }
    if (!windows) all += "    <Library name=\"m\" external=\"true\" description=\"functions of math.h\"/>\n";
    all += fmt::format("  </BuildConfiguration>{}", windows ? "\n" : "");
  }
  return fill_template("fmi/buildDescription.xml.in", embedded_template("fmi/buildDescription.xml.in"),
                       {{"configurations", all}});
}

std::vector<SourceFile> fmi_licence_files(const FmiUnit& unit) {
  const std::string file = unit.has_contacts() ? "fmi/license_with_contacts.txt.in" : "fmi/license.txt.in";
  std::vector<SourceFile> files = {
      {"license.txt", fill_template(file, embedded_template(file), {{"name", unit.name()}})},
      {"MIT-0.txt", std::string(embedded_licence_text("MIT-0.txt"))}};
  if (unit.has_contacts()) files.push_back({"MIT.txt", std::string(embedded_licence_text("MIT.txt"))});
  return files;
}

}  // namespace torsor
