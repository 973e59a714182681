// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/identifier.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"

namespace torsor {
namespace {

const char* shape_name(const ContactShape& shape) {
  static constexpr const char* names[] = {"a point", "a sphere",        "a hollow sphere", "a disc", "a torus",
                                          "an ellipsoid", "a convex body", "a box",           "a plane"};
  return names[shape.index()];
}

struct Centre { FrameReference frame; Expression radius; bool hollow; };

std::optional<Centre> centre_of(const ContactShape& shape) {
  if (const auto* sphere = std::get_if<shape::Sphere>(&shape)) return Centre{sphere->frame, sphere->radius, false};
  if (const auto* hollow = std::get_if<shape::HollowSphere>(&shape)) return Centre{hollow->frame, hollow->radius, true};
  return std::nullopt;
}

}  // namespace

void Scene::add_contact(ContactContent contact) {
  require_identifier(contact.name, "contact");
  claim(contact.name, "contact");
  content_.contacts.push_back(std::move(contact));
}

std::vector<PointHandle> Scene::touching_points(const std::string& name, const ContactShape& shape,
                                                const FrameReference& plane) {
  const std::string point = name + "_point";
  const auto require_lengths = [&](const std::vector<std::pair<const char*, Expression>>& lengths) {
    for (const auto& [what, length] : lengths)
      require_unit(length, units::metre, fmt::format("the {} of the contact '{}'", what, name));
  };
  const auto require_axis = [&](const Triple& axis) {
    require_unit(axis, Unit(), fmt::format("a component of the axis of the contact '{}'", name));
    (void)unit_vector(axis, fmt::format("the axis of the contact '{}' is the null vector: give a direction", name));
  };
  if (const auto* sphere = std::get_if<shape::Sphere>(&shape)) {
    require_lengths({{"radius", sphere->radius}});
    return {sphere_contact(point, sphere->frame, sphere->radius, plane)};
  }
  if (const auto* disc = std::get_if<shape::Disc>(&shape)) {
    require_axis(disc->axis);
    require_lengths({{"radius", disc->radius}});
    return {disc_contact(point, {.frame = disc->frame, .axis = disc->axis, .radius = disc->radius, .plane = plane})};
  }
  if (const auto* torus = std::get_if<shape::Torus>(&shape)) {
    require_axis(torus->axis);
    require_lengths({{"circle's radius", torus->circle_radius}, {"tube's radius", torus->tube_radius}});
    return {torus_contact(point, {.frame = torus->frame,
                                  .axis = torus->axis,
                                  .circle_radius = torus->circle_radius,
                                  .tube_radius = torus->tube_radius,
                                  .plane = plane})};
  }
  if (const auto* ellipsoid = std::get_if<shape::Ellipsoid>(&shape)) {
    for (const Expression& each : ellipsoid->semi_axes) {
      if (each.is_zero())
        throw SceneError(fmt::format("the contact '{}' has a semi-axis 0: give its three lengths, or a disc", name));
      require_lengths({{"semi-axis", each}});
    }
    return {ellipsoid_contact(point, ellipsoid->frame, ellipsoid->semi_axes, plane)};
  }
  if (const auto* convex = std::get_if<shape::Convex>(&shape)) {
    return {support_contact(point, convex->frame, convex->support, plane)};
  }
  const auto* box = std::get_if<shape::Box>(&shape);
  if (box == nullptr) {
    throw SceneError(fmt::format("the contact '{}' is between {} and a plane: a plane takes a point, a sphere, a disc, a "
                                 "torus, an ellipsoid, a convex body or a box",
                                 name, shape_name(shape)));
  }
  std::vector<StatedSize> sizes;
  std::vector<Triple> corners{{Expression(0), Expression(0), Expression(0)}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Expression& half = box->half_edges[axis];
    require_unit(half, units::metre, fmt::format("a half edge of the contact '{}'", name));
    if (half.is_zero()) continue;
    sizes.push_back({"half edge of a box", half});
    std::vector<Triple> moved;
    for (const Triple& corner : corners) {
      for (const Expression& at : {-half, half}) {
        moved.push_back(corner);
        moved.back()[axis] = at;
      }
    }
    corners = std::move(moved);
  }
  std::vector<PointHandle> points;
  for (const Triple& corner : corners) {
    points.push_back(this->point(fmt::format("{}_{}_point", name, points.size() + 1), box->frame, corner));
  }
  content_.points[as_index(points.front().index)].sizes = std::move(sizes);
  content_.boxes.push_back(points);
  return points;
}

void Scene::contact(const std::string& name, const ContactShape& shape, const ContactShape& other,
                    const SurfaceLaw& law) {
  const auto require_number = [&](const Expression& coefficient, const char* what) {
    require_unit(coefficient, Unit(), fmt::format("the {} of the contact '{}'", what, name));
    refuse_measured(coefficient, fmt::format("the {} of the contact '{}'", what, name));
  };
  const Expression static_friction = law.static_friction.value_or(law.friction);
  require_number(law.friction, "friction");
  require_number(static_friction, "static friction");
  require_number(law.restitution, "restitution");
  const std::pair<const char*, const Expression*> turns[] = {{"rolling", &law.rolling}, {"spinning", &law.spinning}};
  for (const auto& [what, length] : turns) {
    if (length->is_zero()) continue;
    require_unit(*length, units::metre, fmt::format("the resistance to {} of the contact '{}'", what, name));
    refuse_measured(*length, fmt::format("the resistance to {} of the contact '{}'", what, name));
  }
  const auto add = [&](const std::string& who, ContactGeometry geometry) {
    const std::size_t number = content_.contacts.size();
    add_contact({who, std::move(geometry), law.friction, static_friction, law.restitution});
    for (const auto& [what, length] : turns) {
      if (length->is_zero()) continue;
      add_contact({fmt::format("{}_{}", who, what), TurnOnContact{number, length == &law.spinning}, *length, *length});
    }
  };
  const auto* plane = std::get_if<shape::Plane>(&other);
  const auto* first = std::get_if<shape::Plane>(&shape);
  if (plane != nullptr || first != nullptr) {
    const shape::Plane& under = plane != nullptr ? *plane : *first;
    const ContactShape& over = plane != nullptr ? shape : other;
    for (const Expression& velocity : under.belt) {
      require_unit(velocity, units::metre_per_second, fmt::format("the belt's velocity at the contact '{}'", name));
    }
    if (const auto* point = std::get_if<shape::Point>(&over)) {
      return add(name, PointOnPlane{point->point, under.frame, under.belt});
    }
    const std::vector<PointHandle> points = touching_points(name, over, under.frame);
    for (const PointHandle& point : points) content_.points[static_cast<std::size_t>(point.index)].contact = name;
    const bool box = std::holds_alternative<shape::Box>(over);
    if (box && !(law.rolling.is_zero() && law.spinning.is_zero())) {
      throw SceneError(fmt::format("the contact '{}' resists rolling or spinning, and a box has corners that do neither: "
                                   "leave both lengths out",
                                   name));
    }
    if (box) claim(name, "contact");
    for (std::size_t k = 0; k < points.size(); ++k) {
      add(box ? fmt::format("{}_{}", name, k + 1) : name, PointOnPlane{points[k], under.frame, under.belt});
    }
    return;
  }
  auto a = centre_of(shape), b = centre_of(other);
  if (!a || !b || (a->hollow && b->hollow)) {
    throw SceneError(fmt::format("the contact '{}' is between {} and {}: one must be a plane, or both spheres of which one "
                                 "may be hollow",
                                 name, shape_name(shape), shape_name(other)));
  }
  if (a->hollow) std::swap(a, b);
  for (const auto& each : {a, b}) {
    require_unit(each->radius, units::metre, fmt::format("a radius of the contact '{}'", name));
  }
  add(name, SphereOnSphere{a->frame, b->frame, a->radius, b->radius, b->hollow});
}

void Scene::stop(const Expression& formula, const std::optional<Expression>& lower,
                 const std::optional<Expression>& upper, const StopLaw& law) {
  const CoordinateContent& coordinate = coordinate_of(formula, "stop");
  const std::string& name = coordinate.q->name;
  if (!lower && !upper) {
    throw SceneError(fmt::format("the stop of '{}' has neither a lower nor an upper place: give one", name));
  }
  if (!coordinate.unknown()) {
    throw SceneError(fmt::format("coordinate '{}' is {} and no stop can hold it: name an unknown one", name,
                                 coordinate.released ? "released" : "driven"));
  }
  require_unit(law.restitution, Unit(), fmt::format("the restitution of the stop of '{}'", name));
  const SymbolPointer q = coordinate.q;
  for (const auto& [place, suffix, sign] : {std::tuple(&lower, "lower", 1), std::tuple(&upper, "upper", -1)}) {
    if (!*place) continue;
    require_unit(**place, q->unit, fmt::format("the {} stop of '{}'", suffix, q->name));
    add_contact({fmt::format("{}_{}", q->name, suffix), Stop{Expression(q), **place, sign}, Expression(0),
                 Expression(0), law.restitution});
  }
}

void Scene::dry_friction(const std::string& name, const Expression& displacement, const DryFriction& friction) {
  const Unit unit = units::joule / displacement.unit();
  const Expression static_bound = friction.static_bound.value_or(friction.bound);
  require_unit(friction.bound, unit, fmt::format("the bound of the dry friction '{}'", name));
  require_unit(static_bound, unit, fmt::format("the static bound of the dry friction '{}'", name));
  add_contact({name, FrictionAlong{displacement, friction.bound, static_bound}});
}

void Scene::joint_friction(const std::string& name, const FrameReference& frame, const JointFriction& friction) {
  const std::string user = fmt::format("the friction '{}'", name);
  const FrameContent& carried = content_.frames[static_cast<std::size_t>(content_.frame_index(frame, user))];
  const bool turns = carried.joint == JointKind::revolute;
  if (!turns && carried.joint != JointKind::prismatic) {
    throw SceneError(fmt::format("{} acts in the joint that carries '{}', which is neither prismatic nor revolute: name a "
                                 "frame that such a joint carries",
                                 user, carried.name));
  }
  const Expression static_friction = friction.static_friction.value_or(friction.friction);
  for (const auto& [coefficient, what] : {std::pair(&friction.friction, "coefficient"), std::pair(&static_friction, "static coefficient")}) {
    require_unit(*coefficient, Unit(), fmt::format("the {} of {}", what, user));
    refuse_measured(*coefficient, fmt::format("the {} of {}", what, user));
  }
  if (turns == friction.radius.is_zero()) {
    throw SceneError(turns ? fmt::format("{} acts in the revolute joint of '{}': give the radius of its journal", user, carried.name)
                           : fmt::format("{} acts in the prismatic joint of '{}', which has no journal: leave the radius out",
                                         user, carried.name));
  }
  if (turns) {
    require_unit(friction.radius, units::metre, fmt::format("the radius of {}", user));
    refuse_measured(friction.radius, fmt::format("the radius of {}", user));
  }
  add_contact({name, FrictionInJoint{frame, friction.radius}, friction.friction, static_friction});
}

}  // namespace torsor
