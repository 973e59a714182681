// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_displacement.hpp"

#include <vector>

#include <fmt/format.h>

namespace torsor {
namespace {

using JointByName = std::map<std::string, const UrdfJoint*>;

/// What a joint makes of its leader's displacement.
UrdfDisplacement following(const UrdfMimic& mimic, const UrdfDisplacement& leader) {
  UrdfDisplacement result = leader;
  result.multiplier = mimic.multiplier * leader.multiplier;
  result.offset = mimic.multiplier * leader.offset;
  result.offset_twelfths = mimic.multiplier * leader.offset_twelfths;
  if (mimic.offset_twelfths) {
    result.offset_twelfths += *mimic.offset_twelfths;
  } else {
    result.offset += mimic.offset;
  }
  static const Number largest = Number(10).pow(300);
  const Number size = result.multiplier.abs();
  if (size > largest || (!size.is_zero() && size * largest < Number(1))) {
    mimic.place.fail("the multipliers of this joint and of those that it follows make a number beyond the range of a "
                     "double; give them other multipliers");
  }
  if (size.is_zero()) result.leader = nullptr;
  return result;
}

}  // namespace

std::map<std::string, UrdfDisplacement> displacements(const UrdfRobot& robot) {
  JointByName joints;
  for (const UrdfJoint& joint : robot.joints) joints[joint.name] = &joint;
  std::map<std::string, UrdfDisplacement> known;
  for (const UrdfJoint& joint : robot.joints) {
    if (!joint.has_displacement()) continue;
    std::vector<const UrdfJoint*> followers;
    const UrdfJoint* at = &joint;
    for (; at->mimic && !known.contains(at->name); at = joints.at(at->mimic->joint)) followers.push_back(at);
    if (!known.contains(at->name)) known[at->name] = {at->has_displacement() ? at : nullptr, Number(1), {}, {}};
    for (; !followers.empty(); followers.pop_back()) {
      const UrdfJoint& follower = *followers.back();
      known[follower.name] = following(*follower.mimic, known.at(follower.mimic->joint));
    }
  }
  return known;
}

}  // namespace torsor
