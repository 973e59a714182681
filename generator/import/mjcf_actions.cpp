// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/import/mjcf_builder.hpp"
#include "torsor/generator/import/rotor.hpp"

namespace torsor {

bool MjcfBuilder::moves(int body) const {
  for (int at = body; at > 0; at = model_.bodies[static_cast<std::size_t>(at)].parent) {
    for (const MjcfJoint& joint : model_.joints) {
      if (joint.body == at) return true;
    }
  }
  return false;
}

void MjcfBuilder::add_joint_actions(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  if (joint.friction_loss != 0) {
    notes_.push_back(fmt::format("joint {}: frictionloss {} does not act", joint.name, shortest(joint.friction_loss)));
  }
  if (joint.is_scalar())
    add_scalar_actions(i);
  else
    add_free_actions(i);
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
    add_rotor(scene_, frame_names_.take(name + "_rotor", "joint"), {.displacement = q, .turns = turns, .armature = a});
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
  if (joint.stiffness != 0) {
    notes_.push_back(
        fmt::format("joint {}: the stiffness of a {} joint does not act", joint.name, is_free ? "free" : "ball"));
  }
  if (joint.limited) notes_.push_back(fmt::format("joint {}: the range of a ball joint does not act", joint.name));
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
    notes_.push_back(
        fmt::format("joint {}: the armature of a ball joint between bodies that move does not act", joint.name));
    return;
  }
  // ½ a Ω² of a body without mass whose moments are a about all axes.
  const Expression a = parameter(parts.name + "_armature", "kg m^2", from_double(joint.armature));
  scene_.body(frame_names_.take(parts.name + "_rotor", "joint"), body,
              Inertia::general({.mass = 0, .xx = a, .yy = a, .zz = a}));
  for (std::size_t k = 0; is_free && k < 3; ++k) {
    add_rotor(scene_, frame_names_.take(parts.name + axes.at(k) + "_rotor", "joint"),
              {.displacement = parts.place[k],
               .turns = false,
               .armature = a / Expression::quantity(Number(1), units::metre * units::metre)});
  }
}

/// Σ coefficient · q, in metres; a coefficient is in m for a hinge and a number for a slide.
std::optional<Expression> MjcfBuilder::tendon_length(const MjcfTendon& tendon) {
  if (tendon.spatial) return std::nullopt;
  Expression length = 0;
  for (const auto& [joint, coefficient] : tendon.terms) {
    if (coefficient == 0) continue;
    const auto i = static_cast<std::size_t>(joint);
    const Unit unit = model_.joints[i].type == MjcfJointType::hinge ? units::metre : Unit();
    length = length + Expression::quantity(from_double(coefficient), unit) * position(i);
  }
  return length;
}

