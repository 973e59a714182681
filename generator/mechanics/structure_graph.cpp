// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/structure_graph.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"

namespace torsor {
namespace {

/// Whether a frame moves in its parent: its displacement is a function of time or of a coordinate that is not released.
bool moves(const SceneContent& scene, const FrameContent& frame) {
  if (frame.joint == JointKind::attitude) return true;
  if (frame.joint == JointKind::weld) return false;
  if (frame.displacement.depends_on(scene.time)) return true;
  for (const CoordinateContent& c : scene.coordinates) {
    if (!c.released && frame.displacement.depends_on(c.q)) return true;
  }
  for (const AttitudeContent& attitude : scene.attitudes) {
    for (const SymbolPointer& e : attitude.symbols->e) {
      if (frame.displacement.depends_on(e)) return true;
    }
  }
  return false;
}

class Builder {
 public:
  explicit Builder(const SceneContent& scene) : scene_(scene), group_(scene.frames.size()) {}

  StructureGraph build() {
    gather_groups();
    find_bodies();
    StructureGraph graph;
    for (const int root : roots_) graph.bodies.push_back({name_of(root), {}});
    body_of_frame_.assign(group_.size(), -1);
    for (std::size_t f = 0; f < group_.size(); ++f) body_of_frame_[f] = body_of(static_cast<int>(f));
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) {
      if (scene_.joints[j].of_tree) add_pieces(graph, static_cast<int>(j));
    }
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) {
      const JointContent& joint = scene_.joints[j];
      if (joint.of_tree) continue;
      graph.joints.push_back({joint.name,
                              joint.type,
                              freedom_count(joint.type),
                              body(joint.a),
                              body(joint.b),
                              true,
                              static_cast<int>(j),
                              {}});
    }
    for (const BodyContent& each : scene_.bodies) graph.bodies[as_index(body(each.frame))].parts.push_back(each.name);
    graph.body_of_frame = body_of_frame_;
    return graph;
  }

 private:
  int frame(const FrameReference& reference) const { return scene_.frame_index(reference, "the structure graph"); }
  int body(const FrameReference& reference) const { return body_of_frame_[as_index(frame(reference))]; }

  int root(int f) const {
    while (group_[as_index(f)] != f) f = group_[as_index(f)];
    return f;
  }

  bool is_named_weld(std::size_t f) const {
    return std::any_of(scene_.joints.begin(), scene_.joints.end(), [f](const JointContent& joint) {
      return joint.type == JointType::weld && joint.of_tree && as_index(joint.of_tree->last) == f;
    });
  }

  /// Frames that do not move in their parents are of one group; its root is the frame that moves, the ground, or the
  /// end of a weld that is named as a joint.
  void gather_groups() {
    for (std::size_t f = 0; f < group_.size(); ++f) {
      const FrameContent& each = scene_.frames[f];
      const bool rigid = each.parent && !moves(scene_, each) && !is_named_weld(f);
      group_[f] = rigid ? frame(*each.parent) : static_cast<int>(f);
    }
  }

  /// Groups at the end of a joint are bodies; those inside one are when something is attached to them.
  void find_bodies() {
    std::vector<bool> is_body(group_.size(), false);
    const auto attach = [&](int f) { is_body[as_index(root(f))] = true; };
    attach(0);
    for (const BodyContent& each : scene_.bodies) attach(frame(each.frame));
    end_of_.resize(group_.size());
    std::iota(end_of_.begin(), end_of_.end(), 0);
    for (const JointContent& joint : scene_.joints) {
      attach(frame(joint.a));
      attach(frame(joint.b));
    }
    for (const JointContent& joint : scene_.joints) {
      if (!joint.of_tree) continue;
      int end = joint.of_tree->last;
      for (int f = end; f >= joint.of_tree->first; --f) {
        if (is_body[as_index(root(f))]) end = f;
        end_of_[as_index(root(f))] = root(end);
      }
    }
    for (std::size_t f = 0; f < group_.size(); ++f) {
      if (is_body[f]) roots_.push_back(static_cast<int>(f));
    }
  }

