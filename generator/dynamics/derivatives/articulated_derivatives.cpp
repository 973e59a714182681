// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/articulated_derivatives.hpp"

#include <array>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/motion/joint_changes.hpp"
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/dynamics/recursions/inverse_operational_inertia.hpp"

namespace torsor {
namespace {

/// What an articulated body asks for a turning w of its parent: N = moment · w, F = resultant · w.
struct TurningAnswer {
  Matrix moment, resultant;
};

/// q̈ of one joint as a function of what a link does: angular · α + linear · β + turning · w.
struct AccelerationRow {
  Vector angular, linear, turning;
};

/// A small change of one joint, at the origin of the link before which it acts, in its axes.
struct JointPerturbation {
  std::size_t joint;          ///< unknown
  Vector w;                   ///< turning of all links beyond
  AccelerationIncrement change;  ///< their {α, β}
  Wrench asked;               ///< of the parent
  AccelerationIncrement met;     ///< their {α, β} when the parent gives way
};

constexpr std::array<ValueMatrix ForwardDerivatives::Of::*, 2> by_kind{&ForwardDerivatives::Of::by_position,
                                                                       &ForwardDerivatives::Of::by_velocity};

class ArticulatedDerivatives {
 public:
  explicit ArticulatedDerivatives(const Equations& equations)
      : equations_(equations),
        n_(static_cast<std::size_t>(tree_.unknown_count())),
        efforts_(all_efforts()),
        free_(articulated_motion(tree_, efforts_, {}, articulated_bodies(tree_))),
        motion_(with_joint_accelerations()),
        joints_(tree_, motion_) {}

