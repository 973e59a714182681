// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// Reads places and directions, made exact within a tolerance; tells in the robot's changes what was changed, and in its
/// exact_angles by how much.
class UrdfPlacements {
 public:
  UrdfPlacements(UrdfRobot& robot, const Number& tolerance) : robot_(robot), tolerance_(tolerance) {}

  /// <origin xyz="..." rpy="..."/>, or quat_xyzw="x y z w" in place of rpy: the rotation
  /// 1 + 2 (w [e] + [e]²)/(w² + e²), which rational components make exact.
  UrdfPlacement placement(const XmlElement& origin, const std::string& where) const;
  /// <axis xyz="..."/>, of unit length.
  std::array<Number, 3> direction(const XmlElement& axis, const std::string& where) const;
  /// The integer k when the angle is taken as k π/12.
  std::optional<Number> twelfths(const XmlElement& element, const XmlNumber& angle, const std::string& where) const;

 private:
  void report(const XmlNumber& angle, const std::optional<Number>& twelfths, const std::string& where) const;
  void record(const std::string& where, double size, double moves) const;
  static Rotation by_quaternion(const XmlElement& origin);

  UrdfRobot& robot_;
  const Number& tolerance_;
};

}  // namespace torsor
