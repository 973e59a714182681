// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/reference_cache.hpp"

namespace torsor {
namespace {

struct CheckRequest : KernelOptions {
  int digits = 50;
  int states = 20;
  bool json = false;
};

CommandResult check(const Scene& scene, const CheckRequest& request) {
  const std::vector<CheckResult> results = check_scene(scene, {request.digits, request.states, request.names()});
  CommandResult result{request.json ? check_json(scene.name(), results) : check_table(scene.name(), results),
                       std::all_of(results.begin(), results.end(), [](const CheckResult& r) { return r.passed(); })};
  if (!scene.content().keeps_massless) return result;
  if (const std::string reason = lack_of_mass(Equations(scene)); !reason.empty()) {
    std::vector<std::string> absent = request.names();
    std::erase_if(absent, [](const std::string& name) { return !solves_with_mass_matrix(name); });
    result.notes.push_back(fmt::format("not checked, for there are none: {}: {}", fmt::join(absent, ", "), reason));
  }
  return result;
}

struct VerifyRequest : KernelOptions {
  StateOptions states;
  int climbs = 2;
  int range = double_states.large;
  std::string scalar = "both";
  std::string exceptions;
  bool every_exception_needed = false;
  VerifyLayout layout;
  bool markdown = false;
  bool json = false;
};

std::string file_text(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw FileError(fmt::format("cannot read '{}': does it exist, and may you read it?", path));
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Says of groups that fail whether they do so near a change point, or near a dead centre of a coordinate.
void name_special_places(const Scene& scene, const ModelOptions& model, std::vector<VerifyRow>& rows) {
  if (scene.content().constraints.empty()) return;
  for (VerifyRow& row : rows) {
    if (row.passed() || !row.worst.counted) continue;
    NamedNumbers parameters;
    for (const ParameterContent& parameter : scene.content().parameters) {
      const auto given = row.numbers.find(parameter.symbol->name);
      if (given != row.numbers.end()) parameters.insert(*given);
    }
    try {
      EvaluatedMotion motion(scene, model, parameters, {});
      std::vector<double> y = closed_start(motion, {});  // the group does not depend on those that have no number
      for (std::size_t i = 0; i < y.size(); ++i) {
        const auto given = row.numbers.find(motion.symbols()[i]->name);
        if (given != row.numbers.end()) y[i] = given->second;
      }
      const double kept = motion.independence(0.0, y);
      if (kept < change_point_is_near) {
        const bool where_all_count = !left_out_that_count(motion, 0.0, y).empty();
        row.remark = fmt::format("near a {}: the other constraints leave {:.1g} of one of them, and what depends on it "
                                 "loses digits (docs/constraints.md)",
                                 where_all_count ? "place where constraints left out count" : "change point", kept);
      } else if (const std::vector<std::string> dead = at_dead_centre(motion, 0.0, y); !dead.empty()) {
        row.remark = fmt::format("near a dead centre of {}: the constraints hardly let it move there, and its acceleration is what "
                                 "cancelling terms leave", fmt::join(dead, ", "));
      }
    } catch (const Error&) {  // a scene that cannot move says so elsewhere
    }
  }
}

CommandResult verify(const Scene& scene, const VerifyRequest& request) {
  VerifyOptions options;
  options.model = request.model(scene);
  options.kernels = request.names();
  options.digits = request.states.digits;
  options.states = request.states.states;
  options.climbs = request.climbs;
  options.seed = request.states.seed;
  options.range = request.range;
  if (request.scalar == "double") options.precisions = {Precision::in_double};
  if (request.scalar == "float") options.precisions = {Precision::in_float};
  if (!request.exceptions.empty()) options.exceptions = parse_accuracy_exceptions(file_text(request.exceptions));
  std::vector<VerifyRow> rows = verify_scene(scene, options);
  name_special_places(scene, options.model, rows);
  CommandResult result;
  result.passed = std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.passed(); });
  result.text = request.json       ? verify_json(scene.name(), rows)
                : request.markdown ? verify_markdown(scene.name(), rows)
                                   : verify_table(scene.name(), rows, request.layout);
  const bool rounding_alone = std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) {
    return row.passed() || (row.worst.counted && row.bounded());
  });
  if (!result.passed && rounding_alone) {
    result.notes.push_back(
        "no error exceeds the bound of rounding at its state: what fails loses digits near that state, as solves do near "
        "dead centres and singular charts; docs/accuracy.md says why, and --exceptions FILE accepts what is known");
  }
  if (!request.every_exception_needed) return result;
  for (const AccuracyException& e : needless_exceptions(scene.name(), rows, options.exceptions)) {
    result.passed = false;
    result.notes.push_back(
        fmt::format("the exception '{} | {} | {} | {}' is not needed, within {} ulp or not there: remove it from {}",
                    e.scene, e.kernel, e.group, e.scalar, accuracy_bar, request.exceptions));
  }
  return result;
}

