// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/scene.hpp"

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/mechanics/identifier.hpp"

namespace torsor {

Scene::Scene(std::string name, std::string title) {
  require_identifier(name, "scene");
  content_.name = std::move(name);
  content_.title = std::move(title);
  content_.time = add_symbol("t", units::second, SymbolKind::time);
  add_frame({"ground", std::nullopt, {}, JointKind::weld, {}, 0});
}

void Scene::claim(const std::string& name, const std::string& what) {
  // Frames and bodies are often namesakes; all that becomes a symbol shares one space.
  const bool own_space = what == "frame" || what == "body" || what == "point" || what == "constraint" || what == "action";
  const std::string key = (own_space ? what : "symbol") + " " + name;
  const auto [place, added] = content_.names.emplace(key, what);
  if (!added) {
    throw SceneError(fmt::format("duplicate name '{}': the scene '{}' already has a {} of that name; choose another "
                                 "name for the new {}",
                                 name, content_.name, place->second, what));
  }
}

SymbolPointer Scene::add_symbol(const std::string& name, const Unit& unit, SymbolKind kind, SymbolPointer rate) {
  return std::make_shared<const Symbol>(Symbol{name, unit, kind, content_.symbol_count++, std::move(rate)});
}

Expression Scene::parameter(const std::string& name, std::string_view unit) {
  require_identifier(name, "parameter");
  claim(name, "parameter");
  content_.parameters.push_back({add_symbol(name, Unit::parse(unit), SymbolKind::parameter), std::nullopt, true});
  return content_.parameters.back().symbol;
}

Expression Scene::parameter(const std::string& name, std::string_view unit, const Expression& value) {
  const Expression symbol = parameter(name, unit);
  if (!value.unit().is_dimensionless() && !(value.unit() == symbol.unit())) {
    throw UnitError(fmt::format("parameter '{}' [{}] is given the value {} [{}]: the units differ; give a plain number or "
                                "one in {}",
                                name, symbol.unit().to_string(), value.to_string(), value.unit().to_string(),
                                symbol.unit().to_string()));
  }
  content_.parameters.back().value = value;
  content_.parameters.back().run_time = false;
  return symbol;
}

Expression Scene::run_time_parameter(const std::string& name, std::string_view unit, const Expression& value) {
  const Expression symbol = parameter(name, unit, value);
  content_.parameters.back().run_time = true;
  return symbol;
}

Expression Scene::coordinate(const std::string& name, std::string_view unit) {
  require_identifier(name, "coordinate");
  claim(name, "coordinate");
  const Unit u = Unit::parse(unit);
  const Unit second = units::second;
  CoordinateContent coordinate;
  coordinate.a = add_symbol(name + "''", u / second.pow(2), SymbolKind::acceleration);
  coordinate.v = add_symbol(name + "'", u / second, SymbolKind::velocity, coordinate.a);
  coordinate.q = add_symbol(name, u, SymbolKind::coordinate, coordinate.v);
  content_.coordinates.push_back(coordinate);
  return content_.coordinates.back().q;
}

Expression Scene::released_coordinate(const std::string& name, std::string_view unit) {
  const Expression q = coordinate(name, unit);
  content_.coordinates.back().released = true;
  return q;
}

Expression Scene::time() const { return content_.time; }

CoordinateContent& Scene::coordinate_of(const Expression& formula, const std::string& purpose) {
  const SymbolPointer symbol = formula.as_symbol();
  for (CoordinateContent& coordinate : content_.coordinates) {
    if (symbol && coordinate.q == symbol) return coordinate;
  }
  throw SceneError(fmt::format("{} needs a coordinate of the scene '{}' and got {}: pass what coordinate(...) returned",
                               purpose, content_.name, formula.to_string()));
}

void Scene::drive(const Expression& formula, const Expression& law) {
  CoordinateContent& coordinate = coordinate_of(formula, "drive");
  if (coordinate.law) {
    throw SceneError(fmt::format("coordinate '{}' is driven twice: keep one law of time", coordinate.q->name));
  }
  if (!law.is_zero() && !(law.unit() == coordinate.q->unit)) {
    throw UnitError(fmt::format("coordinate '{}' [{}] cannot follow the law {} [{}]: the units differ",
                                coordinate.q->name, coordinate.q->unit.to_string(), law.to_string(),
                                law.unit().to_string()));
  }
  coordinate.law = law;
}

void Scene::initial(const Expression& formula, const Expression& value, const Expression& rate) {
  CoordinateContent& coordinate = coordinate_of(formula, "initial");
  const auto require = [&](const Expression& given, const Unit& unit, const std::string& what) {
    // Plain numbers are understood in the coordinate's own SI unit.
    if (given.unit() == unit || given.unit() == Unit()) return;
    throw UnitError(fmt::format("initial {} of '{}' is given in {} and must be in {}", what, coordinate.q->name,
                                given.unit().to_string(), unit.to_string()));
  };
  require(value, coordinate.q->unit, "value");
  require(rate, coordinate.v->unit, "rate");
  coordinate.initial_value = value;
  coordinate.initial_rate = rate;
}

FrameHandle Scene::ground() const { return {0}; }

FrameHandle Scene::add_frame(FrameContent frame) {
  claim(frame.name, "frame");
  content_.frames.push_back(std::move(frame));
  return {static_cast<int>(content_.frames.size()) - 1};
}

FrameHandle Scene::weld(const std::string& name, const FrameReference& parent, const Placement& placement) {
  return add_frame({name, parent, placement, JointKind::weld, {}, 0});
}
FrameHandle Scene::revolute(const std::string& name, const FrameReference& parent, const Triple& axis,
                            const Expression& angle, const Placement& placement) {
  if (!angle.is_zero() && !(angle.unit() == Unit())) {
    throw UnitError(fmt::format("the angle {} of the revolute joint '{}' has the unit {} and must be in rad",
                                angle.to_string(), name, angle.unit().to_string()));
  }
  return add_frame({name, parent, placement, JointKind::revolute, axis, angle});
}
FrameHandle Scene::prismatic(const std::string& name, const FrameReference& parent, const Triple& axis,
                             const Expression& displacement, const Placement& placement) {
  if (!displacement.is_zero() && !(displacement.unit() == Unit::parse("m"))) {
    throw UnitError(fmt::format("the displacement {} of the prismatic joint '{}' has the unit {} and must be in m",
                                displacement.to_string(), name, displacement.unit().to_string()));
  }
  return add_frame({name, parent, placement, JointKind::prismatic, axis, displacement});
}

FrameHandle Scene::free(const std::string& name, const FrameReference& parent, AngleSequence sequence,
                        const Triple& position, const Triple& angles) {
  const FrameHandle x = prismatic(name + ".x", parent, axis::x, position[0]);
  const FrameHandle y = prismatic(name + ".y", x, axis::y, position[1]);
  const FrameHandle z = prismatic(name + ".z", y, axis::z, position[2]);
  const bool euler = sequence == AngleSequence::euler;
  const FrameHandle first = revolute(name + ".1", z, euler ? axis::z : axis::x, angles[0]);
  const FrameHandle second_frame = revolute(name + ".2", first, euler ? axis::x : axis::y, angles[1]);
  return revolute(name, second_frame, axis::z, angles[2]);
}

PointHandle Scene::point(const std::string& name, const FrameReference& frame, const Triple& components) {
  require_identifier(name, "point");
  claim(name, "point");
  content_.points.push_back({name, frame, components});
  return {static_cast<int>(content_.points.size()) - 1};
}

void Scene::body(const std::string& name, const FrameReference& frame, const Inertia& inertia) {
  require_identifier(name, "body");
  claim(name, "body");
  content_.bodies.push_back({name, frame, inertia});
}

ConstraintHandle Scene::add_constraint(ConstraintContent constraint) {
  require_identifier(constraint.name, "constraint");
  claim(constraint.name, "constraint");
  claim(constraint.multiplier->name, "multiplier");
  content_.constraints.push_back(std::move(constraint));
  return {static_cast<int>(content_.constraints.size()) - 1};
}

ConstraintHandle Scene::holonomic(const std::string& name, const Expression& f) {
  // λ works with ∂f/∂q_i: its unit is that of an energy over that of f.
  const auto multiplier = add_symbol("lambda_" + name, Unit::parse("J") / f.unit(), SymbolKind::multiplier);
  return add_constraint({name, HolonomicFormula{f}, multiplier, std::nullopt});
}
ConstraintHandle Scene::nonholonomic(const std::string& name, const Expression& left_side) {
  const auto multiplier = add_symbol("lambda_" + name, Unit::parse("W") / left_side.unit(), SymbolKind::multiplier);
  return add_constraint({name, NonholonomicFormula{left_side}, multiplier, std::nullopt});
}
ConstraintHandle Scene::no_slip(const std::string& name, const FrameReference& body, const PointReference& contact,
                                const Triple& direction, const FrameReference& axes) {
  const auto multiplier = add_symbol("lambda_" + name, Unit::parse("N"), SymbolKind::multiplier);
  return add_constraint({name, NoSlip{body, contact, direction, axes}, multiplier, std::nullopt});
}
ConstraintHandle Scene::closure(const std::string& name, const PointReference& a, const PointReference& b,
                                const Triple& direction) {
  const auto multiplier = add_symbol("lambda_" + name, Unit::parse("N"), SymbolKind::multiplier);
  return add_constraint({name, Closure{a, b, direction}, multiplier, std::nullopt});
}

void Scene::reaction(const ConstraintHandle& handle, const std::string& name, const FrameReference& body,
                     const PointReference& contact, const Triple& direction, const FrameReference& axes,
                     const FrameReference& other) {
  require_identifier(name, "reaction");
  claim(name, "reaction");
  ConstraintContent& constraint = content_.constraints.at(static_cast<std::size_t>(handle.index));
  if (constraint.reaction) {
    throw SceneError(fmt::format("constraint '{}' already has the reaction '{}': one multiplier enforces one constraint",
                                 constraint.name, constraint.reaction->name));
  }
  constraint.reaction = ReactionContent{name, body, contact, direction, axes, other};
  constraint.multiplier = add_symbol(name, Unit::parse("N"), SymbolKind::multiplier);
}

}  // namespace torsor
