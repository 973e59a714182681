// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/mjcf_builder.hpp"
#include "torsor/generator/import/mjcf_origin.hpp"
#include "torsor/generator/import/point_names.hpp"
#include "torsor/generator/import/reading_notes.hpp"
#include "torsor/generator/import/urdf_initial.hpp"

namespace torsor {

ImportedMjcf mjcf_scene(const MjcfModel& model, const MjcfOptions& options) {
  const WorkingDigits precision(50);
  return MjcfBuilder(model, options).build();
}

MjcfBuilder::MjcfBuilder(const MjcfModel& model, const MjcfOptions& options)
    : model_(model), options_(options), scene_(scene_name()), data_(model.remarks) {
  for (const std::string& said : model.notes) note(said, "");
}

std::string MjcfBuilder::scene_name() {
  if (!options_.name.empty()) return options_.name;
  std::string given = model_.name;
  if (given.empty() || given == "MuJoCo Model") {
    given = model_.file.substr(model_.file.find_last_of("/\\") + 1);
    given = given.substr(0, given.find('.'));
  }
  std::string name = as_identifier(given, "robot");
  identifiers_.note("model", given, name);
  return name;
}

ImportedMjcf MjcfBuilder::build() {
  name_frames();
  choose_followers();
  for (std::size_t i = 0; i < model_.joints.size(); ++i) declare(i);
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) place(i);
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) add_inertia(i);
  check_frictions();
  for (std::size_t i = 0; i < model_.joints.size(); ++i) add_joint_actions(i);
  add_tendons();
  if (options_.motors) add_motors();
  add_equalities();
  std::array<Number, 3> gravity;
  for (std::size_t k = 0; k < 3; ++k) gravity[k] = from_double(model_.gravity[k]);
  scene_.gravity(quantities(options_.gravity.value_or(gravity), units::metre_per_second_squared));
  add_points();
  add_ground();
  set_start();
  scene_.keep_massless();
  note_geometry();
  std::vector<std::string> told = notes();
  if (options_.strict && !told.empty()) {
    throw FileError(fmt::format("{}: {}; correct the file, or leave out --strict", model_.file, told.front()));
  }
  scene_.came_from(mjcf_origin(model_, options_, {identifiers_.renamed(), changes_.lines(), data_, told}));
  return {std::move(scene_), std::move(told), model_.geoms};
}

void MjcfBuilder::note(const std::string& kind, const std::string& part) {
  auto found = std::find_if(notes_.begin(), notes_.end(), [&kind](const auto& each) { return each.first == kind; });
  if (found == notes_.end()) found = notes_.insert(notes_.end(), {kind, {}});
  if (!part.empty()) found->second.push_back(part);
}

std::vector<std::string> MjcfBuilder::notes() const {
  std::vector<std::string> lines;
  for (const auto& [kind, parts] : notes_) lines.push_back(note_of_parts(kind, parts));
  return lines;
}

void MjcfBuilder::name_frames() {
  // With the members that the kernel kinematics makes of them.
  frames_.emplace_back("ground");
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) {
    frames_.push_back(identifiers_.frame(model_.bodies[i].name, "body",
                                         {"", "_position", "_velocity", "_angular_velocity", "_rotation", "_origin",
                                          "_origin_position", "_origin_velocity", "_origin_jacobian"}));
  }
}

std::optional<Number> MjcfBuilder::as_twelfths(double angle) const {
  return twelfths_of_pi(from_double(angle), options_.angle_tolerance);
}

Expression MjcfBuilder::position_value(const MjcfJoint& joint, double value, const std::string& what) {
  if (value == 0) return 0;
  if (joint.type != MjcfJointType::hinge) return Expression::quantity(from_double(value), units::metre);
  if (const auto twelfths = as_twelfths(value)) {
    if (twelfths->is_zero()) return 0;
    const Expression exact = Expression(*twelfths / Number(12)) * pi();
    changes_.add(fmt::format("{} is {}", shortest(value), exact.to_string()),
                 fmt::format("joint {} ({})", joint.name, what));
    return exact;
  }
  return Expression::quantity(from_double(value), units::radian);
}

