// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/inertia_derivatives.hpp"

#include <array>

#include "generator/dynamics/composite_bodies.hpp"
#include "generator/dynamics/virtual_power.hpp"

namespace torsor {
namespace {

/// Change of a carrier's motion: δΩ, δΩ̇ − δΩ ∧ Ω, δΓ(O).
struct Change {
  Vector w, alpha, beta;
};

/// What the points of a composite body do relative to its origin: l = 2 ∫ u dm and Q = 2 ∫ u rᵀ dm.
struct PointFlow {
  Vector l;
  Matrix q;

  /// tr(Q) 1 − Q.
  Matrix answer(Program& program) const {
    Matrix w;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      w(i, i) = program.bind(q(j, j) + q(k, k));
      w(i, j) = -q(i, j);
      w(i, k) = -q(i, k);
    }
    return w;
  }
};

class DerivativeRecursion {
 public:
  explicit DerivativeRecursion(const Model& model)
      : model_(model),
        program_(model.program()),
        links_(model.links()),
        axes_(links_.size(), Axes::own),
        motion_(accelerations(model, AccelerationInput::symbols, axes_)),
        load_(joint_wrenches(model, motion_, axes_, {}, &Link::effective)),
        composites_(composite_bodies(model)) {}

  ForceDerivatives run() {
    const auto n = static_cast<std::size_t>(model_.unknown_count());
    result_.by_position.assign(n, std::vector<Value>(n));
    result_.by_velocity = result_.by_position;
    gather_flow();
    changes_.resize(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (is_unknown(k)) changes_[k] = {by_position(k), by_velocity(k)};
    }
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (!is_unknown(k)) continue;
      carry_row(k);
      carry_wrenches(k);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::size_t position = 0, velocity = 1;

  bool is_unknown(std::size_t k) const { return !links_[k].partials.empty(); }
  std::size_t unknown(std::size_t k) const { return static_cast<std::size_t>(links_[k].partials[0].first); }
  ValueMatrix& entries(std::size_t kind) { return kind == position ? result_.by_position : result_.by_velocity; }

  std::size_t first_of_group(std::size_t k) const { return k - static_cast<std::size_t>(links_[k].in_group); }
  bool in_attitude(std::size_t k) const { return first_of_group(k) != model_.turning_link(k); }

  Vector doubled(const Vector& v) const {
    return bound(program_, Vector(Number(2) * v[0], Number(2) * v[1], Number(2) * v[2]));
  }

  /// Twice the velocity of a link's origin relative to its carrier's, in the carrier's axes.
  Vector doubled_velocity(const Link& link) {
    const Acceleration& carrier = motion_[static_cast<std::size_t>(link.parent)];
    Vector v = cross(doubled(carrier.omega()), bound(program_, model_.arm(link)));
    if (link.joint == JointKind::prismatic) {
      v += program_.bind(Number(2) * link.rate) * model_.axis_in_parent(link);
    }
    return bound(program_, v);
  }

  void gather_flow() {
    flow_.resize(links_.size());
    for (std::size_t k = links_.size(); k-- > 1;) {
      const Link& link = links_[k];
      const MassProperties& body = link.effective;
      const Vector omega = doubled(motion_[k].omega());
      PointFlow& own = flow_[k];
      own.l = bound(program_, own.l + cross(omega, body.first_moment));
      const Matrix turning = omega_times_second_moment(omega, body.inertia);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) own.q(i, j) = program_.bind(own.q(i, j) + turning(i, j));
      }
      if (link.parent != 0) hand_over(k);
    }
  }

