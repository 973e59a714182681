// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/inverse_operational_inertia.hpp"

#include <array>

namespace torsor {
namespace {

using Six = std::array<Value, 6>;
using SixBySix = std::array<Six, 6>;

Six together(const Vector& a, const Vector& b) { return {a[0], a[1], a[2], b[0], b[1], b[2]}; }

SixBySix together(const InverseOperationalInertia& c) {
  SixBySix all;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int row = static_cast<int>(i), column = static_cast<int>(j);
      all[i][j] = c.angular(row, column);
      all[i][j + 3] = all[j + 3][i] = c.mixed(row, column);
      all[i + 3][j + 3] = c.linear(row, column);
    }
  }
  return all;
}

InverseOperationalInertia apart(const SixBySix& all) {
  InverseOperationalInertia c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int row = static_cast<int>(i), column = static_cast<int>(j);
      c.angular(row, column) = all[i][j];
      c.mixed(row, column) = all[i][j + 3];
      c.linear(row, column) = all[i + 3][j + 3];
    }
  }
  return c;
}

/// An axis along one of the link's: its component of the six, and 1 or −1.
struct AlignedAxis {
  std::size_t along;
  Value sense;
};

/// The row of the joint alone changes: −Σ of the others with g, and 1/d on the diagonal.
void give_way(Program& program, const AlignedAxis& axis, const ArticulatedJoint& joint, SixBySix& c) {
  const auto& [along, sense] = axis;
  const Six gain = together(joint.gain.moment, joint.gain.resultant);
  Six row;
  for (std::size_t i = 0; i < 6; ++i) {
    if (i == along) continue;
    Value sum;
    for (std::size_t k = 0; k < 6; ++k) {
      if (k != along) sum -= gain[k] * c[k][i];
    }
    row[i] = program.bind(sense * program.bind(sum));
  }
  Value diagonal = joint.inverse;
  for (std::size_t k = 0; k < 6; ++k) {
    if (k != along) diagonal -= gain[k] * (sense * row[k]);
  }
  row[along] = program.bind(diagonal);
  for (std::size_t i = 0; i < 6; ++i) c[along][i] = c[i][along] = row[i];
}

/// C − s hᵀ − h sᵀ + s (g · h + 1/d) sᵀ with h = C g.
void give_way(Program& program, const Six& axis, const ArticulatedJoint& joint, SixBySix& c) {
  const Six gain = together(joint.gain.moment, joint.gain.resultant);
  Six h;
  Value square = joint.inverse;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) h[i] += c[i][k] * gain[k];
    h[i] = program.bind(h[i]);
  }
  for (std::size_t i = 0; i < 6; ++i) square += gain[i] * h[i];
  square = program.bind(square);
  for (std::size_t i = 0; i < 6; ++i) {
    const Value own = program.bind(axis[i] * square);
    for (std::size_t j = 0; j <= i; ++j) {
      Value entry = c[i][j] - axis[i] * h[j];
      entry -= axis[j] * h[i];
      entry += axis[j] * own;
      c[i][j] = c[j][i] = program.bind(entry);
    }
  }
}

}  // namespace

AccelerationIncrement InverseOperationalInertia::operator*(const Wrench& wrench) const {
  AccelerationIncrement change;
  change.angular = angular * wrench.moment;
  change.angular += mixed * wrench.resultant;
  change.linear = transpose(mixed) * wrench.moment;
  change.linear += linear * wrench.resultant;
  return change;
}

InverseOperationalInertia from_parent(const BodyTree& tree, const Link& link, const InverseOperationalInertia& parent) {
  Program& program = tree.program();
  // β + α ∧ r: D + A [r], and L + Dᵀ [r] − [r] (D + A [r]).
  const Matrix arm = cross_matrix(bound(program, tree.arm(link)));
  const Matrix mixed = bound(program, parent.mixed + parent.angular * arm);
  const Matrix left = transpose(parent.mixed) * arm;
  const Matrix right = arm * mixed;
  Matrix linear;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      Value entry = parent.linear(i, j) + left(i, j);
      entry -= right(i, j);
      linear(i, j) = linear(j, i) = program.bind(entry);
    }
  }
  InverseOperationalInertia seen;
  seen.angular = tree.from_parent(link, parent.angular);
  seen.mixed = tree.from_parent(link, mixed);
  seen.linear = tree.from_parent(link, linear);
  return seen;
}

AccelerationIncrement reaction(Program& program, const Link& link, const ArticulatedJoint& joint,
                               const InertiaAcrossJoint& inertia) {
  const auto& [before, after] = inertia;
  if (!link.aligned) {
    const AccelerationIncrement opposite = before * joint.gain;
    const Vector angular = bound(program, -opposite.angular);
    return {angular, bound(program, -opposite.linear)};
  }
  // C' has −Σ of the others in the joint's row, so that C g is the difference there.
  const auto along = static_cast<std::size_t>(*link.aligned + (link.joint == JointKind::revolute ? 0 : 3));
  const Value& sense = link.axis[*link.aligned];
  const Six gain = together(joint.gain.moment, joint.gain.resultant);
  const SixBySix c = together(before), with = together(after);
  Six answer;
  for (std::size_t i = 0; i < 6; ++i) {
    if (i != along) {
      answer[i] = sense * program.bind(with[along][i] - c[along][i]);
      continue;
    }
    Value sum;
    for (std::size_t k = 0; k < 6; ++k) sum -= gain[k] * c[k][along];
    answer[i] = program.bind(sum);
  }
  return {Vector(answer[0], answer[1], answer[2]), Vector(answer[3], answer[4], answer[5])};
}

InverseOperationalInertia with_joint(Program& program, const Link& link, const ArticulatedJoint& joint,
                                     const InverseOperationalInertia& before) {
  SixBySix all = together(before);
  const bool revolute = link.joint == JointKind::revolute;
  if (link.aligned) {
    const auto along = static_cast<std::size_t>(*link.aligned + (revolute ? 0 : 3));
    give_way(program, AlignedAxis{along, link.axis[*link.aligned]}, joint, all);
  } else {
    const Six axis = revolute ? together(link.axis, Vector()) : together(Vector(), link.axis);
    give_way(program, axis, joint, all);
  }
  return apart(all);
}

}  // namespace torsor
