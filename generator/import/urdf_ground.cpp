// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/import/urdf_ground.hpp"

#include <set>
#include <vector>

#include <fmt/format.h>

#include "generator/base/error.hpp"

namespace torsor {

void add_ground(Scene& scene, const UrdfRobot& robot, const UrdfOptions& options,
                const std::map<std::string, std::string>& frames, const TakeName& take) {
  if (options.ground.empty()) return;
  const UrdfCollisions collisions(scene, robot, frames, take, "ground", options.ground_friction, options.ground_restitution);
  std::set<std::string> seen;
  for (const std::string& link : options.ground) {
    if (!seen.insert(link).second) throw UsageError(fmt::format("--ground names the link '{}' twice: name it once", link));
    const std::vector<const UrdfCollision*> of_link = collisions.of_link(link, "--ground");
    for (std::size_t k = 0; k < of_link.size(); ++k) {
      const std::string name = frames.at(link) + "_ground";
      collisions.touch_plane(of_link.size() == 1 ? name : fmt::format("{}_{}", name, k + 1), *of_link[k], scene.ground());
    }
  }
}

}  // namespace torsor
