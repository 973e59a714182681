// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/motion.hpp"

#include "torsor/generator/program/derivative.hpp"

namespace torsor {

std::vector<Twist> twists(const BodyTree& tree) {
  Program& program = tree.program();
  std::vector<Twist> all(tree.links().size());
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Link& link = tree.links()[k];
    const Twist& parent = all[static_cast<std::size_t>(link.parent)];
    const Vector origin = tree.origin_in_parent(link);
    Vector linear = bound(program, parent.linear + cross(parent.angular, bound(program, origin)));
    Vector angular = tree.from_parent(link, parent.angular);
    linear = tree.from_parent(link, linear);
    const Vector joint = link.rate * link.axis;
    (link.joint == JointKind::revolute ? angular : linear) += joint;
    all[k].angular = bound(program, angular, "angular velocity of " + link.name);
    all[k].linear = bound(program, linear, "velocity of " + link.name);
  }
  return all;
}

MomentumScrew momentum(const MassProperties& body, const Twist& twist) {
  MomentumScrew screw;
  screw.resultant = body.mass * twist.linear;
  screw.resultant += cross(twist.angular, body.first_moment);
  screw.moment = body.inertia * twist.angular;
  screw.moment += cross(body.first_moment, twist.linear);
  return screw;
}

Acceleration::Acceleration(Program& program, std::string name, Vector omega, Vector angular, Vector linear)
    : program_(&program),
      name_(std::move(name)),
      omega_(std::move(omega)),
      angular_(std::move(angular)),
      linear_(std::move(linear)) {}

Value Acceleration::product(int i, int j) { return program_->bind(omega_[i] * omega_[j]); }

const Value& Acceleration::u(int i, int j) {
  std::optional<Value>& entry = u_[static_cast<std::size_t>(3 * i + j)];
  if (!entry) {
    Value value;
    if (i == j) {
      const Value first = product((i + 1) % 3, (i + 1) % 3);
      const Value second = product((i + 2) % 3, (i + 2) % 3);
      value = -(first + second);
    } else {
      const int k = 3 - i - j;
      const bool positive = (j - i + 3) % 3 == 2;  // [Ω̇]_ij = −Ω̇_k for (i, j) in cyclic order
      value = product(i, j) + Number(positive ? 1 : -1) * angular_[k];
    }
    entry = program_->bind(value);
  }
  return *entry;
}

Vector Acceleration::u_times(const Vector& v) {
  Vector product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!v[j].is_zero()) product[i] += u(i, j) * v[j];
    }
  }
  return product;
}

namespace {

/// How the recursion below gets s̈ of joint k, and what it leaves the link with.
enum class JointMotion { symbols, zero, reference };

std::vector<Acceleration> recursion(const BodyTree& tree, JointMotion joints, const std::vector<Axes>& axes,
                                    std::vector<Value>* reference) {
  Program& program = tree.program();
  const auto from_parent = [&](std::size_t k, const Vector& v) {
    return axes[k] == Axes::own ? tree.from_parent(tree.links()[k], v) : tree.to_joint(tree.links()[k], v);
  };
  Substitution at_rest(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol->kind != SymbolKind::acceleration) return std::nullopt;
    return program.number(Number(), symbol->unit);
  });
  // Takes s̈ as minus what the axis' component is without it.
  const auto choose = [&](std::size_t k, Vector& angular) {
    const Link& link = tree.links()[k];
    if (joints != JointMotion::reference || !link.aligned || link.partials.empty()) return;
    (*reference)[k] = program.bind(-(link.axis[*link.aligned] * program.bind(angular[*link.aligned])));
    angular[*link.aligned] = Value();
  };
  Vector carried;  // Ω of the parent of a quaternion's links, in their axes
  std::vector<Acceleration> all;
  all.reserve(tree.links().size());
  const Vector upward = tree.upward_gravity();
  all.emplace_back(program, "ground", Vector(), Vector(), upward);
  for (std::size_t k = 1; k < tree.links().size(); ++k) {
    const Link& link = tree.links()[k];
    Acceleration& parent = all[static_cast<std::size_t>(link.parent)];
    const Value s_dot = link.rate;
    const Value s_ddot = joints == JointMotion::symbols ? link.acceleration : at_rest(link.acceleration);
    const Vector origin = bound(program, tree.arm(link));
    Vector linear = parent.linear() + parent.u_times(origin);
    Vector omega = from_parent(k, parent.omega());
    Vector angular = from_parent(k, parent.angular());
    if (link.joint == JointKind::prismatic) {
      const Vector axis = tree.axis_in_parent(link);
      linear += Number(2) * s_dot * cross(parent.omega(), axis);
      linear += s_ddot * axis;
    }
    linear = from_parent(k, bound(program, linear));
    if (link.joint == JointKind::revolute) {
      // Ω̇ = Ω̇_parent + s̈ n + ṡ Ω_parent ∧ n: the turn of the axis with the parent.
      if (link.in_group == 0) carried = omega;
      choose(k, angular);
      angular += s_dot * cross(carried, link.axis);
      angular += s_ddot * link.axis;
      omega += s_dot * link.axis;
    }
    // One by one: compilers evaluate arguments in different orders.
    omega = bound(program, omega, "angular velocity of " + link.name);
    angular = bound(program, angular, "angular acceleration of " + link.name);
    linear = bound(program, linear, "acceleration of " + link.name + tree.length_note());
    all.emplace_back(program, link.name, omega, angular, linear);
  }
  return all;
}

}  // namespace

std::vector<Acceleration> accelerations(const BodyTree& tree, AccelerationInput input, const std::vector<Axes>& axes) {
  return recursion(tree, input == AccelerationInput::zero ? JointMotion::zero : JointMotion::symbols, axes, nullptr);
}

ReferenceMotion reference_motion(const BodyTree& tree, const std::vector<Axes>& axes) {
  ReferenceMotion motion;
  motion.joints.resize(tree.links().size());
  motion.links = recursion(tree, JointMotion::reference, axes, &motion.joints);
  return motion;
}

}  // namespace torsor
