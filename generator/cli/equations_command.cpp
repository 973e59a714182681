// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor {
namespace {

struct EquationsRequest : PageRequest {
  PrintOptions options;
};

}  // namespace

void add_equations_command(CommandSet& commands) {
  const auto request = std::make_shared<EquationsRequest>();
  CLI::App& command = commands.add(
      "equations", "print T, U, Lagrange's equations, constraints, linearisation", [request](const Scene& scene) {
        PrintOptions options = request->options;
        const PageStyle style = request->style();
        options.document = style.document;
        options.language = style.language;
        return CommandResult{print_equations(scene, style.format, options)};
      });
  add_format(command, *request);
  add_about(command, request->options.about, "state of the linearisation, NAME=VALUE, e.g. theta=0; repeatable");
  command.add_flag("--derivation", request->options.derivation,
                   "the steps that lead there: screws, T body by body, partial derivatives, forces by action, reactions");
}

}  // namespace torsor
