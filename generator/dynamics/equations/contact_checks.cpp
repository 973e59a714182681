// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/contact_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/start_error.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

/// Nothing where the formula needs parameters without a value; what is more than parameters is refused elsewhere.
std::optional<Real> known(const SceneContent& scene, const Expression& formula) {
  try {
    return parameter_value(scene, formula);
  } catch (const SceneError&) {
    return std::nullopt;
  }
}

/// Sizes whose value the scene knows, of one that names it in messages.
class SizeCheck {
 public:
  SizeCheck(const SceneContent& scene, std::string user) : scene_(scene), user_(std::move(user)) {}

  std::optional<Real> known(const Expression& formula) const { return torsor::known(scene_, formula); }
  void at_least(const Expression& formula, const char* what, const Expression& least, const char* remedy) const {
    const auto value = known(formula), bound = known(least);
    if (value && bound && *value < *bound) refuse(what, formula, *value, remedy);
  }
  [[noreturn]] void refuse(const char* what, const Expression& formula, const Real& value, const char* remedy) const {
    throw SceneError(
        fmt::format("{} has the {} {} = {:.6g}: {}", user_, what, formula.to_string(), value.to_double(), remedy));
  }

 private:
  const SceneContent& scene_;
  std::string user_;
};

/// Sizes of the bodies around whose lowest point a plane is touched.
void check_lowest_points(const SceneContent& scene) {
  for (const PointContent& point : scene.points) {
    if (!point.lowest || point.lowest->support) continue;
    const SizeCheck check(scene, name_of(point));
    const char* size = "give the size of what touches the plane";
    check.at_least(point.lowest->radius, "radius", Expression(0), size);
    check.at_least(point.lowest->tube, "tube's radius", Expression(0), size);
  }
}

class SurfaceCheck : SizeCheck {
 public:
  SurfaceCheck(const SceneContent& scene, const ContactContent& contact)
      : SizeCheck(scene, fmt::format("contact '{}'", contact.name)), contact_(contact) {}

  void run() {
    if (std::holds_alternative<TurnOnContact>(contact_.geometry)) {
      return at_least(contact_.friction, "length", Expression(0), "a resistance never drives a turn");
    }
    at_least(contact_.friction, "friction", Expression(0), "a surface never pushes along the slip");
    at_least(contact_.static_friction, "static friction", contact_.friction,
             "it must not be below the friction while sliding");
    at_least(contact_.restitution, "restitution", Expression(0), "it must lie between 0 and 1");
    const auto e = known(contact_.restitution);
    if (e && *e > Real(1)) refuse("restitution", contact_.restitution, *e, "it must lie between 0 and 1");
    std::visit(*this, contact_.geometry);
  }

  void operator()(const PointOnPlane&) {}
  void operator()(const Stop&) {}
  void operator()(const TurnOnContact&) {}
  void operator()(const SphereOnSphere& spheres) {
    for (const Expression& radius : {spheres.radius_a, spheres.radius_b}) {
      at_least(radius, "radius", Expression(0), "give the sphere's size");
    }
    const auto a = known(spheres.radius_a), b = known(spheres.radius_b);
    if (spheres.hollow && a && b && !(*a < *b)) {
      refuse("radius", spheres.radius_a, *a, "the sphere must be smaller than the hollow one around it");
    }
  }
  void operator()(const FrictionInJoint& friction) {
    at_least(friction.radius, "radius", Expression(0), "give the size of the journal");
  }
  void operator()(const FrictionAlong& friction) {
    at_least(friction.bound, "bound", Expression(0), "friction never pushes along the motion");
    at_least(friction.static_bound, "static bound", friction.bound, "it must not be below the bound while moving");
  }

 private:
  const ContactContent& contact_;
};

/// The lower stop of the same coordinate; null: there is none.
const ContactContent* lower_stop_of(const SceneContent& scene, const Stop& upper) {
  for (const ContactContent& contact : scene.contacts) {
    const auto* stop = std::get_if<Stop>(&contact.geometry);
    if (stop != nullptr && stop->sign > 0 && stop->displacement.as_symbol() == upper.displacement.as_symbol())
      return &contact;
  }
  return nullptr;
}

void check_stops(const SceneContent& scene) {
  for (const ContactContent& contact : scene.contacts) {
    const auto* upper = std::get_if<Stop>(&contact.geometry);
    if (upper == nullptr || upper->sign > 0) continue;
    const ContactContent* other = lower_stop_of(scene, *upper);
    if (other == nullptr) continue;
    const Expression& lower = std::get<Stop>(other->geometry).at;
    const auto low = known(scene, lower), high = known(scene, upper->at);
    if (!low || !high || *low < *high || lower.to_string() == upper->at.to_string()) continue;
    if (low->is_nan() || high->is_nan()) {
      const bool first = low->is_nan();
      throw SceneError(fmt::format("the stop '{}' at {} has a place that is no number", (first ? *other : contact).name,
                                   (first ? lower : upper->at).to_string()));
    }
    throw SceneError(fmt::format("the stop '{}' at {} = {:.6g} is not below '{}' at {} = {:.6g}: give it a smaller "
                                 "place", other->name,
                                 lower.to_string(), low->to_double(), contact.name, upper->at.to_string(),
                                 high->to_double()));
  }
}

}  // namespace

void check_surfaces(const SceneContent& scene) {
  check_lowest_points(scene);
  for (const ContactContent& contact : scene.contacts) SurfaceCheck(scene, contact).run();
  check_stops(scene);
  if (!scene.contacts.empty() && !scene.frictions.empty()) {
    throw SceneError(fmt::format("friction '{}' assumes that its contact slides, and contact '{}' may open and close: give "
                                 "all frictions of the scene with contacts",
                                 scene.frictions[0].name, scene.contacts[0].name));
  }
}

void check_contacts(const Equations& equations) {
  const SceneContent& scene = equations.scene().content();
  if (scene.contacts.empty()) return;
  const std::vector<ContactRows> contacts = contact_rows(equations.model());
  const auto valued = [](const ParameterContent& parameter) { return parameter.value.has_value(); };
  if (!std::all_of(scene.parameters.begin(), scene.parameters.end(), valued)) return;
  Evaluator<Real> start(equations.program(), [&scene](const SymbolPointer& symbol) { return initial_value(scene, symbol); });
  for (const ContactRows& contact : contacts) {
    if (!contact.normal) continue;
    // Decimals given for irrational positions carry some twelve digits.
    constexpr double tolerance = 1e-9;
    const double gap = start(contact.gap).to_double();
    const Unit& unit = contact.gap.unit();
    if (std::isnan(gap)) {
      throw StartError(fmt::format("contact '{}' has no gap at t = 0: its point of contact is not defined there (a disc "
                                   "that lies flat); correct initial(...)",
                                   contact.name));
    }
    if (gap >= -tolerance) continue;
    throw StartError(fmt::format("contact '{}' starts penetrating: its gap is {:.6g}{} at t = 0 and must not be negative; "
                                 "correct initial(...) of the coordinates that it depends on",
                                 contact.name, gap, unit.is_dimensionless() ? "" : " " + unit.to_string()));
  }
}

void refuse_contacts(const Scene& scene, const std::string& user) {
  if (scene.content().contacts.empty()) return;
  throw SceneError(fmt::format("{} of the scene '{}' does not watch its contact '{}', and bodies would pass through each "
                               "other: the command simulate moves it from event to event, and a program does so with the kernels "
                               "mass_matrix, bias, contacts and contact_coefficients and runtime/contacts (docs/contacts.md)",
                               user, scene.name(), scene.content().contacts[0].name));
}

}  // namespace torsor
