// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/cli/command_line.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

/// Which kernels, and how they are derived: the options that commands on kernels share, as they are written.
struct KernelOptions {
  std::string kernels = "all";
  std::string run_time;
  std::string forward = "cheapest";
  std::string without;

  std::vector<std::string> names() const;  ///< of the kernels; an unknown one is a UsageError
  /// Throws UsageError for an unknown parameter, method or pass.
  ModelOptions model(const Scene& scene) const;
};

/// Throws UsageError where an option has given that name a value before: which of the two counts nobody could see.
void take_once(std::set<std::string>& given, const std::string& option, const std::string& name);
/// --NAME NAME=VALUE, comma-separated, repeatable.
void add_numbers(CLI::App& command, const std::string& option, NamedNumbers& numbers, const std::string& text);
/// --initial, which the tool for files has already for the scene that it makes, and --input.
void add_start_and_inputs(CLI::App& command, NamedNumbers& initial, NamedNumbers& inputs);

void add_kernel_list(CLI::App& command, KernelOptions& options);
/// The list, and --run-time, --forward, --without.
void add_kernel_options(CLI::App& command, KernelOptions& options);

/// States at which kernels are looked at.
struct StateOptions {
  int digits = 50;
  int states = 64;
  std::uint64_t seed = 1;
};

void add_state_options(CLI::App& command, StateOptions& options);
/// --digits, from `least` to 1000, and --states, from 1 to a million.
void add_digits(CLI::App& command, int& digits, const std::string& text, int least);
void add_states(CLI::App& command, int& states, const std::string& text);

}  // namespace torsor
