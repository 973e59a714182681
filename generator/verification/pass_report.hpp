// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// One kernel without one pass.
struct PassEffect {
  int operations = 0;     ///< at every state
  int cycles = 0;         ///< from the state to the last result, with as many units as it takes (earliest_start.hpp)
  /// From the kernel with all passes, in CLN: ‖y - y₀‖ / ‖y₀‖, the largest of all states and units of results.
  double difference = 0;
  double error = 0;       ///< worst error in double, scaled by max(1, condition) [ulp]; see KernelAccuracy
};

struct KernelPasses {
  std::string kernel;
  PassEffect all;                   ///< with all passes that the options ask for
  std::vector<PassEffect> without;  ///< in the order of PassReport::passes
};

struct PassReport {
  std::string scene;
  std::vector<std::string> passes;  ///< those that the options ask for
  std::vector<KernelPasses> kernels;
  int digits = 0;

  /// No pass changes a result by more than a third of the digits: what is left is rounding, amplified by the condition.
  bool equal() const;
};

struct PassReportOptions {
  int digits = 50;
  int states = 16;  ///< random ones for the difference, as many of `verify` for the error
  std::uint64_t seed = 1;
};

/// Leaves out one pass after the other. Kernels that the scene does not have, and series, are not reported.
PassReport report_passes(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options,
                         const PassReportOptions& report);

}  // namespace torsor
