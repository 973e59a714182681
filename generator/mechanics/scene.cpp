// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/scene.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/article.hpp"
#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/mechanics/identifier.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

/// How a law depends on a coordinate, itself or by way of the laws of others, in words; empty when it does not.
std::string followed(const SceneContent& scene, const Expression& law, const CoordinateContent& coordinate) {
  if (law.depends_on(coordinate.q)) return fmt::format("'{}' itself", coordinate.q->name);
  for (const CoordinateContent& other : scene.coordinates) {
    if (!other.law || !law.depends_on(other.q)) continue;
    const std::string further = followed(scene, *other.law, coordinate);
    if (!further.empty()) return fmt::format("'{}', whose law depends on {}", other.q->name, further);
  }
  return {};
}

/// Plain numbers are understood in the SI unit that is asked for.
void require_initial_unit(const Expression& given, const Unit& unit, const std::string& what, const std::string& name) {
  if (given.unit() == unit || given.unit() == Unit()) return;
  throw UnitError(fmt::format("initial {} of '{}' is given in {} and must be in {}", what, name,
                              written_unit(given.unit()), unit.is_dimensionless() ? "plain numbers" : written_unit(unit)));
}

}  // namespace

Scene::Scene(std::string name, std::string title) {
  require_identifier(name, "scene");
  content_.name = std::move(name);
  content_.title = printable(title);
  content_.time = add_symbol("t", units::second, SymbolKind::time);
  claim("t", "time");
  add_frame({"ground", std::nullopt, {}, JointKind::weld, {}, 0});
}

void Scene::claim(const std::string& name, const std::string& what) {
  if (printable(name) != name) {
    throw SceneError(fmt::format("the name '{}' of {} holds bytes that are no UTF-8, or characters that are not seen or "
                                 "turn the direction of text: choose one that shows what it is",
                                 name, with_article(what)));
  }
  // Frames and bodies are often namesakes; all that becomes a symbol shares one space.
  const bool own_space = what == "frame" || what == "body" || what == "point" || what == "constraint" ||
                         what == "action" || what == "joint";
  const std::string key = (own_space ? what : "symbol") + " " + name;
  const auto [place, added] = content_.names.emplace(key, what);
  if (!added) {
    throw SceneError(fmt::format("duplicate name '{}': the scene '{}' already has {} of that name; choose another "
                                 "name for the new {}",
                                 name, content_.name, with_article(place->second), what));
  }
}

SymbolPointer Scene::add_symbol(const std::string& name, const Unit& unit, SymbolKind kind, SymbolPointer rate) {
  return std::make_shared<const Symbol>(Symbol{name, unit, kind, content_.symbol_count++, std::move(rate)});
}

SymbolPointer Scene::add_symbol(const std::string& name, std::string_view unit, SymbolKind kind, SymbolPointer rate) {
  Symbol symbol{name, Unit::parse(unit), kind, content_.symbol_count++, std::move(rate)};
  symbol.unit_text = spaced_unit(unit);
  return std::make_shared<const Symbol>(std::move(symbol));
}

Expression Scene::parameter(const std::string& name, std::string_view unit) {
  require_identifier(name, "parameter");
  claim(name, "parameter");
  content_.parameters.push_back({add_symbol(name, unit, SymbolKind::parameter), std::nullopt, true});
  return content_.parameters.back().symbol;
}

Expression Scene::parameter(const std::string& name, std::string_view unit, const Expression& value) {
  const Expression symbol = parameter(name, unit);
  set_parameter(symbol, value);
  content_.parameters.back().run_time = false;
  return symbol;
}

namespace {

/// Whether a formula depends on a parameter, through the values of others too.
bool depends_on(const Expression& value, const SymbolPointer& parameter, const std::vector<ParameterContent>& parameters) {
  const std::vector<SymbolPointer> symbols = value.symbols();
  return std::any_of(symbols.begin(), symbols.end(), [&](const SymbolPointer& symbol) {
    if (symbol == parameter) return true;
    const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.symbol == symbol; });
    return found != parameters.end() && found->value && depends_on(*found->value, parameter, parameters);
  });
}

}  // namespace

