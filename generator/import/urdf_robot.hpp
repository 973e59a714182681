// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/import/exact_direction.hpp"
#include "torsor/generator/import/reading_notes.hpp"
#include "torsor/generator/import/urdf_visuals.hpp"
#include "torsor/generator/import/xml_element.hpp"

namespace torsor {

// What a URDF file says, with its numbers made exact; read_robot reads it element by element, check_tree looks at
// the whole.

struct UrdfPlacement {
  std::array<Number, 3> xyz;
  Rotation rotation;  ///< Rz(yaw) Ry(pitch) Rx(roll)
};

/// Mass, centre of mass and moments about it, along the link's axes.
struct UrdfInertial {
  XmlPlace place;
  Number mass;
  std::array<Number, 3> center;
  std::array<std::array<Number, 3>, 3> inertia;
  bool is_zero() const;
};

struct UrdfLink {
  XmlPlace place;
  std::string name;
  std::optional<UrdfInertial> inertial;
};

enum class UrdfJointType { revolute, continuous, prismatic, fixed, floating, planar, spherical };

struct UrdfMimic {
  XmlPlace place;
  std::string joint;
  Number multiplier{1}, offset;
  std::optional<Number> offset_twelfths;  ///< the offset is that many π/12
};

/// A link as a joint names it.
struct UrdfLinkReference {
  XmlPlace place;
  std::string link;
};

struct UrdfJoint {
  XmlPlace place;
  std::string name;
  UrdfJointType type = UrdfJointType::fixed;
  UrdfLinkReference parent, child;
  UrdfPlacement origin;
  std::array<Number, 3> axis{Number(1), Number(), Number()};  ///< of unit length
  std::optional<UrdfMimic> mimic;
  std::optional<Number> lower, upper, velocity, effort, damping, friction;

  bool turns() const { return type == UrdfJointType::revolute || type == UrdfJointType::continuous; }
  bool slides() const { return type == UrdfJointType::prismatic; }
  bool has_displacement() const { return turns() || slides(); }
  /// Not fixed, and not free either: an axis, limits and damping belong to it.
  bool moves_by_numbers() const { return turns() || slides() || type == UrdfJointType::planar; }
};

/// What was made exact, for the notes: a text such as "1.5707963267948966 is pi/2" and where it stands.
class UrdfChanges {
 public:
  void add(const std::string& change, const std::string& where);
  /// "1.5707963267948966 is pi/2: joint elbow (rpy), link hand (rpy)", in the order of the file.
  std::vector<std::string> lines() const;

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> changes_;
};

/// An angle or a direction that was made exact.
struct UrdfExactAngle {
  std::string where;  ///< "joint elbow", "link hand", or what offset_of makes of a joint
  double size = 0;    ///< by which it changed [rad]
  double moves = 0;   ///< by which it turns the link at most [rad]
};

/// Where the offset of a joint's mimic stands.
inline std::string offset_of(const std::string& joint) { return "joint " + joint + " (offset)"; }

struct UrdfRobot {
  std::string file;
  std::string name;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  ReadingNotes notes;  ///< what cannot act, what was taken otherwise than stated
  UrdfChanges changes;
  std::vector<UrdfExactAngle> exact_angles;  ///< those that changed by more than nothing
  std::string exact_together;                ///< what they add up to, a line for the notes; empty where it is rounding of doubles
  std::vector<std::string> remarks;  ///< what was understood beyond the letter, a line each
  std::vector<std::string> without_effect;  ///< what is read of joints and used nowhere, a line each
  std::vector<UrdfVisual> visuals;
  std::vector<UrdfCollision> collisions;
  std::vector<std::string> almost;  ///< angles that look like a multiple of π/12 and are beyond the tolerance
};

/// Reads the elements; angles are made exact as long as they add up to the tolerance at most between the root and any link
/// (urdf_deviation.hpp), those that are nearest to multiples of π/12 first. `lines` says where each line of the text comes from, where it was made of other files. Throws
/// FileError as read_urdf does.
UrdfRobot read_robot(std::string_view text, const std::string& file, const Number& angle_tolerance,
                     const std::vector<XmlLine>& lines = {});

/// Looks at the graph of links and joints, which must be a tree, and at the mimics; returns the name of the root link.
/// Joints of that graph may have an undeclared link "world" as their parent, which is then added; a mimic of a fixed joint
/// or of a joint that is not there is dissolved; all with a note. Throws FileError naming the links and joints that are
/// wrong.
std::string settle_tree(UrdfRobot& robot);

/// Makes those joints fixed ones, at zero. Names are those of the file. Throws UsageError for an unknown one.
void fix_joints(UrdfRobot& robot, const std::vector<std::string>& joints);

}  // namespace torsor