  ForwardDerivatives run() {
    children_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) children_[parent(k)].push_back(k);
    ForwardDerivatives::Of& of = result_.accelerations;
    of.by_position.assign(n_, std::vector<Value>(n_));
    of.by_velocity = of.by_force = of.by_position;
    result_.pivots = free_.solution.pivots;
    result_.method = "articulated bodies";
    gather_velocities();
    gather_answers();
    gather_inverse_inertias();
    perturbations_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (is_free(links_[k])) perturb(k);
    }
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (!is_free(links_[k])) continue;
      carry_column(k);
      carry_row(k);
    }
    add_efforts();
    return std::move(result_);
  }

 private:
  std::size_t parent(std::size_t k) const { return static_cast<std::size_t>(links_[k].parent); }
  std::size_t unknown(std::size_t k) const { return static_cast<std::size_t>(links_[k].partials[0].first); }

  std::vector<Value> all_efforts() const {
    std::vector<Value> efforts = equations_.of_inputs();
    for (std::size_t i = 0; i < n_; ++i) efforts[i] = program_.bind(efforts[i] + equations_.actions().passive[i]);
    return efforts;
  }

  std::vector<Acceleration> with_joint_accelerations() const {
    std::vector<Acceleration> all;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const Acceleration& rest = free_.reference.links[k];
      const Vector angular = bound(program_, rest.angular() + free_.added[k].angular);
      const Vector linear = bound(program_, rest.linear() + free_.added[k].linear);
      all.emplace_back(program_, links_[k].name, rest.omega(), angular, linear);
    }
    return all;
  }

  void gather_velocities() {
    doubled_velocities_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const Vector v = doubled_velocities_[parent(k)] + joints_.doubled_velocity(links_[k]);
      doubled_velocities_[k] = tree_.from_parent(links_[k], bound(program_, v));
    }
  }

  /// B of every link before its joint gives way, then of what the joint leaves.
  void gather_answers() {
    answers_.resize(links_.size());
    turning_gains_.resize(links_.size());
    for (std::size_t k = links_.size(); k-- > 1;) {
      const Link& link = links_[k];
      TurningAnswer& answer = answers_[k];  // holds the sum over those that it carries
      add_own(k, answer);
      if (is_free(link)) give_way(k, answer);
      if (link.parent == 0) continue;
      const Matrix resultant = tree_.to_parent(link, answer.resultant);
      Matrix moment = tree_.to_parent(link, answer.moment);
      moment += cross_matrix(bound(program_, tree_.arm(link))) * resultant;
      TurningAnswer& all = answers_[parent(k)];
      all.resultant = bound(program_, all.resultant + resultant);
      all.moment = bound(program_, all.moment + moment);
    }
  }

  /// −Q and tr(Q) 1 − Q are one where Q = [2 Ω] S, S symmetric; with V, (2 V · h) 1 − 2 V hᵀ is added.
  void add_own(std::size_t k, TurningAnswer& answer) const {
    const MassProperties& body = links_[k].mass;
    const Vector &v = doubled_velocities_[k], &h = body.first_moment;
    const PointFlow flow = rigid_flow(program_, body, joints_.doubled_omega(k));
    answer.resultant = bound(program_, answer.resultant - cross_matrix(bound(program_, flow.l + body.mass * v)));
    Vector along;
    for (int i = 0; i < 3; ++i) along[i] = program_.bind(v[i] * h[i]);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Value entry = answer.moment(i, j) - flow.q(i, j);
        if (i == j) {
          entry += along[(i + 1) % 3];
          entry += along[(i + 2) % 3];
        } else {
          entry -= v[i] * h[j];
        }
        answer.moment(i, j) = program_.bind(entry);
      }
    }
  }

  void give_way(std::size_t k, TurningAnswer& answer) {
    const Link& link = links_[k];
    const Matrix& own = link.joint == JointKind::revolute ? answer.moment : answer.resultant;
    const Vector along = bound(program_, transpose(own) * link.axis);
    const ArticulatedJoint& joint = free_.bodies.joints[k];
    turning_gains_[k] = bound(program_, joint.inverse * along);
    for (const bool turning : {true, false}) {
      Matrix& rows = turning ? answer.moment : answer.resultant;
      for (int i = 0; i < 3; ++i) {
        const Value& gain = turning ? joint.gain.moment[i] : joint.gain.resultant[i];
        for (int j = 0; j < 3; ++j) {
          rows(i, j) = is_along_joint(link, i, turning) ? Value() : program_.bind(rows(i, j) - gain * along[j]);
        }
      }
    }
  }

  void gather_inverse_inertias() {
    before_.resize(links_.size());
    inverse_inertias_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      before_[k] = from_parent(tree_, links_[k], inverse_inertias_[parent(k)]);
      inverse_inertias_[k] =
          is_free(links_[k]) ? with_joint(program_, links_[k], free_.bodies.joints[k], before_[k]) : before_[k];
    }
  }

  /// What joint k does to the links beyond, both ways. Joints of one quaternion act before the first of its links.
  void perturb(std::size_t k) {
    const std::size_t at = joints_.first_of_group(k);
    std::array<MotionChange, 2> changes;
    changes[0] = joints_.by_position(k);
    changes[1] = joints_.by_velocity(k);
    for (std::size_t kind = 0; kind < 2; ++kind) {
      MotionChange& motion = changes[kind];
      motion.beta = bound(program_, motion.beta - cross(motion.w, doubled_velocities_[at]));
      JointPerturbation perturbation{unknown(k), motion.w, {motion.alpha, motion.beta}, {}, {}};
      perturbation.met = perturbation.change;
      if (links_[at].parent != 0) {
        Wrench& asked = perturbation.asked;
        asked = free_.bodies.seen_by_parent[at] * perturbation.change;
        asked.moment += answers_[at].moment * motion.w;
        asked.resultant += answers_[at].resultant * motion.w;
        if (kind == 0) add_turned_load(k, asked);
        asked.moment = bound(program_, asked.moment);
        asked.resultant = bound(program_, asked.resultant);
        const AccelerationIncrement yield = before_[at] * asked;
        perturbation.met.angular = bound(program_, motion.alpha - yield.angular);
        perturbation.met.linear = bound(program_, motion.beta - yield.linear);
      }
      perturbations_[at][kind].push_back(std::move(perturbation));
    }
  }

  /// The wrench that is asked already turns with the joint, or its line of action slides.
  void add_turned_load(std::size_t k, Wrench& asked) const {
    const Link& link = links_[k];
    const std::size_t node = tree_.turning_link(k);
    Wrench load = free_.bodies.seen_by_parent[node] * free_.before[node];
    load.resultant = bound(program_, load.resultant + free_.bias_forces[node].resultant);
    load.moment = bound(program_, load.moment + free_.bias_forces[node].moment);
    const bool revolute = link.joint == JointKind::revolute;
    asked.moment += cross(link.axis, revolute ? load.moment : load.resultant);
    if (revolute) asked.resultant += cross(link.axis, load.resultant);
  }

  AccelerationRow row_before(std::size_t k) const {
    const ArticulatedJoint& joint = free_.bodies.joints[k];
    return {-joint.gain.moment, -joint.gain.resultant, -turning_gains_[k]};
  }

  /// q̈_k for changes of the joints that carry it and of its own; forces at k on what those carry otherwise.
  void carry_row(std::size_t k) {
    AccelerationRow row = row_before(k);
    const AccelerationIncrement own =
        reaction(program_, links_[k], free_.bodies.joints[k], {before_[k], inverse_inertias_[k]});
    for (std::size_t at = k;;) {
      for (std::size_t kind = 0; kind < 2; ++kind) {
        for (const JointPerturbation& joint : perturbations_[at][kind]) {
          // Of the joint itself by reciprocity: what its force does to the parent tells what the parent does to it.
          const AccelerationIncrement& change = at == k ? joint.change : joint.met;
          Value entry = dot(row.angular, change.angular) + dot(row.linear, change.linear);
          entry += dot(row.turning, joint.w);
          if (at == k) entry -= dot(own.angular, joint.asked.moment) + dot(own.linear, joint.asked.resultant);
          (result_.accelerations.*by_kind[kind])[unknown(k)][joint.joint] = program_.bind(entry);
        }
      }
      const std::size_t from = at;
      const Link& link = links_[from];
      if (link.parent == 0) return;
      at = parent(from);
      row.linear = tree_.to_parent(link, row.linear);
      row.angular = tree_.to_parent(link, row.angular);
      row.angular = bound(program_, row.angular + cross(bound(program_, tree_.arm(link)), row.linear));
      row.turning = tree_.to_parent(link, row.turning);
      if (children_[at].size() > 1) {
        const AccelerationIncrement here = inverse_inertias_[at] * Wrench{row.linear, row.angular};
        const Vector angular = bound(program_, here.angular);
        const AccelerationIncrement moved{angular, bound(program_, here.linear)};
        for (const std::size_t other : children_[at]) {
          if (other != from) carry_outwards(k, other, moved);
        }
      }
      if (is_free(links_[at])) pass_joint(at, row);
    }
  }

  /// The row before a joint moves, from that after it.
  void pass_joint(std::size_t at, AccelerationRow& row) const {
    const Link& link = links_[at];
    const bool revolute = link.joint == JointKind::revolute;
    const AccelerationRow own = row_before(at);
    const Value moved = program_.bind(dot(link.axis, revolute ? row.angular : row.linear));
    for (int i = 0; i < 3; ++i) {
      row.angular[i] = is_along_joint(link, i, true) ? Value() : program_.bind(row.angular[i] + own.angular[i] * moved);
      row.linear[i] = is_along_joint(link, i, false) ? Value() : program_.bind(row.linear[i] + own.linear[i] * moved);
      row.turning[i] = program_.bind(row.turning[i] + own.turning[i] * moved);
    }
  }

  /// What a unit force at joint k does to its link and to all that it carries.
  void carry_column(std::size_t k) {
    const ArticulatedJoint& joint = free_.bodies.joints[k];
    const AccelerationIncrement before = reaction(program_, links_[k], joint, {before_[k], inverse_inertias_[k]});
    const JointResponse own = joint_response(tree_, {links_[k], joint, joint.inverse}, before);
    result_.accelerations.by_force[unknown(k)][unknown(k)] = own.acceleration;
    for (const std::size_t child : children_[k]) carry_outwards(k, child, own.after);
  }

  /// The same of link `at` and all that it carries, given what its parent does; then q̈_k for changes of their joints.
  void carry_outwards(std::size_t k, std::size_t at, const AccelerationIncrement& parent) {
    const Link& link = links_[at];
    const AccelerationIncrement before = from_parent(tree_, link, parent);
    for (std::size_t kind = 0; kind < 2; ++kind) {
      for (const JointPerturbation& joint : perturbations_[at][kind]) {
        Value entry = -dot(before.angular, joint.asked.moment);
        entry -= dot(before.linear, joint.asked.resultant);
        (result_.accelerations.*by_kind[kind])[unknown(k)][joint.joint] = program_.bind(entry);
      }
    }
    AccelerationIncrement after = before;
    if (is_free(link)) {
      ValueMatrix& by_force = result_.accelerations.by_force;
      const JointResponse moved = joint_response(tree_, {link, free_.bodies.joints[at], Value()}, before);
      // Of two joints on different branches either may come first.
      if (k < at) by_force[unknown(at)][unknown(k)] = by_force[unknown(k)][unknown(at)] = moved.acceleration;
      after = moved.after;
    }
    for (const std::size_t child : children_[at]) carry_outwards(k, child, after);
  }

  /// M⁻¹ ∂Q/∂q, M⁻¹ ∂Q/∂v of springs and dampers, and M⁻¹ E.
  void add_efforts() {
    ForwardDerivatives::Of& of = result_.accelerations;
    const ForceDerivatives opposite = effort_derivatives(equations_, Inputs::act);
    const std::size_t inputs = equations_.model().inputs().size();
    of.by_input.assign(n_, std::vector<Value>(inputs));
    for (std::size_t r = 0; r < n_; ++r) {
      for (std::size_t j = 0; j < n_; ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
          of.by_position[r][j] -= of.by_force[r][i] * opposite.by_position[i][j];
          of.by_velocity[r][j] -= of.by_force[r][i] * opposite.by_velocity[i][j];
        }
        of.by_position[r][j] = program_.bind(of.by_position[r][j]);
        of.by_velocity[r][j] = program_.bind(of.by_velocity[r][j]);
      }
      for (std::size_t k = 0; k < inputs; ++k) {
        for (std::size_t i = 0; i < n_; ++i) of.by_input[r][k] += of.by_force[r][i] * equations_.actions().inputs[k][i];
        of.by_input[r][k] = program_.bind(of.by_input[r][k]);
      }
    }
  }

  const Equations& equations_;
  const BodyTree& tree_ = equations_.model().without_lines();
  Program& program_ = equations_.program();
  const std::vector<Link>& links_ = tree_.links();
  std::size_t n_;
  std::vector<Value> efforts_;
  ArticulatedMotion free_;
  std::vector<Acceleration> motion_;
  JointChanges joints_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<Vector> doubled_velocities_;  ///< 2 V(O) of each link, in its axes
  std::vector<TurningAnswer> answers_;      ///< B less what the joint gives way to
  std::vector<Vector> turning_gains_;       ///< s · B/d
  std::vector<InverseOperationalInertia> before_, inverse_inertias_;
  std::vector<std::array<std::vector<JointPerturbation>, 2>> perturbations_;  ///< by the link before which they act
  ForwardDerivatives result_;
};

}  // namespace

bool fits_articulated_derivatives(const Equations& equations) {
  return equations.constraints().empty() && equations.actions().wrenches.empty() &&
         has_simple_joints(equations.model());
}

ForwardDerivatives articulated_derivatives(const Equations& equations) {
  return ArticulatedDerivatives(equations).run();
}

}  // namespace torsor
