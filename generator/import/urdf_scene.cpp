// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/expression/high_precision.hpp"
#include "generator/import/identifiers.hpp"
#include "generator/import/urdf.hpp"
#include "generator/import/urdf_initial.hpp"
#include "generator/import/urdf_notes.hpp"
#include "generator/import/urdf_robot.hpp"
#include "generator/mechanics/inertia_validity.hpp"

namespace torsor {
namespace {

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

Triple quantities(const std::array<Number, 3>& numbers, const Unit& unit = Unit()) {
  return {Expression::quantity(numbers[0], unit), Expression::quantity(numbers[1], unit),
          Expression::quantity(numbers[2], unit)};
}

bool is_identity(const UrdfPlacement& place) {
  return place.rotation.is_identity() &&
         std::all_of(place.xyz.begin(), place.xyz.end(), [](const Number& x) { return x.is_zero(); });
}

Placement placement(const UrdfPlacement& place) { return {quantities(place.xyz, units::metre), place.rotation}; }

/// The free joint of a floating base or of a floating joint.
struct FreeJoint {
  Triple position;
  AttitudeHandle attitude;
};

class SceneBuilder {
 public:
  SceneBuilder(const UrdfRobot& robot, const UrdfOptions& options, std::string root)
      : robot_(robot), options_(options), root_(std::move(root)), scene_(scene_name()) {}

  ImportedRobot build() {
    // With the members that the kernel kinematics makes of them.
    for (const UrdfLink& link : robot_.links) {
      frames_[link.name] = take(frame_names_, link.name, "link",
                                {"", "_position", "_velocity", "_angular_velocity", "_rotation", "_origin",
                                 "_origin_position", "_origin_velocity", "_origin_jacobian"});
    }
    std::string base_name;
    if (options_.base == UrdfBase::floating) base_ = free_joint(root_, "link", base_name);
    for (const UrdfJoint& joint : robot_.joints) declare(joint);
    weld_or_free_root();
    for (const UrdfJoint& joint : robot_.joints) place(joint);
    for (const UrdfLink& link : robot_.links) add_body(link);
    for (const UrdfJoint& joint : robot_.joints) add_actions(joint);
    scene_.gravity(quantities(options_.gravity, units::metre_per_second_squared));
    add_points();
    set_initial(scene_, options_.initial);
    ImportedRobot imported{std::move(scene_), std::move(data_)};
    imported.scene.came_from(urdf_origin(robot_, options_, imported.joints, renamed_, odd_inertia_));
    return imported;
  }

 private:
  std::string scene_name() {
    if (!options_.name.empty()) return options_.name;
    const std::string name = as_identifier(robot_.name, "robot");
    note_name("robot", robot_.name, name);
    return name;
  }

  void note_name(const std::string& kind, const std::string& name, const std::string& identifier) {
    if (name == identifier) return;
    std::string note = fmt::format("{} '{}' is {}", kind, name, identifier);
    if (std::find(renamed_.begin(), renamed_.end(), note) == renamed_.end()) renamed_.push_back(std::move(note));
  }

  std::string take(Identifiers& names, const std::string& name, const std::string& kind,
                   const std::vector<std::string>& suffixes = {""}) {
    std::string identifier = names.take(name, kind, suffixes);
    note_name(kind, name, identifier);
    return identifier;
  }

  FreeJoint free_joint(const std::string& name, const std::string& kind, std::string& word) {
    word = take(symbols_, name, kind,
                {"_x", "_y", "_z", "_attitude_w", "_attitude_x", "_attitude_y", "_attitude_z", "_attitude_omega_x",
                 "_attitude_omega_y", "_attitude_omega_z"});
    FreeJoint joint;
    for (std::size_t i = 0; i < 3; ++i) joint.position[i] = scene_.coordinate(word + "_" + axis_names.at(i), "m");
    joint.attitude = scene_.attitude(word + "_attitude");
    return joint;
  }

  /// Whether the joint's damping is a damper of the scene.
  bool acts(const UrdfJoint& joint) const {
    return options_.dampers && (joint.turns() || joint.slides()) && joint.damping && !joint.damping->is_zero();
  }

