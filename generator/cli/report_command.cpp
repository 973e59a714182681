// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/cli/report.hpp"

namespace torsor {
namespace {

struct ReportRequest : KernelOptions {
  About about;
  double duration = 10.0;
  bool meshes = false;
  NamedNumbers initial, inputs;
  std::string reference;
  std::string language = "en";
};

}  // namespace

void add_report_command(CommandSet& commands) {
  const auto request = std::make_shared<ReportRequest>();
  CLI::App& command = commands.add(
      "report", "write one HTML file: the mechanism, its equations and its motion", [request](const Scene& scene) {
        return CommandResult{report_html(scene, {request->model(scene), request->about, request->duration, request->meshes,
                                                 request->initial, request->inputs, request->reference, NaturalLanguage::named(request->language)})};
      });
  command.add_option("--run-time", request->run_time,
                     "parameters that the reader of the page can change, comma-separated, or all; when absent, all that can be");
  command.add_option("--to", request->duration, "length of the motion [s]")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  command.add_flag("--meshes", request->meshes,
                   "draw the meshes (STL, OBJ, Collada) that the scene or its URDF file shows, made small enough for the page");
  add_start_and_inputs(command, request->initial, request->inputs);
  commands.starts_from(command, [request] { return GivenStart{request->initial, {}, {}}; });
  command.add_option("--reference", request->reference, "CSV of the command reference: dots beside the curves of the motion");
  add_language(command, request->language);
  add_about(command, request->about, "state of the linearisation, NAME=VALUE, e.g. theta=0; repeatable");
}

}  // namespace torsor
