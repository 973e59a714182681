// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {
namespace {

constexpr std::array<const Triple*, 3> unit_axes{&axis::x, &axis::y, &axis::z};

const Triple& unit_axis(int i) { return *unit_axes.at(static_cast<std::size_t>(i)); }

/// What a joint's displacement is measured in.
struct DisplacementKind {
  std::string what;
  Unit unit;
  std::string unit_name;
};

void require_displacement(const std::string& joint, const Expression& given, const DisplacementKind& kind) {
  if (given.is_zero() || given.unit() == kind.unit) return;
  throw UnitError(fmt::format("the {} {} of the joint '{}' has the unit {} and must be in {}", kind.what,
                              given.to_string(), joint, given.unit().to_string(), kind.unit_name));
}

}  // namespace

FrameHandle Scene::ground() const { return {0}; }

FrameHandle Scene::add_frame(FrameContent frame) {
  claim(frame.name, "frame");
  content_.frames.push_back(std::move(frame));
  return {static_cast<int>(content_.frames.size()) - 1};
}

FrameHandle Scene::add_joint(const std::string& name, const FrameReference& parent, const Placement& placement,
                             const StepsOfJoint& joint) {
  const auto& [type, steps] = joint;
  require_unit(placement.origin, units::metre, fmt::format("a component of the origin of the joint '{}'", name));
  for (const Step& step : steps) {
    if (!step.attitude) require_unit(step.axis, Unit(), fmt::format("a component of the axis of the joint '{}'", name));
    if (step.kind == JointKind::revolute) require_displacement(name, step.displacement, {"angle", Unit(), "rad"});
    if (step.kind == JointKind::prismatic)
      require_displacement(name, step.displacement, {"displacement", units::metre, "m"});
    if (!step.attitude) continue;
    AttitudeContent& attitude = content_.attitudes.at(as_index(*step.attitude));
    if (!attitude.frame.empty()) {
      throw SceneError(fmt::format("the attitude '{}' turns the frame '{}' and cannot turn '{}' too: declare another one",
                                   attitude.name, attitude.frame, name));
    }
    attitude.frame = name;
  }
  FrameReference at = parent;
  const int first = static_cast<int>(content_.frames.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step& step = steps[k];
    const bool last = k + 1 == steps.size();
    at = add_frame({last ? name : name + "." + step.suffix, at, k == 0 ? placement : Placement(), step.kind, step.axis,
                    step.displacement, step.attitude});
  }
  const int end = static_cast<int>(content_.frames.size()) - 1;
  content_.joints.push_back({name, type, parent, FrameHandle{end}, placement, FrameRange{first, end}, 0});
  return {end};
}

FrameHandle Scene::weld(const std::string& name, const FrameReference& parent, const Placement& placement) {
  require_unit(placement.origin, units::metre, fmt::format("a component of the origin of the frame '{}'", name));
  return add_frame({name, parent, placement, JointKind::weld, {}, 0});
}

FrameHandle Scene::revolute(const std::string& name, const FrameReference& parent, const Triple& axis,
                            const Expression& angle, const Placement& placement) {
  return add_joint(name, parent, placement, {JointType::revolute, {{"1", JointKind::revolute, axis, angle}}});
}

FrameHandle Scene::prismatic(const std::string& name, const FrameReference& parent, const Triple& axis,
                             const Expression& displacement, const Placement& placement) {
  return add_joint(name, parent, placement, {JointType::prismatic, {{"1", JointKind::prismatic, axis, displacement}}});
}

FrameHandle Scene::helical(const std::string& name, const FrameReference& parent, const HelicalMotion& motion,
                           const Placement& placement) {
  const FrameHandle frame = add_joint(name, parent, placement,
                                      {JointType::helical,
                                       {{"1", JointKind::prismatic, motion.axis, motion.pitch * motion.angle},
                                        {"2", JointKind::revolute, motion.axis, motion.angle}}});
  content_.joints.back().pitch = motion.pitch;
  return frame;
}

FrameHandle Scene::cylindrical(const std::string& name, const FrameReference& parent, const CylindricalMotion& motion,
                               const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::cylindrical,
                    {{"1", JointKind::prismatic, motion.axis, motion.displacement},
                     {"2", JointKind::revolute, motion.axis, motion.angle}}});
}

FrameHandle Scene::universal(const std::string& name, const FrameReference& parent, const UniversalMotion& motion,
                             const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::universal,
                    {{"1", JointKind::revolute, motion.first, motion.first_angle},
                     {"2", JointKind::revolute, motion.second, motion.second_angle}}});
}

std::vector<Scene::Step> Scene::turn(const PlaneRotations& rotations) {
  const auto& [sequence, angles] = rotations;
  std::vector<Step> steps;
  for (std::size_t k = 0; k < 3; ++k) {
    const int about = sequence.axes[k];
    if (about < 0 || about > 2 || (k > 0 && about == sequence.axes[k - 1])) {
      throw SceneError(fmt::format("the sequence of plane rotations about axes {}, {}, {} describes no orientation: give "
                                   "0, 1 or 2 for x, y, z, neighbours different",
                                   sequence.axes[0], sequence.axes[1], sequence.axes[2]));
    }
    steps.push_back({std::to_string(k + 1), JointKind::revolute, unit_axis(about), angles[k]});
  }
  return steps;
}

