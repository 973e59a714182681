// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/header.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/emission/cpp_description.hpp"
#include "torsor/generator/emission/cpp_function.hpp"
#include "torsor/generator/emission/cpp_language.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/emission/cpp_structures.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/formula_printer.hpp"
#include "torsor/generator/emission/listing_printer.hpp"
#include "torsor/generator/emission/support.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {
namespace {

/// Members of Precomputed behind the parameters.
std::string precomputed_structure(const MechanismListing& mechanism) {
  std::string text;
  for (const PrecomputedMember& each : mechanism.members) {
    text += fmt::format("Scalar {};{}\n", each.name, each.meaning.empty() ? "" : "  ///< " + comment_text(each.meaning));
  }
  return text;
}

/// Where the quaternions lie among the coordinates, for the runtime, which keeps their norm.
std::string quaternion_table(const MechanismListing& mechanism) {
  const std::vector<std::size_t> places = quaternion_places(mechanism);
  if (places.empty()) return "";
  return fmt::format(
      "/// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).\n"
      "static constexpr int quaternion_count = {};\nstatic constexpr int quaternions[quaternion_count] = {{{}}};\n",
      places.size(), fmt::join(places, ", "));
}

/// Which multipliers are zero because their constraints repeat others, for the runtime, which cannot solve for them.
std::string redundancy_table(const Equations& equations) {
  if (equations.constraints().empty() || !equations.redundancy().redundant()) return "";
  const std::vector<std::size_t>& dropped = equations.redundancy().dropped;
  return fmt::format(
      "/// Multipliers that are taken as zero: their constraints repeat others.\n"
      "static constexpr int redundant_count = {};\nstatic constexpr int redundant_multipliers[redundant_count] = {{{}}};\n",
      dropped.size(), fmt::join(dropped, ", "));
}

/// What the scene says of the range of its freedoms, when it says anything.
std::string limits_table(const Model& model) {
  const auto freedoms = model.coordinates().begin();
  const auto end = freedoms + model.unknown_count();
  if (std::none_of(freedoms, end, [](const CoordinateContent& c) { return c.limits.has_value(); })) return "";
  const auto bound = [](const std::optional<Number>& value, const char* otherwise) {
    return value ? literal(value->to_double()) : std::string(otherwise);
  };
  std::string text =
      "/// Range of each freedom, largest rate and largest effort, by its index in v; infinite where the scene states "
      "none.\n/// Data: no kernel looks at them.\nstruct Limits { double lower, upper, velocity, effort; };\n"
      "static constexpr Limits limits[velocity_count] = {\n";
  for (auto c = freedoms; c != end; ++c) {
    const CoordinateLimits limits = c->limits.value_or(CoordinateLimits());
    text += fmt::format("    {{{}, {}, {}, {}}},  // {}\n", bound(limits.lower, "-HUGE_VAL"),
                        bound(limits.upper, "HUGE_VAL"), bound(limits.velocity, "HUGE_VAL"),
                        bound(limits.effort, "HUGE_VAL"), c->q->name);
  }
  return text + "};\n";
}

/// Vectors of the initial state whose entries have names.
std::map<std::string, const Structure*> start_vectors(const MechanismListing& mechanism) {
  return {{"state.q", mechanism.structure("Coordinates")}, {"state.v", mechanism.structure("Velocities")}};
}

std::string blocks_text(const std::vector<std::string>& blocks) {
  std::string text;
  for (const std::string& block : blocks) text += (text.empty() ? "" : "\n") + block;
  return text;
}

/// What stands in the template behind the head comment, which tells where the scene came from and where the header was
/// written to.
std::map<std::string, std::string> body_of(const MechanismListing& mechanism, const std::string& support) {
  const Equations& equations = *mechanism.equations;
  const Scene& scene = equations.scene();
  std::vector<std::string> common_text, structure_texts, functions;
  for (const Structure& structure : mechanism.common) common_text.push_back(structure_text(structure));
  for (const Structure& structure : mechanism.own) structure_texts.push_back(structure_text(structure) + cpp_tables(structure));
  const Structure* const integrals = mechanism.structure("FirstIntegrals");
  std::string visits;
  bool jets = false;
  for (const KernelListing& kernel : mechanism.kernels) {
    FunctionText function = cpp_function(mechanism, kernel);
    visits += wrapped(fmt::format("visitor(Description::kernels[{}], {});", functions.size(), function.pointer), 4) + "\n";
    functions.push_back(std::move(function.body));
    jets = jets || kernel.listing.recurrence;
  }
  const CppLanguage language(mechanism.layout, "parameters.", {}, start_vectors(mechanism));
  const std::string precompute_body = print(mechanism.precompute, language);
  const std::string start_body = print(mechanism.initial_state, language);
  const auto selects = [](const std::string& text) { return text.find("torsor::Selections<") != std::string::npos; };
  const bool selections =
      selects(precompute_body) || selects(start_body) || std::any_of(functions.begin(), functions.end(), selects);
  const auto size = [](std::size_t count) { return std::to_string(count); };
  const Model& model = equations.model();
  return {
      {"scene_name", scene.name()},
      {"support", support.empty() ? support_text(selections, jets) : fmt::format("#include \"{}\"\n", support)},
      {"of_support", support.empty() ? "" : " ^ torsor::support_fingerprint"},
      {"description", cpp_description(mechanism)},
      {"coordinate_count", size(model.positions().size())},
      {"velocity_count", std::to_string(model.unknown_count())},
      {"input_count", size(model.inputs().size())},
      {"parameter_count", size(mechanism.layout.parameters.size())},
      {"multiplier_count", size(scene.content().constraints.size())},
      {"first_integral_count", size(integrals == nullptr ? 0 : integrals->members.size())},
      {"quaternions", quaternion_table(mechanism) + redundancy_table(equations) + limits_table(model)},
      {"structures", blocks_text(common_text)},
      {"precomputed_members", precomputed_structure(mechanism)},
      {"default_parameters", print(mechanism.default_parameters, language)},
      {"precompute", precompute_body},
      {"initial_parameters", mechanism.initial_state.reads(Table::parameter) ? " parameters" : ""},
      {"initial_state", start_body},
      {"kernel_structures", structure_texts.empty() ? "" : blocks_text(structure_texts) + "\n"},
      {"kernels", blocks_text(functions)},
      {"visits", visits}};
}

std::string filled(std::map<std::string, std::string>& values, std::uint64_t fingerprint) {
  values["fingerprint"] = fmt::format("{:016x}", fingerprint);
  return fill_template("mechanism.hpp.in", embedded_template("mechanism.hpp.in"), values);
}

std::uint64_t fingerprint_of(const std::string& text) {
  return Fnv().add(std::string_view(text).substr(text.find("#pragma once"))).value();
}

}  // namespace

std::string emit_header(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options) {
  return emit_header(lower_mechanism(scene, kernels, options));
}

std::string emit_header(const MechanismListing& mechanism, const std::string& support) {
  require_cpp_name(mechanism.scene().name(), "scene");
  std::map<std::string, std::string> values = body_of(mechanism, support);
  Provenance provenance = provenance_of(mechanism);
  provenance.support = support;
  values.emplace("provenance", provenance_comment(provenance));
  return filled(values, fingerprint_of(filled(values, 0)));
}

std::uint64_t header_fingerprint(const MechanismListing& mechanism) {
  std::map<std::string, std::string> values = body_of(mechanism, "");
  values.emplace("provenance", "");
  return fingerprint_of(filled(values, 0));
}

}  // namespace torsor
