// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/import/mjcf_builder.hpp"

namespace torsor {
namespace {

/// A gear along three axes and about three: of what is zero nothing acts.
bool pushes(const MjcfActuator& actuator) {
  return std::any_of(actuator.gear.begin(), actuator.gear.begin() + 3, [](double g) { return g != 0; });
}
bool twists(const MjcfActuator& actuator) {
  return std::any_of(actuator.gear.begin() + 3, actuator.gear.end(), [](double g) { return g != 0; });
}

/// A gear is a number: the input is the force of the actuator before it.
Expression geared(const MjcfActuator& actuator, std::size_t k, const Expression& q) {
  const Number gear = from_double(actuator.gear[k]);
  return gear.is_one() ? q : Expression(gear) * q;
}

/// Three components of the gear times the input; the unit turns a force into a torque where one input does both.
Triple parts(const MjcfActuator& actuator, std::size_t first, const Expression& input, const Unit& unit = Unit()) {
  Triple all;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gear = actuator.gear[first + k];
    all[k] = gear == 0 ? Expression(0) : Expression::quantity(from_double(gear), unit) * input;
  }
  return all;
}

Triple opposite(const Triple& components) { return {-components[0], -components[1], -components[2]}; }

constexpr const char* no_gear = "its gear is 0";

}  // namespace

void MjcfBuilder::does_not_act(const MjcfActuator& actuator, const std::string& why) {
  note("actuators do not act", fmt::format("{} ({})", actuator.name, why));
}

void MjcfBuilder::drive(const MjcfActuator& actuator, const Expression& displacement) {
  const std::string name = identifiers_.symbol(actuator.name, "actuator");
  if (!actuator.law.empty()) data_.push_back(fmt::format("actuator {}: {}", actuator.name, actuator.law));
  scene_.motor(name, displacement);
}

/// What turns freely or acts at a site works with no coordinate: its force is a parameter that stays open.
Expression MjcfBuilder::open_force(const MjcfActuator& actuator, bool is_force) {
  const std::string name = identifiers_.symbol(actuator.name, "actuator");
  data_.push_back(fmt::format("actuator {}: its {} is the run-time parameter {}{}", actuator.name,
                              is_force ? "force" : "torque", name, actuator.law.empty() ? "" : "; " + actuator.law));
  return scene_.run_time_parameter(name, is_force ? "N" : "N m", 0);
}

void MjcfBuilder::add_motor(const MjcfActuator& actuator) {
  const auto target = static_cast<std::size_t>(std::max(0, actuator.target));
  const bool by_length =
      actuator.transmission == MjcfTransmission::tendon || actuator.transmission == MjcfTransmission::slider_crank;
  if (by_length ? actuator.gear[0] == 0 : !pushes(actuator) && !twists(actuator))
    return does_not_act(actuator, no_gear);
  switch (actuator.transmission) {
    case MjcfTransmission::joint:
    case MjcfTransmission::joint_in_parent: {
      const MjcfJoint& joint = model_.joints[target];
      if (joint.type == MjcfJointType::ball) return drive_ball(actuator);
      if (joint.type == MjcfJointType::free) return drive_free(actuator);
      if (actuator.gear[0] == 0) return does_not_act(actuator, no_gear);
      if (is_held(target)) return does_not_act(actuator, "its joint is held");
      return drive(actuator, geared(actuator, 0, position(target)));
    }
    case MjcfTransmission::tendon: {
      const std::optional<Expression> length = tendon_length(model_.tendons[target]);
      if (!length) return does_not_act(actuator, "its tendon runs around geoms");
      if (!varies(*length)) return does_not_act(actuator, "the length of its tendon is constant");
      return drive(actuator, geared(actuator, 0, *length));
    }
    case MjcfTransmission::site:
      return actuator.reference ? drive_between_sites(actuator) : drive_at_site(actuator);
    case MjcfTransmission::slider_crank:
      return drive_slider(actuator);
    case MjcfTransmission::other:
      return does_not_act(actuator, "its transmission is none of joint, tendon, site, slider-crank");
  }
}

void MjcfBuilder::drive_ball(const MjcfActuator& actuator) {
  if (!pushes(actuator)) return does_not_act(actuator, no_gear);
  const JointParts& joint = joints_[static_cast<std::size_t>(actuator.target)];
  const Expression u = open_force(actuator, false);
  const bool in_parent = actuator.transmission == MjcfTransmission::joint_in_parent;
  scene_.torque_between(joint.name + "_" + as_identifier(actuator.name, "actuator"),
                        {.a = joint.frame,
                         .b = joint.parent_frame,
                         .components = parts(actuator, 0, u),
                         .axes = in_parent ? joint.parent_frame : joint.frame});
}

