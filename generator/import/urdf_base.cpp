// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_base.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace torsor {
namespace {

/// The links that are one body with the root, and the joints that leave it.
struct RootBody {
  bool has_mass = false;
  std::vector<const UrdfJoint*> leaving;
};

RootBody body_of_root(const UrdfRobot& robot, const std::string& root) {
  std::map<std::string, std::vector<const UrdfJoint*>> below;
  for (const UrdfJoint& joint : robot.joints) below[joint.parent.link].push_back(&joint);
  std::map<std::string, bool> massive;
  for (const UrdfLink& link : robot.links) massive[link.name] = link.inertial && !link.inertial->is_zero();
  RootBody body;
  std::vector<std::string> links{root};
  for (std::size_t i = 0; i < links.size(); ++i) {
    body.has_mass = body.has_mass || massive[links[i]];
    const std::vector<const UrdfJoint*> joints = below[links[i]];
    for (const UrdfJoint* joint : joints) {
      if (joint->type == UrdfJointType::fixed) {
        links.push_back(joint->child.link);
      } else {
        body.leaving.push_back(joint);
      }
    }
  }
  return body;
}

/// The joint by which the world holds the robot, when it is the only one and fixed.
std::vector<UrdfJoint>::iterator hold_of_world(UrdfRobot& robot, const std::string& world) {
  const auto at_world = [&world](const UrdfJoint& joint) { return joint.parent.link == world; };
  const auto hold = std::find_if(robot.joints.begin(), robot.joints.end(), at_world);
  if (hold == robot.joints.end() || hold->type != UrdfJointType::fixed) return robot.joints.end();
  return std::find_if(hold + 1, robot.joints.end(), at_world) == robot.joints.end() ? hold : robot.joints.end();
}

}  // namespace

SettledBase settle_base(UrdfRobot& robot, const std::string& root, UrdfBase wanted) {
  if (wanted == UrdfBase::fixed) return {root, wanted};
  const bool is_world = root == "world";
  const RootBody body = body_of_root(robot, root);
  const auto floats = [](const UrdfJoint* joint) { return joint->type == UrdfJointType::floating; };
  const auto floating = std::find_if(body.leaving.begin(), body.leaving.end(), floats);
  if (floating != body.leaving.end() &&
      (is_world || (!body.has_mass && std::all_of(body.leaving.begin(), body.leaving.end(), floats)))) {
    robot.remarks.push_back(fmt::format("the joint '{}' of the file is the floating base; '{}' is fixed to the ground",
                                        (*floating)->name, root));
    return {root, UrdfBase::fixed};
  }
  const auto link = std::find_if(robot.links.begin(), robot.links.end(), [&](const UrdfLink& l) { return l.name == root; });
  const auto hold = hold_of_world(robot, root);
  if (!is_world || hold == robot.joints.end() || (link->inertial && !link->inertial->is_zero())) return {root, wanted};
  const std::string child = hold->child.link;
  robot.remarks.push_back(fmt::format("the link 'world' and the fixed joint '{}' are left out; '{}' floats, from where it held it",
                                      hold->name, child));
  const UrdfPlacement start = hold->origin;
  robot.links.erase(link);
  robot.joints.erase(hold);
  return {child, wanted, start};
}

}  // namespace torsor
