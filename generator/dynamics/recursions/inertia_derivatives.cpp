// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/inertia_derivatives.hpp"

#include <algorithm>
#include <array>

#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/dynamics/motion/joint_changes.hpp"
#include "torsor/generator/dynamics/recursions/composite_bodies.hpp"

namespace torsor {
namespace {

class DerivativeRecursion {
 public:
  explicit DerivativeRecursion(const BodyTree& tree)
      : tree_(tree),
        program_(tree.program()),
        links_(tree.links()),
        axes_(links_.size(), Axes::own),
        motion_(accelerations(tree, AccelerationInput::symbols, axes_)),
        joints_(tree, motion_),
        load_(joint_wrenches(tree, motion_, axes_, {})),
        composites_(composite_bodies(tree)) {}

  ForceDerivatives run() {
    find_changes();
    carry();
    return std::move(result_);
  }

  InertiaSlopes run_beside_mass() {
    InertiaSlopes slopes;
    find_changes();
    slopes.own.resize(static_cast<std::size_t>(tree_.unknown_count()));
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (is_unknown(k) && links_[k].aligned) slopes.own[unknown(k)] = leave_out_own(k);
    }
    carry();
    if (all_joints_are_free(tree_)) slopes.bias = bias();
    slopes.forces = std::move(result_);
    return slopes;
  }

 private:
  static constexpr std::size_t position = 0, velocity = 1;

  bool is_unknown(std::size_t k) const { return !links_[k].partials.empty(); }
  std::size_t unknown(std::size_t k) const { return static_cast<std::size_t>(links_[k].partials[0].first); }
  ValueMatrix& entries(std::size_t kind) { return kind == position ? result_.by_position : result_.by_velocity; }

  void find_changes() {
    changes_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (!is_unknown(k)) continue;
      changes_[k][position] = joints_.by_position(k);
      changes_[k][velocity] = joints_.by_velocity(k);
    }
  }

  Value leave_out_own(std::size_t k) {
    const Link& link = links_[k];
    MotionChange& change = changes_[k][position];
    Value& along = (link.joint == JointKind::revolute ? change.alpha : change.beta)[*link.aligned];
    const Value own = link.axis[*link.aligned] * along;
    along = Value();
    return own;
  }

