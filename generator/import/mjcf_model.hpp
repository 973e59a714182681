// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace torsor {

// What MuJoCo makes of an MJCF file, in plain numbers of SI; read_with_mujoco fills it, mjcf_scene makes a scene of it.
// Indices are those of MuJoCo; a parent comes before its children, body 0 is the world. Quaternions are (w, x, y, z).

struct MjcfBody {
  std::string name;
  int parent = 0;
  std::array<double, 3> position{};  ///< in the parent
  std::array<double, 4> quaternion{1, 0, 0, 0};
  double mass = 0;
  std::array<double, 3> center{};               ///< of mass
  std::array<double, 4> principal{1, 0, 0, 0};  ///< the principal axes in the body's
  std::array<double, 3> inertia{};              ///< principal moments about the centre of mass
  bool mocap = false;
  bool floats_weightless = false;  ///< gravity is compensated, in part or whole
};

enum class MjcfJointType { free, ball, slide, hinge };

/// Joints of a body follow one another in the order in which they are here.
struct MjcfJoint {
  std::string name;
  MjcfJointType type = MjcfJointType::hinge;
  int body = 0;
  std::array<double, 3> position{}, axis{0, 0, 1};  ///< in the body
  std::vector<double> reference;         ///< q where the bodies are placed as the file says: 1, 4 or 7 numbers
  std::vector<double> spring_reference;  ///< q where the spring rests
  double stiffness = 0, damping = 0, armature = 0, friction_loss = 0;
  bool limited = false;
  std::array<double, 2> range{};
  bool is_scalar() const { return type == MjcfJointType::slide || type == MjcfJointType::hinge; }
};

/// Contact geometry: it does not act in a scene, and is kept for those who add contacts to it.
struct MjcfGeom {
  std::string name, type;
  int body = 0;
  std::array<double, 3> size{}, position{}, friction{};
  std::array<double, 4> quaternion{1, 0, 0, 0};
};

struct MjcfSite {
  std::string name;
  int body = 0;
  std::array<double, 3> position{};
  std::array<double, 4> quaternion{1, 0, 0, 0};
};

/// A straight piece of a tendon between two sites; a pulley before it divides its part in the length.
struct MjcfTendonSpan {
  int from = 0, to = 0;
  double divisor = 1;
  double length_at_reference = 0;
};

/// The length is Σ coefficient · q of a fixed tendon, Σ |AB| / divisor of one that runs through sites.
struct MjcfTendon {
  std::string name;
  std::vector<MjcfTendonSpan> spans;
  bool wraps = false;  ///< around spheres or cylinders: its length is not known here
  std::vector<std::pair<int, double>> terms;  ///< joint, coefficient
  double stiffness = 0, damping = 0, friction_loss = 0;
  double rest = 0, length_at_reference = 0;
  bool limited = false;
};

enum class MjcfTransmission { joint, joint_in_parent, tendon, site, slider_crank, other };

struct MjcfActuator {
  std::string name;
  MjcfTransmission transmission = MjcfTransmission::joint;
  int target = 0;                ///< joint, tendon or site; of a slider-crank the site of the crank
  std::optional<int> reference;  ///< the site whose axes the gear is along, or along whose z the slider moves
  double rod = 0;                ///< of a slider-crank: from slider to crank
  std::array<double, 6> gear{};
  std::string law;  ///< how MuJoCo makes the force of the control, where the two are not the same
};

enum class MjcfEqualityType { connect, weld, joint, tendon, other };

struct MjcfEquality {
  std::string name;
  MjcfEqualityType type = MjcfEqualityType::connect;
  int first = 0;                                        ///< a body, joint or tendon
  std::optional<int> second;                            ///< another one
  std::array<double, 3> first_point{}, second_point{};  ///< of connect and weld: they coincide
  std::array<double, 4> quaternion{1, 0, 0, 0};         ///< weld: the second body in the first
  std::array<double, 5> polynomial{};                   ///< joint, tendon
};

struct MjcfModel {
  std::string file, name;
  std::array<double, 3> gravity{};
  bool limits_act = true;  ///< the file does not disable them
  std::vector<MjcfBody> bodies;
  std::vector<MjcfJoint> joints;
  std::vector<MjcfGeom> geoms;
  std::vector<MjcfSite> sites;
  std::vector<MjcfTendon> tendons;
  std::vector<MjcfActuator> actuators;
  std::vector<MjcfEquality> equalities;  ///< those that are active
  std::vector<std::string> notes;        ///< what the file says and no scene does
  std::vector<std::string> remarks;      ///< what the file says not to act
};

}  // namespace torsor
