// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "torsor/generator/import/surface_contacts.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_robot.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Where contacts of a robot are made.
struct UrdfContactScene {
  Scene& scene;
  const UrdfRobot& robot;
  const std::map<std::string, std::string>& frames;  ///< of links
  FileIdentifiers& identifiers;
};

/// Makes contacts of the <collision> elements of links that an option names.
class UrdfCollisions {
 public:
  /// The law's coefficients are the run-time parameters <word>_friction and <word>_restitution.
  UrdfCollisions(const UrdfContactScene& around, const std::string& word, const Surfaces& surfaces);

  /// The <collision> elements of a link, one at least, each a sphere, a box or a cylinder. `option` is the one that
  /// names the link. Throws UsageError for a link that is unknown or has none, FileError for another form.
  std::vector<const UrdfCollision*> of_link(const std::string& link, const std::string& option) const;

  /// A sphere touches the plane as it is, a box with its corners, a cylinder with its two rims.
  void touch_plane(const std::string& name, const UrdfCollision& collision, const FrameReference& plane) const;
  void touch_each_other(const std::string& name, const UrdfCollision& sphere, const UrdfCollision& other) const;

  const std::string& frame(const std::string& link) const { return around_.frames.at(link); }
  /// A frame at a place of a link or of another frame.
  FrameHandle at(const std::string& name, const FrameReference& parent, const Placement& placement) const {
    return contacts_.at(name, parent, placement);
  }

 private:
  UrdfContactScene around_;
  SurfaceContacts contacts_;
};

}  // namespace torsor
