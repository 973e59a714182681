// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/articulated_bodies.hpp"

namespace torsor {
namespace {

Matrix added(Program& program, const Matrix& a, const Matrix& b) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = program.bind(a(i, j) + b(i, j));
  }
  return result;
}

ArticulatedInertia rigid(const MassProperties& body) {
  ArticulatedInertia own;
  own.angular = body.inertia;
  own.coupling = cross_matrix(body.first_moment);
  for (int i = 0; i < 3; ++i) own.linear(i, i) = body.mass;
  return own;
}

ArticulatedJoint joint_of(Program& program, const Link& link, const ArticulatedInertia& body) {
  const bool revolute = link.joint == JointKind::revolute;
  const Vector moment = bound(program, (revolute ? body.angular : body.coupling) * link.axis);
  const Vector resultant = bound(program, (revolute ? transpose(body.coupling) : body.linear) * link.axis);
  ArticulatedJoint joint;
  joint.pivot = program.bind(dot(link.axis, revolute ? moment : resultant), "pivot");
  joint.inverse = program.bind(pow(joint.pivot, -1));
  for (const bool turning : {true, false}) {
    for (int i = 0; i < 3; ++i) {
      Value& gain = turning ? joint.gain.moment[i] : joint.gain.resultant[i];
      // The axis may be minus x, y or z: I s/d along it is then -1.
      gain = is_along_joint(link, i, turning) ? link.axis[i]
                                              : program.bind((turning ? moment : resultant)[i] * joint.inverse);
    }
  }
  return joint;
}

/// I − d g gᵀ. Along an aligned axis the row of the joint vanishes exactly and is left out.
ArticulatedInertia without_joint(Program& program, const Link& link, const ArticulatedInertia& body,
                                 const ArticulatedJoint& joint) {
  const bool revolute = link.joint == JointKind::revolute;
  const Vector moment = bound(program, (revolute ? body.angular : body.coupling) * link.axis);
  const Vector resultant = bound(program, (revolute ? transpose(body.coupling) : body.linear) * link.axis);
  const auto reduced = [&](const Value& entry, const Value& row, const Value& column, bool zero) {
    return zero ? Value() : program.bind(entry - row * column);
  };
  ArticulatedInertia rest;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const bool zero_h = is_along_joint(link, i, true) || is_along_joint(link, j, false);
      rest.coupling(i, j) = reduced(body.coupling(i, j), joint.gain.moment[i], resultant[j], zero_h);
      if (j > i) continue;
      const bool zero_j = is_along_joint(link, i, true) || is_along_joint(link, j, true);
      const bool zero_m = is_along_joint(link, i, false) || is_along_joint(link, j, false);
      rest.angular(i, j) = rest.angular(j, i) = reduced(body.angular(i, j), joint.gain.moment[i], moment[j], zero_j);
      rest.linear(i, j) = rest.linear(j, i) = reduced(body.linear(i, j), joint.gain.resultant[i], resultant[j], zero_m);
    }
  }
  return rest;
}

/// Adds what a link hands over to the answer of its parent. Moved by r: H + [r] M, and J − H [r] + [r] (H + [r] M)ᵀ.
void hand_over(const BodyTree& tree, const Link& link, const ArticulatedInertia& body, ArticulatedInertia& parent) {
  Program& program = tree.program();
  const Matrix arm = cross_matrix(bound(program, tree.arm(link)));
  const Matrix angular = tree.to_parent(link, body.angular);
  const Matrix coupling = tree.to_parent(link, body.coupling);
  const Matrix linear = tree.to_parent(link, body.linear);
  const Matrix moved = added(program, coupling, arm * linear);
  const Matrix left = coupling * arm;
  const Matrix right = arm * transpose(moved);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      Value entry = angular(i, j) - left(i, j);
      entry += right(i, j);
      parent.angular(i, j) = parent.angular(j, i) = program.bind(parent.angular(i, j) + program.bind(entry));
    }
  }
  parent.coupling = added(program, parent.coupling, moved);
  parent.linear = added(program, parent.linear, linear);
}

}  // namespace

Wrench ArticulatedInertia::operator*(const AccelerationIncrement& change) const {
  Wrench wrench;
  wrench.moment = angular * change.angular;
  wrench.moment += coupling * change.linear;
  wrench.resultant = transpose(coupling) * change.angular;
  wrench.resultant += linear * change.linear;
  return wrench;
}

Matrix cross_matrix(const Vector& v) {
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    m(i, j) = -v[k];
    m(i, k) = v[j];
  }
  return m;
}

ArticulatedBodies articulated_bodies(const BodyTree& tree) {
  const auto& links = tree.links();
  ArticulatedBodies result;
  result.joints.resize(links.size());
  result.seen_by_parent.resize(links.size());
  std::vector<ArticulatedInertia> bodies;
  for (const Link& link : links) bodies.push_back(rigid(link.mass));
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    result.seen_by_parent[k] = bodies[k];
    if (is_free(link)) result.joints[k] = joint_of(tree.program(), link, bodies[k]);
    if (link.parent == 0) continue;
    if (is_free(link)) result.seen_by_parent[k] = without_joint(tree.program(), link, bodies[k], result.joints[k]);
    hand_over(tree, link, result.seen_by_parent[k], bodies[static_cast<std::size_t>(link.parent)]);
  }
  return result;
}

}  // namespace torsor