void MjcfBuilder::drive_free(const MjcfActuator& actuator) {
  const auto target = static_cast<std::size_t>(actuator.target);
  const JointParts& joint = joints_[target];
  const std::string& body = frames_[static_cast<std::size_t>(model_.joints[target].body)];
  if (!twists(actuator)) {
    Expression along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (actuator.gear[k] != 0) along = along + geared(actuator, k, joint.place[k]);
    }
    return drive(actuator, along);
  }
  const bool forces = pushes(actuator);
  const Expression u = open_force(actuator, forces);
  const std::string name = joint.name + "_" + as_identifier(actuator.name, "actuator");
  const PointHandle origin = scene_.point(name + "_at", body, {0, 0, 0});
  if (forces) {
    scene_.force(name + "_force",
                 {.body = body, .point = origin, .components = parts(actuator, 0, u), .axes = scene_.ground()});
  }
  const bool in_parent = actuator.transmission == MjcfTransmission::joint_in_parent;
  const FrameReference turning = in_parent ? FrameReference(scene_.ground()) : FrameReference(body);
  scene_.torque(name + "_torque", body, parts(actuator, 3, u, forces ? units::metre : Unit()), turning);
}

void MjcfBuilder::drive_at_site(const MjcfActuator& actuator) {
  const MjcfSite& site = model_.sites[static_cast<std::size_t>(actuator.target)];
  if (!moves(site.body)) return does_not_act(actuator, "its site does not move");
  const bool forces = pushes(actuator);
  const Expression u = open_force(actuator, forces);
  const std::string name = identifiers_.frames().take(actuator.name + "_site", "site", {"", "_at"});
  weld_at(site, name);
  const PointHandle at = scene_.point(name + "_at", name, {0, 0, 0});
  scene_.wrench(name + "_wrench", {.body = name,
                                   .point = at,
                                   .force = parts(actuator, 0, u),
                                   .moment = parts(actuator, 3, u, forces ? units::metre : Unit()),
                                   .axes = name});
}

/// The gear is along the axes of the other site, where the opposite force and moment act. Two opposite forces at
/// different points turn what carries both; versions of MuJoCo differ in whether they do.
void MjcfBuilder::drive_between_sites(const MjcfActuator& actuator) {
  const int other = *actuator.reference;
  const MjcfSite& site = model_.sites[static_cast<std::size_t>(actuator.target)];
  const MjcfSite& reference = model_.sites[static_cast<std::size_t>(other)];
  if (!move_apart(site.body, reference.body)) return does_not_act(actuator, "its sites do not move apart");
  const bool forces = pushes(actuator);
  const int carrier = common_carrier(site.body, reference.body);
  if (forces && moves(carrier)) {
    return does_not_act(actuator,
                        fmt::format("it pushes from one site against another, and {}, which carries both, moves",
                                    model_.bodies[static_cast<std::size_t>(carrier)].name));
  }
  const Expression u = open_force(actuator, forces);
  const std::string axes = frame_of_site(other);
  const Triple force = parts(actuator, 0, u), moment = parts(actuator, 3, u, forces ? units::metre : Unit());
  const std::string name = identifiers_.frames().take(actuator.name, "actuator", {"_wrench", "_back"});
  const auto act = [&](const std::string& called, int at, const Triple& f, const Triple& m) {
    const int body = model_.sites[static_cast<std::size_t>(at)].body;
    if (!moves(body)) return;
    scene_.wrench(called, {.body = frames_[static_cast<std::size_t>(body)],
                           .point = point_of_site(at),
                           .force = f,
                           .moment = m,
                           .axes = axes});
  };
  act(name + "_wrench", actuator.target, force, moment);
  act(name + "_back", other, opposite(force), opposite(moment));
}

/// A slider along z of one site that a rod joins to the other, the crank: at the crank (x, y, z) it stands at
/// z − √(rod² − x² − y²), or where the rod is too short at z, as in MuJoCo.
void MjcfBuilder::drive_slider(const MjcfActuator& actuator) {
  const int slider = *actuator.reference;
  const int on_crank = model_.sites[static_cast<std::size_t>(actuator.target)].body;
  if (!move_apart(on_crank, model_.sites[static_cast<std::size_t>(slider)].body)) {
    return does_not_act(actuator, "its sites do not move apart");
  }
  const Triple crank = scene_.position(point_of_site(actuator.target), frame_of_site(slider));
  const Expression rod = Expression::quantity(from_double(actuator.rod), units::metre);
  const Expression reach = rod * rod - crank[0] * crank[0] - crank[1] * crank[1];
  // The square root of a constant has the slope 0, whatever the constant; that of zero would be 0/0.
  const Expression least = Expression(Number(10).pow(-30)) * rod * rod;
  const Expression slid = crank[2] - sqrt(max(reach, least));
  if (!varies(slid)) return does_not_act(actuator, "its sites do not move apart");
  drive(actuator, geared(actuator, 0, slid));
}

}  // namespace torsor