struct ReferenceRequest : ReferenceOptions {
  std::string cache;
};

/// Times are positive and increase; what is wrong is quoted as the user wrote it.
void check_times(const std::vector<std::string>& times) {
  Number before;
  for (const std::string& text : times) {
    Number time;
    try {
      time = parse_decimal(text);
    } catch (const Error& error) {
      throw UsageError(fmt::format("--times: {}", error.what()));
    }
    if (std::isinf(time.to_double())) {
      throw UsageError(fmt::format("--times: '{}' is beyond what a double holds, and no motion gets there", text));
    }
    if (!(before < time)) {
      throw UsageError(fmt::format("--times: '{}' does not come after what is before it: times are positive and increase", text));
    }
    before = time;
  }
}

CommandResult reference(const Scene& scene, const ReferenceRequest& request) {
  check_times(request.times);
  ReferenceResult motion =
      request.cache.empty() ? integrate_reference(scene, request) : integrate_cached_reference(scene, request, request.cache);
  return {std::move(motion.text), motion.shortfalls.empty(), std::move(motion.shortfalls)};
}

void add_check(CommandSet& commands) {
  const auto request = std::make_shared<CheckRequest>();
  CLI::App& command = commands.add("check", "compare independent derivations at random states",
                                   [request](const Scene& scene) { return check(scene, *request); });
  add_kernel_list(command, *request);
  add_digits(command, request->digits, "digits of the arithmetic in which derivations are compared", 20);
  add_states(command, request->states, "number of states");
  command.add_flag("--json", request->json, "print JSON");
}

void add_verify(CommandSet& commands) {
  const auto request = std::make_shared<VerifyRequest>();
  CLI::App& command = commands.add("verify", "search for the worst rounding errors of the kernels, in double and float",
                                   [request](const Scene& scene) { return verify(scene, *request); });
  add_kernel_options(command, *request);
  add_state_options(command, request->states);
  command.add_option("--climbs", request->climbs, "number of searches for a worse state, for each group of results")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  command.add_option("--range", request->range, "numbers of a state have sizes up to 2^±RANGE, in float up to 2^±10 at most")
      ->capture_default_str()
      ->check(CLI::Range(4, double_states.large));
  command.add_option("--scalar", request->scalar, "double, float or both")
      ->capture_default_str()
      ->check(CLI::IsMember({"double", "float", "both"}));
  CLI::Option* exceptions =
      command.add_option("--exceptions", request->exceptions,
                         "file of groups that may exceed the bar: scene | kernel | group | scalar | limit | reason");
  command
      .add_flag(
          "--every-exception-needed", request->every_exception_needed,
          "also fail where the file lists a group that stays within the bar; needs the kernels and the search it was made with")
      ->needs(exceptions);
  CLI::Option* every_group =
      command.add_flag("--all", request->layout.every_group, "print every group of results, not only the worst of each kernel");
  CLI::Option* markdown =
      command.add_flag("--markdown", request->markdown, "print one row of the table in docs/accuracy.md");
  CLI::Option* with_states = command.add_flag("--show-states", request->layout.with_states, "print the state of each row");
  markdown->excludes(every_group)->excludes(with_states);
  command.add_flag("--json", request->json, "print JSON")->excludes(markdown);
}

void add_reference(CommandSet& commands) {
  const auto request = std::make_shared<ReferenceRequest>();
  request->digits = 50;
  CLI::App& command = commands.add("reference", "integrate the motion in high precision by an independent derivation",
                                   [request](const Scene& scene) { return reference(scene, *request); });
  add_digits(command, request->digits, "digits of the result", 10);
  command.add_option("--times", request->times, "comma-separated times in seconds, increasing")
      ->required()
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--cache", request->cache, "keep references in this folder, so that none is integrated twice");
}

}  // namespace

void add_verification_commands(CommandSet& commands) {
  add_check(commands);
  add_verify(commands);
  add_reference(commands);
}

}  // namespace torsor
