// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/ground_motion.hpp"

namespace torsor {

GroundMotion::GroundMotion(const Model& model) : model_(&model) {
  Program& program = model.program();
  Place ground;
  ground.rotation = identity(program);
  places_.push_back(ground);
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    const Link& link = model.links()[k];
    const Place parent = at(link.parent);
    Place place;
    place.rotation = turned(link);
    place.axis = bound(program, parent.rotation * model.axis_in_parent(link));
    place.from_parent = parent.rotation * link.placement_origin;
    if (link.joint == JointKind::prismatic) place.from_parent += link.displacement * place.axis;
    place.from_parent = bound(program, place.from_parent);
    place.origin = bound(program, parent.origin + place.from_parent, "place of " + link.name);
    const Vector joint = link.rate * place.axis;
    place.angular = parent.angular;
    place.linear = carried(parent, model.origin_in_parent(link));
    place.turning = model.from_parent(link, parent.turning);
    if (link.joint == JointKind::revolute) place.turning += link.rate * link.axis;
    place.turning = bound(program, place.turning);
    (link.joint == JointKind::revolute ? place.angular : place.linear) += joint;
    place.angular = bound(program, place.angular, "angular velocity of " + link.name);
    place.linear = bound(program, place.linear, "velocity of " + link.name);
    places_.push_back(place);
  }
}

/// Axes of the link in the ground's. Neighbours that turn about one axis turn by the sum of their angles: absolute
/// angles come out as they are.
Matrix GroundMotion::turned(const Link& link) const {
  Program& program = model_->program();
  const auto& links = model_->links();
  const Link* outer = &link;
  Value angle = link.angle;
  bool merged = false;
  while (link.turn == Turn::aligned && outer->placement_rotation.is_identity()) {
    const Link& next = links[static_cast<std::size_t>(outer->parent)];
    const bool same_axis = next.turn == Turn::aligned && next.aligned == link.aligned;
    if (!same_axis && (next.turn != Turn::none || next.in_group > 0 || &next == &links.front())) break;
    if (same_axis) {
      angle = next.angle + angle;
      merged = true;
    }
    outer = &next;
  }
  const Matrix carried =
      bound(program, at(outer->parent).rotation * constant_matrix(program, outer->placement_rotation));
  if (link.turn == Turn::none) return carried;
  if (link.turn == Turn::general) return bound(program, carried * link.rotation);
  const Value sine = merged ? program.sin(angle) : link.sine;
  const Value cosine = merged ? program.cos(angle) : link.cosine;
  const int x = (*link.aligned + 1) % 3;
  const int y = (*link.aligned + 2) % 3;
  Matrix result = carried;
  for (int i = 0; i < 3; ++i) {
    result(i, x) = cosine * carried(i, x);
    result(i, x) += sine * carried(i, y);
    result(i, y) = cosine * carried(i, y);
    result(i, y) -= sine * carried(i, x);
  }
  return bound(program, result);
}

Vector GroundMotion::carried(const Place& place, const Vector& point) const {
  const Vector turning = bound(model_->program(), cross(place.turning, bound(model_->program(), point)));
  return place.linear + place.rotation * turning;
}

Vector GroundMotion::velocity(int link, const Vector& place) const {
  return bound(model_->program(), carried(at(link), place));
}

std::vector<Vector> GroundMotion::partial_velocities(int link, const Vector& arm) const {
  Program& program = model_->program();
  std::vector<Vector> partials(model_->coordinates().size());
  Vector from_joint = arm;
  for (int k = link; k > 0; k = model_->links()[static_cast<std::size_t>(k)].parent) {
    const Link& joint = model_->links()[static_cast<std::size_t>(k)];
    if (!joint.partials.empty()) {
      const bool slides = joint.joint == JointKind::prismatic;
      const Vector moved = slides ? at(k).axis : bound(program, cross(at(k).axis, from_joint));
      for (const auto& [i, partial] : joint.partials) partials[static_cast<std::size_t>(i)] += partial * moved;
    }
    from_joint = bound(program, from_joint + at(k).from_parent);
  }
  for (Vector& partial : partials) partial = bound(program, partial);
  return partials;
}

std::vector<Vector> GroundMotion::partial_angular_velocities(int link) const {
  std::vector<Vector> partials(model_->coordinates().size());
  for (int k = link; k > 0; k = model_->links()[static_cast<std::size_t>(k)].parent) {
    const Link& joint = model_->links()[static_cast<std::size_t>(k)];
    if (joint.joint != JointKind::revolute) continue;
    for (const auto& [i, partial] : joint.partials) partials[static_cast<std::size_t>(i)] += partial * at(k).axis;
  }
  for (Vector& partial : partials) partial = bound(model_->program(), partial);
  return partials;
}

}  // namespace torsor
