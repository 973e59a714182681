// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/import/mjcf_builder.hpp"

namespace torsor {

bool MjcfBuilder::is_held(std::size_t joint) const {
  const auto found = followed_.find(joint);
  if (found == followed_.end()) return false;
  const MjcfEquality& law = model_.equalities[found->second];
  const auto is_zero = [](double coefficient) { return coefficient == 0; };
  return !law.second || std::all_of(law.polynomial.begin() + 1, law.polynomial.end(), is_zero) ||
         is_held(static_cast<std::size_t>(*law.second));
}

bool MjcfBuilder::moves(int body) const {
  for (int at = body; at > 0; at = model_.bodies[static_cast<std::size_t>(at)].parent) {
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      if (model_.joints[i].body == at && !is_held(i)) return true;
    }
  }
  return false;
}

void MjcfBuilder::add_joint_actions(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  if (is_held(i)) {
    const bool rubs = joint.friction_loss != 0 || friction_of(joint);
    if (joint.stiffness != 0 || joint.damping != 0 || joint.armature != 0 || rubs)
      note("springs, dampers, rotors and friction of joints that equalities hold do not act", joint.name);
    return;
  }
  if (joint.is_scalar())
    add_scalar_actions(i);
  else
    add_free_actions(i);
  add_dry_friction(i);
}

void MjcfBuilder::add_scalar_actions(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  const std::string& name = joints_[i].name;
  const bool turns = joint.type == MjcfJointType::hinge;
  const Expression& q = position(i);
  if (joint.stiffness != 0) {
    const Expression k = parameter(name + "_stiffness", turns ? "N m" : "N/m", from_double(joint.stiffness));
    scene_.spring(name + "_spring", q, k, position_value(joint, joint.spring_reference[0], "springref"));
  }
  if (joint.damping != 0 && options_.dampers) {
    const Expression c = parameter(name + "_damping", turns ? "N m s" : "N s/m", from_double(joint.damping));
    scene_.damper(name + "_damper", q, c);
  } else if (joint.damping != 0) {
    data_.push_back(fmt::format("{}: damping {}", joint.name, shortest(joint.damping)));
  }
  if (joint.armature != 0) {
    const Expression a = parameter(name + "_armature", turns ? "kg m^2" : "kg", from_double(joint.armature));
    scene_.reflected_inertia(identifiers_.frames().take(name + "_rotor", "joint"), q, a);
  }
  if (joint.limited && options_.limits && !model_.limits_act) {
    note("the flag limit or constraint is disabled: --limits makes no stops", joint.name);
  } else if (joint.limited && options_.limits && !followed_.contains(i)) {
    const Unit& unit = turns ? units::radian : units::metre;
    const auto end = [&](double at) { return Expression::quantity(from_double(at), unit); };
    scene_.stop(q, end(joint.range[0]), end(joint.range[1]));
  }
  if (joint.limited && followed_.contains(i)) {
    data_.push_back(
        fmt::format("{}: at least {}, at most {}", joint.name, shortest(joint.range[0]), shortest(joint.range[1])));
  }
}

void MjcfBuilder::add_free_actions(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  const JointParts& parts = joints_[i];
  const bool is_free = joint.type == MjcfJointType::free;
  const std::string& body = is_free ? frames_[static_cast<std::size_t>(joint.body)] : parts.frame;
  const std::string parent = is_free ? "ground" : parts.parent_frame;
  static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
  if (joint.stiffness != 0) add_free_spring(i);
  if (joint.limited) note("the range of ball joints does not act", joint.name);
  if (joint.damping != 0 && options_.dampers) {
    const Expression c = parameter(parts.name + "_damping", "N m s", from_double(joint.damping));
    scene_.rotational_drag(parts.name + "_drag", body, c, parent);
    for (std::size_t k = 0; is_free && k < 3; ++k) {
      scene_.damper(parts.name + axes.at(k) + "_damper", parts.place[k],
                    c / Expression::quantity(Number(1), units::metre * units::metre));
    }
  } else if (joint.damping != 0) {
    data_.push_back(fmt::format("{}: damping {}", joint.name, shortest(joint.damping)));
  }
  if (joint.armature == 0) return;
  if (!is_free &&
      (moves(model_.bodies[static_cast<std::size_t>(joint.body)].parent) ||
       parent != frames_[static_cast<std::size_t>(model_.bodies[static_cast<std::size_t>(joint.body)].parent)])) {
    note("the armature of ball joints between bodies that move does not act",
         fmt::format("{} ({})", joint.name, shortest(joint.armature)));
    return;
  }
  // ½ a Ω² of a body without mass whose moments are a about all axes.
  const Expression a = parameter(parts.name + "_armature", "kg m^2", from_double(joint.armature));
  scene_.body(identifiers_.frames().take(parts.name + "_rotor", "joint"), body,
              Inertia::general({.mass = 0, .xx = a, .yy = a, .zz = a}));
  for (std::size_t k = 0; is_free && k < 3; ++k) {
    scene_.reflected_inertia(identifiers_.frames().take(parts.name + axes.at(k) + "_rotor", "joint"), parts.place[k],
                             a / Expression::quantity(Number(1), units::metre * units::metre));
  }
}

