// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/import/surfaces.hpp"
#include "torsor/generator/import/xml_element.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// What the root link of a URDF file is to the ground.
enum class UrdfBase {
  fixed,     ///< welded to it
  floating,  ///< free: a position along the ground's axes and a unit quaternion
};

/// How a URDF file becomes a scene.
struct UrdfOptions {
  UrdfBase base = UrdfBase::fixed;
  std::array<Number, 3> gravity{Number(), Number(), Number::rational(-981, 100)};  ///< in the root link's axes [m/s²]
  /// Angles near a multiple of π/12 are that multiple, axes near a direction whose components are sines and cosines of
  /// such angles are that direction, as long as this adds up to no more than the tolerance [rad] from the root to any link.
  Number angle_tolerance = Number::rational(1, 1000000000);
  bool dampers = true;  ///< <dynamics damping="c"> acts: the effort −c q̇; otherwise it is data only
  bool motors = true;   ///< a motor on every joint that turns or slides and follows no other
  /// Refuses what is noted otherwise: what cannot act, and inertia that no matter has.
  bool strict = false;
  /// Joints that become fixed ones, at zero, by their names in the file; "massless" stands for all that move no mass.
  std::vector<std::string> fix;
  std::string name;  ///< of the scene; the robot's when empty
  /// What else the command line says of the file, as it is written there: " --arg prefix:=left_".
  std::string file_arguments;
  std::vector<std::string> package_folders;  ///< of packages of ROS that meshes name
  /// Links whose origins become points of the scene, <link>_origin: the kernel kinematics has their Jacobians.
  std::vector<std::string> points;
  /// Reflected inertia of the rotors that drive joints, {joint, number} [kg m², kg]: ½ a q̇² beside the links.
  std::vector<std::pair<std::string, Number>> armature;
  /// Dry friction in joints, {joint, the largest effort} [N m, N]: kernels `contacts` and `contact_coefficients`.
  std::vector<std::pair<std::string, Number>> friction;
  bool friction_of_file = false;  ///< <dynamics friction="b"> acts so too, where `friction` says nothing else
  bool limits = false;  ///< <limit lower upper> are stops, without restitution
  /// Links whose <collision> spheres, boxes and cylinders' rims touch the ground z = 0. The run-time parameters are
  /// ground_friction and ground_restitution.
  Surfaces ground;
  /// Pairs of links whose <collision> elements meet, A:B: spheres with spheres. With a face behind one link, A:B+z, the
  /// elements of the other meet its plane. The run-time parameters are contacts_friction and contacts_restitution.
  Surfaces contacts;
  bool run_time_gravity = false;  ///< its components are the run-time parameters gravity_x, gravity_y, gravity_z
  /// State at t = 0 where it is not zero, by set_initial: {"elbow", "0.3"}, {"elbow'", "1"}, {"base_attitude_w",
  /// "0.6"}.
  std::vector<std::pair<std::string, std::string>> initial;
};

/// What a URDF file states about one joint beyond its mechanics: numbers for controllers and simulators. An angle is in
/// rad, a distance in m, an effort in N m or N.
struct UrdfJointData {
  std::string joint;       ///< as the file names it
  std::string coordinate;  ///< the scene's coordinate; empty for a joint that has none of its own
  std::optional<Number> lower, upper, velocity, effort;
  std::optional<Number> damping;   ///< c of the effort −c q̇
  bool damping_acts = false;       ///< by a damper of the scene
  std::optional<Number> friction;  ///< the bound of dry friction
  bool friction_acts = false;      ///< as dry friction of the scene
};

struct ImportedRobot {
  Scene scene;
  std::vector<UrdfJointData> joints{};  ///< those that move, in the order of the file
  std::vector<std::string> notes{};     ///< what a user should know of the file, a line each; the scene's origin has them too
};

/// Reads a robot (Unified Robot Description Format: a tree of links and joints) into a scene.
///
/// A link becomes a frame of its name and, if its mass or its inertia is not zero, a body whose mass, centre of mass
/// and moments are parameters with values (<link>_mass, <link>_com_x, <link>_inertia_xx, ...). A joint becomes a joint
/// of the scene, placed by origin: p_parent = xyz + Rz(yaw) Ry(pitch) Rx(roll) p_child.
///  * revolute, continuous, prismatic: a coordinate of the joint's name about or along the axis, with its limits, and a
///    motor on it, <joint>_torque or <joint>_force. <mimic>: the displacement multiplier · (other's) + offset, no
///    coordinate.
///  * fixed: a weld.
///  * spherical (or ball): the attitude <joint>_attitude, as of a floating joint.
///  * floating: position <joint>_x, _y, _z along the axes of the joint's origin and the attitude <joint>_attitude, a
///    unit quaternion with the components of the angular velocity in the child's axes.
///  * planar: <joint>_x, _y along two directions of the plane whose normal is the axis (the two axes that follow it
///    cyclically when it is one of x, y, z), then a turn <joint>_angle about the normal.
/// A floating base does the same as a floating joint, named after the root link. Coordinates are in the order of the
/// file's joints, those of a floating base first. Names become identifiers, distinct ones of distinct names.
///
/// Numbers are exact: a decimal is that rational. An angle near a multiple of π/12 is that multiple as the tolerance has it;
/// another one turns by rational sines and cosines, good to 10⁻¹⁸ of the angle, that form a rotation exactly. Axes are
/// normalised in the same way. What was changed is told in the notes of the scene's origin, which generated headers
/// quote, and so what has no effect: soft limits, accelerations, ends of a continuous joint.
///
/// What URDF does not know cannot act and is noted, one line for each kind; pictures, shapes of contact and materials are
/// passed over. What looks like a misspelling of something that acts is refused. Moments of inertia are taken as given:
/// notes name the links whose moments no matter has, since only sums along the axes of joints may matter. A mimic of a
/// joint that is not there is void, one of a fixed joint holds its joint; an undeclared parent "world" is the ground.
/// Joints that move no mass are kept; kernels that solve with the mass matrix are then absent.
///
/// Throws FileError, "file:line: <element>: what is wrong; what to do", for XML that cannot be read, an unknown type of
/// joint, missing, misspelt or misplaced elements and attributes, wrong numbers, a graph that is no tree, mimics in a
/// circle, a negative mass; UsageError for options that contradict the file.
ImportedRobot read_urdf(const std::string& path, const UrdfOptions& options = {});

/// The same of a text; `file` is the name used in messages and in the scene's origin. `lines` says where each line of the
/// text comes from, where it was made of other files (xacro): messages then name those.
ImportedRobot read_urdf_text(std::string_view text, const std::string& file, const UrdfOptions& options = {},
                             const std::vector<XmlLine>& lines = {});

}  // namespace torsor
