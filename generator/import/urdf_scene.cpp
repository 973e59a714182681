// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/import/command_words.hpp"
#include "torsor/generator/import/identifiers.hpp"
#include "torsor/generator/import/point_names.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_base.hpp"
#include "torsor/generator/import/urdf_contacts.hpp"
#include "torsor/generator/import/urdf_displacement.hpp"
#include "torsor/generator/import/urdf_ground.hpp"
#include "torsor/generator/import/urdf_initial.hpp"
#include "torsor/generator/import/urdf_notes.hpp"
#include "torsor/generator/import/urdf_robot.hpp"
#include "torsor/generator/import/urdf_scene.hpp"
#include "torsor/generator/mechanics/inertia_validity.hpp"

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
  SceneBuilder(const UrdfRobot& robot, const UrdfOptions& options, SettledBase base)
      : robot_(robot),
        options_(options),
        root_(std::move(base)),
        displacements_of_joints_(displacements(robot)),
        scene_(scene_name()) {}

  ImportedRobot build() {
    // With the members that the kernel kinematics makes of them.
    for (const UrdfLink& link : robot_.links) {
      frames_[link.name] = identifiers_.frame(link.name, "link",
                                              {"", "_position", "_velocity", "_angular_velocity", "_rotation",
                                               "_origin", "_origin_position", "_origin_velocity", "_origin_jacobian"});
    }
    std::string base_name;
    if (root_.base == UrdfBase::floating) base_ = free_joint(root_.root, "link", base_name);
    const Triple weight = gravity();
    check_joints("--armature", options_.armature);
    check_joints("--friction", options_.friction);
    for (const UrdfJoint& joint : robot_.joints) {
      const std::size_t before = scene_.content().coordinates.size();
      declare(joint);
      const std::vector<CoordinateContent>& all = scene_.content().coordinates;
      for (std::size_t i = before; i < all.size(); ++i) coordinates_[joint.name].insert(all[i].q->name);
    }
    weld_or_free_root();
    for (const UrdfJoint& joint : robot_.joints) place(joint);
    for (const UrdfLink& link : robot_.links) add_body(link);
    for (const UrdfJoint& joint : robot_.joints) add_actions(joint);
    scene_.gravity(weight);
    add_points();
    const UrdfContactScene around{scene_, robot_, frames_, identifiers_};
    add_ground(around, options_.ground);
    add_contacts(around, options_.contacts);
    for (const UrdfVisual& visual : robot_.visuals) {
      scene_.show({.frame = frames_.at(visual.link), .form = visual.form, .placement = visual.placement, .colour = visual.colour});
    }
    set_initial(scene_, root_.start ? with_start(options_.initial, base_name, *root_.start) : options_.initial);
    scene_.keep_massless();
    ImportedRobot imported{std::move(scene_), std::move(data_), robot_.notes.lines()};
    note_almost_exact_angles(imported.notes);
    for (const UrdfJoint& joint : robot_.joints) {
      if (!options_.limits || !joint.mimic || !(joint.lower || joint.upper)) continue;
      imported.notes.push_back(fmt::format("joint '{}' follows '{}': its limits are no stops, those of '{}' are", joint.name,
                                           joint.mimic->joint, joint.mimic->joint));
    }
    imported.scene.came_from(urdf_origin(robot_, options_, imported.joints, identifiers_.renamed()));
    return imported;
  }

  /// The joints of which no coordinate moves any mass.
  std::vector<std::string> massless_joints(const Scene& scene) const {
    const Equations equations(scene);
    std::set<std::string> massless;
    for (const int i : equations.massless()) {
      massless.insert(equations.model().coordinates()[static_cast<std::size_t>(i)].q->name);
    }
    std::vector<std::string> joints;
    for (const UrdfJoint& joint : robot_.joints) {
      const auto own = coordinates_.find(joint.name);
      if (own == coordinates_.end() || own->second.empty()) continue;
      if (std::includes(massless.begin(), massless.end(), own->second.begin(), own->second.end())) {
        joints.push_back(joint.name);
      }
    }
    return joints;
  }

 private:
  std::string scene_name() {
    if (!options_.name.empty()) return options_.name;
    const std::string name = as_identifier(robot_.name, "robot");
    identifiers_.note("robot", robot_.name, name);
    return name;
  }

  FreeJoint free_joint(const std::string& name, const std::string& kind, std::string& word) {
    word = identifiers_.symbol(name, kind,
                               {"_x", "_y", "_z", "_attitude_w", "_attitude_x", "_attitude_y", "_attitude_z",
                                "_attitude_omega_x", "_attitude_omega_y", "_attitude_omega_z"});
    FreeJoint joint;
    for (std::size_t i = 0; i < 3; ++i) joint.position[i] = scene_.coordinate(word + "_" + axis_names.at(i), "m");
    joint.attitude = scene_.attitude(word + "_attitude");
    return joint;
  }

  /// Whether the joint turns or slides with a coordinate, its own or that of the joint that it follows.
  bool follows(const UrdfJoint& joint) const {
    return joint.has_displacement() && displacements_of_joints_.at(joint.name).leader != nullptr;
  }

  /// Whether the joint's damping is a damper of the scene.
  bool acts(const UrdfJoint& joint) const {
    return options_.dampers && follows(joint) && joint.damping && !joint.damping->is_zero();
  }

  static std::optional<Number> given(const std::vector<std::pair<std::string, Number>>& values, const std::string& joint) {
    for (const auto& [name, value] : values) {
      if (name == joint) return value;
    }
    return std::nullopt;
  }

  /// The bound of its dry friction, where there is any.
  std::optional<Number> friction_of(const UrdfJoint& joint) const {
    if (!follows(joint)) return std::nullopt;
    std::optional<Number> bound = given(options_.friction, joint.name);
    if (!bound && options_.friction_of_file) bound = joint.friction;
    return bound && !bound->is_zero() ? bound : std::nullopt;
  }

  /// Throws where an option names a joint that does not turn or slide.
  void check_joints(const char* option, const std::vector<std::pair<std::string, Number>>& values) const {
    std::vector<std::string> known;
    for (const UrdfJoint& joint : robot_.joints) {
      if (follows(joint)) known.push_back(joint.name);
    }
    check_joint_numbers(option, values, known);
  }

  void declare(const UrdfJoint& joint) {
    if (joint.type == UrdfJointType::fixed) return;
    UrdfJointData data{joint.name,    {},          joint.lower,   joint.upper, joint.velocity, joint.effort,
                       joint.damping, acts(joint), joint.friction, friction_of(joint).has_value()};
    if (joint.type == UrdfJointType::floating) {
      free_[joint.name] = free_joint(joint.name, "joint", names_[joint.name]);
    } else if (joint.type == UrdfJointType::planar) {
      const std::string word = identifiers_.symbol(joint.name, "joint", {"_x", "_y", "_angle"});
      names_[joint.name] = word;
      planar_[joint.name] = {scene_.coordinate(word + "_x", "m"), scene_.coordinate(word + "_y", "m"),
                             scene_.coordinate(word + "_angle", "rad")};  // braces: from left to right
    } else if (joint.type == UrdfJointType::spherical) {
      const std::string word = identifiers_.symbol(joint.name, "joint",
                                                   {"_attitude_w", "_attitude_x", "_attitude_y", "_attitude_z",
                                                    "_attitude_omega_x", "_attitude_omega_y", "_attitude_omega_z"});
      names_[joint.name] = word;
      free_[joint.name].attitude = scene_.attitude(word + "_attitude");
    } else if (!joint.mimic) {
      const std::string effort = joint.turns() ? "_torque" : "_force";
      data.coordinate = identifiers_.symbol(joint.name, "joint",
                                            {"", effort, "_damping", "_armature", "_friction", "_lower", "_upper"});
      names_[joint.name] = data.coordinate;
      const Expression q = scene_.coordinate(data.coordinate, joint.turns() ? "rad" : "m");
      displacements_[joint.name] = q;
      if (data.lower || data.upper || data.velocity || data.effort) {
        scene_.limits(q, {data.lower, data.upper, data.velocity, data.effort});
      }
    } else {
      names_[joint.name] = identifiers_.symbol(joint.name, "joint", {"", "_damping", "_armature", "_friction"});
    }
    data_.push_back(std::move(data));
  }

  /// The joint's displacement as a formula of coordinates.
  Expression displacement(const UrdfJoint& joint) const {
    const UrdfDisplacement& given = displacements_of_joints_.at(joint.name);
    const Unit unit = joint.turns() ? units::radian : units::metre;
    Expression result;
    if (given.leader != nullptr) {
      const Unit leader_unit = given.leader->turns() ? units::radian : units::metre;
      const Expression& followed = displacements_.at(given.leader->name);
      result = given.multiplier.is_one() && unit == leader_unit
                   ? followed
                   : Expression::quantity(given.multiplier, unit / leader_unit) * followed;
    }
    if (!given.offset_twelfths.is_zero()) {
      const Number part = given.offset_twelfths / Number(12);
      result = result + (joint.turns() ? Expression(part) : Expression::quantity(part, unit)) * pi();
    }
    if (!given.offset.is_zero()) result = result + Expression::quantity(given.offset, unit);
    return result;
  }

  void weld_or_free_root() {
    const std::string& frame = frames_.at(root_.root);
    if (root_.base == UrdfBase::fixed) {
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
          from = identifiers_.frames().take(joint.name + "_fixed", "joint");
          scene_.weld(from, parent, at);
        }
        return scene_.free(child, from, free.position, free.attitude);
      }
      case UrdfJointType::spherical:
        return scene_.spherical(child, parent, free_.at(joint.name).attitude, at);
      case UrdfJointType::planar: {
        const auto& [x, y, angle] = planar_.at(joint.name);
        const Rotation tilt = rotation_to(joint.axis);
        if (tilt.is_identity()) return scene_.planar(child, parent, {.x = x, .y = y, .angle = angle}, at);
        const std::string slide = identifiers_.frames().take(joint.name + "_plane", "joint");
        const FrameHandle frame =
            scene_.planar(slide, parent, {.x = x, .y = y, .angle = angle}, {at.origin, at.rotation * tilt});
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

  /// Its components as numbers, or as parameters of their own.
  Triple gravity() {
    Triple components = quantities(options_.gravity, units::metre_per_second_squared);
    if (!options_.run_time_gravity) return components;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name = identifiers_.symbol(fmt::format("gravity_{}", axis_names.at(i)), "parameter");
      components[i] = scene_.run_time_parameter(
          name, "m/s^2", Expression::quantity(options_.gravity[i], units::metre_per_second_squared));
    }
    return components;
  }

  void add_body(const UrdfLink& link) {
    if (!link.inertial || link.inertial->is_zero()) return;
    const UrdfInertial& inertial = *link.inertial;
    const std::string& frame = frames_.at(link.name);
    const std::string word =
        identifiers_.symbols().take(link.name, "link",
                                    {"_mass", "_com_x", "_com_y", "_com_z", "_inertia_xx", "_inertia_yy", "_inertia_zz",
                                     "_inertia_xy", "_inertia_xz", "_inertia_yz"});
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
    const Inertia inertia =
        Inertia::general({.mass = mass, .xx = xx, .yy = yy, .zz = zz, .xy = xy, .xz = xz, .yz = yz}).at(center);
    try {
      check_inertia(scene_.content(), {frame, frame, inertia, Moments::as_read});
    } catch (const SceneError& error) {
      inertial.place.fail(error.what());
    }
    scene_.body(frame, frame, inertia, Moments::as_read);
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
    if (options_.limits && !joint.mimic && (joint.lower || joint.upper)) {
      const Unit unit = joint.turns() ? units::radian : units::metre;
      const auto place = [&unit](const std::optional<Number>& at) {
        return at ? std::optional<Expression>(Expression::quantity(*at, unit)) : std::nullopt;
      };
      scene_.stop(displacements_.at(joint.name), place(joint.lower), place(joint.upper));
    }
    const std::optional<Number> armature = given(options_.armature, joint.name);
    if (armature && !armature->is_zero()) {
      scene_.reflected_inertia(identifiers_.frames().take(name + "_rotor", "joint"), displacement(joint),
                               parameter(name + "_armature", joint.turns() ? "kg m^2" : "kg", *armature));
    }
    if (const std::optional<Number> bound = friction_of(joint)) {
      scene_.dry_friction(name + "_dry_friction", displacement(joint),
                          {parameter(name + "_friction", joint.turns() ? "N m" : "N", *bound)});
    }
  }

  /// Who wrote pi/2 to five digits sees it while the file is read; the head of a header lists all of them.
  void note_almost_exact_angles(std::vector<std::string>& notes) const {
    constexpr std::size_t most = 3;
    const std::vector<std::string>& all = robot_.almost;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) notes.push_back(all[i]);
    if (all.size() > most) {
      notes.push_back(fmt::format("{} more angles look exact and are not: the head of a generated header lists them", all.size() - most));
    }
  }

  /// Links by name; `all` are all, unless a link is called so.
  void add_points() {
    std::vector<std::string> known;
    for (const UrdfLink& link : robot_.links) known.push_back(link.name);
    for (const std::string& link : point_names(options_.points, known)) {
      const auto found = frames_.find(link);
      if (found == frames_.end()) {
        throw UsageError(fmt::format("unknown link '{}' in --points: {}the robot has {}", link,
                                     did_you_mean(link, known), fmt::join(known, ", ")));
      }
      scene_.point(found->second + "_origin", found->second, {0, 0, 0});
    }
  }

  const UrdfRobot& robot_;
  const UrdfOptions& options_;
  SettledBase root_;
  std::map<std::string, UrdfDisplacement> displacements_of_joints_;
  std::map<std::string, std::set<std::string>> coordinates_;  ///< their names, by joint
  FileIdentifiers identifiers_;  // before the scene, whose name is one
  Scene scene_;
  std::vector<UrdfJointData> data_;
  std::map<std::string, std::string> frames_;        ///< by link
  std::map<std::string, std::string> names_;         ///< by joint that moves
  std::map<std::string, Expression> displacements_;  ///< coordinates, by joint
  std::map<std::string, FreeJoint> free_;
  std::map<std::string, std::array<Expression, 3>> planar_;
  std::optional<FreeJoint> base_;
};

