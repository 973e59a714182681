// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/articulated_body.hpp"

#include <algorithm>

namespace torsor {
namespace {

/// (moment, resultant) = [J H; Hᵀ M] (angular, linear acceleration) + bias: how a subtree answers at a link's origin.
struct Articulated {
  Matrix angular;   ///< J, symmetric
  Matrix coupling;  ///< H
  Matrix linear;    ///< M, symmetric
  Wrench bias;
};

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

Matrix sum(Program& program, const Matrix& a, const Matrix& b) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = program.bind(a(i, j) + b(i, j));
  }
  return result;
}

/// Accelerations of a link without what q̈ of its own joint adds.
struct Motion {
  Vector angular, linear;
};

class Recursion {
 public:
  Recursion(const Model& model, const std::vector<Value>& efforts, const std::map<int, Wrench>& wrenches)
      : model_(model), program_(model.program()), links_(model.links()), efforts_(efforts), wrenches_(wrenches) {}

  ForwardSolution solve() {
    const std::size_t n = links_.size();
    drift_.resize(n);
    joints_.resize(n);
    gather_velocities();
    bodies_.resize(n);
    for (std::size_t k = 1; k < n; ++k) bodies_[k] = rigid(k);
    for (std::size_t k = n; k-- > 1;) eliminate(k);
    solution_.method = "the articulated-body recursion";
    return accelerate();
  }

 private:
  /// What elimination of a joint leaves for the way back: q̈ = (u − U · A) / d.
  struct Joint {
    Vector moment, resultant;  ///< U
    Value inverse;             ///< 1/d
    Value effort;              ///< u
  };

  bool is_unknown(std::size_t k) const { return !links_[k].partials.empty(); }

