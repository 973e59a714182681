// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/header.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "generator/emission/cpp_function.hpp"
#include "generator/emission/cpp_language.hpp"
#include "generator/emission/cpp_names.hpp"
#include "generator/emission/cpp_structures.hpp"
#include "generator/emission/embedded_templates.hpp"
#include "generator/emission/formula_printer.hpp"
#include "generator/emission/kernel_kinematics.hpp"
#include "generator/emission/listing_printer.hpp"
#include "generator/emission/provenance.hpp"
#include "generator/emission/start_values.hpp"
#include "generator/emission/text_template.hpp"
#include "generator/expression/error.hpp"
#include "generator/expression/fnv.hpp"

namespace torsor {
namespace {

/// Members of Precomputed behind the parameters.
std::string precomputed_structure(const Program& program, const Schedule& schedule) {
  std::string text;
  for (std::size_t k = 0; k < precomputed_count(schedule); ++k) {
    const std::string meaning = k < schedule.members.size() ? program[schedule.members[k]].name : "";
    text += fmt::format("Scalar {};{}\n", precomputed_name(program, schedule, k),
                        meaning.empty() ? "" : "  ///< " + comment_text(meaning));
  }
  return text;
}

Layout layout_of(const Equations& equations, const std::vector<SymbolPointer>& parameters) {
  const Model& model = equations.model();
  Layout layout;
  layout.coordinates = model.positions();
  for (int i = 0; i < model.unknown_count(); ++i) {
    const CoordinateContent& coordinate = model.coordinates()[static_cast<std::size_t>(i)];
    layout.velocities.push_back(coordinate.v);
    layout.accelerations.push_back(coordinate.a);
  }
  layout.inputs = model.inputs();
  for (const ConstraintContent& constraint : model.scene().constraints) layout.multipliers.push_back(constraint.multiplier);
  layout.parameters = parameters;
  return layout;
}

/// Structures of all kernels; two kernels may share one when it is the same.
std::vector<Structure> kernel_structures(const std::vector<Kernel>& kernels) {
  std::vector<Structure> all;
  for (const Kernel& kernel : kernels) {
    for (const Structure& structure : kernel.structures) {
      const bool known =
          std::any_of(all.begin(), all.end(), [&](const Structure& each) { return each.name == structure.name; });
      if (!known) all.push_back(structure);
    }
  }
  return all;
}

/// Where the quaternions lie among the coordinates, for the runtime, which keeps their norm.
std::string quaternion_table(const Model& model) {
  std::string first;
  int count = 0;
  const std::vector<SymbolPointer> positions = model.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto attitude = positions[i]->attitude.lock();
    if (!attitude || attitude->e[0] != positions[i]) continue;
    first += (first.empty() ? "" : ", ") + std::to_string(i);
    ++count;
  }
  if (count == 0) return "";
  return fmt::format(
      "/// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).\n"
      "static constexpr int quaternion_count = {};\nstatic constexpr int quaternions[] = {{{}}};\n",
      count, first);
}

/// Which multipliers are zero because their constraints repeat others, for the runtime, which cannot solve for them.
std::string redundancy_table(const Equations& equations) {
  if (equations.constraints().empty() || !equations.redundancy().redundant()) return "";
  const std::vector<std::size_t>& dropped = equations.redundancy().dropped;
  return fmt::format(
      "/// Multipliers that are taken as zero: their constraints repeat others.\n"
      "static constexpr int redundant_count = {};\nstatic constexpr int redundant_multipliers[] = {{{}}};\n",
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
      "static constexpr Limits limits[] = {\n";
  for (auto c = freedoms; c != end; ++c) {
    const CoordinateLimits limits = c->limits.value_or(CoordinateLimits());
    text += fmt::format("    {{{}, {}, {}, {}}},  // {}\n", bound(limits.lower, "-HUGE_VAL"),
                        bound(limits.upper, "HUGE_VAL"), bound(limits.velocity, "HUGE_VAL"),
                        bound(limits.effort, "HUGE_VAL"), c->q->name);
  }
  return text + "};\n";
}

/// Vectors of the initial state whose entries have names.
std::map<std::string, const Structure*> start_vectors(const std::vector<Structure>& structures) {
  std::map<std::string, const Structure*> vectors;
  for (const Structure& each : structures) {
    if (each.name == "Coordinates") vectors.emplace("state.q", &each);
    if (each.name == "Velocities") vectors.emplace("state.v", &each);
  }
  return vectors;
}

std::string blocks_text(const std::vector<std::string>& blocks) {
  std::string text;
  for (const std::string& block : blocks) text += (text.empty() ? "" : "\n") + block;
  return text;
}

}  // namespace

std::string emit_header(const Equations& equations, const std::vector<Kernel>& kernels, const HeaderOptions& options) {
  const Scene& scene = equations.scene();
  Program& program = equations.program();
  require_cpp_name(scene.name(), "scene");
  const std::vector<SymbolPointer> parameters = run_time_parameters(scene, options.model);
  std::vector<Kernel> present;
  if (has_quaternions(equations.model())) present.push_back(make_coordinate_rates(equations));
  std::copy_if(kernels.begin(), kernels.end(), std::back_inserter(present),
               [](const Kernel& kernel) { return kernel.skipped.empty(); });

  std::vector<Structure> structures = common_structures(equations, parameters);
  std::vector<std::string> common_text;
  for (const Structure& structure : structures) common_text.push_back(structure_text(structure));
  std::vector<std::string> structure_texts;
  std::size_t first_integrals = 0;
  for (const Structure& structure : kernel_structures(present)) {
    std::string text = structure_text(structure);
    if (structure.name == "FirstIntegrals") first_integrals = structure.members.size();
    text += structure.tables;
    structure_texts.push_back(std::move(text));
    structures.push_back(structure);
  }

  std::vector<std::vector<Value>> values_of_kernels;
  for (const Kernel& kernel : present) values_of_kernels.push_back(kernel.values());
  const Schedule schedule = make_schedule(program, values_of_kernels);
  HeaderParts parts{&program, &schedule, layout_of(equations, parameters), structures};
  for (std::size_t k = 0; k < precomputed_count(schedule); ++k) {
    parts.members.push_back(precomputed_name(program, schedule, k));
  }
  const CppLanguage start_language(parts.layout, "parameters.", {}, start_vectors(structures));
  const Listing precompute = lower_precompute(program, schedule, parts.layout);
  Provenance provenance{&scene, options.model, kernels, parameters, {}};
  provenance.notes = notes(equations.redundancy(), scene);
  if (const OperationCount once = count(precompute); once.total() > 0) {
    provenance.operations.push_back({"precompute", once, std::nullopt});
  }
  // Before: no inertia moved across joints, no products shared, no factoring, nothing done once for a set of parameters.
  const Equations unoptimised(scene, as_given(options.model));
  std::vector<std::string> functions;
  for (std::size_t k = 0; k < present.size(); ++k) {
    FunctionText function = cpp_function(parts, present[k], schedule.functions[k]);
    if (present[k].name != "coordinate_rates") {
      std::optional<int> before;  // recurrences have nothing to be compared with
      if (!present[k].series) {
        const std::vector<Value> values = make_kernel(present[k].name, unoptimised).values();
        before = count_unoptimised(unoptimised.program(), values).total();
      }
      provenance.operations.push_back({present[k].name, function.operations, before});
    }
    functions.push_back(std::move(function.body));
  }

  const Listing start = initial_state(equations, options.model, parts.layout);
  const std::string precompute_body = print(precompute, start_language);
  const std::string start_body = print(start, start_language);
  const SceneContent& content = scene.content();
  const auto size = [](std::size_t count) { return std::to_string(count); };
  const std::string degrees = std::to_string(equations.model().unknown_count());
  const auto without_licence = [](std::string_view text) { return std::string(text.substr(text.find('\n') + 1)); };
  const bool jets = std::any_of(present.begin(), present.end(), [](const Kernel& kernel) { return kernel.series.has_value(); });
  const auto selects = [](const std::string& body) { return body.find("torsor::Selections<") != std::string::npos; };
  const bool selections = selects(precompute_body) || selects(start_body) || std::any_of(functions.begin(), functions.end(), selects);
  const std::string selection_support =
      selections ? without_licence(embedded_template("selections.hpp")) + "\n" : "";
  std::map<std::string, std::string> values = {
      {"provenance", provenance_comment(provenance)},
      {"scene_name", scene.name()},
      {"sincos", without_licence(embedded_template("sincos.hpp")) +
                     without_licence(embedded_template("sincos_registers.hpp"))},
      {"jet_support", selection_support + (jets ? without_licence(embedded_template("jets.hpp")) + "\n" : "")},
      {"coordinate_count", size(equations.model().positions().size())},
      {"velocity_count", degrees},
      {"input_count", size(equations.model().inputs().size())},
      {"parameter_count", size(parameters.size())},
      {"multiplier_count", size(content.constraints.size())},
      {"first_integral_count", size(first_integrals)},
      {"quaternions",
       quaternion_table(equations.model()) + redundancy_table(equations) + limits_table(equations.model())},
      {"structures", blocks_text(common_text)},
      {"precomputed_members", precomputed_structure(program, schedule)},
      {"default_parameters", print(default_parameters(scene, parameters), start_language)},
      {"precompute", precompute_body},
      {"initial_parameters", start.reads(Table::parameter) ? " parameters" : ""},
      {"initial_state", start_body},
      {"kernel_structures", structure_texts.empty() ? "" : blocks_text(structure_texts) + "\n"},
      {"kernels", blocks_text(functions)}};
  const auto with_fingerprint = [&values](std::uint64_t bits) {
    values["fingerprint"] = fmt::format("{:016x}", bits);
    return fill_template("mechanism.hpp.in", embedded_template("mechanism.hpp.in"), values);
  };
  const std::string text = with_fingerprint(0);
  // Not of the head comment, which tells where the scene came from and where the header was written to.
  return with_fingerprint(Fnv().add(std::string_view(text).substr(text.find("#pragma once"))).value());
}

}  // namespace torsor