  void carry() {
    const auto n = static_cast<std::size_t>(tree_.unknown_count());
    result_.by_position.assign(n, std::vector<Value>(n));
    result_.by_velocity = result_.by_position;
    gather_flow();
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (!is_unknown(k)) continue;
      carry_row(k);
      carry_wrenches(k);
    }
  }

  std::vector<Value> bias() {
    std::vector<Value> half_rates, forces(result_.by_velocity.size());
    for (std::size_t j = 0; j < forces.size(); ++j) {
      half_rates.push_back(program_.bind(Number::rational(1, 2) * tree_.v(static_cast<int>(j))));
    }
    const Vector upward = tree_.upward_gravity();
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const WrenchAt& first = composites_.unit_wrenches[k].back();
      const Vector on_ground = bound(program_, tree_.to_parent(links_[first.link], first.wrench.resultant));
      Value& force = forces[unknown(k)];
      force = dot(on_ground, upward);
      for (std::size_t j = 0; j < forces.size(); ++j) force += result_.by_velocity[unknown(k)][j] * half_rates[j];
      force = program_.bind(force);
    }
    return forces;
  }

  void gather_flow() {
    flow_.resize(links_.size());
    for (std::size_t k = links_.size(); k-- > 1;) {
      const Link& link = links_[k];
      const PointFlow own = rigid_flow(program_, link.mass, joints_.doubled_omega(k));
      PointFlow& all = flow_[k];
      all.l = bound(program_, all.l + own.l);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) all.q(i, j) = program_.bind(all.q(i, j) + own.q(i, j));
      }
      if (link.parent != 0) hand_over(k);
    }
  }

  /// Adds the composite of link k to its parent's: r = ρ + r', u = V + u'.
  void hand_over(std::size_t k) {
    const Link& link = links_[k];
    PointFlow& parent = flow_[static_cast<std::size_t>(link.parent)];
    const MassProperties& body = composites_.bodies[k];
    const Vector v = joints_.doubled_velocity(link);
    const Vector rho = bound(program_, tree_.arm(link));
    const Vector h = bound(program_, tree_.to_parent(link, body.first_moment));
    const Vector l = bound(program_, tree_.to_parent(link, flow_[k].l) + body.mass * v);
    const Matrix q = tree_.to_parent(link, flow_[k].q);
    parent.l = bound(program_, parent.l + l);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Value entry = parent.q(i, j) + q(i, j);
        entry += l[i] * rho[j];
        entry += v[i] * h[j];
        parent.q(i, j) = program_.bind(entry);
      }
    }
  }

  /// δP_k for changes of joint k and of all that carry it.
  void carry_row(std::size_t k) {
    const Link& link = links_[k];
    const std::size_t node = tree_.turning_link(k);
    Vector a = link.joint == JointKind::revolute ? transpose(flow_[node].answer(program_)) * link.axis
                                                 : cross(flow_[node].l, link.axis);
    a = bound(program_, a);
    const std::size_t own_first = joints_.first_of_group(k);
    std::size_t before = k;
    for (const WrenchAt& unit : composites_.unit_wrenches[k]) {
      const Vector& p = unit.wrench.moment;
      const Vector& c = unit.wrench.resultant;
      if (unit.link != k) {
        // From the link before, which is carried by this one.
        a = tree_.to_parent(links_[before], a);
        a = bound(program_, a + cross(joints_.doubled_velocity(links_[before]), c));
      }
      before = unit.link;
      const bool own_group = joints_.first_of_group(unit.link) == own_first;
      if (own_group ? unit.link != k : joints_.first_of_group(unit.link) != unit.link) continue;
      // All joints that share this place.
      for (std::size_t j = joints_.first_of_group(unit.link); j <= tree_.turning_link(unit.link); ++j) {
        if (!is_unknown(j)) continue;
        for (const std::size_t kind : {position, velocity}) {
          const MotionChange& change = changes_[j][kind];
          Value entry = dot(a, change.w) + dot(p, change.alpha);
          entry += dot(c, change.beta);
          entries(kind)[unknown(k)][unknown(j)] = program_.bind(entry);
        }
      }
    }
  }

  /// How joint k changes the wrench that its links ask of those that carry it.
  Wrench changed_wrench(std::size_t k, std::size_t kind) {
    const Link& link = links_[k];
    const std::size_t node = tree_.turning_link(k);
    const MotionChange& change = changes_[k][kind];
    const MassProperties& body = composites_.bodies[node];
    Wrench wrench;
    wrench.resultant = body.mass * change.beta;
    wrench.resultant += cross(change.alpha, body.first_moment);
    wrench.resultant += cross(change.w, flow_[node].l);
    wrench.moment = body.inertia * change.alpha;
    wrench.moment += cross(body.first_moment, change.beta);
    wrench.moment += flow_[node].answer(program_) * change.w;
    if (kind == position) {
      // The wrench itself turns, or its line of action slides.
      wrench.moment += cross(link.axis, link.joint == JointKind::revolute ? load_[node].moment : load_[node].resultant);
      if (link.joint == JointKind::revolute) wrench.resultant += cross(link.axis, load_[node].resultant);
    }
    wrench.resultant = bound(program_, wrench.resultant);
    wrench.moment = bound(program_, wrench.moment);
    return wrench;
  }

  void carry_wrenches(std::size_t k) {
    const std::size_t first = joints_.first_of_group(k);
    if (links_[first].parent == 0) return;
    for (const std::size_t kind : {position, velocity}) {
      Wrench wrench = changed_wrench(k, kind);
      for (std::size_t at = first; links_[at].parent != 0;) {
        wrench = in_parent(tree_, links_[at], wrench);
        at = static_cast<std::size_t>(links_[at].parent);
        if (!is_unknown(at)) continue;
        const Link& here = links_[at];
        const bool turns = here.joint == JointKind::revolute;
        entries(kind)[unknown(at)][unknown(k)] =
            program_.bind(dot(here.axis, turns ? wrench.moment : wrench.resultant));
      }
    }
  }

  const BodyTree& tree_;
  Program& program_;
  const std::vector<Link>& links_;
  std::vector<Axes> axes_;
  std::vector<Acceleration> motion_;
  JointChanges joints_;
  std::vector<Wrench> load_;
  CompositeBodies composites_;
  std::vector<PointFlow> flow_;
  std::vector<std::array<MotionChange, 2>> changes_;
  ForceDerivatives result_;
};

}  // namespace

ForceDerivatives inertia_derivatives(const BodyTree& tree) { return DerivativeRecursion(tree).run(); }

InertiaSlopes inertia_slopes(const BodyTree& tree) { return DerivativeRecursion(tree).run_beside_mass(); }

bool all_joints_are_free(const BodyTree& tree) {
  const auto& links = tree.links();
  return std::none_of(links.begin() + 1, links.end(), [](const Link& link) { return link.partials.empty(); });
}

}  // namespace torsor
