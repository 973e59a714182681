// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/identifier.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {
namespace {

using Kind = JointClosure::Kind;

/// A locked direction: suffix of its name, what vanishes, and its sign, chosen so that the multiplier is a component of
/// the force or the moment on b.
struct Locked {
  const char* suffix;
  Kind kind;
  int i, j, sign;
};

namespace locked {
// δ(a_i · b_j) = δθ · (b_j ∧ a_i), δθ the turn of b in a.
constexpr Locked x{"x", Kind::offset, 0, 0, 1}, y{"y", Kind::offset, 1, 0, 1}, z{"z", Kind::offset, 2, 0, 1};
constexpr Locked b_like_a_x{"rx", Kind::alignment, 2, 1, 1}, b_like_a_y{"ry", Kind::alignment, 0, 2, 1},
    b_like_a_z{"rz", Kind::alignment, 1, 0, 1};
constexpr Locked parallel_x_y{"ry", Kind::alignment, 2, 0, -1}, parallel_x_z{"rz", Kind::alignment, 1, 0, 1};
constexpr Locked parallel_z_x{"rx", Kind::alignment, 1, 2, -1}, parallel_z_y{"ry", Kind::alignment, 0, 2, 1};
constexpr Locked cross{"r", Kind::alignment, 0, 1, -1}, line{"ry", Kind::alignment, 2, 0, -1};
constexpr Locked screw{"x", Kind::screw, 0, 0, 1};
}  // namespace locked

std::vector<Locked> locked_directions(JointType type) {
  using namespace locked;
  switch (type) {
    case JointType::weld: return {x, y, z, b_like_a_x, b_like_a_y, b_like_a_z};
    case JointType::revolute: return {x, y, z, parallel_x_y, parallel_x_z};
    case JointType::prismatic: return {y, z, b_like_a_x, b_like_a_y, b_like_a_z};
    case JointType::helical: return {screw, y, z, parallel_x_y, parallel_x_z};
    case JointType::cylindrical: return {y, z, parallel_x_y, parallel_x_z};
    case JointType::universal: return {x, y, z, cross};
    case JointType::spherical: return {x, y, z};
    case JointType::planar: return {z, parallel_z_x, parallel_z_y};
    case JointType::line_contact: return {z, line};
    case JointType::sphere_in_cylinder: return {y, z};
    case JointType::point_contact: return {z};
    case JointType::free: return {};
  }
  return {};
}

}  // namespace

ConstraintHandle Scene::add_constraint(ConstraintContent constraint) {
  require_identifier(constraint.name, "constraint");
  claim(constraint.name, "constraint");
  claim(constraint.multiplier->name, "multiplier");
  content_.constraints.push_back(std::move(constraint));
  return {static_cast<int>(content_.constraints.size()) - 1};
}

ConstraintHandle Scene::add_constraint(const std::string& name, ConstraintLaw law, const Unit& multiplier) {
  const SymbolPointer symbol = add_symbol("lambda_" + name, multiplier, SymbolKind::multiplier);
  return add_constraint({name, std::move(law), symbol, std::nullopt});
}

ConstraintHandle Scene::holonomic(const std::string& name, const Expression& f) {
  // λ works with ∂f/∂q_i: its unit is that of an energy over that of f.
  return add_constraint(name, HolonomicFormula{f}, units::joule / f.unit());
}
ConstraintHandle Scene::nonholonomic(const std::string& name, const Expression& left_side) {
  return add_constraint(name, NonholonomicFormula{left_side}, units::watt / left_side.unit());
}
ConstraintHandle Scene::no_slip(const std::string& name, const NoSlip& law) {
  require_unit(law.direction, Unit(), fmt::format("a component of the direction of the constraint '{}'", name));
  return add_constraint(name, law, units::newton);
}
std::vector<ConstraintHandle> Scene::rolling(const std::string& name, const Rolling& rolling) {
  const auto along = [&](const char* suffix, const Triple& direction) {
    return no_slip(name + suffix, {.body = rolling.body,
                                   .contact = rolling.contact,
                                   .direction = direction,
                                   .axes = rolling.tangents,
                                   .on = rolling.on});
  };
  const ConstraintHandle along_x = along("_x", axis::x);
  const ConstraintHandle along_y = along("_y", axis::y);
  return {along_x, along_y};
}
ConstraintHandle Scene::point_in_plane(const std::string& name, const PointReference& point,
                                       const FrameReference& plane) {
  return add_constraint(name, PointInPlane{point, plane}, units::newton);
}
ConstraintHandle Scene::closure(const std::string& name, const PointReference& a, const PointReference& b,
                                const Triple& direction) {
  require_unit(direction, Unit(), fmt::format("a component of the direction of the constraint '{}'", name));
  return add_constraint(name, Closure{a, b, direction}, units::newton);
}

std::vector<ConstraintHandle> Scene::loop_joint(const std::string& name, const LoopJoint& joint) {
  const auto& [type, a, b, pitch] = joint;
  if (type == JointType::free) {
    throw SceneError(fmt::format("joint '{}' cannot close a loop: a free joint holds nothing; leave it out", name));
  }
  if ((type == JointType::helical) == pitch.is_zero()) {
    throw SceneError(fmt::format("joint '{}' is {} and {}", name, to_string(type),
                                 pitch.is_zero() ? "needs its pitch [m/rad]" : "has no pitch: leave it out"));
  }
  if (!pitch.is_zero() && !(pitch.unit() == units::metre)) {
    throw UnitError(fmt::format("the pitch {} of joint '{}' has the unit {} and must be in m (per radian)",
                                pitch.to_string(), name, pitch.unit().to_string()));
  }
  claim(name, "joint");
  content_.joints.push_back({name, type, a, b, {}, std::nullopt, pitch});
  std::vector<ConstraintHandle> handles;
  for (const Locked& direction : locked_directions(type)) {
    const JointClosure law{direction.kind, a, b, direction.i, direction.j, direction.sign, pitch};
    const Unit unit = direction.kind == Kind::alignment ? units::newton_metre : units::newton;
    handles.push_back(add_constraint(name + "_" + direction.suffix, law, unit));
  }
  return handles;
}

void Scene::independent(const std::vector<Expression>& coordinates) {
  for (const Expression& wanted : coordinates) {
    const CoordinateContent& coordinate = coordinate_of(wanted, "independent");
    if (!coordinate.unknown()) {
      throw SceneError(fmt::format("coordinate '{}' is {} and cannot be independent: name an unknown one",
                                   coordinate.q->name, coordinate.released ? "released" : "driven"));
    }
    content_.independent.push_back(coordinate.q);
  }
}

void Scene::reaction(const ConstraintHandle& handle, const std::string& name, const PointReaction& reaction) {
  require_identifier(name, "reaction");
  require_unit(reaction.direction, Unit(), fmt::format("a component of the direction of the reaction '{}'", name));
  claim(name, "reaction");
  ConstraintContent& constraint = content_.constraints.at(static_cast<std::size_t>(handle.index));
  if (constraint.reaction) {
    throw SceneError(fmt::format("constraint '{}' already has the reaction '{}': one multiplier enforces one constraint",
                                 constraint.name, constraint.reaction->name));
  }
  constraint.reaction = ReactionContent{reaction, name};
  constraint.multiplier = add_symbol(name, units::newton, SymbolKind::multiplier);
}

}  // namespace torsor
