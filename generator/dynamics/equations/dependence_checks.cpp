// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/dependence_checks.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// What a formula may depend on; each allows what those before it do.
enum class Allowed { parameters, time, configuration, velocities };

const char* allowed_text(Allowed allowed) {
  switch (allowed) {
    case Allowed::parameters:
      return "parameters";
    case Allowed::time:
      return "time and parameters";
    case Allowed::configuration:
      return "coordinates, time and parameters";
    case Allowed::velocities:
      return "coordinates, their rates, time and parameters";
  }
  return "";
}

bool is_allowed(SymbolKind kind, Allowed allowed) {
  switch (kind) {
    case SymbolKind::pi:
    case SymbolKind::parameter:
      return true;
    case SymbolKind::time:
      return allowed >= Allowed::time;
    case SymbolKind::coordinate:
      return allowed >= Allowed::configuration;
    case SymbolKind::velocity:
      return allowed >= Allowed::velocities;
    case SymbolKind::acceleration:
    case SymbolKind::input:
    case SymbolKind::multiplier:
      return false;
  }
  return false;
}

const char* kind_text(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::time:
      return "the time";
    case SymbolKind::coordinate:
      return "the coordinate";
    case SymbolKind::velocity:
      return "the velocity";
    case SymbolKind::acceleration:
      return "the acceleration";
    case SymbolKind::input:
      return "the input";
    case SymbolKind::multiplier:
      return "the multiplier";
    default:
      return "the symbol";
  }
}

/// Some function of what a measured quantity is made of, and of nothing else: a number of its own keeps it from cancelling
/// with anything. No frame has a place yet.
Value stand_in(Program& program, const Symbol& measured) {
  Value sum = program.number(Number(1));
  for (const SymbolPointer& part : measured.made_of) {
    sum += Value(program, program.symbol(part).polynomial(), Unit());
  }
  const Value own = program.symbol(
      std::make_shared<const Symbol>(Symbol{measured.name, Unit(), SymbolKind::parameter, measured.index, nullptr}));
  return {program, (own * program.bind(sum)).polynomial(), measured.unit};
}

class DependenceCheck {
 public:
  explicit DependenceCheck(const Scene& scene) : program_(Model::resolver(scene, {})), scene_(scene.content()) {
    program_.set_measurer({[this](const Symbol& symbol) { return stand_in(program_, symbol); }, {}});
  }

  void run() {
    const Triple& g = scene_.gravity;
    for (const Expression& component : g) require("gravity", component, Allowed::time);
    for (const CoordinateContent& c : scene_.coordinates) {
      if (c.law) require("the law of coordinate '" + c.q->name + "'", *c.law, Allowed::configuration);
      const std::string of = " of '" + (c.attitude ? c.v : c.q)->name + "'";
      if (c.initial_value) require("the initial value" + of, *c.initial_value, Allowed::parameters);
      if (c.initial_rate) require("the initial rate" + of, *c.initial_rate, Allowed::parameters);
    }
    for (const AttitudeContent& attitude : scene_.attitudes) {
      if (!attitude.initial) continue;
      const std::string what = "the initial attitude '" + attitude.name + "'";
      for (const Expression& e : *attitude.initial) require(what, e, Allowed::parameters);
    }
    for (const FrameContent& frame : scene_.frames) {
      const std::string joint = scene_.name_of(frame);
      all("the placement of " + joint, frame.placement.origin, Allowed::parameters);
      if (frame.joint == JointKind::weld || frame.joint == JointKind::attitude) continue;
      all("the axis of " + joint, frame.axis, Allowed::parameters);
      require("the displacement of " + joint, frame.displacement, Allowed::configuration);
    }
    for (const PointContent& point : scene_.points) {
      const std::string name = name_of(point);
      all("the place of " + name, point.components, Allowed::configuration);
      if (!point.lowest) continue;
      require("the radius of " + name, point.lowest->radius, Allowed::parameters);
      require("the tube's radius of " + name, point.lowest->tube, Allowed::parameters);
      if (point.lowest->support) require("the support function of " + name, point.lowest->support->h, Allowed::parameters);
      if (point.lowest->axis) all("the axis of " + name, *point.lowest->axis, Allowed::parameters);
    }
    for (const ActionContent& action : scene_.actions) std::visit(*this, action);
    for (const ConstraintContent& constraint : scene_.constraints) {
      user_ = "constraint '" + constraint.name + "'";
      std::visit(*this, constraint.law);
    }
    for (const ContactFriction& friction : scene_.frictions) {
      const std::string name = "friction '" + friction.name + "'";
      require("the coefficient of " + name, friction.coefficient, Allowed::velocities);
      all("the direction of " + name, friction.direction, Allowed::velocities);
      require("the length of the direction of " + name, friction.length, Allowed::velocities);
    }
    for (const ContactContent& contact : scene_.contacts) {
      user_ = "contact '" + contact.name + "'";
      std::visit(*this, contact.geometry);
      require("the friction of " + user_, contact.friction, Allowed::parameters);
      require("the static friction of " + user_, contact.static_friction, Allowed::parameters);
      require("the restitution of " + user_, contact.restitution, Allowed::parameters);
    }
  }

