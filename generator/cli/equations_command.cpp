// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "generator/cli/command_set.hpp"
#include "generator/printing/print_equations.hpp"

namespace torsor {
namespace {

struct EquationsRequest {
  std::string format = "text";
  PrintOptions options;
};

}  // namespace

void add_equations_command(CommandSet& commands) {
  const auto request = std::make_shared<EquationsRequest>();
  CLI::App& command = commands.add(
      "equations", "print T, U, Lagrange's equations, constraints, linearisation", [request](const Scene& scene) {
        return CommandResult{print_equations(scene, parse_format(request->format), request->options)};
      });
  command.add_option("--format", request->format, "text or latex")->capture_default_str();
  add_about(command, request->options.about, "state of the linearisation, NAME=VALUE, e.g. theta=0; repeatable");
  command.add_flag("--document", request->options.document, "LaTeX: a whole document");
}

}  // namespace torsor
