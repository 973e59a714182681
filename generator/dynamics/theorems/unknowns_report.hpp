// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"

namespace torsor {

/// One unknown component of action on isolated bodies, and which of the six theorems it enters.
struct IsolationUnknown {
  std::string name;            ///< "shoulder X", or a multiplier's name
  std::array<bool, 6> enters;  ///< resultant along x, y, z of the query's axes, then moment at its point
};

/// Which equation gives which unknown (course, §6.3.3): for isolated bodies, a point and axes, the components that the
/// joints across the boundary can transmit and the multipliers of constraints that act across it. An equation that none
/// enters is an equation of motion.
struct IsolationReport {
  std::vector<IsolationUnknown> unknowns;
  std::string text;
};
IsolationReport isolation_report(const Equations& equations, const BodyNames& bodies, const ScrewQuery& query,
                                 const NaturalLanguage& say = {});

/// Count of unknowns (coordinates, reactions, multipliers) against equations and the choice it leaves (course, §6.5.5),
/// as text.
std::string unknowns_report(const Equations& equations, const NaturalLanguage& say = {});

}  // namespace torsor
