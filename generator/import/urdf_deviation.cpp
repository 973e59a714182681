// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "torsor/generator/base/decimal.hpp"

namespace torsor {
namespace {

/// Of each node of a graph in which every node follows one other at most: its own number and a multiple of that of the
/// one it follows. What follows itself in a circle, which is refused later, counts as following nothing.
class Accumulation {
 public:
  struct Node {
    double own = 0, factor = 1;
    std::string followed;  ///< empty for none
  };

  void add(const std::string& name, const Node& node) { nodes_.emplace(name, node); }

  double of(const std::string& name) {
    std::vector<std::string> way;
    std::string at = name;
    while (!sums_.contains(at)) {
      const auto node = nodes_.find(at);
      if (node == nodes_.end() || way.size() > nodes_.size()) {
        sums_[at] = 0;
        break;
      }
      way.push_back(at);
      if (node->second.followed.empty()) break;
      at = node->second.followed;
    }
    for (; !way.empty(); way.pop_back()) {
      const Node& node = nodes_.at(way.back());
      const auto before = sums_.find(node.followed);
      sums_[way.back()] = node.own + (before == sums_.end() ? 0 : node.factor * before->second);
    }
    return sums_[name];
  }

 private:
  std::map<std::string, Node> nodes_;
  std::map<std::string, double> sums_;
};

}  // namespace

UrdfDeviation largest_deviation(const UrdfRobot& robot, double size) {
  std::map<std::string, double> own;
  for (const UrdfExactAngle& angle : robot.exact_angles) {
    if (angle.size <= size) own[angle.where] += angle.moves;
  }
  UrdfDeviation result;
  if (own.empty()) return result;
  Accumulation displacements, links;
  for (const UrdfJoint& joint : robot.joints) {
    const std::string offset = joint.mimic ? offset_of(joint.name) : "";
    displacements.add(joint.name, {joint.mimic ? own[offset] : 0, joint.mimic ? std::abs(joint.mimic->multiplier.to_double()) : 1,
                                   joint.mimic ? joint.mimic->joint : ""});
  }
  for (const UrdfJoint& joint : robot.joints) {
    links.add(joint.child.link, {own["joint " + joint.name] + displacements.of(joint.name), 1, joint.parent.link});
  }
  for (const UrdfLink& link : robot.links) {
    const double sum = links.of(link.name) + own["link " + link.name];
    if (sum > result.sum) result = {sum, link.name};
  }
  return result;
}

Number smaller_tolerance(const UrdfRobot& robot, const Number& tolerance, double allowed) {
  std::vector<double> sizes{0};
  for (const UrdfExactAngle& angle : robot.exact_angles) sizes.push_back(angle.size);
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  const auto first_beyond = std::partition_point(sizes.begin() + 1, sizes.end(), [&](double size) {
    return largest_deviation(robot, size).sum <= allowed;
  });
  const double last = *(first_beyond - 1);
  const double beyond = first_beyond == sizes.end() ? last : *first_beyond;
  const Number between = from_double((last + beyond) / 2);
  // A direction is compared by its components, which differ somewhat from its angle.
  const Number half = tolerance / Number(2);
  return between < tolerance ? between : half;
}

}  // namespace torsor
