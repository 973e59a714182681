// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/forces/virtual_power.hpp"

namespace torsor {
namespace {

std::size_t unknown_of(const Link& link) { return static_cast<std::size_t>(link.partials[0].first); }

class Recursion {
 public:
  Recursion(const BodyTree& tree, const std::vector<Value>& efforts) : tree_(tree), efforts_(efforts) {}

  ArticulatedMotion run(const std::map<int, Wrench>& wrenches, ArticulatedBodies bodies) {
    motion_.reference = reference_motion(tree_, std::vector<Axes>(links_.size(), Axes::own));
    motion_.bodies = std::move(bodies);
    motion_.bias_forces.resize(links_.size());
    efforts_by_pivot_.resize(links_.size());
    for (std::size_t k = links_.size(); k-- > 1;) {
      Wrench own = screw_less_gravity(program_, motion_.reference.links[k], links_[k]);
      if (const auto wrench = wrenches.find(static_cast<int>(k)); wrench != wrenches.end()) {
        const Wrench applied = tree_.applied(k, wrench->second);
        own.resultant += -applied.resultant;
        own.moment += -applied.moment;
      }
      ask(k, own);
    }
    accelerate();
    return std::move(motion_);
  }

 private:
  /// The wrench of link k and of those that it carries, less what its joint gives way to.
  void ask(std::size_t k, const Wrench& own) {
    const Link& link = links_[k];
    Wrench& wrench = motion_.bias_forces[k];  // holds the sum over those that it carries
    wrench.resultant = bound(program_, wrench.resultant + own.resultant);
    wrench.moment = bound(program_, wrench.moment + own.moment);
    if (is_free(link)) give_way(k, wrench);
    if (link.parent == 0) return;
    Wrench& parent = motion_.bias_forces[static_cast<std::size_t>(link.parent)];
    const Vector force = tree_.to_parent(link, wrench.resultant);
    const Vector origin = bound(program_, tree_.arm(link));
    parent.resultant += force;
    parent.moment += tree_.to_parent(link, wrench.moment);
    parent.moment += cross(origin, force);
  }

  /// p + g u, with u = effort − s · p: along an aligned axis that is the effort.
  void give_way(std::size_t k, Wrench& wrench) {
    const Link& link = links_[k];
    const ArticulatedJoint& joint = motion_.bodies.joints[k];
    motion_.solution.pivots.push_back({joint.pivot, joint.pivot});
    const Value& effort = efforts_[unknown_of(link)];
    const bool revolute = link.joint == JointKind::revolute;
    const Value rest = program_.bind(effort - dot(link.axis, revolute ? wrench.moment : wrench.resultant));
    efforts_by_pivot_[k] = program_.bind(joint.inverse * rest);
    for (const bool turning : {true, false}) {
      for (int i = 0; i < 3; ++i) {
        Value& entry = turning ? wrench.moment[i] : wrench.resultant[i];
        const Value& gain = turning ? joint.gain.moment[i] : joint.gain.resultant[i];
        entry = is_along_joint(link, i, turning) ? effort * link.axis[i] : program_.bind(entry + gain * rest);
      }
    }
  }

  void accelerate() {
    ForwardSolution& solution = motion_.solution;
    solution.method = "the articulated-body recursion";
    solution.accelerations.resize(static_cast<std::size_t>(tree_.unknown_count()));
    motion_.before.resize(links_.size());
    motion_.added.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const Link& link = links_[k];
      motion_.before[k] = from_parent(tree_, link, motion_.added[static_cast<std::size_t>(link.parent)]);
      motion_.added[k] = motion_.before[k];
      if (!is_free(link)) continue;
      const JointResponse change =
          joint_response(tree_, {link, motion_.bodies.joints[k], efforts_by_pivot_[k]}, motion_.before[k]);
      motion_.added[k] = change.after;
      const Value whole = change.acceleration + motion_.reference.joints[k];
      solution.accelerations[unknown_of(link)] = program_.bind(whole, "acceleration of joint " + link.name);
    }
  }

  const BodyTree& tree_;
  Program& program_ = tree_.program();
  const std::vector<Link>& links_ = tree_.links();
  const std::vector<Value>& efforts_;
  std::vector<Value> efforts_by_pivot_;
  ArticulatedMotion motion_;
};

}  // namespace

bool has_simple_joints(const BodyTree& tree) {
  std::vector<int> uses(static_cast<std::size_t>(tree.unknown_count()), 0);
  for (const Link& link : tree.links()) {
    std::size_t unknowns = 0;
    for (const auto& [i, partial] : link.partials) {
      if (i >= tree.unknown_count()) continue;
      if (!partial.is_number(1) || !partial.unit().is_dimensionless()) return false;  // a pitch of 1 m is none
      // A displacement q + f(t) has another second derivative than q.
      if (!(link.acceleration - tree.a(i)).is_zero()) return false;
      ++unknowns;
      ++uses[static_cast<std::size_t>(i)];
    }
    if (unknowns > 1 || unknowns != link.partials.size()) return false;
  }
  return std::all_of(uses.begin(), uses.end(), [](int use) { return use == 1; });
}

AccelerationIncrement from_parent(const BodyTree& tree, const Link& link, const AccelerationIncrement& parent) {
  Program& program = tree.program();
  const Vector origin = bound(program, tree.arm(link));
  const Vector carried = bound(program, parent.linear + cross(parent.angular, origin));
  AccelerationIncrement own;
  own.angular = tree.from_parent(link, parent.angular);
  own.linear = tree.from_parent(link, carried);
  return own;
}

JointResponse joint_response(const BodyTree& tree, const JointThatMoves& joint, const AccelerationIncrement& before) {
  Program& program = tree.program();
  const Link& link = joint.link;
  const Wrench& gain = joint.inertia.gain;
  const bool revolute = link.joint == JointKind::revolute;
  AccelerationIncrement after = before;
  if (!link.aligned) {
    Value rest = joint.effort_by_pivot - dot(gain.moment, before.angular);
    rest -= dot(gain.resultant, before.linear);
    const Value acceleration = program.bind(rest);
    Vector& moved = revolute ? after.angular : after.linear;
    moved = bound(program, moved + acceleration * link.axis);
    return {acceleration, after};
  }
  Value along = joint.effort_by_pivot;  // of the link's matter, along the axis of the joint
  for (int i = 0; i < 3; ++i) {
    if (!is_along_joint(link, i, true)) along -= gain.moment[i] * before.angular[i];
    if (!is_along_joint(link, i, false)) along -= gain.resultant[i] * before.linear[i];
  }
  along = program.bind(along);
  const Value& own_before = (revolute ? before.angular : before.linear)[*link.aligned];
  const Value sense = link.axis[*link.aligned];
  (revolute ? after.angular : after.linear)[*link.aligned] = sense * along;
  return {program.bind(along - sense * own_before), after};
}

ArticulatedMotion articulated_motion(const BodyTree& tree, const std::vector<Value>& efforts,
                                     const std::map<int, Wrench>& wrenches, ArticulatedBodies bodies) {
  return Recursion(tree, efforts).run(wrenches, std::move(bodies));
}

ForwardSolution articulated_forward(const Model& model, const std::vector<Value>& efforts,
                                    const std::map<int, Wrench>& wrenches) {
  ArticulatedBodies bodies = articulated_bodies(model.regrouped());
  return articulated_motion(model.without_lines(), efforts, wrenches, std::move(bodies)).solution;
}

}  // namespace torsor
