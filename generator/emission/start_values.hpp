// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/listing/listing.hpp"

namespace torsor {

/// The value each run-time parameter has in the scene, with the parameters it depends on at their own values: outputs
/// "parameters.NAME". One without a value is not a number, so that nothing computes with it by mistake.
Listing default_parameters(const Scene& scene, const std::vector<SymbolPointer>& parameters);

/// The scene's state at t = 0, a formula of the run-time parameters where it depends on them: outputs "state.time",
/// "state.q[i]" and "state.v[i]". Throws SceneError when it depends on anything else.
Listing initial_state(const Equations& equations, const ModelOptions& options, const Layout& layout);

}  // namespace torsor
