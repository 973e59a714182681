// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {
namespace {

nlohmann::ordered_json to_json(const OperationCount& count) {
  return {{"additions", count.additions},         {"multiplications", count.multiplications},
          {"divisions", count.divisions},         {"square_roots", count.square_roots},
          {"sincos_pairs", count.sincos_pairs},   {"others", count.others},
          {"total", count.total()}};
}

std::string row(const std::string& name, const OperationCount& c) {
  return fmt::format("{:<37}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", name, c.additions, c.multiplications,
                     c.divisions, c.square_roots, c.sincos_pairs, c.others, c.total());
}

}  // namespace

SceneCounts count_mechanism(const MechanismListing& mechanism) {
  SceneCounts counts{mechanism.scene().name(), {}, {}, {}};
  const Equations& equations = *mechanism.equations;
  std::vector<Value> all;
  OperationCount series;  // its recurrences stand in no program and share nothing with other kernels
  for (const KernelListing& each : mechanism.kernels) {
    if (each.kernel.name == "coordinate_rates") continue;
    counts.kernels.emplace_back(each.kernel.name, count(each.listing));
    if (each.listing.recurrence) {
      series += counts.kernels.back().second;
      continue;
    }
    const std::vector<Value> values = make_kernel(each.kernel.name, equations).values();
    all.insert(all.end(), values.begin(), values.end());
  }
  counts.joint = count(equations.program(), all);
  counts.joint += series;
  counts.precompute = count(mechanism.precompute);
  return counts;
}

SceneCounts count_scene(const Scene& scene, const std::vector<std::string>& names, const ModelOptions& options) {
  return count_mechanism(lower_mechanism(scene, names, options));
}

std::string counts_table(const std::vector<SceneCounts>& scenes) {
  std::string text;
  for (const SceneCounts& scene : scenes) {
    text += fmt::format("{}{}\n{:<37}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", text.empty() ? "" : "\n", scene.name,
                        "kernel", "add", "multiply", "divide", "sqrt", "sincos", "others", "total");
    for (const auto& [name, count] : scene.kernels) text += row(name, count);
    if (scene.precompute.total() > 0) text += row("precompute, once", scene.precompute);
    if (scene.kernels.size() > 1) text += row("all in one program", scene.joint);
  }
  return text;
}

std::string counts_json(const std::vector<SceneCounts>& scenes) {
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const SceneCounts& scene : scenes) {
    nlohmann::ordered_json model{{"name", scene.name}, {"kernels", nlohmann::ordered_json::object()}};
    for (const auto& [name, count] : scene.kernels) model["kernels"][name] = to_json(count);
    model["joint"] = to_json(scene.joint);
    if (scene.precompute.total() > 0) model["precompute"] = to_json(scene.precompute);
    models.push_back(std::move(model));
  }
  return (models.size() == 1 ? models[0] : nlohmann::ordered_json{{"models", models}}).dump(2) + "\n";
}

}  // namespace torsor