  void declare(const UrdfJoint& joint) {
    if (joint.type == UrdfJointType::fixed) return;
    UrdfJointData data{joint.name,    {},          joint.lower,   joint.upper, joint.velocity, joint.effort,
                       joint.damping, acts(joint), joint.friction};
    if (joint.type == UrdfJointType::floating) {
      free_[joint.name] = free_joint(joint.name, "joint", names_[joint.name]);
    } else if (joint.type == UrdfJointType::planar) {
      const std::string word = take(symbols_, joint.name, "joint", {"_x", "_y", "_angle"});
      names_[joint.name] = word;
      planar_[joint.name] = {scene_.coordinate(word + "_x", "m"), scene_.coordinate(word + "_y", "m"),
                             scene_.coordinate(word + "_angle", "rad")};  // braces: from left to right
    } else if (!joint.mimic) {
      const std::string effort = joint.turns() ? "_torque" : "_force";
      data.coordinate = take(symbols_, joint.name, "joint", {"", effort, "_damping"});
      names_[joint.name] = data.coordinate;
      const Expression q = scene_.coordinate(data.coordinate, joint.turns() ? "rad" : "m");
      displacements_[joint.name] = q;
      if (data.lower || data.upper || data.velocity || data.effort) {
        scene_.limits(q, {data.lower, data.upper, data.velocity, data.effort});
      }
    } else {
      names_[joint.name] = take(symbols_, joint.name, "joint", {"", "_damping"});
    }
    data_.push_back(std::move(data));
  }

  /// The joint's displacement as a formula of coordinates; that of a mimic is multiplier · (leader's) + offset.
  Expression displacement(const UrdfJoint& joint) {
    if (const auto found = displacements_.find(joint.name); found != displacements_.end()) return found->second;
    const UrdfMimic& mimic = *joint.mimic;
    const auto is_leader = [&mimic](const UrdfJoint& each) { return each.name == mimic.joint; };
    const UrdfJoint& leader = *std::find_if(robot_.joints.begin(), robot_.joints.end(), is_leader);
    const Unit unit = joint.turns() ? units::radian : units::metre;
    const Unit leader_unit = leader.turns() ? units::radian : units::metre;
    const Expression followed = displacement(leader);
    Expression result;
    if (!mimic.multiplier.is_zero()) {
      result = mimic.multiplier.is_one() && unit == leader_unit
                   ? followed
                   : Expression::quantity(mimic.multiplier, unit / leader_unit) * followed;
    }
    if (mimic.offset_twelfths) {
      if (!mimic.offset_twelfths->is_zero()) {
        result = result + Expression(*mimic.offset_twelfths / Number(12)) * pi();
      }
    } else if (!mimic.offset.is_zero()) {
      result = result + Expression::quantity(mimic.offset, unit);
    }
    displacements_[joint.name] = result;
    return result;
  }

  void weld_or_free_root() {
    const std::string& frame = frames_.at(root_);
    if (options_.base == UrdfBase::fixed) {
      scene_.weld(frame, scene_.ground(), {});
    } else {
      scene_.free(frame, scene_.ground(), base_->position, base_->attitude);
    }
  }

  void place(const UrdfJoint& joint) {
    const FrameHandle frame = add_joint(joint);
    if (joint.type != UrdfJointType::fixed) scene_.name_joint(frame, names_.at(joint.name));
  }

  /// The frame that the joint moves: the child, or one that the child is welded to.
  FrameHandle add_joint(const UrdfJoint& joint) {
    const std::string& parent = frames_.at(joint.parent.link);
    const std::string& child = frames_.at(joint.child.link);
    const Placement at = placement(joint.origin);
    const Triple axis = quantities(joint.axis);
    switch (joint.type) {
      case UrdfJointType::revolute:
      case UrdfJointType::continuous:
        return scene_.revolute(child, parent, axis, displacement(joint), at);
      case UrdfJointType::prismatic:
        return scene_.prismatic(child, parent, axis, displacement(joint), at);
      case UrdfJointType::fixed:
        return scene_.weld(child, parent, at);
      case UrdfJointType::floating: {
        const FreeJoint& free = free_.at(joint.name);
        std::string from = parent;
        if (!is_identity(joint.origin)) {
          from = frame_names_.take(joint.name + "_fixed", "joint");
          scene_.weld(from, parent, at);
        }
        return scene_.free(child, from, free.position, free.attitude);
      }
      case UrdfJointType::planar: {
        const auto& [x, y, angle] = planar_.at(joint.name);
        const Rotation tilt = rotation_to(joint.axis);
        if (tilt.is_identity()) return scene_.planar(child, parent, x, y, angle, at);
        const std::string slide = frame_names_.take(joint.name + "_plane", "joint");
        const FrameHandle frame = scene_.planar(slide, parent, x, y, angle, {at.origin, at.rotation * tilt});
        scene_.weld(child, slide, {{0, 0, 0}, tilt.transpose()});
        return frame;
      }
    }
    return scene_.ground();
  }

  /// A parameter with its value; zero stays zero, so that it vanishes in printed equations too.
  Expression parameter(const std::string& name, const char* unit, const Number& value) {
    if (value.is_zero()) return 0;
    return scene_.parameter(name, unit, Expression::quantity(value, Unit::parse(unit)));
  }

