// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <fmt/format.h>

#include "generator/import/urdf_robot.hpp"

namespace torsor {
namespace {

using ByName = std::map<std::string, const UrdfJoint*>;

/// The joint above each link that has one.
ByName joints_by_child(const UrdfRobot& robot) {
  std::map<std::string, bool> links;
  for (const UrdfLink& link : robot.links) links[link.name] = true;
  ByName above;
  for (const UrdfJoint& joint : robot.joints) {
    for (const UrdfLinkReference* end : {&joint.parent, &joint.child}) {
      if (!links.contains(end->link)) {
        end->place.fail(fmt::format("there is no link '{}'; declare it by <link name=\"{}\"/> or correct the name",
                                    end->link, end->link));
      }
    }
    if (joint.parent.link == joint.child.link) {
      joint.place.fail(fmt::format("joins the link '{}' to itself; a joint has two different links", joint.child.link));
    }
    const auto [first, added] = above.emplace(joint.child.link, &joint);
    if (!added) {
      joint.child.place.fail(
          fmt::format("the link '{}' has two parents: '{}' by the joint '{}' of line {}, and '{}'; a "
                      "link is the child of one joint, so remove one (a closed loop cannot be written "
                      "in URDF: write that mechanism as a scene)",
                      joint.child.link, first->second->parent.link, first->second->name, first->second->place.line,
                      joint.parent.link));
    }
  }
  return above;
}

/// Every link must hang on the root: from one that does not, going up leads round a loop.
void refuse_loops(const UrdfRobot& robot, const ByName& above) {
  for (const UrdfLink& link : robot.links) {
    std::string at = link.name;
    std::size_t steps = 0;
    for (; above.contains(at) && steps <= robot.joints.size(); ++steps) at = above.at(at)->parent.link;
    if (steps <= robot.joints.size()) continue;
    const UrdfJoint& start = *above.at(at);
    std::string loop = fmt::format("'{}'", start.name);
    for (const UrdfJoint* joint = above.at(start.parent.link); joint != &start; joint = above.at(joint->parent.link)) {
      loop += fmt::format(", '{}'", joint->name);
    }
    start.place.fail(
        fmt::format("closes a loop of joints: {}; the links of a robot form a tree, so let one of them begin "
                    "at another link",
                    loop));
  }
}

void check_mimics(const UrdfRobot& robot) {
  ByName joints;
  for (const UrdfJoint& joint : robot.joints) joints[joint.name] = &joint;
  for (const UrdfJoint& joint : robot.joints) {
    if (!joint.mimic) continue;
    const XmlPlace& place = joint.mimic->place;
    const auto found = joints.find(joint.mimic->joint);
    if (found == joints.end()) {
      place.fail(fmt::format("there is no joint '{}' to mimic; correct the name", joint.mimic->joint));
    }
    const UrdfJoint& leader = *found->second;
    if (!leader.turns() && !leader.slides()) {
      place.fail(
          fmt::format("the joint '{}' has no single displacement to mimic; name a revolute, continuous or prismatic "
                      "joint",
                      leader.name));
    }
    std::string path = "'" + joint.name + "'";
    const UrdfJoint* at = &joint;
    for (std::size_t steps = 0; at->mimic && steps <= robot.joints.size(); ++steps) {
      const auto next = joints.find(at->mimic->joint);
      if (next == joints.end()) break;  // told at that joint
      at = next->second;
      path += fmt::format(" -> '{}'", at->name);
      if (at == &joint) {
        place.fail(fmt::format("the joints mimic one another in a circle: {}; let one of them be free", path));
      }
    }
  }
}

/// A joint that moves no mass, neither itself nor by those that mimic it, has no equation of motion.
void refuse_massless(const UrdfRobot& robot, const ByName& above) {
  ByName joints;
  for (const UrdfJoint& joint : robot.joints) joints[joint.name] = &joint;
  std::set<const UrdfJoint*> moving;
  for (const UrdfLink& link : robot.links) {
    if (!link.inertial || link.inertial->is_zero()) continue;
    for (auto at = above.find(link.name); at != above.end(); at = above.find(at->second->parent.link)) {
      const UrdfJoint* joint = at->second;
      moving.insert(joint);
      while (joint->mimic) {
        joint = joints.at(joint->mimic->joint);
        moving.insert(joint);
      }
    }
  }
  for (const UrdfJoint& joint : robot.joints) {
    if (joint.type == UrdfJointType::fixed || joint.mimic || moving.contains(&joint)) continue;
    joint.place.fail(
        fmt::format("moves no mass: neither '{}' nor any link beyond it has an <inertial> that is not zero; "
                    "give one, or make the joint fixed",
                    joint.child.link));
  }
}

}  // namespace

std::string check_tree(const UrdfRobot& robot) {
  const ByName above = joints_by_child(robot);
  refuse_loops(robot, above);
  const UrdfLink* root = nullptr;
  for (const UrdfLink& link : robot.links) {
    if (above.contains(link.name)) continue;
    if (root != nullptr) {
      link.place.fail(
          fmt::format("is the child of no joint, as '{}' of line {} is; a robot has one root link, so join "
                      "this one to another",
                      root->name, root->place.line));
    }
    root = &link;
  }
  check_mimics(robot);
  refuse_massless(robot, above);
  return root->name;
}

}  // namespace torsor