  void gather_velocities() {
    omega_.resize(links_.size());
    Vector carried;  // Ω of the parent of a quaternion's links, in their axes
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const Link& link = links_[k];
      const Vector& parent = omega_[static_cast<std::size_t>(link.parent)];
      Vector omega = model_.from_parent(link, parent);
      const Vector origin = bound(program_, model_.arm(link));
      Acceleration turning(program_, link.name, parent, Vector(), Vector());  // U of the parent at zero Ω̇
      Vector linear = turning.u_times(origin);
      if (link.joint == JointKind::prismatic) {
        const Vector axis = model_.axis_in_parent(link);
        linear += Number(2) * link.rate * cross(parent, axis);
        if (!is_unknown(k)) linear += link.acceleration * axis;
      }
      Vector angular;
      if (link.joint == JointKind::revolute) {
        if (link.in_group == 0) carried = omega;
        angular = link.rate * cross(carried, link.axis);
        if (!is_unknown(k)) angular += link.acceleration * link.axis;
        omega += link.rate * link.axis;
      }
      drift_[k].angular = bound(program_, angular);
      drift_[k].linear = model_.from_parent(link, bound(program_, linear));
      omega_[k] = bound(program_, omega, "angular velocity of " + link.name);
    }
  }

  /// One link by itself: bias {Ω ∧ (Ω ∧ h), Ω ∧ J Ω} minus what is applied to it.
  Articulated rigid(std::size_t k) {
    const MassProperties& body = links_[k].effective;
    Articulated own;
    own.angular = body.inertia;
    own.coupling = cross_matrix(body.first_moment);
    for (int i = 0; i < 3; ++i) own.linear(i, i) = body.mass;
    Acceleration turning(program_, links_[k].name, omega_[k], Vector(), Vector());
    own.bias.resultant = turning.u_times(body.first_moment);
    const Matrix& j = body.inertia;
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3;
      const int z = (x + 2) % 3;
      Value& n = own.bias.moment[x];
      const Value difference = program_.bind(j(z, z) - j(y, y));
      if (!difference.is_zero()) n += difference * turning.product(y, z);
      if (!j(x, y).is_zero()) n -= j(x, y) * turning.product(x, z);
      if (!j(x, z).is_zero()) n += j(x, z) * turning.product(x, y);
      if (!j(y, z).is_zero()) {
        const Value square = turning.product(y, y);
        const Value spread = program_.bind(square - turning.product(z, z));
        n += j(y, z) * spread;
      }
    }
    if (const auto wrench = wrenches_.find(static_cast<int>(k)); wrench != wrenches_.end()) {
      const Wrench applied = model_.over_length(wrench->second);
      own.bias.resultant += -applied.resultant;
      own.bias.moment += -applied.moment;
    }
    own.bias.resultant = bound(program_, own.bias.resultant);
    own.bias.moment = bound(program_, own.bias.moment);
    return own;
  }

  /// Takes the joint of link k out of its subtree's answer and hands that to the parent.
  void eliminate(std::size_t k) {
    const Link& link = links_[k];
    Articulated& body = bodies_[k];
    Joint& joint = joints_[k];
    if (is_unknown(k)) {
      const bool revolute = link.joint == JointKind::revolute;
      joint.moment = bound(program_, (revolute ? body.angular : body.coupling) * link.axis);
      joint.resultant = bound(program_, (revolute ? transpose(body.coupling) : body.linear) * link.axis);
      const Value pivot = program_.bind(dot(link.axis, revolute ? joint.moment : joint.resultant), "pivot");
      solution_.pivots.emplace_back(pivot, pivot);
      joint.inverse = program_.bind(pow(pivot, -1));
      const auto unknown = static_cast<std::size_t>(link.partials[0].first);
      joint.effort =
          program_.bind(efforts_[unknown] - dot(link.axis, revolute ? body.bias.moment : body.bias.resultant));
      if (link.parent == 0) return;
      subtract(body, joint, link.aligned, revolute);
    }
    if (link.parent == 0) return;
    // Bias of the subtree: what the drift accelerations need, and what the effort gives.
    const Motion& drift = drift_[k];
    Wrench bias = body.bias;
    bias.moment += body.angular * drift.angular;
    bias.moment += body.coupling * drift.linear;
    bias.resultant += transpose(body.coupling) * drift.angular;
    bias.resultant += body.linear * drift.linear;
    if (is_unknown(k)) {
      const Value unit = program_.bind(joint.inverse * joint.effort);
      bias.moment += unit * joint.moment;
      bias.resultant += unit * joint.resultant;
    }
    bias.moment = bound(program_, bias.moment);
    bias.resultant = bound(program_, bias.resultant);
    hand_over(k, bias);
  }

  /// I − U Uᵀ/d. Along an aligned axis the row of the joint vanishes exactly and is left out.
  void subtract(Articulated& body, const Joint& joint, int aligned, bool revolute) {
    const auto vanishes = [&](int i, bool moment_row) { return i == aligned && moment_row == revolute; };
    Vector moment_by_d, resultant_by_d;
    for (int i = 0; i < 3; ++i) {
      if (!vanishes(i, true)) moment_by_d[i] = program_.bind(joint.moment[i] * joint.inverse);
      if (!vanishes(i, false)) resultant_by_d[i] = program_.bind(joint.resultant[i] * joint.inverse);
    }
    const auto reduced = [&](const Value& entry, const Value& row, const Value& column, bool zero) {
      return zero ? Value() : program_.bind(entry - row * column);
    };
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const bool zero_h = vanishes(i, true) || vanishes(j, false);
        body.coupling(i, j) = reduced(body.coupling(i, j), moment_by_d[i], joint.resultant[j], zero_h);
        if (j > i) continue;
        const bool zero_j = vanishes(i, true) || vanishes(j, true);
        const bool zero_m = vanishes(i, false) || vanishes(j, false);
        body.angular(i, j) = body.angular(j, i) = reduced(body.angular(i, j), moment_by_d[i], joint.moment[j], zero_j);
        body.linear(i, j) = body.linear(j, i) =
            reduced(body.linear(i, j), resultant_by_d[i], joint.resultant[j], zero_m);
      }
    }
  }

  void hand_over(std::size_t k, const Wrench& bias) {
    const Link& link = links_[k];
    const Articulated& body = bodies_[k];
    Articulated& parent = bodies_[static_cast<std::size_t>(link.parent)];
    const Vector origin = bound(program_, model_.arm(link));
    const Matrix arm = cross_matrix(origin);
    const Matrix angular = model_.to_parent(link, body.angular);
    const Matrix coupling = model_.to_parent(link, body.coupling);
    const Matrix linear = model_.to_parent(link, body.linear);
    // Moved by r: H + [r] M, and J − H [r] + [r] (H + [r] M)ᵀ.
    const Matrix moved = sum(program_, coupling, arm * linear);
    const Matrix left = coupling * arm;
    const Matrix right = arm * transpose(moved);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        Value entry = angular(i, j) - left(i, j);
        entry += right(i, j);
        parent.angular(i, j) = parent.angular(j, i) = program_.bind(parent.angular(i, j) + program_.bind(entry));
      }
    }
    parent.coupling = sum(program_, parent.coupling, moved);
    parent.linear = sum(program_, parent.linear, linear);
    const Vector force = model_.to_parent(link, bias.resultant);
    parent.bias.resultant = bound(program_, parent.bias.resultant + force);
    Vector moment = model_.to_parent(link, bias.moment);
    moment += cross(origin, force);
    parent.bias.moment = bound(program_, parent.bias.moment + moment);
  }

  ForwardSolution accelerate() {
    solution_.accelerations.resize(static_cast<std::size_t>(model_.unknown_count()));
    std::vector<Motion> motion(links_.size());
    motion[0].linear = model_.upward_gravity();
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const Link& link = links_[k];
      const Motion& parent = motion[static_cast<std::size_t>(link.parent)];
      const Vector origin = bound(program_, model_.arm(link));
      const Vector carried = bound(program_, parent.linear + cross(parent.angular, origin));
      Motion own;
      own.angular = model_.from_parent(link, parent.angular);
      own.linear = model_.from_parent(link, carried);
      own.angular = bound(program_, own.angular + drift_[k].angular);
      own.linear = bound(program_, own.linear + drift_[k].linear);
      if (is_unknown(k)) {
        const Joint& joint = joints_[k];
        Value rest = joint.effort;
        rest -= dot(joint.moment, own.angular);
        rest -= dot(joint.resultant, own.linear);
        const Value acceleration =
            program_.bind(joint.inverse * program_.bind(rest), "acceleration of joint " + link.name);
        solution_.accelerations[static_cast<std::size_t>(link.partials[0].first)] = acceleration;
        Vector& moved = link.joint == JointKind::revolute ? own.angular : own.linear;
        moved = bound(program_, moved + acceleration * link.axis);
      }
      motion[k] = own;
    }
    return std::move(solution_);
  }

  const Model& model_;
  Program& program_;
  const std::vector<Link>& links_;
  const std::vector<Value>& efforts_;
  const std::map<int, Wrench>& wrenches_;
  std::vector<Vector> omega_;
  std::vector<Motion> drift_;
  std::vector<Articulated> bodies_;
  std::vector<Joint> joints_;
  ForwardSolution solution_;
};

}  // namespace

bool has_simple_joints(const Model& model) {
  std::vector<int> uses(static_cast<std::size_t>(model.unknown_count()), 0);
  for (const Link& link : model.links()) {
    std::size_t unknowns = 0;
    for (const auto& [i, partial] : link.partials) {
      if (i >= model.unknown_count()) continue;
      if (!partial.is_number(1) || !partial.unit().is_dimensionless()) return false;  // a pitch of 1 m is none
      // A displacement q + f(t) has another second derivative than q.
      if (!(link.acceleration - model.a(i)).is_zero()) return false;
      ++unknowns;
      ++uses[static_cast<std::size_t>(i)];
    }
    if (unknowns > 1 || unknowns != link.partials.size()) return false;
  }
  return std::all_of(uses.begin(), uses.end(), [](int use) { return use == 1; });
}

ForwardSolution articulated_forward(const Model& model, const std::vector<Value>& efforts,
                                    const std::map<int, Wrench>& wrenches) {
  return Recursion(model, efforts, wrenches).solve();
}

}  // namespace torsor