  /// The ground's for the frame of a rotor, which is no body.
  int body_of(int f) const {
    const auto place = std::find(roots_.begin(), roots_.end(), end_of_[as_index(root(f))]);
    return place == roots_.end() ? 0 : static_cast<int>(place - roots_.begin());
  }

  /// Of the frames of a body, one that shares its name with an inertia has the body's; else the first that is not
  /// inside a joint has a name its author gave.
  std::string name_of(int of_root) const {
    for (const BodyContent& each : scene_.bodies) {
      const int at = frame(each.frame);
      if (of_root > 0 && root(at) == of_root && scene_.frames[as_index(at)].name == each.name) return each.name;
    }
    for (std::size_t f = 0; f < group_.size(); ++f) {
      const std::string& name = scene_.frames[f].name;
      if (root(static_cast<int>(f)) == of_root && name.find('.') == std::string::npos) return name;
    }
    return scene_.frames[as_index(of_root)].name;
  }

  int freedoms_of(const JointContent& joint, int f) const {
    if (joint.type == JointType::helical && f != joint.of_tree->last) return 0;  // the slide follows the turn
    return scene_.frames[as_index(f)].joint == JointKind::attitude ? 3 : 1;
  }

  /// One joint of the graph for each stretch between bodies.
  void add_pieces(StructureGraph& graph, int j) const {
    const JointContent& joint = scene_.joints[as_index(j)];
    if (joint.type == JointType::weld) {
      graph.joints.push_back({joint.name, joint.type, 0, body(joint.a), body(joint.b), false, j, {}});
      return;
    }
    std::vector<GraphJoint> pieces;
    int from = body(joint.a);
    GraphJoint piece;
    bool whole = true;
    for (int f = joint.of_tree->first; f <= joint.of_tree->last; ++f) {
      if (root(f) != f) {
        whole = false;
        continue;
      }
      piece.frames.push_back(f);
      piece.freedoms += freedoms_of(joint, f);
      if (!is_end(f)) continue;
      piece.a = from;
      piece.b = from = body_of_frame_[as_index(f)];
      pieces.push_back(piece);
      piece = {};
    }
    for (GraphJoint& each : pieces) {
      each.scene_joint = j;
      each.name = pieces.size() == 1 ? joint.name : scene_.frames[as_index(each.frames.back())].name;
      if (pieces.size() == 1 && whole) {
        each.type = joint.type;
      } else if (each.frames.size() == 1) {
        const JointKind kind = scene_.frames[as_index(each.frames[0])].joint;
        each.type = kind == JointKind::revolute    ? JointType::revolute
                    : kind == JointKind::prismatic ? JointType::prismatic
                                                   : JointType::spherical;
      }
      graph.joints.push_back(each);
    }
  }

  bool is_end(int f) const { return std::binary_search(roots_.begin(), roots_.end(), f); }

  const SceneContent& scene_;
  std::vector<int> group_;   ///< of a frame: a frame of the same body nearer to the ground, itself at the root
  std::vector<int> end_of_;  ///< of a group's root: the root of the body at the end of the joint it is inside of
  std::vector<int> roots_;   ///< of the bodies, ascending
  std::vector<int> body_of_frame_;
};

}  // namespace

StructureGraph structure_graph(const Scene& scene) { return Builder(scene.content()).build(); }

std::vector<GraphEdge> StructureGraph::edges() const {
  std::vector<GraphEdge> all;
  for (const GraphJoint& joint : joints) all.emplace_back(joint.a, joint.b);
  return all;
}

int StructureGraph::parameter_count() const {
  int count = 0;
  for (const GraphJoint& joint : joints) count += joint.freedoms;
  return count;
}

}  // namespace torsor
