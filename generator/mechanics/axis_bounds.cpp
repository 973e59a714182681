// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/axis_bounds.hpp"

#include <string>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"

namespace torsor {
namespace {

std::string triple_text(const Triple& v) {
  return fmt::format("({}, {}, {})", v[0].to_string(), v[1].to_string(), v[2].to_string());
}

/// cos² <= 10⁻²⁴ of their angle.
SizeBound perpendicular(const JointContent& joint, const Triple& first, const Triple& second) {
  const Expression product = dot(first, second), squares = folded_product(dot(first, first), dot(second, second));
  return {product * product, SizeBound::Relation::at_most, Expression(Number(10).pow(-24)) * squares,
          fmt::format("the axes {} and {} of the universal joint '{}' are not perpendicular (the cosine of their angle is \1): "
                      "correct one, or make the joint of two revolute ones",
                      triple_text(first), triple_text(second), joint.name),
          {product / sqrt(squares)}};
}

}  // namespace

std::vector<SizeBound> bounds_of_axes(const SceneContent& scene) {
  std::vector<SizeBound> bounds;
  for (const FrameContent& frame : scene.frames) {
    if (frame.joint == JointKind::weld || frame.joint == JointKind::attitude) continue;
    bounds.push_back({Expression(0), SizeBound::Relation::below, dot(frame.axis, frame.axis),
                      fmt::format("the axis of {} is the null vector: give a direction", scene.name_of(frame)), {}});
  }
  for (const JointContent& joint : scene.joints) {
    if (joint.type != JointType::universal || !joint.of_tree) continue;
    bounds.push_back(perpendicular(joint, scene.frames[as_index(joint.of_tree->first)].axis,
                                   scene.frames[as_index(joint.of_tree->last)].axis));
  }
  std::erase_if(bounds, [](const SizeBound& each) { return !of_parameters(each.value) || !of_parameters(each.bound); });
  return bounds;
}

}  // namespace torsor
