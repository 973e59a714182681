// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/cli/simulate.hpp"

namespace torsor {

/// Whether the scene has contacts that open and close, stops or dry friction.
bool has_contacts(const Scene& scene);

/// The motion of such a scene from event to event, by `runtime/contacts`: its columns are those of `simulate` and of
/// each contact the gap and the reactions; its notes tell of events. Throws as `simulate`, and UsageError for a scene
/// that is too large.
Simulation simulate_contacts(const Scene& scene, const SimulationOptions& options);

}  // namespace torsor
