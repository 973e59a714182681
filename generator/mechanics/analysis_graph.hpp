// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {

/// What ties bodies beside the joints: constraints that are no joint, and actions.
struct AnalysisLink {
  enum class Kind { constraint, action };
  Kind kind = Kind::action;
  std::string name;
  std::string what;         ///< "rolling without slip", "spring", "gravity", "imposes phi(t)", ...
  std::vector<int> bodies;  ///< by index in StructureGraph::bodies, ascending; most often two
};

/// The links that complete a structure graph to the graph of analysis (Pommier, Dynamique des systèmes de solides,
/// §6.2.4). Actions from outside are tied to the ground. An action on a displacement given as a formula is tied to
/// the two bodies whose relative displacement that is (the sum of the displacements of the joints between them).
/// Otherwise it is tied to all bodies that the formula's coordinates move in their joints. The same holds for a law
/// of time on a coordinate, or on a joint whose displacement is a formula of time. A `closure` of two points and a
/// `point_in_plane` are constraints; the joints that close loops belong to the structure graph.
std::vector<AnalysisLink> analysis_links(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& say = {});

}  // namespace torsor
