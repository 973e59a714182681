// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/mechanics/identifier.hpp"
#include "generator/mechanics/require_unit.hpp"
#include "generator/mechanics/scene.hpp"

namespace torsor {
namespace {

/// "the direction of the friction 'rub'".
std::string of(const char* quantity, const char* kind, const std::string& name) {
  return fmt::format("the {} of the {} '{}'", quantity, kind, name);
}

}  // namespace

void Scene::gravity(const Triple& acceleration) {
  require_unit(acceleration, units::metre / units::second.pow(2), "a component of the gravity");
  content_.gravity = acceleration;
}

void Scene::spring(const std::string& name, const Expression& elongation, const Expression& stiffness,
                   const Expression& rest) {
  claim(name, "action");
  content_.actions.emplace_back(ElongationSpring{name, elongation, stiffness, rest});
}
void Scene::damper(const std::string& name, const Expression& elongation, const Expression& damping) {
  claim(name, "action");
  content_.actions.emplace_back(ElongationDamper{name, elongation, damping});
}
void Scene::spring(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& stiffness, const Expression& rest) {
  claim(name, "action");
  content_.actions.emplace_back(PointSpring{name, a, b, stiffness, rest});
}
void Scene::damper(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& damping) {
  claim(name, "action");
  content_.actions.emplace_back(PointDamper{name, a, b, damping});
}
Expression Scene::motor(const std::string& name, const Expression& displacement) {
  require_identifier(name, "motor");
  claim(name, "input");
  claim(name, "action");
  const SymbolPointer input = add_symbol(name, Unit::parse("J") / displacement.unit(), SymbolKind::input);
  content_.actions.emplace_back(Motor{name, input, displacement});
  return input;
}
void Scene::force(const std::string& name, const FrameReference& body, const PointReference& point,
                  const Triple& components, const FrameReference& axes) {
  claim(name, "action");
  content_.actions.emplace_back(GivenForce{name, body, point, components, axes});
}
void Scene::torque(const std::string& name, const FrameReference& body, const Triple& components,
                   const FrameReference& axes) {
  claim(name, "action");
  content_.actions.emplace_back(GivenTorque{name, body, components, axes});
}
void Scene::force_function(const std::string& name, const Expression& u) {
  require_unit(u, units::joule, fmt::format("force function '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(GivenForceFunction{name, u});
}
void Scene::effort(const std::string& name, const Expression& displacement, const Expression& force) {
  require_unit(force, units::joule / displacement.unit(),
               fmt::format("the intensity of the effort '{}' on {} [{}]", name, displacement.to_string(),
                           displacement.unit().to_string()));
  claim(name, "action");
  content_.actions.emplace_back(Effort{name, displacement, force});
}
void Scene::gravitation(const std::string& name, const PointReference& a, const PointReference& b,
                        const Expression& strength) {
  require_unit(strength, units::joule * units::metre, fmt::format("the strength of the gravitation '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(Gravitation{name, a, b, strength});
}
void Scene::wrench(const std::string& name, const FrameReference& body, const PointReference& point,
                   const Triple& force, const Triple& moment, const FrameReference& axes) {
  require_unit(force, units::newton, fmt::format("a force component of the wrench '{}'", name));
  require_unit(moment, units::newton_metre, fmt::format("a moment component of the wrench '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(GivenWrench{name, body, point, force, moment, axes});
}
void Scene::drag(const std::string& name, const FrameReference& body, const PointReference& point,
                 const Expression& coefficient, const FrameReference& relative_to) {
  require_unit(coefficient, units::newton / units::metre_per_second,
               fmt::format("the coefficient of the drag '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(Drag{name, body, point, coefficient, relative_to});
}
void Scene::rotational_drag(const std::string& name, const FrameReference& body, const Expression& coefficient,
                            const FrameReference& relative_to) {
  require_unit(coefficient, units::newton_metre / units::radian_per_second,
               fmt::format("the coefficient of the rotational drag '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(RotationalDrag{name, body, coefficient, relative_to});
}
void Scene::force_between(const std::string& name, const FrameReference& a, const FrameReference& b,
                          const PointReference& point, const Triple& components, const FrameReference& axes) {
  require_unit(components, units::newton, fmt::format("a component of the force '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(MutualAction{name, a, b, point, components, axes});
}
void Scene::torque_between(const std::string& name, const FrameReference& a, const FrameReference& b,
                           const Triple& components, const FrameReference& axes) {
  require_unit(components, units::newton_metre, fmt::format("a component of the torque '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(MutualAction{name, a, b, std::nullopt, components, axes});
}

void Scene::add_friction(ContactFriction friction) {
  if (friction.constraint < 0 || friction.constraint >= static_cast<int>(content_.constraints.size())) {
    throw SceneError(fmt::format("friction '{}' is tied to constraint number {}, which belongs to another scene",
                                 friction.name, friction.constraint));
  }
  claim(friction.name, "action");
  content_.frictions.push_back(std::move(friction));
}
void Scene::sliding_friction(const std::string& name, const ConstraintHandle& normal, const Expression& f,
                             const FrameReference& body, const PointReference& point, const Triple& direction,
                             const FrameReference& axes, const FrameReference& other) {
  require_unit(f, Unit(), fmt::format("the coefficient of the friction '{}'", name));
  require_one_unit(direction, of("direction", "friction", name));
  add_friction({name, normal.index, f, body, point, direction, axes, other, {}});
}
void Scene::friction_law(const std::string& name, const ConstraintHandle& normal,
                         const std::function<Expression(const Expression& speed)>& law, const FrameReference& body,
                         const PointReference& point, const FrameReference& plane, const FrameReference& other,
                         const Expression& smoothing) {
  if (smoothing.is_zero()) {
    throw SceneError(fmt::format("the law of friction '{}' has the smoothing speed 0, with which its force is no number at "
                                 "rest: give one that is small beside the speeds that matter, e.g. 1e-6 m/s",
                                 name));
  }
  require_unit(smoothing, units::metre_per_second, fmt::format("the smoothing speed of the friction '{}'", name));
  const Triple slip = velocity(point, body, plane, other);
  const Expression speed = sqrt(pow(slip[0], 2) + pow(slip[1], 2) + pow(smoothing, 2));
  const Expression coefficient = law(speed);
  require_unit(coefficient, Unit(), fmt::format("the value of the law of friction '{}'", name));
  add_friction({name, normal.index, coefficient, body, point, {slip[0], slip[1], 0}, plane, other, speed});
}
void Scene::rolling_resistance(const std::string& name, const ConstraintHandle& normal, const Expression& h,
                               const FrameReference& body, const Triple& direction, const FrameReference& axes,
                               const FrameReference& other) {
  require_unit(h, units::metre, fmt::format("the length of the rolling resistance '{}'", name));
  require_one_unit(direction, of("direction", "rolling resistance", name));
  add_friction({name, normal.index, h, body, std::nullopt, direction, axes, other, {}});
}
void Scene::spinning_resistance(const std::string& name, const ConstraintHandle& normal, const Expression& k,
                                const FrameReference& body, const Triple& direction, const FrameReference& axes,
                                const FrameReference& other) {
  require_unit(k, units::metre, fmt::format("the length of the spinning resistance '{}'", name));
  require_one_unit(direction, of("direction", "spinning resistance", name));
  add_friction({name, normal.index, k, body, std::nullopt, direction, axes, other, {}});
}

}  // namespace torsor
