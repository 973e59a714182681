// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/dynamics/forces/actions.hpp"

namespace torsor {

/// Which actions are looked at, and on which bodies.
struct ActionSelection {
  /// Names of actions; "gravity" is the weight. Empty: all of them.
  std::vector<std::string> actions;
  /// Names of the bodies on which they are counted: the action of a spring on one of its ends alone, as on an isolated
  /// body. Empty: wherever they act, so that the power of a mutual action is that of both ends. An action that works on
  /// a formula (an elongation) has no ends and cannot be asked for by body.
  std::vector<std::string> bodies;
};

/// What the selected actions do, as seen with the coordinates of the scene.
struct SelectedActions {
  std::vector<Value> forces;           ///< Q_i of the unknowns, inputs included
  Value power;                         ///< on those bodies, imposed motions included [W]
  Value force_function;                ///< U of those that have one, both ends of mutual actions included [J]
  std::vector<std::string> frictions;  ///< names of those that are friction, whose forces are left out
};

/// The power of a mutual action that has a force function is dU/dt, of both ends; that of a force function given by
/// formula is Σ Q_i q̇_i, for nothing is known of what else it acts on. Throws SceneError for an unknown name, or an
/// action without ends asked for by body.
SelectedActions selected_actions(const Model& model, const ActionSelection& selection);

}  // namespace torsor
