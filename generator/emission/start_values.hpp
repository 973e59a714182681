// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/dynamics/equations/equations.hpp"

namespace torsor {

/// Body of `default_parameters`: the value each run-time parameter has in the scene, with the parameters it depends on
/// at their own values. One without a value is not a number, so that nothing computes with it by mistake.
std::string default_parameters_body(const Scene& scene, const std::vector<SymbolPointer>& parameters);

/// Body of `initial_state`: the scene's state at t = 0, a formula of the run-time parameters where it depends on them.
/// Throws SceneError when it depends on anything else.
struct InitialState {
  std::string body;
  bool reads_parameters = false;
};
InitialState initial_state(const Equations& equations, const ModelOptions& options);

}  // namespace torsor
