// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"
#include "torsor/generator/printing/force_function_text.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/printing/statics_text.hpp"
#include "torsor/generator/printing/theorem_text.hpp"

namespace torsor {
namespace {

void add_force_function(CommandSet& commands) {
  const auto selection = std::make_shared<ActionSelection>();
  CLI::App& command =
      commands.add("force-function", "say whether actions have a potential energy, a force function or neither",
                   [selection](const Scene& scene) { return CommandResult{force_function_text(scene, *selection)}; });
  command.add_option("--actions", selection->actions, "names, comma-separated; gravity is the weight; all when absent")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--bodies", selection->bodies, "bodies on which they are counted; both ends of all when absent")
      ->delimiter(',')->allow_extra_args(false);
}

struct UnknownsRequest : PageRequest {
  std::vector<std::string> bodies;
  std::string point;
  std::string axes = "ground";
};

CommandResult unknowns(const Scene& given, const UnknownsRequest& request) {
  if (request.bodies.empty() != request.point.empty()) {
    throw UsageError("--isolate BODIES and --at POINT go together: the point at which moments are taken");
  }
  if (request.bodies.empty() && request.axes != "ground") {
    throw UsageError("--axes is for --isolate BODIES --at POINT: the axes along which their theorems are written");
  }
  Scene scene = given;
  const PointReference point = request.bodies.empty() ? PointReference("") : point_at(scene, request.point);
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const PageStyle style = request.style();
  std::string text = unknowns_report(equations, style.language);
  if (!request.bodies.empty()) text += isolation_report(equations, request.bodies, {point, request.axes}, style.language).text;
  return {style.format == Format::text ? text : printing::words_as_page(text, given.content(), style)};
}

void add_unknowns(CommandSet& commands) {
  const auto request = std::make_shared<UnknownsRequest>();
  CLI::App& command =
      commands.add("unknowns", "count unknowns and equations, and name the theorem that gives each reaction",
                   [request](const Scene& scene) { return unknowns(scene, *request); });
  command.add_option("--isolate", request->bodies, "bodies to isolate, comma-separated")->delimiter(',')->allow_extra_args(false);
  command.add_option("--at", request->point, "point at which their moments are taken");
  command.add_option("--axes", request->axes, "frame along whose axes the theorems are written")->capture_default_str();
  add_format(command, *request);
}

struct TheoremPage : TheoremRequest, PageRequest {};
struct ScrewPage : ScrewRequest, PageRequest {};
struct StaticsPage : PageRequest {
  About about, set;
};

void add_theorem(CommandSet& commands) {
  const auto request = std::make_shared<TheoremPage>();
  CLI::App& command = commands.add(
      "theorem", "write Newton-Euler's theorem or the energy theorem for some bodies, reactions by name",
      [request](const Scene& scene) { return CommandResult{theorem_text(scene, *request, request->style())}; });
  command.add_option("--kind", request->kind, "resultant, moment or energy")->capture_default_str();
  command.add_option("--bodies", request->bodies, "bodies to isolate, comma-separated; all that move when absent")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--at", request->point, "point at which moments are taken, or a frame for its origin");
  command.add_option("--direction", request->direction, "x, y, z or components 0,1,0")->capture_default_str();
  command.add_option("--axes", request->axes, "frame along whose axes the direction is given")->capture_default_str();
  command.add_option("--observer", request->observer, "frame from which motion is seen")->capture_default_str();
  add_format(command, *request);
}

void add_screw(CommandSet& commands) {
  const auto request = std::make_shared<ScrewPage>();
  CLI::App& command =
      commands.add("screw", "write the momentum screw and the dynamic screw of some bodies, and their kinetic energy",
                   [request](const Scene& scene) { return CommandResult{screw_text(scene, *request, request->style())}; });
  command.add_option("--body,--bodies", request->bodies, "bodies, comma-separated; all when absent")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--at", request->point, "point at which screws are reduced, or a frame for its origin");
  command.add_option("--axes", request->axes, "frame along whose axes components are given")->capture_default_str();
  command.add_option("--observer", request->observer, "frame from which motion is seen")->capture_default_str();
  add_format(command, *request);
}

void add_statics(CommandSet& commands) {
  const auto request = std::make_shared<StaticsPage>();
  CLI::App& command = commands.add(
      "statics", "print equations of equilibrium; at a state also its stability by Lejeune-Dirichlet and Hurwitz",
      [request](const Scene& scene) {
        return CommandResult{statics_text(scene, request->about, request->set, request->style())};
      });
  add_about(command, request->about, "the state, NAME=VALUE, e.g. theta=0; repeatable");
  add_assignments(command, "--set", request->set, "value of a parameter in all that is written, NAME=VALUE, e.g. omega=0; repeatable");
  add_format(command, *request);
}

}  // namespace

void add_statics_commands(CommandSet& commands) {
  add_force_function(commands);
  add_unknowns(commands);
  add_theorem(commands);
  add_screw(commands);
  add_statics(commands);
}

}  // namespace torsor
