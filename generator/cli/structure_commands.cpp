// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/cli/kernel_options.hpp"

namespace torsor {
namespace {

struct StructureRequest {
  GraphRequest graph;
  bool json = false;
  KernelOptions kernels;
  std::string language = "en";
};

void add_inputs_outputs(CLI::App& command, StructureRequest& request) {
  command
      .add_option("--inputs-outputs", request.graph.inputs_outputs,
                  "joints that count as those with the outside, comma-separated; those of the ground when absent")
      ->delimiter(',')->allow_extra_args(false);
}

}  // namespace

void add_structure_commands(CommandSet& commands) {
  const auto request = std::make_shared<StructureRequest>();
  CLI::App& structure = commands.add(
      "structure", "count loops, mobility and redundancy; name what is internal or indeterminate",
      [request](const Scene& scene) {
        if (request->json && request->language != "en") {
          throw UsageError("--language is for text, and --json prints names that programs read: leave one of them out");
        }
        return CommandResult{request->json ? structure_json(scene, request->graph.inputs_outputs)
                                           : structure_text(scene, request->graph.inputs_outputs,
                                                            NaturalLanguage::named(request->language))};
      });
  add_inputs_outputs(structure, *request);
  structure.add_flag("--json", request->json, "print JSON");
  add_language(structure, request->language);

  CLI::App& graph = commands.add(
      "graph", "draw the graph of bodies and joints", [request](const Scene& scene) {
        if (request->graph.kind != "reduced" && !request->graph.inputs_outputs.empty()) {
          throw UsageError("--inputs-outputs is for --of reduced: the other graphs show all joints alike");
        }
        return CommandResult{graph_text(scene, request->graph, NaturalLanguage::named(request->language))};
      });
  add_inputs_outputs(graph, *request);
  graph.add_option("--format", request->graph.format, "dot (for Graphviz) or svg")->capture_default_str();
  graph.add_option("--of", request->graph.kind, "structure, analysis (with constraints and actions) or reduced")
      ->capture_default_str();
  add_language(graph, request->language);

  CLI::App& list = commands.add(
      "list", "print what the scene contains and the kernels it offers",
      [request](const Scene& scene) {
        if (!request->json && !request->kernels.kernels.empty() && request->kernels.kernels != KernelOptions().kernels) {
          throw UsageError("--kernels is for --json, which prints their shapes: the text names all kernels of the scene");
        }
        return CommandResult{request->json ? list_json(scene, request->kernels.names()) : list_text(scene)};
      });
  list.add_flag("--json", request->json, "print JSON, with the shapes of what kernels write");
  add_kernel_list(list, request->kernels);
}

}  // namespace torsor