  /// [2 Ω] ∫ r rᵀ dm, and ∫ r rᵀ dm = ½ tr(J) 1 − J.
  Matrix omega_times_second_moment(const Vector& omega, const Matrix& j) const {
    Matrix second;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      Value diagonal = j(b, b) + j(c, c);
      diagonal -= j(a, a);
      second(a, a) = program_.bind(Number::rational(1, 2) * diagonal);
      second(b, c) = second(c, b) = program_.bind(-j(b, c));
    }
    Matrix product;
    for (int column = 0; column < 3; ++column) {
      const Vector r = cross(omega, Vector(second(0, column), second(1, column), second(2, column)));
      for (int row = 0; row < 3; ++row) product(row, column) = r[row];
    }
    return product;
  }

  /// Adds the composite of link k to its carrier's: r = ρ + r', u = V + u'.
  void hand_over(std::size_t k) {
    const Link& link = links_[k];
    PointFlow& carrier = flow_[static_cast<std::size_t>(link.parent)];
    const MassProperties& body = composites_.bodies[k];
    const Vector v = doubled_velocity(link);
    const Vector rho = bound(program_, model_.arm(link));
    const Vector h = bound(program_, model_.to_parent(link, body.first_moment));
    const Vector l = bound(program_, model_.to_parent(link, flow_[k].l) + body.mass * v);
    const Matrix q = model_.to_parent(link, flow_[k].q);
    carrier.l = bound(program_, carrier.l + l);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Value entry = carrier.q(i, j) + q(i, j);
        entry += l[i] * rho[j];
        entry += v[i] * h[j];
        carrier.q(i, j) = program_.bind(entry);
      }
    }
  }

  /// Ω_p ∧ s of the carrier, in the axes of link k.
  Vector carrier_omega_cross_axis(std::size_t k) {
    const Link& link = links_[k];
    if (!in_attitude(k)) return bound(program_, cross(motion_[k].omega(), link.axis));
    const Link& first = links_[first_of_group(k)];
    const Vector carried = model_.from_parent(first, motion_[static_cast<std::size_t>(first.parent)].omega());
    return bound(program_, cross(bound(program_, carried), link.axis));
  }

  Change by_position(std::size_t k) {
    const Link& link = links_[k];
    Change change;
    if (link.joint == JointKind::prismatic) {
      change.beta = bound(program_, motion_[k].u_times(link.axis));
      return change;
    }
    change.w = carrier_omega_cross_axis(k);
    change.beta = bound(program_, cross(motion_[model_.turning_link(k)].linear(), link.axis));
    if (in_attitude(k)) {
      const Link& first = links_[first_of_group(k)];
      const Vector axis = bound(program_, model_.to_parent(first, link.axis));
      const Vector turned = bound(program_, motion_[static_cast<std::size_t>(first.parent)].u_times(axis));
      change.alpha = bound(program_, model_.from_parent(first, turned));
    } else {
      change.alpha = bound(program_, motion_[k].u_times(link.axis));  // U s = U_p s
    }
    return change;
  }

  Change by_velocity(std::size_t k) {
    const Link& link = links_[k];
    Change change;
    if (link.joint == JointKind::prismatic) {
      change.beta = bound(program_, cross(doubled(motion_[k].omega()), link.axis));
      return change;
    }
    change.w = link.axis;
    if (in_attitude(k)) {
      const Vector own = bound(program_, cross(motion_[model_.turning_link(k)].omega(), link.axis));
      change.alpha = bound(program_, carrier_omega_cross_axis(k) + own);
    } else {
      change.alpha = bound(program_, cross(doubled(motion_[k].omega()), link.axis));
    }
    return change;
  }

  /// δP_k for changes of joint k and of all that carry it.
  void carry_row(std::size_t k) {
    const Link& link = links_[k];
    const std::size_t node = model_.turning_link(k);
    Vector a = link.joint == JointKind::revolute ? transpose(flow_[node].answer(program_)) * link.axis
                                                 : cross(flow_[node].l, link.axis);
    a = bound(program_, a);
    const std::size_t own_first = first_of_group(k);
    std::size_t before = k;
    for (const WrenchAt& unit : composites_.unit_wrenches[k]) {
      const Vector& p = unit.wrench.moment;
      const Vector& c = unit.wrench.resultant;
      if (unit.link != k) {
        // From the link before, which is carried by this one.
        a = model_.to_parent(links_[before], a);
        a = bound(program_, a + cross(doubled_velocity(links_[before]), c));
      }
      before = unit.link;
      const bool own_group = first_of_group(unit.link) == own_first;
      if (own_group ? unit.link != k : first_of_group(unit.link) != unit.link) continue;
      // All joints that share this place.
      for (std::size_t j = first_of_group(unit.link); j <= model_.turning_link(unit.link); ++j) {
        if (!is_unknown(j)) continue;
        for (const std::size_t kind : {position, velocity}) {
          const Change& change = changes_[j][kind];
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
    const std::size_t node = model_.turning_link(k);
    const Change& change = changes_[k][kind];
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
    const std::size_t first = first_of_group(k);
    if (links_[first].parent == 0) return;
    for (const std::size_t kind : {position, velocity}) {
      Wrench wrench = changed_wrench(k, kind);
      for (std::size_t at = first; links_[at].parent != 0;) {
        wrench = in_parent(model_, links_[at], wrench);
        at = static_cast<std::size_t>(links_[at].parent);
        if (!is_unknown(at)) continue;
        const Link& here = links_[at];
        const bool turns = here.joint == JointKind::revolute;
        entries(kind)[unknown(at)][unknown(k)] =
            program_.bind(dot(here.axis, turns ? wrench.moment : wrench.resultant));
      }
    }
  }

  const Model& model_;
  Program& program_;
  const std::vector<Link>& links_;
  std::vector<Axes> axes_;
  std::vector<Acceleration> motion_;
  std::vector<Wrench> load_;
  CompositeBodies composites_;
  std::vector<PointFlow> flow_;
  std::vector<std::array<Change, 2>> changes_;
  ForceDerivatives result_;
};

}  // namespace

ForceDerivatives inertia_derivatives(const Model& model) { return DerivativeRecursion(model).run(); }

}  // namespace torsor