void Scene::set_parameter(const Expression& parameter, const Expression& value) {
  const auto found = std::find_if(content_.parameters.begin(), content_.parameters.end(),
                                  [&](const ParameterContent& p) { return p.symbol == parameter.as_symbol(); });
  if (found == content_.parameters.end()) {
    throw SceneError(fmt::format("set_parameter gives a value to a parameter of the scene, and got {}", parameter.to_string()));
  }
  const std::string& name = found->symbol->name;
  refuse_measured(value, fmt::format("parameter '{}'", name));
  if (!value.unit().is_dimensionless() && !(value.unit() == parameter.unit())) {
    throw UnitError(fmt::format("parameter '{}' [{}] is given the value {} [{}]: the units differ; give a plain number or "
                                "one in {}",
                                name, parameter.unit().to_string(), value.to_string(), value.unit().to_string(),
                                parameter.unit().to_string()));
  }
  if (depends_on(value, found->symbol, content_.parameters)) {
    throw SceneError(fmt::format("the value {} of the parameter '{}' depends on '{}' itself: give a number or a formula of "
                                 "other parameters",
                                 value.to_string(), name, name));
  }
  found->value = value;
}

Expression Scene::run_time_parameter(const std::string& name, std::string_view unit, const Expression& value) {
  const Expression symbol = parameter(name, unit, value);
  content_.parameters.back().run_time = true;
  return symbol;
}

Expression Scene::coordinate(const std::string& name, std::string_view unit) {
  require_identifier(name, "coordinate");
  claim(name, "coordinate");
  const Unit u = Unit::parse(unit), second = units::second;
  CoordinateContent coordinate;
  if (u.is_dimensionless() && unit.find("rad") == std::string_view::npos) {  // a ratio: its rate is no rad/s
    coordinate.a = add_symbol(name + "''", "1/s^2", SymbolKind::acceleration);
    coordinate.v = add_symbol(name + "'", "1/s", SymbolKind::velocity, coordinate.a);
  } else {
    coordinate.a = add_symbol(name + "''", u / second.pow(2), SymbolKind::acceleration);
    coordinate.v = add_symbol(name + "'", u / second, SymbolKind::velocity, coordinate.a);
  }
  coordinate.q = add_symbol(name, unit, SymbolKind::coordinate, coordinate.v);
  content_.coordinates.push_back(coordinate);
  return content_.coordinates.back().q;
}

Expression Scene::released_coordinate(const std::string& name, std::string_view unit) {
  const Expression q = coordinate(name, unit);
  content_.coordinates.back().released = true;
  return q;
}

std::string Scene::command_line(const std::string& command) const {
  const std::string& arguments = content_.origin.arguments;
  return arguments.empty() ? content_.name + "_scene " + command : "torsor " + command + " " + arguments;
}

Expression Scene::time() const { return content_.time; }