Rotation MjcfBuilder::rotation(const std::array<double, 4>& q, const std::string& where) {
  std::array<Number, 4> exact;
  for (std::size_t k = 0; k < 4; ++k) exact[k] = from_double(q[k]);
  const ExactRotation found = exact_rotation(exact, options_.angle_tolerance);
  if (!found.taken_for.empty()) {
    changes_.add(fmt::format("quat {} {} {} {} is {}", shortest(q[0]), shortest(q[1]), shortest(q[2]), shortest(q[3]),
                             found.taken_for),
                 where);
  }
  return found.rotation;
}

std::array<Number, 3> MjcfBuilder::direction(const std::array<double, 3>& axis, const std::string& where) {
  const std::array<Number, 3> given{from_double(axis[0]), from_double(axis[1]), from_double(axis[2])};
  const ExactDirection exact = exact_direction(given, options_.angle_tolerance);
  if (exact.changed) {
    changes_.add(
        fmt::format("axis {} {} {} is ({}, {}, {})", shortest(axis[0]), shortest(axis[1]), shortest(axis[2]),
                    exact.components[0].to_string(), exact.components[1].to_string(), exact.components[2].to_string()),
        where);
  }
  return exact.components;
}

Triple MjcfBuilder::quantities(const std::array<Number, 3>& numbers, const Unit& unit) {
  return {Expression::quantity(numbers[0], unit), Expression::quantity(numbers[1], unit),
          Expression::quantity(numbers[2], unit)};
}

Triple MjcfBuilder::lengths(const std::array<double, 3>& numbers) {
  return quantities({from_double(numbers[0]), from_double(numbers[1]), from_double(numbers[2])}, units::metre);
}

Expression MjcfBuilder::parameter(const std::string& name, const char* unit, const Number& value) {
  if (value.is_zero()) return 0;
  return scene_.parameter(name, unit, Expression::quantity(value, Unit::parse(unit)));
}

void MjcfBuilder::declare(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  JointParts& parts = joints_[i];
  const std::vector<std::string> attitude{"_attitude_w",       "_attitude_x",       "_attitude_y",      "_attitude_z",
                                          "_attitude_omega_x", "_attitude_omega_y", "_attitude_omega_z"};
  if (joint.type == MjcfJointType::free) {
    std::vector<std::string> all{"_x", "_y", "_z", "_damping", "_armature", "_stiffness"};
    all.insert(all.end(), attitude.begin(), attitude.end());
    parts.name = identifiers_.symbol(joint.name, "joint", all);
    static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
    for (std::size_t k = 0; k < 3; ++k) parts.place[k] = scene_.coordinate(parts.name + axes.at(k), "m");
    parts.attitude = scene_.attitude(parts.name + "_attitude");
    return;
  }
  if (joint.type == MjcfJointType::ball) {
    std::vector<std::string> all{"_damping", "_armature", "_stiffness"};
    all.insert(all.end(), attitude.begin(), attitude.end());
    parts.name = identifiers_.symbol(joint.name, "joint", all);
    parts.attitude = scene_.attitude(parts.name + "_attitude");
    return;
  }
  const bool turns = joint.type == MjcfJointType::hinge;
  parts.name = identifiers_.symbol(
      joint.name, "joint",
      {"", turns ? "_torque" : "_force", "_damping", "_stiffness", "_armature", "_friction", "_lower", "_upper"});
  if (followed_.contains(i)) return;
  parts.position = scene_.coordinate(parts.name, turns ? "rad" : "m");
  parts.known = true;
  if (joint.limited) {
    scene_.limits(parts.position,
                  {from_double(joint.range[0]), from_double(joint.range[1]), std::nullopt, std::nullopt});
  }
}

const Expression& MjcfBuilder::position(std::size_t i) {
  JointParts& parts = joints_[i];
  if (parts.known) return parts.position;
  const MjcfEquality& law = model_.equalities[followed_.at(i)];
  parts.position = polynomial(law, i);
  parts.known = true;
  return parts.position;
}