  void add_body(const UrdfLink& link) {
    if (!link.inertial || link.inertial->is_zero()) return;
    const UrdfInertial& inertial = *link.inertial;
    const std::string& frame = frames_.at(link.name);
    const std::string word = symbols_.take(link.name, "link",
                                           {"_mass", "_com_x", "_com_y", "_com_z", "_inertia_xx", "_inertia_yy",
                                            "_inertia_zz", "_inertia_xy", "_inertia_xz", "_inertia_yz"});
    const Expression mass = parameter(word + "_mass", "kg", inertial.mass);
    Triple center;
    for (std::size_t i = 0; i < 3; ++i) {
      center[i] = parameter(word + "_com_" + axis_names.at(i), "m", inertial.center[i]);
    }
    const auto moment = [&](std::size_t i, std::size_t j) {
      return parameter(word + "_inertia_" + axis_names.at(i) + axis_names.at(j), "kg m^2", inertial.inertia[i][j]);
    };
    const Expression xx = moment(0, 0);
    const Expression yy = moment(1, 1);
    const Expression zz = moment(2, 2);
    const Expression xy = moment(0, 1);
    const Expression xz = moment(0, 2);
    const Expression yz = moment(1, 2);
    const Inertia inertia = Inertia::general(mass, xx, yy, zz, xy, xz, yz).at(center);
    scene_.body(frame, frame, inertia, moments_of(link, inertia));
  }

  /// Whether the link's moments must be taken as they are. Refuses those that may not.
  Moments moments_of(const UrdfLink& link, const Inertia& inertia) {
    const auto refusal = [&](Moments moments) -> std::string {
      try {
        check_inertia(scene_.content(), {frames_.at(link.name), frames_.at(link.name), inertia, moments});
      } catch (const SceneError& error) {
        return error.what();
      }
      return "";
    };
    const std::string reason = refusal(Moments::of_matter);
    if (reason.empty()) return Moments::of_matter;
    const std::string anyway = refusal(Moments::as_given);
    if (!anyway.empty()) link.inertial->place.fail(anyway);
    if (!options_.accept_inertia) link.inertial->place.fail(reason + "; --accept-inertia takes them as they are");
    odd_inertia_.push_back(link.name);
    return Moments::as_given;
  }

  void add_actions(const UrdfJoint& joint) {
    if (!joint.turns() && !joint.slides()) return;
    const std::string& name = names_.at(joint.name);
    if (options_.motors && !joint.mimic) {
      scene_.motor(name + (joint.turns() ? "_torque" : "_force"), displacement(joint));
    }
    if (acts(joint)) {
      const std::string parameter_name = name + "_damping";
      scene_.damper(name + "_damper", displacement(joint),
                    parameter(parameter_name, joint.turns() ? "N m s" : "N s/m", *joint.damping));
    }
  }

  void add_points() {
    for (const std::string& link : options_.points) {
      const auto found = frames_.find(link);
      if (found == frames_.end()) {
        std::string known;
        for (const UrdfLink& each : robot_.links) known += (known.empty() ? "" : ", ") + each.name;
        throw UsageError(fmt::format("unknown link '{}' in --points: the robot has {}", link, known));
      }
      scene_.point(found->second + "_origin", found->second, {0, 0, 0});
    }
  }

  const UrdfRobot& robot_;
  const UrdfOptions& options_;
  std::string root_;
  std::vector<std::string> renamed_;
  std::vector<std::string> odd_inertia_;  ///< links
  Scene scene_;
  Identifiers symbols_{{"t"}};
  Identifiers frame_names_{{"ground"}};
  std::vector<UrdfJointData> data_;
  std::map<std::string, std::string> frames_;        ///< by link
  std::map<std::string, std::string> names_;         ///< by joint that moves
  std::map<std::string, Expression> displacements_;  ///< by joint
  std::map<std::string, FreeJoint> free_;
  std::map<std::string, std::array<Expression, 3>> planar_;
  std::optional<FreeJoint> base_;
};

void check_options(const UrdfOptions& options) {
  if (options.angle_tolerance.sign() < 0 || options.angle_tolerance > Number::rational(1, 10)) {
    throw UsageError("--angle-tolerance is an angle in rad between 0 and 0.1: multiples of pi/12 are 0.26 apart");
  }
}

}  // namespace

ImportedRobot read_urdf_text(std::string_view text, const std::string& file, const UrdfOptions& options,
                             const std::vector<XmlLine>& lines) {
  check_options(options);
  const WorkingDigits precision(50);
  const UrdfRobot robot = read_robot(text, file, options.angle_tolerance, lines);
  const std::string root = check_tree(robot);
  return SceneBuilder(robot, options, root).build();
}

}  // namespace torsor