CoordinateContent& Scene::coordinate_of(const Expression& formula, const std::string& purpose) {
  const SymbolPointer symbol = formula.as_symbol();
  for (CoordinateContent& coordinate : content_.coordinates) {
    if (symbol && coordinate.q == symbol && !coordinate.attitude) return coordinate;
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
  const auto& independent = content_.independent;
  if (std::find(independent.begin(), independent.end(), coordinate.q) != independent.end()) {
    throw SceneError(fmt::format("coordinate '{}' is named in independent(...) and cannot follow a law of time: name an "
                                 "unknown one there",
                                 coordinate.q->name));
  }
  if (const std::string through = followed(content_, law, coordinate); !through.empty()) {
    throw SceneError(fmt::format("coordinate '{0}' cannot follow the law {1}: that depends on {2}; write the law without "
                                 "'{0}', as a formula of time and of coordinates that do not follow it",
                                 coordinate.q->name, law.to_string(), through));
  }
  coordinate.law = law;
}

void Scene::initial(const Expression& formula, const Expression& value, const Expression& rate) {
  CoordinateContent& coordinate = coordinate_of(formula, "initial");
  if (coordinate.released) {
    throw SceneError(fmt::format("coordinate '{0}' is released, held at zero by its joint, and has no initial value: drop "
                                 "initial('{0}'), or declare it by coordinate(...)",
                                 coordinate.q->name));
  }
  refuse_measured(value, fmt::format("the initial value of '{}'", coordinate.q->name));
  refuse_measured(rate, fmt::format("the initial rate of '{}'", coordinate.q->name));
  require_initial_unit(value, coordinate.q->unit, "value", coordinate.q->name);
  require_initial_unit(rate, coordinate.v->unit, "rate", coordinate.q->name);
  coordinate.initial_value = value;
  coordinate.initial_rate = rate;
}

void Scene::limits(const Expression& formula, const CoordinateLimits& given) {
  CoordinateContent& coordinate = coordinate_of(formula, "limits");
  CoordinateLimits limits = coordinate.limits.value_or(CoordinateLimits{});
  if (given.lower) limits.lower = given.lower;
  if (given.upper) limits.upper = given.upper;
  if (given.velocity) limits.velocity = given.velocity;
  if (given.effort) limits.effort = given.effort;
  if (limits.lower && limits.upper && *limits.upper < *limits.lower) {
    throw SceneError(fmt::format("the coordinate '{}' has a lower limit {} above its upper one, {}: exchange them",
                                 coordinate.q->name, limits.lower->to_string(), limits.upper->to_string()));
  }
  coordinate.limits = limits;
}

AttitudeHandle Scene::attitude(const std::string& name) {
  require_identifier(name, "attitude");
  const int index = static_cast<int>(content_.attitudes.size());
  const Unit per_second = Unit() / units::second;
  const auto symbols = std::make_shared<AttitudeSymbols>();
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string component = name + "_" + "wxyz"[k];
    claim(component, "coordinate");
    symbols->e[k] = std::make_shared<const Symbol>(
        Symbol{component, Unit(), SymbolKind::coordinate, content_.symbol_count++, nullptr, symbols});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string component = name + "_omega_" + "xyz"[k];
    claim(component, "velocity");
    CoordinateContent freedom;
    freedom.a = add_symbol(component + "'", per_second / units::second, SymbolKind::acceleration);
    freedom.v = add_symbol(component, per_second, SymbolKind::velocity, freedom.a);
    // Nothing is a function of this coordinate, which does not exist: it lends its name to the freedom.
    freedom.q = add_symbol(component, Unit(), SymbolKind::coordinate, freedom.v);
    freedom.attitude = index;
    symbols->omega[k] = freedom.v;
    content_.coordinates.push_back(freedom);
  }
  content_.attitudes.push_back({name, symbols, {}, std::nullopt});
  return {index};
}

void Scene::initial(AttitudeHandle handle, const std::array<Expression, 4>& quaternion, const Triple& rates) {
  AttitudeContent& attitude = content_.attitudes.at(static_cast<std::size_t>(handle.index));
  for (const Expression& e : quaternion) refuse_measured(e, fmt::format("the initial attitude '{}'", attitude.name));
  for (const Expression& rate : rates) refuse_measured(rate, fmt::format("the initial rate of '{}'", attitude.name));
  for (const Expression& e : quaternion) require_initial_unit(e, Unit(), "quaternion", attitude.name);
  for (const Expression& rate : rates) {
    require_initial_unit(rate, units::radian_per_second, "angular velocity", attitude.name);
  }
  attitude.initial = quaternion;
  int k = 0;
  for (CoordinateContent& freedom : content_.coordinates) {
    if (freedom.attitude == handle.index) freedom.initial_rate = rates[static_cast<std::size_t>(k++)];
  }
}

