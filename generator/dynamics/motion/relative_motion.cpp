// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/relative_motion.hpp"

#include <algorithm>

namespace torsor {
namespace {

/// Velocities for a unit rate of one joint, reduced at the point.
Twist joint_twist(const Model& model, int k, const SeenPoint& point) {
  const int axes = point.axes;
  const Link& joint = model.links()[static_cast<std::size_t>(k)];
  Program& program = model.program();
  const Vector axis = bound(program, model.express(model.axis_in_parent(joint), joint.parent, axes));
  if (joint.joint == JointKind::prismatic) return {Vector(), axis};
  return {axis, bound(program, cross(axis, model.arm_of(k, point)))};
}

}  // namespace

RelativeMotion::RelativeMotion(const Model& model, int a, int b, const SeenPoint& point) : model_(model) {
  const std::vector<int> to_a = model.chain(a);
  const std::vector<int> to_b = model.chain(b);
  const auto add = [&](const std::vector<int>& chain, const std::vector<int>& other, bool negative) {
    for (const int k : chain) {
      if (std::find(other.begin(), other.end(), k) != other.end()) continue;
      const Link& joint = model_.links()[static_cast<std::size_t>(k)];
      Twist per_rate = joint_twist(model_, k, point);
      if (negative) per_rate = {-per_rate.angular, -per_rate.linear};
      twist_.angular += joint.rate * per_rate.angular;
      twist_.linear += joint.rate * per_rate.linear;
      joints_.push_back(k);
      per_rate_.push_back(std::move(per_rate));
    }
  };
  add(to_a, to_b, false);
  add(to_b, to_a, true);
  twist_.angular = bound(model.program(), twist_.angular);
  twist_.linear = bound(model.program(), twist_.linear);
}

std::vector<Value> RelativeMotion::generalised_forces(const Wrench& wrench) const {
  Program& program = model_.program();
  std::vector<Value> forces(model_.coordinates().size());
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const Link& joint = model_.links()[static_cast<std::size_t>(joints_[k])];
    if (joint.partials.empty()) continue;
    const Value effort = program.bind(reciprocal_product(wrench, per_rate_[k]));
    for (const auto& [i, partial] : joint.partials) forces[static_cast<std::size_t>(i)] += effort * partial;
  }
  for (Value& force : forces) force = program.bind(force);
  return forces;
}

}  // namespace torsor