std::vector<Scene::Step> Scene::turn(AttitudeHandle attitude) {
  return {{"1", JointKind::attitude, {}, 0, attitude.index}};
}

std::vector<Scene::Step> Scene::turn(const SphericalMotion& by) {
  return std::visit([](const auto& each) { return turn(each); }, by);
}

std::vector<Scene::Step> Scene::slides(const std::vector<std::pair<Triple, Expression>>& slides,
                                       const std::vector<Step>& then) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  std::vector<Step> steps;
  for (std::size_t k = 0; k < slides.size(); ++k) {
    steps.push_back({names.at(k), JointKind::prismatic, slides[k].first, slides[k].second});
  }
  steps.insert(steps.end(), then.begin(), then.end());
  return steps;
}

FrameHandle Scene::spherical(const std::string& name, const FrameReference& parent, const PlaneRotations& rotations,
                             const Placement& placement) {
  return add_joint(name, parent, placement, {JointType::spherical, turn(rotations)});
}
FrameHandle Scene::spherical(const std::string& name, const FrameReference& parent, AttitudeHandle attitude,
                             const Placement& placement) {
  return add_joint(name, parent, placement, {JointType::spherical, turn(attitude)});
}

FrameHandle Scene::planar(const std::string& name, const FrameReference& parent, const PlanarMotion& motion,
                          const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::planar, slides({{axis::x, motion.x}, {axis::y, motion.y}},
                                              {{"1", JointKind::revolute, axis::z, motion.angle}})});
}

FrameHandle Scene::line_contact(const std::string& name, const FrameReference& parent, const LineContactMotion& motion,
                                const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::line_contact, slides({{axis::x, motion.x}, {axis::y, motion.y}},
                                                    {{"1", JointKind::revolute, axis::z, motion.yaw},
                                                     {"2", JointKind::revolute, axis::x, motion.roll}})});
}

FrameHandle Scene::sphere_in_cylinder(const std::string& name, const FrameReference& parent,
                                      const SphereInCylinderMotion& motion, const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::sphere_in_cylinder, slides({{motion.axis, motion.displacement}}, turn(motion.turn))});
}

FrameHandle Scene::point_contact(const std::string& name, const FrameReference& parent,
                                 const PointContactMotion& motion, const Placement& placement) {
  return add_joint(name, parent, placement,
                   {JointType::point_contact, slides({{axis::x, motion.x}, {axis::y, motion.y}}, turn(motion.turn))});
}

FrameHandle Scene::free(const std::string& name, const FrameReference& parent, const Triple& position,
                        const PlaneRotations& rotations) {
  return add_joint(name, parent, {},
                   {JointType::free,
                    slides({{axis::x, position[0]}, {axis::y, position[1]}, {axis::z, position[2]}}, turn(rotations))});
}
FrameHandle Scene::free(const std::string& name, const FrameReference& parent, const Triple& position,
                        AttitudeHandle attitude) {
  return add_joint(name, parent, {},
                   {JointType::free,
                    slides({{axis::x, position[0]}, {axis::y, position[1]}, {axis::z, position[2]}}, turn(attitude))});
}

void Scene::name_joint(const FrameHandle& frame, const std::string& name) {
  for (JointContent& joint : content_.joints) {
    if (!joint.of_tree || joint.of_tree->last != frame.index) continue;
    claim(name, "joint");
    joint.name = name;
    return;
  }
  const FrameContent& welded = content_.frames.at(as_index(frame.index));
  if (!welded.parent || welded.joint != JointKind::weld) {
    throw SceneError(fmt::format("no joint to be named '{}': no joint of the tree ends at the frame '{}'", name,
                                 welded.name));
  }
  claim(name, "joint");
  content_.joints.push_back(
      {name, JointType::weld, *welded.parent, frame, welded.placement, FrameRange{frame.index, frame.index}, 0});
}

void Scene::reflected_inertia(const std::string& name, const Expression& displacement, const Expression& inertia) {
  const bool slides = displacement.unit() == units::metre;
  if (!slides && !(displacement.unit() == Unit())) {
    throw UnitError(fmt::format("the displacement {} of the reflected inertia '{}' has the unit {} and must be in rad or m",
                                displacement.to_string(), name, displacement.unit().to_string()));
  }
  require_unit(inertia, slides ? units::kilogram : units::kilogram_metre_squared,
               fmt::format("the reflected inertia '{}' of a {}", name, slides ? "slide" : "turn"));
  // A wheel that turns by e, about an axis that does not matter; along a slide one of radius 1 m.
  const Expression metre = Expression::quantity(Number(1), units::metre);
  const FrameHandle turned =
      add_frame({name, ground(), {}, JointKind::revolute, axis::z, slides ? displacement / metre : displacement});
  content_.rotors.push_back({name, turned, Inertia::general({.mass = 0, .zz = slides ? inertia * metre * metre : inertia})});
}

}  // namespace torsor
