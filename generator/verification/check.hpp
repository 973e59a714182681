// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// One comparison, at its worst over all states.
struct CheckResult {
  std::string name;
  std::string description;
  double worst = 0;                               ///< relative difference, or a count of failures
  double bound = 0;                               ///< passes when worst <= bound
  bool passed() const { return worst <= bound; }  // false for NaN
};

struct CheckOptions {
  int digits = 50;
  int states = 20;
  std::vector<std::string> kernels{};  ///< looked at in double; empty: usual_kernel_names
};

/// Checks a scene against itself at pseudo-random states (fixed seeds, so that a failure repeats):
/// the two derivations of Lagrange's equations, symmetry and positiveness of M, both mass matrices, the energy theorem,
/// constraints and their reactions, forward against inverse dynamics, and the double kernels against CLN.
/// Where joints move no mass, what needs the accelerations of the motion is left out, and the energy theorem holds under the
/// forces of inverse dynamics.
/// A relative difference is ‖x − y‖ over the size of what was added to make x, never below ‖x‖.
std::vector<CheckResult> check_scene(const Scene& scene, const CheckOptions& options);
/// The same without the double kernels.
std::vector<CheckResult> check_derivations(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