PointHandle Scene::add_point(PointContent point) {
  require_identifier(point.name, "point");
  claim(point.name, "point");
  content_.points.push_back(std::move(point));
  return {static_cast<int>(content_.points.size()) - 1};
}
PointHandle Scene::point(const std::string& name, const FrameReference& frame, const Triple& components) {
  require_unit(components, units::metre, fmt::format("a component of the point '{}'", name));
  return add_point({name, frame, components});
}
PointHandle Scene::disc_contact(const std::string& name, const DiscContact& disc) {
  require_unit(disc.axis, Unit(), fmt::format("a component of the axis of the disc at '{}'", name));
  require_unit(disc.radius, units::metre, fmt::format("the radius of the disc at '{}'", name));
  const Triple axis =
      unit_vector(disc.axis, fmt::format("the axis of the disc at '{}' is the null vector: give a direction", name));
  return add_point({name, disc.frame, {}, LowestPoint{axis, disc.radius, disc.plane}});
}
PointHandle Scene::torus_contact(const std::string& name, const TorusContact& torus) {
  require_unit(torus.axis, Unit(), fmt::format("a component of the axis of the torus at '{}'", name));
  require_unit(torus.circle_radius, units::metre, fmt::format("the circle's radius of '{}'", name));
  require_unit(torus.tube_radius, units::metre, fmt::format("the tube's radius of '{}'", name));
  const Triple axis =
      unit_vector(torus.axis, fmt::format("the axis of the torus at '{}' is the null vector: give a direction", name));
  return add_point({name, torus.frame, {}, LowestPoint{axis, torus.circle_radius, torus.plane, torus.tube_radius}});
}
PointHandle Scene::ellipsoid_contact(const std::string& name, const FrameReference& frame, const Triple& semi_axes,
                                     const FrameReference& plane) {
  for (const Expression& each : semi_axes) {
    if (each.is_zero()) {
      throw SceneError(fmt::format("the ellipsoid of '{}' has a semi-axis 0: give its three lengths, or a disc_contact", name));
    }
    require_unit(each, units::metre, fmt::format("a semi-axis of '{}'", name));
  }
  const auto h = [&](const Triple& u) {
    return sqrt(pow(semi_axes[0] * u[0], 2) + pow(semi_axes[1] * u[1], 2) + pow(semi_axes[2] * u[2], 2));
  };
  const PointHandle point = support_contact(name, frame, h, plane);
  for (const Expression& each : semi_axes) {
    content_.points[as_index(point.index)].sizes.push_back({"semi-axis of an ellipsoid", each, StatedSize::Least::above_zero});
  }
  return point;
}
PointHandle Scene::support_contact(const std::string& name, const FrameReference& frame,
                                   const std::function<Expression(const Triple& u)>& h, const FrameReference& plane) {
  SupportFunction support;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string component = fmt::format("{}.u_{}", name, "xyz"[i]);
    support.direction[i] = add_symbol(component, Unit(), SymbolKind::parameter);
  }
  support.h = h({Expression(support.direction[0]), Expression(support.direction[1]), Expression(support.direction[2])});
  require_unit(support.h, units::metre, fmt::format("the support function of '{}'", name));
  return add_point({name, frame, {}, LowestPoint{std::nullopt, {}, plane, {}, std::move(support)}});
}
PointHandle Scene::sphere_contact(const std::string& name, const FrameReference& frame, const Expression& radius,
                                  const FrameReference& plane) {
  require_unit(radius, units::metre, fmt::format("the radius of the sphere at '{}'", name));
  return add_point({name, frame, {}, LowestPoint{std::nullopt, radius, plane}});
}

void Scene::body(const std::string& name, const FrameReference& frame, const Inertia& inertia, Moments moments) {
  require_identifier(name, "body");
  claim(name, "body");
  content_.bodies.push_back({name, frame, inertia, moments});
}

}  // namespace torsor
