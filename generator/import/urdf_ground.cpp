// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_ground.hpp"

#include <set>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

void add_ground(const UrdfContactScene& around, const Surfaces& ground) {
  if (ground.named.empty()) return;
  const UrdfCollisions collisions(around, "ground", ground);
  std::set<std::string> seen;
  for (const std::string& link : ground.named) {
    if (!seen.insert(link).second) throw UsageError(fmt::format("--ground names the link '{}' twice: name it once", link));
    const std::vector<const UrdfCollision*> of_link = collisions.of_link(link, "--ground");
    for (std::size_t k = 0; k < of_link.size(); ++k) {
      const std::string name = around.frames.at(link) + "_ground";
      collisions.touch_plane(of_link.size() == 1 ? name : fmt::format("{}_{}", name, k + 1), *of_link[k], around.scene.ground());
    }
  }
}

}  // namespace torsor
