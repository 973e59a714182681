// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/motion/body_screws.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"

namespace torsor {

/// The wrench that a joint transmits to the body that it carries, component by component as a person writes it.
/// Components that no law gives are symbols with the names of `connections`. Along the joint's freedoms stand the
/// forces of motors, springs, dampers and formulas of constraints.
struct JointAction {
  Connection connection;
  Wrench wrench;  ///< on the body: along the axes of `connection.top`, at the origin of `connection.bottom`
  std::vector<SymbolPointer> unknowns;  ///< "[shoulder X]" [N], "[shoulder L]" [N m], kind multiplier
  std::vector<std::string> remarks;     ///< for a reader: where a component is not split into unknown and given
};

/// The action along a freedom s_k is Σ Q_i v_i over the generalised forces Q_i of what works on formulas of coordinates
/// and the virtual motion v in which s_k alone changes, at unit rate. Where the displacements of the joints are no sums
/// of coordinates with constant factors, or several turns of one joint make its twist depend on the configuration, a
/// component along a freedom gets a name too, unless nothing works in the joints; a remark says so.
std::vector<JointAction> joint_actions(const Equations& equations, const NaturalLanguage& say = {});

/// The wrench reduced and written as asked.
Wrench as_asked(const Model& model, const JointAction& action, const ScrewQuery& query);

}  // namespace torsor
