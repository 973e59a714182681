// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/structure/joint_space.hpp"
#include "torsor/generator/dynamics/structure/twist_space.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {

/// Digits in which ranks of mechanisms are decided.
constexpr int mobility_digits = zero_tests::twists.digits;

/// A joint of a graph with the twists it allows, whatever it is made of.
struct TwistEdge {
  std::string name;
  int a = 0, b = 0;
  bool outside = false;  ///< a joint with the outside of the mechanism, or a named input or output
  JointTwists motion;
};

/// Kinematic closure of all independent loops: rows 6 l + k say that the sum of the twists around loop l has no
/// component k (Ω_x, Ω_y, Ω_z, V_x, V_y, V_z at the ground's origin); one column for each freedom, joint by joint.
RealRows closure_matrix(const std::vector<TwistEdge>& edges, const std::vector<GraphLoop>& loops);

/// Numbers of a mechanism (Pommier, Dynamique des systèmes de solides, §3.5.4).
struct MobilityCount {
  int bodies = 0, joints = 0;
  int loops = 0;       ///< cyclomatic number μ = joints − bodies + 1
  int parameters = 0;  ///< n_p, sum of the joints' freedoms
  int equations = 0;   ///< 6 μ
  int rank = 0;        ///< r of the closure equations
  int mobility = 0;    ///< m = n_p − r
  int redundancy = 0;  ///< degree of over-constraint h = 6 μ − r
  int internal = 0;    ///< mobility that is left when the joints with the outside are blocked
  int useful = 0;      ///< m − internal
};
MobilityCount count_mobility(int bodies, const std::vector<TwistEdge>& edges);

/// A motion that is left when the joints with the outside are blocked.
struct InternalMotion {
  std::vector<std::string> bodies;  ///< that move in it: one, or several that cannot do so alone
  int freedoms = 1;
  std::string text;  ///< "turns about z"
};

/// Components of a joint's reaction that equilibrium leaves undetermined: "F_x", ... "M_z" along the axes of the joint
/// (those its first body holds), moments at the origin of its second frame.
struct IndeterminateReaction {
  std::string joint;
  std::vector<std::string> components;
};

struct MobilityOptions {
  std::vector<std::string> inputs_outputs;  ///< joints that count as those with the outside; empty: those of the ground
  std::uint64_t seed = 1;                   ///< of the generic configuration
  NaturalLanguage language{};               ///< of the texts
};

struct Mobility {
  StructureGraph graph;
  std::vector<GraphLoop> loops;
  std::vector<bool> outside;    ///< by joint
  bool moved_to_close = false;  ///< the scene's initial values did not close the loops: nearby ones that do were taken
  MobilityCount given;          ///< at the initial configuration
  MobilityCount generic;        ///< at a configuration near it that is not special
  bool singular = false;        ///< the rank at the initial configuration is below the generic one
  bool immobile = false;  ///< the freedoms at the initial configuration are infinitesimal only: no other one is near
  std::vector<InternalMotion> internal;
  std::vector<std::string> internal_freedoms;  ///< "spin: turn about z" of joints
  std::vector<IndeterminateReaction> indeterminate;
  std::vector<std::string> redundant;  ///< closure equations that can be dropped one at a time: "loop 1: V_z"
  std::vector<TwistEdge> given_edges, generic_edges;
};

/// Counts, ranks and what follows from them. The closures are those of the joints alone; what ties their freedoms
/// beyond (contacts, rolling, formulas of coordinates) is counted by `scene_freedoms`.
///
/// Ranks are decided in 50 digits by elimination with complete pivoting and a tolerance of 1e-20 relative to the
/// largest entry, lengths divided by the size of the mechanism. The generic configuration is reached by a pseudo-random
/// move along the freedoms and Newton's method back onto the closures (to 1e-40). Names of directions, internal motions
/// and reactions are those at the initial configuration, or at the generic one when the initial one is singular.
///
/// Throws SceneError when the loops cannot be closed near the initial values, or for an unknown joint in
/// `inputs_outputs`.
Mobility analyse_mobility(const Scene& scene, const MobilityOptions& options = {});

/// Freedoms of the scene as it is written, at its initial configuration: coordinates that are not driven, less the rank
/// of all constraints, those without joint included.
struct SceneFreedoms {
  int coordinates = 0;  ///< unknown ones, a quaternion counting three
  int driven = 0;
  int constraints = 0;
  std::vector<std::string> no_joints;  ///< names of the constraints that are no joint of the structure graph
  int rank = 0;
  int internal = 0;  ///< freedoms that are left when the joints with the outside are blocked as well
  int freedoms() const { return coordinates - rank; }
  int useful() const { return freedoms() - internal; }
};
/// `closed_rank` is the rank where the loops are closed, near the start, if that is known: beside it, of which the start has some
/// digits, rows that repeat others look independent. Throws UsageError for an unknown joint in `inputs_outputs`, which are those
/// of MobilityOptions.
SceneFreedoms scene_freedoms(const Scene& scene, const std::vector<std::string>& inputs_outputs = {},
                             std::optional<std::size_t> closed_rank = {});

}  // namespace torsor
