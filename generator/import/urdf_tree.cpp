// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/identifiers.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {
namespace {

using ByName = std::map<std::string, UrdfJoint*>;

/// Many files call so what the robot stands on, some without declaring it.
constexpr const char* world = "world";

template <class Part>
std::vector<std::string> names_of(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

void declare_world(UrdfRobot& robot) {
  std::set<std::string> links;
  for (const UrdfLink& link : robot.links) links.insert(link.name);
  if (links.contains(world)) return;
  for (const UrdfJoint& joint : robot.joints) {
    if (joint.parent.link != world) continue;
    robot.notes.add("the parent link 'world' is not declared and is taken as the ground", "joint " + joint.name,
                    joint.parent.place);
    robot.links.insert(robot.links.begin(), {joint.parent.place, world, std::nullopt});
    return;
  }
}

/// The joint above each link that has one.
ByName joints_by_child(UrdfRobot& robot) {
  std::set<std::string> links;
  for (const UrdfLink& link : robot.links) links.insert(link.name);
  ByName above;
  for (UrdfJoint& joint : robot.joints) {
    for (const UrdfLinkReference* end : {&joint.parent, &joint.child}) {
      if (!links.contains(end->link)) {
        end->place.fail(fmt::format("there is no link '{}'; {}declare it by <link name=\"{}\"/> or correct the name",
                                    end->link, did_you_mean(end->link, names_of(robot.links)), end->link));
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
  std::map<std::string, const UrdfLink*> visited;  // by link: the one from which the way up went over it
  for (const UrdfLink& link : robot.links) {
    std::string at = link.name;
    while (above.contains(at) && visited.emplace(at, &link).second) at = above.at(at)->parent.link;
    if (!above.contains(at) || visited.at(at) != &link) continue;
    const UrdfJoint* first = above.at(at);  // of the file
    for (const UrdfJoint* joint = above.at(first->parent.link); joint != above.at(at); joint = above.at(joint->parent.link)) {
      if (joint < first) first = joint;
    }
    const UrdfJoint& start = *first;
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

/// A link without mass that nothing is joined to can be left out.
void leave_out_lonely_links(UrdfRobot& robot) {
  if (robot.links.size() < 2) return;
  std::set<std::string> joined;
  for (const UrdfJoint& joint : robot.joints) joined.insert({joint.parent.link, joint.child.link});
  if (joined.empty()) return;
  const auto lonely = [&](const UrdfLink& link) {
    if (joined.contains(link.name) || (link.inertial && !link.inertial->is_zero())) return false;
    robot.notes.add("a link without mass that nothing is joined to is left out", "link " + link.name, link.place);
    return true;
  };
  robot.links.erase(std::remove_if(robot.links.begin(), robot.links.end(), lonely), robot.links.end());
}

const UrdfLink& root_link(const UrdfRobot& robot, const ByName& above) {
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
  return *root;
}

/// Whether the joint's mimic stays: its leader is there and has a displacement.
bool keep_mimic(UrdfRobot& robot, const UrdfJoint& joint, const ByName& joints) {
  const UrdfMimic& mimic = *joint.mimic;
  const auto found = joints.find(mimic.joint);
  if (found == joints.end()) {
    const std::string meant = did_you_mean(mimic.joint, names_of(robot.joints));
    if (!meant.empty()) {
      mimic.place.fail(fmt::format("there is no joint '{}' to mimic; {}correct the name", mimic.joint, meant));
    }
    robot.notes.add(fmt::format("<mimic> of the joint '{}', which is not there, is void, and the joint is free", mimic.joint),
                    "joint " + joint.name, mimic.place, ReadingNotes::Parts::each);
    return false;
  }
  const UrdfJoint& leader = *found->second;
  if (leader.type == UrdfJointType::fixed) {
    robot.notes.add("<mimic> of a fixed joint holds the joint at the offset", "joint " + joint.name, mimic.place,
                    ReadingNotes::Parts::each);
  } else if (!leader.has_displacement()) {
    mimic.place.fail(
        fmt::format("the joint '{}' has no single displacement to mimic; name a revolute, continuous or prismatic "
                    "joint",
                    leader.name));
  }
  return true;
}

void settle_mimics(UrdfRobot& robot) {
  ByName joints;
  for (UrdfJoint& joint : robot.joints) joints[joint.name] = &joint;
  for (UrdfJoint& joint : robot.joints) {
    if (joint.mimic && !keep_mimic(robot, joint, joints)) joint.mimic.reset();
  }
  std::map<const UrdfJoint*, const UrdfJoint*> visited;  // the joint from which the way to the leaders went over it
  for (const UrdfJoint& joint : robot.joints) {
    const UrdfJoint* at = &joint;
    while (at->mimic && visited.emplace(at, &joint).second) at = joints.at(at->mimic->joint);
    if (!at->mimic || visited.at(at) != &joint) continue;
    std::string path = "'" + at->name + "'";
    const UrdfJoint* next = at;
    do {
      next = joints.at(next->mimic->joint);
      path += fmt::format(" -> '{}'", next->name);
    } while (next != at);
    at->mimic->place.fail(fmt::format("the joints mimic one another in a circle: {}; let one of them be free", path));
  }
}

/// The joint of which the scene's identifier is the name; the end where there is none.
std::vector<UrdfJoint>::iterator joint_of_identifier(UrdfRobot& robot, const std::string& name) {
  const auto is_meant = [&name](const UrdfJoint& joint) { return as_identifier(joint.name, "joint") == name; };
  const auto end = robot.joints.end(), found = std::find_if(robot.joints.begin(), end, is_meant);
  if (found == end) return found;
  const auto other = std::find_if(found + 1, end, is_meant);
  if (other == end) return found;
  throw UsageError(fmt::format("'{}' in --fix may be the joint '{}' or '{}' of the robot '{}': write the name as the file has it",
                               name, found->name, other->name, robot.name));
}

}  // namespace

std::string settle_tree(UrdfRobot& robot) {
  declare_world(robot);
  const ByName above = joints_by_child(robot);
  refuse_loops(robot, above);
  leave_out_lonely_links(robot);
  settle_mimics(robot);
  return root_link(robot, above).name;
}

void fix_joints(UrdfRobot& robot, const std::vector<std::string>& joints) {
  for (const std::string& name : joints) {
    const auto has_name = [&name](const UrdfJoint& joint) { return joint.name == name; };
    auto found = std::find_if(robot.joints.begin(), robot.joints.end(), has_name);
    if (found == robot.joints.end()) found = joint_of_identifier(robot, name);
    if (found == robot.joints.end()) {
      throw UsageError(fmt::format("unknown joint '{}' in --fix: {}name joints of the robot '{}', or massless: it has {}", name,
                                   did_you_mean(name, names_of(robot.joints)), robot.name,
                                   fmt::join(names_of(robot.joints), ", ")));
    }
    found->type = UrdfJointType::fixed;
    found->mimic.reset();
  }
}

}  // namespace torsor
