// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/ownership_checks.hpp"

#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/measure.hpp"

namespace torsor {
namespace {

class OwnershipCheck {
 public:
  explicit OwnershipCheck(const Scene& scene) : scene_(scene.content()) {
    own_.insert(scene_.time);
    for (const ParameterContent& parameter : scene_.parameters) own_.insert(parameter.symbol);
    for (const CoordinateContent& c : scene_.coordinates) own_.insert({c.q, c.v, c.a});
    for (const AttitudeContent& attitude : scene_.attitudes) {
      own_.insert(attitude.symbols->e.begin(), attitude.symbols->e.end());
      own_.insert(attitude.symbols->omega.begin(), attitude.symbols->omega.end());
    }
    for (const ActionContent& action : scene_.actions) {
      if (const auto* motor = std::get_if<Motor>(&action)) own_.insert(motor->input);
    }
    for (const ConstraintContent& constraint : scene_.constraints) own_.insert(constraint.multiplier);
    for (const PointContent& point : scene_.points) {
      if (point.lowest && point.lowest->support) {
        own_.insert(point.lowest->support->direction.begin(), point.lowest->support->direction.end());
      }
    }
  }

  void run() {
    of("gravity", scene_.gravity);
    for (const ParameterContent& p : scene_.parameters) of("parameter '" + p.symbol->name + "'", p.value);
    for (const CoordinateContent& c : scene_.coordinates) {
      of("coordinate '" + c.q->name + "'", c.law, c.initial_value, c.initial_rate);
    }
    for (const AttitudeContent& attitude : scene_.attitudes) {
      if (attitude.initial) of("attitude '" + attitude.name + "'", *attitude.initial);
    }
    for (const FrameContent& f : scene_.frames) of(scene_.name_of(f), f.placement, f.axis, f.displacement);
    for (const JointContent& j : scene_.joints) of("joint '" + j.name + "'", j.placement, j.pitch);
    for (const PointContent& point : scene_.points) {
      of(name_of(point), point.components);
      if (!point.lowest) continue;
      const LowestPoint& lowest = *point.lowest;
      if (lowest.axis) look(*lowest.axis);
      look(lowest.radius), look(lowest.tube);
      if (lowest.support) look(lowest.support->h);
    }
    for (const BodyContent* body : scene_.inertias()) {
      const Inertia& i = body->inertia;
      of(scene_.name_of(*body), i.mass, i.center, i.xx, i.yy, i.zz, i.xy, i.xz, i.yz);
    }
    for (const ActionContent& action : scene_.actions) {
      user_ = "action '" + name_of(action) + "'";
      std::visit(*this, action);
    }
    for (const ContactFriction& f : scene_.frictions) of("friction '" + f.name + "'", f.coefficient, f.direction, f.length);
    for (const ConstraintContent& constraint : scene_.constraints) {
      user_ = "constraint '" + constraint.name + "'";
      std::visit(*this, constraint.law);
      if (constraint.reaction) of("reaction '" + constraint.reaction->name + "'", constraint.reaction->direction);
    }
    for (const ContactContent& contact : scene_.contacts) {
      of("contact '" + contact.name + "'", contact.friction, contact.static_friction, contact.restitution);
      std::visit(*this, contact.geometry);
    }
    for (const Shown& shown : scene_.shown) {
      of("a picture's form", shown.placement);
      std::visit(*this, shown.form);
    }
  }

  // --- actions ---
  void operator()(const ElongationSpring& s) { look(s.elongation), look(s.stiffness), look(s.rest); }
  void operator()(const ElongationDamper& d) { look(d.elongation), look(d.damping); }
  void operator()(const PointSpring& s) { look(s.stiffness), look(s.rest); }
  void operator()(const PointDamper& d) { look(d.damping); }
  void operator()(const Motor& m) { look(m.displacement); }
  void operator()(const GivenForce& f) { look(f.components); }
  void operator()(const GivenTorque& t) { look(t.components); }
  void operator()(const GivenForceFunction& f) { look(f.force_function); }
  void operator()(const GeneralisedForce& f) { look(f.displacement), look(f.force); }
  void operator()(const Gravitation& g) { look(g.strength); }
  void operator()(const GivenWrench& w) { look(w.force), look(w.moment); }
  void operator()(const Drag& d) { look(d.coefficient); }
  void operator()(const RotationalDrag& d) { look(d.coefficient); }
  void operator()(const MutualAction& a) { look(a.components); }
  // --- constraints ---
  void operator()(const HolonomicFormula& law) { look(law.f); }
  void operator()(const NonholonomicFormula& law) { look(law.left_side); }
  void operator()(const NoSlip& law) { look(law.direction); }
  void operator()(const Closure& law) { look(law.direction); }
  void operator()(const PointInPlane&) {}
  void operator()(const JointClosure& law) { look(law.pitch); }
  // --- contacts ---
  void operator()(const PointOnPlane& on) { look(on.belt); }
  void operator()(const SphereOnSphere& s) { look(s.radius_a), look(s.radius_b); }
  void operator()(const Stop& s) { look(s.displacement), look(s.at); }
  void operator()(const FrictionAlong& f) { look(f.displacement), look(f.bound), look(f.static_bound); }
  void operator()(const FrictionInJoint& f) { look(f.radius); }
  void operator()(const TurnOnContact&) {}
  // --- pictures ---
  void operator()(const form::Box& box) { look(box.edges); }
  void operator()(const form::Cylinder& c) { look(c.radius), look(c.length); }
  void operator()(const form::Cone& c) { look(c.radius), look(c.length); }
  void operator()(const form::Sphere& s) { look(s.radius); }
  void operator()(const form::Segment& s) { look(s.from), look(s.to), look(s.radius); }
  void operator()(const form::Torus& t) { look(t.radius), look(t.tube); }
  void operator()(const form::Mesh&) {}

 private:
  template <class... Formulas>
  void of(std::string user, const Formulas&... formulas) {
    user_ = std::move(user);
    (look(formulas), ...);
  }

  void look(const Expression& formula) {
    for (const SymbolPointer& symbol : formula.symbols()) {
      if (symbol->measure) {
        // Between frames that do not move against each other it is made of nothing.
        if (symbol->measure->vector->time != scene_.time) refuse(*symbol, formula);
        for (const SymbolPointer& part : symbol->made_of) require_own(part, formula);
      } else {
        require_own(symbol, formula);
      }
    }
  }
  void look(const std::optional<Expression>& formula) {
    if (formula) look(*formula);
  }
  template <std::size_t n>
  void look(const std::array<Expression, n>& formulas) {
    for (const Expression& formula : formulas) look(formula);
  }
  void look(const Placement& placement) { look(placement.origin); }

  void require_own(const SymbolPointer& symbol, const Expression& formula) const {
    if (symbol->kind == SymbolKind::pi || own_.contains(symbol)) return;
    refuse(*symbol, formula);
  }
  [[noreturn]] void refuse(const Symbol& symbol, const Expression& formula) const {
    throw SceneError(fmt::format("'{}' belongs to another scene than '{}', whose {} has the formula {}: take the symbols "
                                 "that this scene gave out",
                                 symbol.name, scene_.name, user_, formula.to_string()));
  }

  const SceneContent& scene_;
  std::set<SymbolPointer> own_;  // looked up only: the order of addresses is never seen
  std::string user_;
};

}  // namespace

void check_ownership(const Scene& scene) { OwnershipCheck(scene).run(); }

}  // namespace torsor
