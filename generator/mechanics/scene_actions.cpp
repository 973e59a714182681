// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/identifier.hpp"
#include "torsor/generator/mechanics/require_unit.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {
namespace {

/// "the direction of the friction 'rub'".
std::string of(const char* quantity, const char* kind, const std::string& name) {
  return fmt::format("the {} of the {} '{}'", quantity, kind, name);
}

}  // namespace

void Scene::gravity(const Triple& acceleration) {
  require_unit(acceleration, units::metre / units::second.pow(2), "a component of the gravity");
  if (content_.gravity_given) {
    throw SceneError(fmt::format("the scene '{}' has a gravity already: give one sum of both, or a force for what else acts",
                                 content_.name));
  }
  content_.gravity_given = true;
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
void Scene::spring(const std::string& name, const SpringBetween& spring) {
  claim(name, "action");
  content_.actions.emplace_back(PointSpring{spring, name});
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
void Scene::force(const std::string& name, const PointForce& force) {
  claim(name, "action");
  content_.actions.emplace_back(GivenForce{force, name});
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
void Scene::generalised_force(const std::string& name, const Expression& displacement, const Expression& force) {
  require_unit(force, units::joule / displacement.unit(),
               fmt::format("the generalised force '{}' on {} [{}]", name, displacement.to_string(),
                           displacement.unit().to_string()));
  claim(name, "action");
  content_.actions.emplace_back(GeneralisedForce{name, displacement, force});
}
void Scene::gravitation(const std::string& name, const PointReference& a, const PointReference& b,
                        const Expression& strength) {
  require_unit(strength, units::joule * units::metre, fmt::format("the strength of the gravitation '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(Gravitation{name, a, b, strength});
}
void Scene::wrench(const std::string& name, const PointWrench& wrench) {
  require_unit(wrench.force, units::newton, fmt::format("a force component of the wrench '{}'", name));
  require_unit(wrench.moment, units::newton_metre, fmt::format("a moment component of the wrench '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(GivenWrench{wrench, name});
}
void Scene::drag(const std::string& name, const PointDrag& drag) {
  require_unit(drag.coefficient, units::newton / units::metre_per_second,
               fmt::format("the coefficient of the drag '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(Drag{drag, name});
}
void Scene::rotational_drag(const std::string& name, const FrameReference& body, const Expression& coefficient,
                            const FrameReference& relative_to) {
  require_unit(coefficient, units::newton_metre / units::radian_per_second,
               fmt::format("the coefficient of the rotational drag '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(RotationalDrag{name, body, coefficient, relative_to});
}
void Scene::force_between(const std::string& name, const ForceBetween& force) {
  require_unit(force.components, units::newton, fmt::format("a component of the force '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(MutualAction{name, force.a, force.b, force.point, force.components, force.axes});
}
void Scene::torque_between(const std::string& name, const TorqueBetween& torque) {
  require_unit(torque.components, units::newton_metre, fmt::format("a component of the torque '{}'", name));
  claim(name, "action");
  content_.actions.emplace_back(MutualAction{name, torque.a, torque.b, std::nullopt, torque.components, torque.axes});
}

void Scene::add_friction(ContactFriction friction) {
  if (friction.constraint < 0 || friction.constraint >= static_cast<int>(content_.constraints.size())) {
    throw SceneError(fmt::format("friction '{}' is tied to constraint number {}, which belongs to another scene",
                                 friction.name, friction.constraint));
  }
  claim(friction.name, "action");
  content_.frictions.push_back(std::move(friction));
}
void Scene::sliding_friction(const std::string& name, const ConstraintHandle& normal, const SlidingFriction& friction) {
  require_unit(friction.coefficient, Unit(), fmt::format("the coefficient of the friction '{}'", name));
  require_one_unit(friction.direction, of("direction", "friction", name));
  add_friction({name,
                normal.index,
                friction.coefficient,
                friction.body,
                friction.point,
                friction.direction,
                friction.axes,
                friction.other,
                {}});
}
void Scene::friction_law(const std::string& name, const ConstraintHandle& normal, const FrictionLaw& friction) {
  if (friction.smoothing.is_zero()) {
    throw SceneError(fmt::format("the law of friction '{}' has the smoothing speed 0, with which its force is no number at "
                                 "rest: give one that is small beside the speeds that matter, e.g. 1e-6 m/s",
                                 name));
  }
  require_unit(friction.smoothing, units::metre_per_second,
               fmt::format("the smoothing speed of the friction '{}'", name));
  const Triple slip = velocity(friction.point, friction.body, friction.plane, friction.other);
  const Expression speed = sqrt(pow(slip[0], 2) + pow(slip[1], 2) + pow(friction.smoothing, 2));
  const Expression coefficient = friction.law(speed);
  require_unit(coefficient, Unit(), fmt::format("the value of the law of friction '{}'", name));
  add_friction({name,
                normal.index,
                coefficient,
                friction.body,
                friction.point,
                {slip[0], slip[1], 0},
                friction.plane,
                friction.other,
                speed});
}
void Scene::rolling_resistance(const std::string& name, const ConstraintHandle& normal,
                               const RotationResistance& resistance) {
  add_resistance(name, "rolling resistance", normal, resistance);
}
void Scene::spinning_resistance(const std::string& name, const ConstraintHandle& normal,
                                const RotationResistance& resistance) {
  add_resistance(name, "spinning resistance", normal, resistance);
}
void Scene::add_resistance(const std::string& name, const char* kind, const ConstraintHandle& normal,
                           const RotationResistance& resistance) {
  require_unit(resistance.length, units::metre, of("length", kind, name));
  require_one_unit(resistance.direction, of("direction", kind, name));
  add_friction({name,
                normal.index,
                resistance.length,
                resistance.body,
                std::nullopt,
                resistance.direction,
                resistance.axes,
                resistance.other,
                {}});
}

}  // namespace torsor
