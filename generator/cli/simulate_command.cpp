// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/cli/simulate.hpp"
#include "torsor/generator/cli/start_state.hpp"

namespace torsor {
namespace {

struct SimulationRequest : KernelOptions {
  SimulationOptions options;
  std::vector<std::string> plot;
  std::vector<std::string> events;
  std::string until;
  bool no_projection = false;
  const CLI::Option* tolerance = nullptr;
};

/// A share of a long run on the standard error, where a person looks at it.
class Progress {
 public:
  void operator()(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(500) || isatty(STDERR_FILENO) == 0) return;
    shown_ = now;
    const int done = static_cast<int>(40 * share);
    std::fprintf(stderr, "\r[%s%s] %3.0f %%", std::string(static_cast<std::size_t>(done), '#').c_str(),
                 std::string(static_cast<std::size_t>(40 - done), ' ').c_str(), 100 * share);
    if (share >= 1.0) std::fprintf(stderr, "\n");
    std::fflush(stderr);
  }

 private:
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

/// Quaternions of --initial with norm 1, as a motion starts from them; `notes` says of those that had another.
NamedNumbers with_unit_quaternions(const Scene& scene, NamedNumbers given, std::vector<std::string>& notes) {
  for (const AttitudeContent& attitude : scene.content().attitudes) {
    double norm = 0;
    for (const SymbolPointer& component : attitude.symbols->e) {
      const auto number = given.find(component->name);
      if (number != given.end()) norm = std::hypot(norm, number->second);
    }
    if (!(norm > 0 && std::isfinite(norm))) continue;  // none is given, or the start says what is wrong
    if (std::abs(norm - 1) > 1e-3) {
      notes.push_back(fmt::format("--initial gives the attitude '{}' a quaternion of norm {:.6g}, which is normalised",
                                  attitude.name, norm));
    }
    for (const SymbolPointer& component : attitude.symbols->e) given.at(component->name) /= norm;
  }
  return given;
}

/// Numbers of --initial that the start does not have, where the constraints do not allow them together; empty: it has them
/// all. That a closed start is typed in few digits is no news.
std::string moved_start(const Simulation& motion, const NamedNumbers& given) {
  std::vector<std::string> moved;
  std::vector<double> start = motion.before;
  if (start.empty() && !motion.rows.empty()) start = motion.rows[0];
  for (std::size_t i = 0; i < std::min(motion.names.size(), start.size()); ++i) {
    const auto asked = given.find(motion.names[i]);
    if (asked == given.end() || std::abs(start[i] - asked->second) <= 1e-3 * (1 + std::abs(asked->second))) continue;
    moved.push_back(fmt::format("{} = {:.6g} instead of {:.6g}", asked->first, start[i], asked->second));
  }
  if (moved.empty()) return {};
  return fmt::format("the constraints do not allow what --initial gives: the motion starts at {}", fmt::join(moved, ", "));
}

/// The first events and the last ones: who reads a terminal wants to know how it began and how it ended. The table has all.
void tell_events(const std::vector<std::string>& events, std::vector<std::string>& notes) {
  constexpr std::size_t first = 8, last = 2;
  const std::size_t left_out = events.size() > first + last + 1 ? events.size() - first - last : 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (left_out > 0 && i == first) {
      notes.push_back(fmt::format("{} events more: the table has all, in lines that begin with \"# Event:\"", left_out));
      i += left_out;
    }
    notes.push_back("event: " + events[i]);
  }
}

CommandResult run_simulation(const Scene& scene, SimulationRequest request, const std::string& output) {
  SimulationOptions& options = request.options;
  options.model = request.model(scene);
  options.parameters = with_defaults(scene, options.parameters);
  options.project = !request.no_projection;
  for (const std::string& event : request.events) options.events.push_back({event, false});
  if (!request.until.empty()) options.events.push_back({request.until, true});
  options.progress = Progress();
  if (!request.plot.empty() && !request.plot[0].ends_with(".svg")) {
    throw UsageError(fmt::format("--plot writes SVG: end the name '{}' in .svg", request.plot[0]));
  }
  if (!request.plot.empty() && output != "-" && same_file(request.plot[0], output)) {
    throw UsageError(fmt::format("--plot and --output name one file, '{}': give the table another name", output));
  }
  if (options.method == "gauss" && request.tolerance->count() > 0) {
    throw UsageError("--tolerance is for methods that choose their steps, and gauss does not: give --method-step");
  }
  const Simulation motion = simulate(scene, options);
  CommandResult result{simulation_csv(scene, options, motion), motion.status.empty()};
  if (!request.plot.empty() && !motion.rows.empty()) {
    std::vector<std::string> columns(1);
    for (const char c : request.plot[1]) {
      if (c == ',') columns.emplace_back();
      else columns.back() += c;
    }
    result.files.push_back({request.plot[0], simulation_svg(scene, motion, columns)});
  }
  const NamedNumbers given = with_unit_quaternions(scene, options.initial, result.notes);
  if (const std::string moved = moved_start(motion, given); !moved.empty()) result.notes.push_back(moved);
  tell_events(motion.events, result.notes);
  result.notes.insert(result.notes.end(), motion.remarks.begin(), motion.remarks.end());
  if (!motion.status.empty()) result.notes.push_back(fmt::format("the motion ends: {}", motion.status));
  return result;
}

}  // namespace

void add_simulate_command(CommandSet& commands) {
  const auto request = std::make_shared<SimulationRequest>();
  CLI::App& command = commands.add("simulate", "integrate the motion; write it as a table, and draw it",
                                   [request, &commands](const Scene& scene) { return run_simulation(scene, *request, commands.output()); });
  SimulationOptions& options = request->options;
  command.add_option("--to", options.duration, "end of the motion [s]")->capture_default_str();
  command.add_option("--step", options.step, "time between rows [s]; the method chooses its own steps")->capture_default_str();
  request->tolerance = command.add_option("--tolerance", options.tolerance, "largest error of one step, as a part of 1 + |y|")->capture_default_str();
  command.add_option("--method", options.method, "dp853; radau for stiff motions; gauss, of fixed steps, for long ones")
      ->capture_default_str();
  command.add_option("--method-step", options.method_step, "step of gauss [s]; that of the rows when absent");
  command
      .add_option("--events", request->events,
                  "rows where a formula passes through zero: \"NAME: FORMULA\", or \"x = 0.5\"; may be given again")
      ->allow_extra_args(false);
  command.add_option("--until", request->until, "end the motion where a formula passes through zero, e.g. \"theta = 0\"");
  add_start_and_inputs(command, options.initial, options.inputs);
  commands.starts_from(command, [request] {
    return GivenStart{request->options.initial, request->options.parameters, request->options.model};
  });
  add_numbers(command, "--run-time", options.parameters, "values of parameters, NAME=NUMBER; comma-separated");
  command
      .add_option("--impact-law", options.impact_law, "of contacts: newton_moreau, poisson, energetic (of one contact) or sequential")
      ->capture_default_str();
  command.add_flag("--impact-without-collision", options.impact_without_collision,
                   "where one contact slips and no regimes exist, its impulse ends the slip");
  command.add_flag("--no-projection", request->no_projection, "do not project steps onto the constraints: they drift");
  command
      .add_option("--plot", request->plot, "draw columns over time: a file, then names, comma-separated: motion.svg x,theta")
      ->expected(2);
}

}  // namespace torsor
