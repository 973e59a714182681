// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/dynamics/structure/mobility.hpp"

namespace torsor {

/// A joint of the reduced graph: one of the mechanism, or what is equivalent to several of them.
struct EquivalentJoint {
  TwistEdge edge;  ///< bodies by index in ReducedGraph::bodies; named "L1//L2" in parallel, "L4-L3" in series
  TwistClass allows;
  bool made_of_one = true;
};

/// One merger: of bodies tied by a weld, of joints in parallel, of joints in series with the body between them.
struct ReductionStep {
  enum class Kind { weld, parallel, series };
  Kind kind = Kind::weld;
  std::string text;
  int redundant = 0;  ///< closure equations that disappear because others say the same
  int internal = 0;   ///< internal freedoms that disappear with a body
};

struct ReducedGraph {
  std::vector<std::string> bodies;  ///< the ground first
  std::vector<EquivalentJoint> joints;
  std::vector<ReductionStep> steps;
  MobilityCount count;
  bool special = false;  ///< at the given configuration joints are equivalent to others than here, or loops have another rank
};

/// Replaces loops by equivalent joints as long as possible (Pommier, Dynamique des systèmes de solides, §3.5.4): bodies
/// tied by a joint without freedom become one; joints in parallel, between the same two bodies, become one that allows
/// what both allow; joints in series become one that allows the sum of what they allow, where a body in a loop has just
/// these two and none of them is a joint with the outside (those stay, so that inputs and outputs can be read off).
/// Mobility less the internal freedoms that are named lost in series stays the same; all at one configuration.
ReducedGraph reduce(const std::vector<std::string>& bodies, const std::vector<TwistEdge>& edges, const NaturalLanguage& say = {});

/// At the given configuration where it is regular and its reduction is the generic one, else at the generic configuration.
ReducedGraph reduced_graph(const Mobility& mobility, const NaturalLanguage& say = {});

}  // namespace torsor
