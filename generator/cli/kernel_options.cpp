// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/kernel_options.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {
namespace {

ForwardMethod forward_method(const std::string& name) {
  if (name == "cheapest") return ForwardMethod::cheapest;
  if (name == "factorisation") return ForwardMethod::factorisation;
  if (name == "articulated_body") return ForwardMethod::articulated_body;
  if (name == "sums_of_squares") return ForwardMethod::sums_of_squares;
  throw UsageError(fmt::format(
      "unknown method '{}' in --forward: {}use cheapest, factorisation, articulated_body or sums_of_squares", name,
      did_you_mean(name, {"cheapest", "factorisation", "articulated_body", "sums_of_squares"})));
}

void check_parameter(const Scene& scene, const std::string& name) {
  const auto& parameters = scene.content().parameters;
  if (std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.symbol->name == name; })) return;
  std::vector<std::string> known;
  for (const auto& p : parameters) known.push_back(p.symbol->name);
  throw UsageError(fmt::format("unknown parameter '{}' in --run-time: {}the scene '{}' has {}", name,
                               did_you_mean(name, known), scene.name(),
                               known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

}  // namespace

std::vector<std::string> KernelOptions::names() const { return parse_kernel_list(kernels); }

ModelOptions KernelOptions::model(const Scene& scene) const {
  ModelOptions options;
  options.forward = forward_method(forward);
  options.passes = passes_without(without);
  if (run_time == "all") {
    options.all_run_time = true;
    return options;
  }
  for (std::size_t begin = 0; begin < run_time.size();) {
    const std::size_t end = std::min(run_time.find(',', begin), run_time.size());
    const std::string name = run_time.substr(begin, end - begin);
    begin = end + 1;
    check_parameter(scene, name);
    options.run_time.insert(name);
  }
  return options;
}

void add_kernel_list(CLI::App& command, KernelOptions& options) {
  command
      .add_option("--kernels", options.kernels,
                  fmt::format("comma-separated list of {}; or all (the default), which leaves out second derivatives "
                              "and sensitivities",
                              fmt::join(kernel_names(), ", ")))
      ->each([](const std::string& list) { parse_kernel_list(list); });  // refused before the scene is even built
}

void add_kernel_options(CLI::App& command, KernelOptions& options) {
  add_kernel_list(command, options);
  command.add_option("--run-time", options.run_time, "parameters that stay symbols, comma-separated, or all");
  command
      .add_option("--forward", options.forward,
                  "method of forward_dynamics: cheapest (of those that keep its digits), factorisation, articulated_body or "
                  "sums_of_squares")
      ->capture_default_str();
  std::string passes;
  for (const Pass& pass : all_passes()) passes += fmt::format("{}{}", passes.empty() ? "" : ", ", pass.name);
  command.add_option("--without", options.without, "passes to leave out, comma-separated: " + passes);
}

void add_digits(CLI::App& command, int& digits, const std::string& text, int least) {
  command.add_option("--digits", digits, text)->capture_default_str()->check(CLI::Range(least, 1000));
}

void add_states(CLI::App& command, int& states, const std::string& text) {
  command.add_option("--states", states, text)->capture_default_str()->check(CLI::Range(1, 1000000));
}

void add_state_options(CLI::App& command, StateOptions& options) {
  add_digits(command, options.digits, "digits of the exact arithmetic; more are taken where the error depends on them", 20);
  add_states(command, options.states, "number of states at which the search begins");
  command.add_option("--seed", options.seed, "seed of the first state; the same seed gives the same states")->capture_default_str();
}

void take_once(std::set<std::string>& given, const std::string& option, const std::string& name) {
  if (!given.insert(name).second) throw UsageError(fmt::format("{} names '{}' twice: give it one value", option, name));
}

namespace {

/// Of "0.25", "1/3" or what else a double is read from.
std::optional<double> number_of(const std::string& text) {
  try {
    return parse_decimal(text).to_double();
  } catch (const Error&) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) ? std::optional<double>(value) : std::nullopt;
  }
}

}  // namespace

void add_numbers(CLI::App& command, const std::string& option, NamedNumbers& numbers, const std::string& text) {
  command
      .add_option_function<std::vector<std::string>>(
          option,
          [&numbers, option](const std::vector<std::string>& assignments) {
            std::set<std::string> given;
            for (const std::string& assignment : assignments) {
              const std::size_t equals = assignment.find('=');
              const std::optional<double> value =
                  equals == std::string::npos ? std::nullopt : number_of(assignment.substr(equals + 1));
              if (!value) {
                throw UsageError(fmt::format("{} takes NAME=NUMBER, e.g. theta=0.5, and got '{}'", option, assignment));
              }
              const std::string name = assignment.substr(0, equals);
              if (!std::isfinite(*value)) throw UsageError(fmt::format("{} {} is not a finite number", option, name));
              take_once(given, option, name);
              numbers[name] = *value;
            }
          },
          text)
      ->delimiter(',')->allow_extra_args(false);
}

void add_start_and_inputs(CLI::App& command, NamedNumbers& initial, NamedNumbers& inputs) {
  if (command.get_option_no_throw("--initial") == nullptr) {  // the tool for files has it already, for the scene it makes
    add_numbers(command, "--initial", initial, "start values, NAME=NUMBER, rates NAME'=NUMBER; comma-separated");
  }
  add_numbers(command, "--input", inputs, "constant inputs, NAME=NUMBER; comma-separated; 0 when absent");
}

}  // namespace torsor
