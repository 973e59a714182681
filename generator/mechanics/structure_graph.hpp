// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Frames that never move relative to one another: a vertex of the structure graph. Body 0 is the ground.
struct GraphBody {
  std::string name;
  std::vector<std::string> parts;  ///< inertias of the scene that are attached
};

/// A joint between two bodies: an edge of the structure graph.
struct GraphJoint {
  std::string name;
  std::optional<JointType> type;  ///< none for a piece of a joint, or one with a part held fixed
  int freedoms = 0;
  int a = 0, b = 0;  ///< bodies
  bool closes_loop = false;
  int scene_joint = 0;      ///< index in SceneContent::joints
  std::vector<int> frames;  ///< of the tree: those that move, in order
};

/// A loop of the graph: joints with the sense (+1 from a to b) in which it runs through them, and the bodies it visits,
/// the first one again at the end.
struct GraphLoop {
  int closing = 0;  ///< the joint that no other loop has, run through from a to b
  std::vector<std::pair<int, int>> joints;
  std::vector<int> bodies;
};

/// Ends of an edge.
using GraphEdge = std::pair<int, int>;

/// As many loops as are independent, n_edges − n_bodies + n_components: one for each edge that a spanning tree (edges
/// taken in order) leaves out. Each begins and ends at the body of the loop nearest to body 0.
std::vector<GraphLoop> independent_loops(int bodies, const std::vector<GraphEdge>& edges);

/// Cyclomatic number μ = n_joints − n_bodies + 1 of a connected graph (the ground counts as a body); one more for each
/// further component.
int cyclomatic_number(int bodies, const std::vector<GraphEdge>& edges);

/// Bodies and joints of a scene (Pommier, Dynamique des systèmes de solides, §3.5.4). Frames welded in the tree, and
/// frames whose displacement is constant or a released coordinate, are one body; frames between the freedoms of one
/// joint are none, unless an inertia or another joint is attached there. A weld that closes a loop, or that is named as
/// a joint (Scene::name_joint), is a joint with no freedom.
struct StructureGraph {
  std::vector<GraphBody> bodies;
  std::vector<GraphJoint> joints;  ///< those of the tree first, then those that close loops
  std::vector<int> body_of_frame;  ///< by frame of the scene; of a frame inside a joint, the body at its end

  std::vector<GraphEdge> edges() const;
  int parameter_count() const;  ///< n_p = Σ freedoms
};
StructureGraph structure_graph(const Scene& scene);

/// "P(ground/rocker)·P(rocker/coupler)·P(coupler/crank)·P(crank/ground) = I": the geometric closure of a loop's
/// orientations, P(b_i/b_j) the array that turns components along b_j into components along b_i: what is read from the
/// right runs once around the loop (Pommier, §3.5.4, with the order mended).
std::string orientation_closure(const StructureGraph& graph, const GraphLoop& loop);
/// "O_ground O_crank + O_crank O_coupler + ... = 0"
std::string position_closure(const StructureGraph& graph, const GraphLoop& loop);
/// "{V(crank/ground)} + ... + {V(ground/rocker)} = 0": twists all reduced at one point.
std::string twist_closure(const StructureGraph& graph, const GraphLoop& loop);

}  // namespace torsor
