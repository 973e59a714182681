// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/reduced_graph.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"

namespace torsor {
namespace {

std::string in_brackets(const std::string& name) {
  return name.find_first_of("/-") == std::string::npos ? name : "(" + name + ")";
}

class Reduction {
 public:
  Reduction(const std::vector<std::string>& bodies, const std::vector<TwistEdge>& edges, const NaturalLanguage& language)
      : say(language), bodies_(bodies), alive_(bodies.size(), true) {
    for (const TwistEdge& edge : edges) joints_.push_back({edge, recognise_twists(edge.motion.twists), true});
  }

  ReducedGraph run() {
    while (merge_weld() || merge_parallel() || merge_series()) {
    }
    ReducedGraph result;
    std::vector<int> place(bodies_.size());  // of the bodies that are left
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!alive_[b]) continue;
      place[b] = static_cast<int>(result.bodies.size());
      result.bodies.push_back(bodies_[b]);
    }
    std::vector<TwistEdge> edges;
    for (EquivalentJoint& joint : joints_) {
      joint.edge.a = place[as_index(joint.edge.a)];
      joint.edge.b = place[as_index(joint.edge.b)];
      edges.push_back(joint.edge);
    }
    result.joints = joints_;
    result.steps = steps_;
    result.count = count_mobility(static_cast<int>(result.bodies.size()), edges);
    return result;
  }

 private:
  bool merge_weld() {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].allows.freedoms > 0) continue;
      const int keep = std::min(joints_[j].edge.a, joints_[j].edge.b);
      const int gone = std::max(joints_[j].edge.a, joints_[j].edge.b);
      const std::string name = joints_[j].edge.name;
      joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(j));
      if (gone == keep) {
        steps_.push_back(
            {ReductionStep::Kind::weld, say("{} holds {} to itself", name, bodies_[as_index(keep)]), 6, 0});
        return true;
      }
      steps_.push_back({ReductionStep::Kind::weld,
                        say("{} holds {} to {}: one body", name, bodies_[as_index(gone)], bodies_[as_index(keep)]), 0,
                        0});
      alive_[as_index(gone)] = false;
      for (EquivalentJoint& joint : joints_) {
        if (joint.edge.a == gone) joint.edge.a = keep;
        if (joint.edge.b == gone) joint.edge.b = keep;
      }
      return true;
    }
    return false;
  }

  bool merge_parallel() {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      for (std::size_t j = i + 1; j < joints_.size(); ++j) {
        const TwistEdge& first = joints_[i].edge;
        const TwistEdge& second = joints_[j].edge;
        const bool same = (first.a == second.a && first.b == second.b) || (first.a == second.b && first.b == second.a);
        if (!same) continue;
        const RealRows common = intersection_of(first.motion.twists, second.motion.twists);
        const RealRows together = span_of(first.motion.twists, second.motion.twists);
        const auto text = [&, a = bodies_[as_index(first.a)], b = bodies_[as_index(first.b)], one = first.name,
                           two = second.name](const std::string& joint) {
          return say("{} and {} in parallel between {} and {}: {}", one, two, a, b, joint);
        };
        merge(i, j,
              {.twists = common,
               .sign = "//",
               .kind = ReductionStep::Kind::parallel,
               .text = text,
               .redundant = 6 - static_cast<int>(together.size())});
        return true;
      }
    }
    return false;
  }

  bool merge_series() {
    const std::vector<bool> in_loop = joints_in_loops();
    for (std::size_t body = 1; body < bodies_.size(); ++body) {
      std::vector<std::size_t> here;
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        const int number = static_cast<int>(body);
        if (joints_[j].edge.a == number || joints_[j].edge.b == number) here.push_back(j);
      }
      if (here.size() != 2) continue;
      const auto stays = [&](std::size_t j) { return joints_[j].edge.outside || !in_loop[j]; };
      if (stays(here[0]) || stays(here[1])) continue;
      const TwistEdge first = joints_[here[0]].edge, second = joints_[here[1]].edge;
      const RealRows all = span_of(first.motion.twists, second.motion.twists);
      const int lost = static_cast<int>(first.motion.twists.size() + second.motion.twists.size() - all.size());
      const int number = static_cast<int>(body);
      const int from = first.a == number ? first.b : first.a, to = second.a == number ? second.b : second.a;
      alive_[body] = false;
      const auto text = [&](const std::string& joint) {
        return say("{} and {} in series through {}: {}", first.name, second.name, bodies_[body], joint);
      };
      merge(here[0], here[1],
            {.twists = all, .sign = "-", .kind = ReductionStep::Kind::series, .text = text, .internal = lost});
      joints_[here[0]].edge.a = from;
      joints_[here[0]].edge.b = to;
      return true;
    }
    return false;
  }

  /// What two joints are replaced by.
  struct Equivalent {
    RealRows twists;  ///< that it allows
    std::string sign;  ///< between the names of the two
    ReductionStep::Kind kind;
    std::function<std::string(const std::string&)> text;  ///< the step in words, given those of the joint
    int redundant = 0;
    int internal = 0;
  };

  /// Puts the equivalent joint in the place of the first.
  void merge(std::size_t i, std::size_t j, const Equivalent& made) {
    EquivalentJoint& joint = joints_[i];
    const bool outside = joint.edge.outside || joints_[j].edge.outside;
    joint.edge.name = in_brackets(joint.edge.name) + made.sign + in_brackets(joints_[j].edge.name);
    joint.edge.outside = outside;
    joint.edge.motion = {made.twists, std::vector<std::string>(made.twists.size())};
    joint.allows = recognise_twists(made.twists);
    joint.made_of_one = false;
    steps_.push_back({made.kind, made.text(joint.allows.text(say)), made.redundant, made.internal});
    joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(j));
  }

  std::vector<bool> joints_in_loops() const {
    std::vector<GraphEdge> ends;
    for (const EquivalentJoint& joint : joints_) ends.emplace_back(joint.edge.a, joint.edge.b);
    std::vector<bool> in_loop(joints_.size(), false);
    for (const GraphLoop& loop : independent_loops(static_cast<int>(bodies_.size()), ends)) {
      for (const auto& step : loop.joints) in_loop[as_index(step.first)] = true;
    }
    return in_loop;
  }

  const NaturalLanguage& say;
  std::vector<std::string> bodies_;
  std::vector<bool> alive_;
  std::vector<EquivalentJoint> joints_;
  std::vector<ReductionStep> steps_;
};

bool same_joints(const ReducedGraph& a, const ReducedGraph& b) {
  if (a.joints.size() != b.joints.size()) return false;
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    const TwistClass& one = a.joints[j].allows;
    const TwistClass& other = b.joints[j].allows;
    if (a.joints[j].edge.name != b.joints[j].edge.name || one.freedoms != other.freedoms || one.type != other.type) {
      return false;
    }
  }
  return true;
}

}  // namespace

ReducedGraph reduce(const std::vector<std::string>& bodies, const std::vector<TwistEdge>& edges, const NaturalLanguage& say) {
  return Reduction(bodies, edges, say).run();
}

ReducedGraph reduced_graph(const Mobility& mobility, const NaturalLanguage& say) {
  const WorkingDigits precision(mobility_digits);
  std::vector<std::string> bodies;
  for (const GraphBody& body : mobility.graph.bodies) bodies.push_back(body.name);
  ReducedGraph given = reduce(bodies, mobility.given_edges, say);
  ReducedGraph generic = reduce(bodies, mobility.generic_edges, say);
  if (!mobility.singular && same_joints(given, generic)) return given;
  generic.special = true;
  return generic;
}

}  // namespace torsor