void MjcfBuilder::add_tendons() {
  for (const MjcfTendon& tendon : model_.tendons) {
    const std::optional<Expression> length = tendon_length(tendon);
    if (tendon.friction_loss != 0) notes_.push_back(fmt::format("tendon {}: frictionloss does not act", tendon.name));
    if (tendon.limited) notes_.push_back(fmt::format("tendon {}: its range does not act", tendon.name));
    if (tendon.stiffness == 0 && tendon.damping == 0) continue;
    if (!length || length->is_zero()) {
      notes_.push_back(fmt::format("tendon {}: stiffness and damping of a spatial tendon do not act", tendon.name));
      continue;
    }
    const std::string name = take(symbols_, tendon.name, "tendon", {"", "_stiffness", "_damping"});
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

void MjcfBuilder::add_motor(const MjcfActuator& actuator) {
  const auto target = static_cast<std::size_t>(std::max(0, actuator.target));
  const auto cannot = [&](const std::string& why) {
    notes_.push_back(fmt::format("actuator {} does not act: {}", actuator.name, why));
  };
  const auto drive = [&](const Expression& displacement) {
    const std::string name = take(symbols_, actuator.name, "actuator");
    if (!actuator.law.empty()) data_.push_back(fmt::format("actuator {}: {}", actuator.name, actuator.law));
    return scene_.motor(name, displacement);
  };
  // What turns freely or acts at a site works with no coordinate: its force is a parameter that stays open.
  const auto open_force = [&](bool is_force) {
    const std::string name = take(symbols_, actuator.name, "actuator");
    data_.push_back(fmt::format("actuator {}: its {} is the run-time parameter {}{}", actuator.name,
                                is_force ? "force" : "torque", name, actuator.law.empty() ? "" : "; " + actuator.law));
    return scene_.run_time_parameter(name, is_force ? "N" : "N m", 0);
  };
  // A gear is a number: the input is the force of the actuator before it.
  const auto geared = [&](std::size_t k, const Expression& q) {
    const Number gear = from_double(actuator.gear[k]);
    return gear.is_one() ? q : Expression(gear) * q;
  };
  const auto part = [&](std::size_t k, const Expression& input, const Unit& unit) -> Expression {
    if (actuator.gear[k] == 0) return 0;
    return Expression::quantity(from_double(actuator.gear[k]), unit) * input;
  };
  const bool pushes = std::any_of(actuator.gear.begin(), actuator.gear.begin() + 3, [](double g) { return g != 0; });
  const bool twists = std::any_of(actuator.gear.begin() + 3, actuator.gear.end(), [](double g) { return g != 0; });
  switch (actuator.transmission) {
    case MjcfTransmission::joint:
    case MjcfTransmission::joint_in_parent: {
      const MjcfJoint& joint = model_.joints[target];
      const JointParts& parts = joints_[target];
      if (joint.is_scalar()) {
        if (actuator.gear[0] == 0) return cannot("its gear is 0");
        drive(geared(0, position(target)));
        return;
      }
      const bool in_parent = actuator.transmission == MjcfTransmission::joint_in_parent;
      if (joint.type == MjcfJointType::ball) {
        if (!pushes) return cannot("its gear is 0");
        const Expression u = open_force(false);
        scene_.torque_between(joints_[target].name + "_" + as_identifier(actuator.name, "actuator"),
                              {.a = parts.frame,
                               .b = parts.parent_frame,
                               .components = {part(0, u, Unit()), part(1, u, Unit()), part(2, u, Unit())},
                               .axes = in_parent ? parts.parent_frame : parts.frame});
        return;
      }
      if (!pushes && !twists) return cannot("its gear is 0");
      const std::string& body = frames_[static_cast<std::size_t>(joint.body)];
      if (!twists) {
        Expression along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          if (actuator.gear[k] != 0) along = along + geared(k, parts.place[k]);
        }
        drive(along);
        return;
      }
      const Expression u = open_force(pushes);
      const Unit arm = pushes ? units::metre : Unit();
      const std::string name = joints_[target].name + "_" + as_identifier(actuator.name, "actuator");
      const PointHandle origin = scene_.point(name + "_at", body, {0, 0, 0});
      if (pushes) {
        scene_.force(name + "_force", {.body = body,
                                       .point = origin,
                                       .components = {part(0, u, Unit()), part(1, u, Unit()), part(2, u, Unit())},
                                       .axes = scene_.ground()});
      }
      const FrameReference turning = in_parent ? FrameReference(scene_.ground()) : FrameReference(body);
      scene_.torque(name + "_torque", body, {part(3, u, arm), part(4, u, arm), part(5, u, arm)}, turning);
      return;
    }
    case MjcfTransmission::tendon: {
      const std::optional<Expression> length = tendon_length(model_.tendons[target]);
      if (!length || length->is_zero()) return cannot("its tendon is spatial");
      if (actuator.gear[0] == 0) return cannot("its gear is 0");
      drive(geared(0, *length));
      return;
    }
    case MjcfTransmission::site: {
      const MjcfSite& site = model_.sites[target];
      if (!pushes && !twists) return cannot("its gear is 0");
      if (!moves(site.body)) return cannot("its site does not move");
      const Expression u = open_force(pushes);
      const Unit arm = pushes ? units::metre : Unit();
      const std::string name = frame_names_.take(actuator.name + "_site", "site", {"", "_at"});
      scene_.weld(name, frames_[static_cast<std::size_t>(site.body)],
                  {lengths(site.position), rotation(site.quaternion, "site " + site.name)});
      const PointHandle at = scene_.point(name + "_at", name, {0, 0, 0});
      scene_.wrench(name + "_wrench", {.body = name,
                                       .point = at,
                                       .force = {part(0, u, Unit()), part(1, u, Unit()), part(2, u, Unit())},
                                       .moment = {part(3, u, arm), part(4, u, arm), part(5, u, arm)},
                                       .axes = name});
      return;
    }
    case MjcfTransmission::other:
      return cannot("its transmission is none of joint, fixed tendon, site");
  }
}

}  // namespace torsor