/// q1 = ref1 + Σ c_k (q2 − ref2)^k.
Expression MjcfBuilder::polynomial(const MjcfEquality& law, std::size_t first) {
  const MjcfJoint& joint = model_.joints[first];
  const Unit unit = joint.type == MjcfJointType::hinge ? units::radian : units::metre;
  Expression sum = position_value(joint, joint.reference[0] + law.polynomial[0], "polycoef");
  if (!law.second) return sum;
  const auto second = static_cast<std::size_t>(*law.second);
  const MjcfJoint& other = model_.joints[second];
  const Unit other_unit = other.type == MjcfJointType::hinge ? units::radian : units::metre;
  const Expression moved = position(second) - position_value(other, other.reference[0], "ref");
  if (moved.is_zero()) return sum;  // the other joint is held there, and its zero has no unit
  Expression power = moved;
  Unit power_unit = other_unit;
  for (std::size_t k = 1; k < 5; ++k) {
    if (law.polynomial[k] != 0) {
      const Number c = from_double(law.polynomial[k]);
      sum = sum + (c.is_one() && unit == power_unit ? power : Expression::quantity(c, unit / power_unit) * power);
    }
    power = power * moved;
    power_unit = power_unit * other_unit;
  }
  return sum;
}

void MjcfBuilder::place(std::size_t i) {
  const MjcfBody& body = model_.bodies[i];
  const std::string& frame = frames_[i];
  std::string at = frames_[static_cast<std::size_t>(body.parent)];
  Placement placement{lengths(body.position), rotation(body.quaternion, "body " + body.name)};
  if (body.mocap) data_.push_back(fmt::format("mocap body {} stands still at its place", body.name));
  std::vector<std::size_t> joints;
  for (std::size_t k = 0; k < model_.joints.size(); ++k) {
    if (model_.joints[k].body == static_cast<int>(i)) joints.push_back(k);
  }
  if (joints.empty()) {
    scene_.weld(frame, at, placement);
    return;
  }
  // Where the last joint's origin lies in the body: joints of one body may stand at different places.
  std::array<Number, 3> offset;
  for (std::size_t n = 0; n < joints.size(); ++n) {
    const MjcfJoint& joint = model_.joints[joints[n]];
    const JointParts& parts = joints_[joints[n]];
    if (joint.type == MjcfJointType::free) {
      scene_.name_joint(scene_.free(frame, scene_.ground(), parts.place, parts.attitude), parts.name);
      return;
    }
    std::array<Number, 3> here;
    for (std::size_t k = 0; k < 3; ++k)
      here[k] = joint.type == MjcfJointType::slide ? offset[k] : from_double(joint.position[k]);
    for (int row = 0; row < 3; ++row) {
      Number moved;
      for (int k = 0; k < 3; ++k) {
        moved += placement.rotation(row, k) * (here[static_cast<std::size_t>(k)] - offset[static_cast<std::size_t>(k)]);
      }
      Expression& component = placement.origin[static_cast<std::size_t>(row)];
      component = component + Expression::quantity(moved, units::metre);
    }
    offset = here;
    const bool at_origin = std::all_of(offset.begin(), offset.end(), [](const Number& x) { return x.is_zero(); });
    const bool last = n + 1 == joints.size() && at_origin;
    const std::string moved = last ? frame : identifiers_.frames().take(body.name + "_" + joint.name, "frame");
    at = add_joint(joints[n], moved, at, placement);
    placement = Placement{};
    if (last) return;
  }
  for (Number& x : offset) x = -x;
  scene_.weld(frame, at, {quantities(offset, units::metre), {}});
}

std::string MjcfBuilder::add_joint(std::size_t i, const std::string& frame, const std::string& parent,
                                   const Placement& placement) {
  const MjcfJoint& joint = model_.joints[i];
  JointParts& parts = joints_[i];
  if (joint.type == MjcfJointType::ball) {
    scene_.name_joint(scene_.spherical(frame, parent, parts.attitude, placement), parts.name);
    parts.frame = frame;
    parts.parent_frame = parent;
    return frame;
  }
  const Triple axis = quantities(direction(joint.axis, "joint " + joint.name), Unit());
  const Expression moved = position(i) - position_value(joint, joint.reference[0], "ref");
  const FrameHandle made = joint.type == MjcfJointType::hinge ? scene_.revolute(frame, parent, axis, moved, placement)
                                                              : scene_.prismatic(frame, parent, axis, moved, placement);
  scene_.name_joint(made, parts.name);
  return frame;
}