  // --- actions: what is differentiated of them ---
  void operator()(const ElongationSpring& spring) {
    require("the elongation of spring '" + spring.name + "'", spring.elongation, Allowed::configuration);
    require("the rest of spring '" + spring.name + "'", spring.rest, Allowed::configuration);
    require("the stiffness of spring '" + spring.name + "'", spring.stiffness, Allowed::configuration);
  }
  void operator()(const ElongationDamper& damper) {
    require("the elongation of damper '" + damper.name + "'", damper.elongation, Allowed::configuration);
    require("the damping of damper '" + damper.name + "'", damper.damping, Allowed::velocities);
  }
  void operator()(const PointSpring& spring) {
    require("the rest of spring '" + spring.name + "'", spring.rest, Allowed::configuration);
    require("the stiffness of spring '" + spring.name + "'", spring.stiffness, Allowed::configuration);
  }
  void operator()(const PointDamper& damper) {
    require("the damping of damper '" + damper.name + "'", damper.damping, Allowed::velocities);
  }
  void operator()(const Motor& motor) {
    require("the displacement of motor '" + motor.name + "'", motor.displacement, Allowed::configuration);
  }
  void operator()(const GeneralisedForce& given) {
    require("the displacement of generalised force '" + given.name + "'", given.displacement, Allowed::configuration);
  }
  void operator()(const Gravitation& attraction) {
    require("the strength of gravitation '" + attraction.name + "'", attraction.strength, Allowed::configuration);
  }

  // --- constraints ---
  void operator()(const HolonomicFormula& law) { require("the holonomic " + user_, law.f, Allowed::configuration); }
  void operator()(const NonholonomicFormula& law) { require("the " + user_, law.left_side, Allowed::velocities); }
  void operator()(const NoSlip& law) { all("the direction of " + user_, law.direction, Allowed::configuration); }
  void operator()(const Closure& law) { all("the direction of " + user_, law.direction, Allowed::configuration); }
  void operator()(const JointClosure& law) { require("the pitch of " + user_, law.pitch, Allowed::parameters); }

  // --- contacts ---
  void operator()(const PointOnPlane& on) {
    for (const Expression& velocity : on.belt) require("the velocity of the belt of " + user_, velocity, Allowed::configuration);
  }
  void operator()(const SphereOnSphere& spheres) {
    require("a radius of " + user_, spheres.radius_a, Allowed::parameters);
    require("a radius of " + user_, spheres.radius_b, Allowed::parameters);
  }
  void operator()(const Stop& stop) {
    require("the displacement of " + user_, stop.displacement, Allowed::configuration);
    require("the place of " + user_, stop.at, Allowed::configuration);
  }
  void operator()(const FrictionAlong& friction) {
    require("the displacement of " + user_, friction.displacement, Allowed::configuration);
    require("the bound of " + user_, friction.bound, Allowed::parameters);
    require("the static bound of " + user_, friction.static_bound, Allowed::parameters);
  }

  void operator()(const FrictionInJoint& friction) {
    require("the radius of " + user_, friction.radius, Allowed::parameters);
  }

  /// Others look at their formulas themselves, or have none.
  template <class Other>
  void operator()(const Other&) {}

 private:
  void all(const std::string& what, const Triple& formulas, Allowed allowed) {
    for (const Expression& formula : formulas) require(what, formula, allowed);
  }

  /// Of the formula as it is lowered: a coordinate that follows a law of time is a formula of time.
  void require(const std::string& what, const Expression& formula, Allowed allowed) {
    const Value value = program_.lower(formula);
    if (value.is_zero() || value.is_constant()) return;
    for (const ValueNumber value_number : program_.live({value})) {
      const SymbolPointer& symbol = program_[value_number].symbol;
      if (!symbol || is_allowed(symbol->kind, allowed)) continue;
      const bool condition = what.starts_with("the holonomic");
      throw SceneError(fmt::format("{} depends on {} '{}' through {}: give a formula of {}{}", what,
                                   kind_text(symbol->kind), symbol->name, formula.to_string(), allowed_text(allowed),
                                   condition ? ", or write it as nonholonomic(...)" : ""));
    }
  }

  Program program_;
  const SceneContent& scene_;
  std::string user_;
};

}  // namespace

void check_dependences(const Scene& scene) { DependenceCheck(scene).run(); }

}  // namespace torsor