/// U = −½ k θ², θ the angle from the attitude of rest, and −½ k x² of each place of a free joint. With e = (w, v) the
/// quaternion from rest, θ is 2 atan2(|v|, |w|). It is written as |v| · (2 atan2(s, |w|)/s), s = max(|v|, 10⁻¹⁵), so
/// that force and stiffness are those of θ at rest too, where θ has no derivative.
void MjcfBuilder::add_free_spring(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  const JointParts& parts = joints_[i];
  const bool is_free = joint.type == MjcfJointType::free;
  const Expression k = parameter(parts.name + "_stiffness", "N m", from_double(joint.stiffness));
  static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
  for (std::size_t a = 0; is_free && a < 3; ++a) {
    scene_.spring(parts.name + axes.at(a) + "_spring", parts.place[a],
                  k / Expression::quantity(Number(1), units::metre * units::metre),
                  Expression::quantity(from_double(joint.spring_reference[a]), units::metre));
  }
  const std::array<Expression, 4> e = scene_.attitude_components(parts.attitude);
  std::array<Expression, 4> rest;
  for (std::size_t c = 0; c < 4; ++c) rest[c] = from_double(joint.spring_reference[(is_free ? 3 : 0) + c]);
  // (w, v) = conjugate(rest) e.
  const Expression w = rest[0] * e[0] + rest[1] * e[1] + rest[2] * e[2] + rest[3] * e[3];
  Expression square = 0;
  for (std::size_t a = 1; a < 4; ++a) {
    const std::size_t b = a % 3 + 1, c = b % 3 + 1;
    const Expression component = rest[0] * e[a] - rest[a] * e[0] - rest[b] * e[c] + rest[c] * e[b];
    square = square + component * component;
  }
  const Expression s = sqrt(max(square, Expression(Number(10).pow(-30))));
  const Expression angle_per_length = 2 * atan2(s, abs(w)) / s;
  scene_.force_function(parts.name + "_spring",
                        -k * angle_per_length * angle_per_length * square * Expression(Number::rational(1, 2)));
}

void MjcfBuilder::add_tendons() {
  for (const MjcfTendon& tendon : model_.tendons) {
    const std::optional<Expression> length = tendon_length(tendon);
    const bool rubs = options_.friction_of_file && tendon.friction_loss != 0;
    if (tendon.friction_loss != 0 && !rubs) {
      note("frictionloss of tendons acts with --friction file only",
           fmt::format("{} ({})", tendon.name, shortest(tendon.friction_loss)));
    }
    if (tendon.limited) note("the range of tendons does not act", tendon.name);
    if (tendon.stiffness == 0 && tendon.damping == 0 && !rubs) continue;
    if (!length) {
      note("stiffness, damping and frictionloss of tendons around geoms do not act", tendon.name);
      continue;
    }
    if (!varies(*length)) {
      note("stiffness, damping and frictionloss of tendons of constant length do not act", tendon.name);
      continue;
    }
    const std::string name =
        identifiers_.symbol(tendon.name, "tendon", {"", "_stiffness", "_damping", "_friction", "_dry_friction"});
    if (rubs) {
      const Expression bound = parameter(name + "_friction", "N", from_double(tendon.friction_loss));
      scene_.dry_friction(name + "_dry_friction", *length, {bound});
    }
    if (tendon.stiffness != 0) {
      const Expression k = parameter(name + "_stiffness", "N/m", from_double(tendon.stiffness));
      scene_.spring(name + "_spring", *length, k,
                    tendon.rest == 0 ? Expression(0) : Expression::quantity(from_double(tendon.rest), units::metre));
    }
    if (tendon.damping != 0 && options_.dampers) {
      scene_.damper(name + "_damper", *length, parameter(name + "_damping", "N s/m", from_double(tendon.damping)));
    } else if (tendon.damping != 0) {
      data_.push_back(fmt::format("{}: damping {}", tendon.name, shortest(tendon.damping)));
    }
  }
}

void MjcfBuilder::add_motors() {
  for (const MjcfActuator& actuator : model_.actuators) add_motor(actuator);
  if (!model_.actuators.empty()) return;
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    if (!model_.joints[i].is_scalar() || followed_.contains(i)) continue;
    const bool turns = model_.joints[i].type == MjcfJointType::hinge;
    scene_.motor(joints_[i].name + (turns ? "_torque" : "_force"), position(i));
  }
}

}  // namespace torsor