void MjcfBuilder::add_inertia(std::size_t i) {
  const MjcfBody& body = model_.bodies[i];
  if (body.mass == 0 && body.inertia == std::array<double, 3>{}) return;
  const std::string word =
      identifiers_.symbols().take(body.name, "body",
                                  {"_mass", "_com_x", "_com_y", "_com_z", "_inertia_xx", "_inertia_yy", "_inertia_zz",
                                   "_inertia_xy", "_inertia_xz", "_inertia_yz"});
  const Rotation r = rotation(body.principal, fmt::format("body {} (principal axes)", body.name));
  const auto moment = [&](int row, int column) {
    Number sum;
    for (int k = 0; k < 3; ++k)
      sum += r(row, k) * from_double(body.inertia[static_cast<std::size_t>(k)]) * r(column, k);
    return sum;
  };
  static constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  const auto stated = [&](int row, int column) {
    const std::string name =
        word + "_inertia_" + axes.at(static_cast<std::size_t>(row)) + axes.at(static_cast<std::size_t>(column));
    return parameter(name, "kg m^2", moment(row, column));
  };
  const Expression mass = parameter(word + "_mass", "kg", from_double(body.mass));
  Triple center;
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = parameter(word + "_com_" + axes.at(k), "m", from_double(body.center[k]));
  }
  const Expression xx = stated(0, 0), yy = stated(1, 1), zz = stated(2, 2);
  const Expression xy = stated(0, 1), xz = stated(0, 2), yz = stated(1, 2);
  scene_.body(frames_[i], frames_[i],
              Inertia::general({.mass = mass, .xx = xx, .yy = yy, .zz = zz, .xy = xy, .xz = xz, .yz = yz}).at(center));
  if (body.floats_weightless) note("gravcomp does not act", "body " + body.name);
}

/// Bodies and sites by name; `all` are all bodies, unless a body or a site is called so.
void MjcfBuilder::add_points() {
  std::vector<std::string> bodies, sites;
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) bodies.push_back(model_.bodies[i].name);
  for (const MjcfSite& each : model_.sites) sites.push_back(each.name);
  for (const std::string& name : point_names(options_.points, bodies, sites)) {
    const auto is_named = [&name](const auto& part) { return part.name == name; };
    const auto body = std::find_if(model_.bodies.begin() + 1, model_.bodies.end(), is_named);
    if (body != model_.bodies.end()) {
      const std::string& frame = frames_[static_cast<std::size_t>(body - model_.bodies.begin())];
      scene_.point(frame + "_origin", frame, {0, 0, 0});
      continue;
    }
    const auto site = std::find_if(model_.sites.begin(), model_.sites.end(), is_named);
    if (site == model_.sites.end()) {
      std::vector<std::string> known = bodies;
      known.insert(known.end(), sites.begin(), sites.end());
      throw UsageError(fmt::format("unknown body or site '{}' in --points: {}the model has {}", name,
                                   did_you_mean(name, known), fmt::join(known, ", ")));
    }
    scene_.point(identifiers_.frame(name, "site", {"_origin"}) + "_origin",
                 frames_[static_cast<std::size_t>(site->body)], lengths(site->position));
  }
}

void MjcfBuilder::set_start() {
  std::vector<std::pair<std::string, std::string>> start = options_.initial;
  const auto add = [&start](const std::string& name, double value) {
    if (value != 0) start.emplace_back(name, shortest(value));
  };
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    const MjcfJoint& joint = model_.joints[i];
    const std::string& name = joints_[i].name;
    const auto is_given = [this](const std::string& whole) {
      return std::any_of(options_.initial.begin(), options_.initial.end(),
                         [&](const auto& each) { return each.first == whole; });
    };
    if (joint.is_scalar() && !followed_.contains(i) && !is_given(name)) add(name, joint.reference[0]);
    if (joint.type != MjcfJointType::free) continue;
    static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
    static constexpr std::array<const char*, 4> components{"_attitude_w", "_attitude_x", "_attitude_y", "_attitude_z"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_given(name + axes.at(k))) add(name + axes.at(k), joint.reference[k]);
    }
    const bool turned =
        std::any_of(components.begin(), components.end(), [&](const char* c) { return is_given(name + c); });
    for (std::size_t k = 0; k < 4 && !turned; ++k) add(name + components.at(k), joint.reference[3 + k]);
  }
  set_initial(scene_, start);
}

void MjcfBuilder::note_geometry() {
  const std::size_t idle = model_.geoms.size() - touching_.size();
  if (idle == 0) return;
  note(fmt::format("contacts {}: the geometry of {} {}geom{} is kept and has no effect",
                   touching_.empty() ? "do not act" : "act as --ground says", idle, touching_.empty() ? "" : "other ",
                   idle == 1 ? "" : "s"),
       "");
}

}  // namespace torsor