/// A link that is left out is drawn nowhere.
void forget_pictures_of_gone_links(UrdfRobot& robot) {
  std::set<std::string> links;
  for (const UrdfLink& link : robot.links) links.insert(link.name);
  std::erase_if(robot.visuals, [&links](const UrdfVisual& visual) { return !links.contains(visual.link); });
}

void check_options(const UrdfOptions& options) {
  if (options.angle_tolerance.sign() < 0 || options.angle_tolerance > Number::rational(1, 10)) {
    throw UsageError("--angle-tolerance is an angle in rad between 0 and 0.1: multiples of pi/12 are 0.26 apart");
  }
}

}  // namespace

ImportedRobot make_scene(UrdfRobot robot, const UrdfOptions& options) {
  check_options(options);
  const WorkingDigits precision(50);
  const std::string root = settle_tree(robot);
  const SettledBase base = settle_base(robot, root, options.base);
  forget_pictures_of_gone_links(robot);
  if (options.strict) robot.notes.refuse();
  std::vector<std::string> fixed = options.fix;
  const bool fix_massless = std::erase(fixed, "massless") > 0;
  fix_joints(robot, fixed);
  if (!fixed.empty()) robot.remarks.push_back(fmt::format("fixed by --fix: {}", fmt::join(fixed, ", ")));
  while (true) {
    SceneBuilder builder(robot, options, base);
    ImportedRobot imported = builder.build();
    if (!fix_massless || imported.scene.content().coordinates.empty()) return imported;
    const std::vector<std::string> massless = builder.massless_joints(imported.scene);
    if (massless.empty()) return imported;
    fix_joints(robot, massless);
    robot.remarks.push_back(fmt::format("fixed because they move no mass: {}", fmt::join(massless, ", ")));
  }
}

ImportedRobot read_urdf_text(std::string_view text, const std::string& file, const UrdfOptions& options,
                             const std::vector<XmlLine>& lines) {
  check_options(options);
  return make_scene(read_robot(text, file, options.angle_tolerance, lines), options);
}

}  // namespace torsor
