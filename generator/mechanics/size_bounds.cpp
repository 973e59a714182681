// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/size_bounds.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/axis_bounds.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"

namespace torsor {
namespace {

using Relation = SizeBound::Relation;

/// "m = 5", or the number alone where the formula says no more.
std::string with_value(const Expression& formula) {
  return formula.symbols().empty() ? "\1" : formula.to_string() + " = \1";
}

/// Bounds of one thing, which messages name.
class Bounds {
 public:
  explicit Bounds(std::string user) : user_(std::move(user)) {}

  void at_least(const Expression& formula, const char* what, const Expression& least, const char* remedy) {
    all_.push_back({formula, Relation::at_least, least, said(formula, what, remedy)});
  }
  void at_most(const Expression& formula, const char* what, const Expression& most, const char* remedy) {
    all_.push_back({formula, Relation::at_most, most, said(formula, what, remedy)});
  }
  void below(const Expression& formula, const char* what, const Expression& limit, const char* remedy) {
    all_.push_back({formula, Relation::below, limit, said(formula, what, remedy)});
  }
  std::vector<SizeBound> take() { return std::move(all_); }

 private:
  std::string said(const Expression& formula, const char* what, const char* remedy) const {
    return user_ + " has the " + what + " " + formula.to_string() + " = \1: " + remedy;
  }

  std::string user_;
  std::vector<SizeBound> all_;
};

void append(std::vector<SizeBound>& all, std::vector<SizeBound> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Sizes of the bodies around whose lowest point a plane is touched.
std::vector<SizeBound> bounds_of_lowest_point(const PointContent& point) {
  if (!point.lowest || point.lowest->support) return {};
  Bounds bounds(name_of(point));
  const char* size = "give the size of what touches the plane";
  bounds.at_least(point.lowest->radius, "radius", Expression(0), size);
  bounds.at_least(point.lowest->tube, "tube's radius", Expression(0), size);
  return bounds.take();
}

std::vector<SizeBound> bounds_of_contact(const ContactContent& contact) {
  Bounds bounds(fmt::format("contact '{}'", contact.name));
  if (std::holds_alternative<TurnOnContact>(contact.geometry)) {
    bounds.at_least(contact.friction, "length", Expression(0), "a resistance never drives a turn");
    return bounds.take();
  }
  bounds.at_least(contact.friction, "friction", Expression(0), "a surface never pushes along the slip");
  bounds.at_least(contact.static_friction, "static friction", contact.friction,
                  "it must not be below the friction while sliding");
  bounds.at_least(contact.restitution, "restitution", Expression(0), "it must lie between 0 and 1");
  bounds.at_most(contact.restitution, "restitution", Expression(1), "it must lie between 0 and 1");
  if (const auto* spheres = std::get_if<SphereOnSphere>(&contact.geometry)) {
    bounds.at_least(spheres->radius_a, "radius", Expression(0), "give the sphere's size");
    bounds.at_least(spheres->radius_b, "radius", Expression(0), "give the sphere's size");
    if (spheres->hollow) {
      bounds.below(spheres->radius_a, "radius", spheres->radius_b, "the sphere must be smaller than the hollow one around it");
    }
  } else if (const auto* joint = std::get_if<FrictionInJoint>(&contact.geometry)) {
    bounds.at_least(joint->radius, "radius", Expression(0), "give the size of the journal");
  } else if (const auto* along = std::get_if<FrictionAlong>(&contact.geometry)) {
    bounds.at_least(along->bound, "bound", Expression(0), "friction never pushes along the motion");
    bounds.at_least(along->static_bound, "static bound", along->bound, "it must not be below the bound while moving");
  }
  return bounds.take();
}

/// Of a length of which the squares alone went into a formula, where a sign is lost.
SizeBound bound_of_size(const std::string& owner, const StatedSize& size) {
  const std::string has = owner + " has the " + size.what + " " + with_value(size.value) + " m";
  switch (size.least) {
    case StatedSize::Least::other:
      return {size.value, Relation::at_least, size.other,
              has + ", below the " + size.other_what + " " + with_value(size.other) + " m: exchange them, or correct one"};
    case StatedSize::Least::above_zero:
      return {Expression(0), Relation::below, size.value, has + ": it must be above 0", {size.value}};
    case StatedSize::Least::zero:
      break;
  }
  return {size.value, Relation::at_least, Expression(0), has + ": a length is never negative; give its size"};
}

/// The lower stop of the same coordinate; null: there is none.
const ContactContent* lower_stop_of(const SceneContent& scene, const Stop& upper) {
  for (const ContactContent& contact : scene.contacts) {
    const auto* stop = std::get_if<Stop>(&contact.geometry);
    if (stop != nullptr && stop->sign > 0 && stop->displacement.as_symbol() == upper.displacement.as_symbol())
      return &contact;
  }
  return nullptr;
}

std::vector<SizeBound> bounds_of_stops(const SceneContent& scene) {
  std::vector<SizeBound> bounds;
  for (const ContactContent& contact : scene.contacts) {
    const auto* upper = std::get_if<Stop>(&contact.geometry);
    if (upper == nullptr || upper->sign > 0) continue;
    const ContactContent* other = lower_stop_of(scene, *upper);
    if (other == nullptr) continue;
    const Expression& lower = std::get<Stop>(other->geometry).at;
    if (lower.to_string() == upper->at.to_string()) continue;
    bounds.push_back({lower, Relation::below, upper->at,
                      "the stop '" + other->name + "' at " + lower.to_string() + " = \1 is not below '" + contact.name + "' at " +
                          upper->at.to_string() + " = \1: give it a smaller place"});
  }
  return bounds;
}

/// Leading minors of a symmetric operator (xx, yy, zz, xy, xz, yz).
std::array<Expression, 3> minors(const std::array<Expression, 6>& J) {
  const auto& [xx, yy, zz, xy, xz, yz] = J;
  const auto product = [](const Expression& a, const Expression& b, const Expression& c) {
    return folded_product(folded_product(a, b), c);
  };
  return {xx, folded_product(xx, yy) - folded_product(xy, xy),
          product(xx, yy, zz) + folded_product(2, product(xy, yz, xz)) - product(xx, yz, yz) - product(yy, xz, xz) -
              product(zz, xy, xy)};
}

/// Whether one of these parameters stands in a formula, or in those of parameters in it.
bool depends_on(const SceneContent& scene, const Expression& formula, const std::vector<SymbolPointer>& given) {
  const std::vector<SymbolPointer> symbols = formula.symbols();
  return std::any_of(symbols.begin(), symbols.end(), [&](const SymbolPointer& symbol) {
    if (std::find(given.begin(), given.end(), symbol) != given.end()) return true;
    return std::any_of(scene.parameters.begin(), scene.parameters.end(), [&](const ParameterContent& parameter) {
      return parameter.symbol == symbol && parameter.value && depends_on(scene, *parameter.value, given);
    });
  });
}

}  // namespace

bool SizeBound::broken(const Real& of_value, const Real& of_bound) const {
  switch (relation) {
    case Relation::at_least: return of_value < of_bound;
    case Relation::at_most: return of_value > of_bound;
    case Relation::below: return of_value > of_bound || of_value == of_bound;
  }
  return false;
}

std::vector<Expression> SizeBound::formulas() const {
  std::vector<Expression> all{value, bound};
  all.insert(all.end(), shown.begin(), shown.end());
  return all;
}

bool of_parameters(const Expression& formula) {
  const std::vector<SymbolPointer> symbols = formula.symbols();
  return std::all_of(symbols.begin(), symbols.end(), [](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::parameter || symbol->kind == SymbolKind::pi;
  });
}

SizeBound bound_of_mass(const SceneContent& scene, const BodyContent& body) {
  const std::string name = scene.name_of(body);
  if (scene.is_rotor(body)) {
    return {body.inertia.zz, Relation::at_least, Expression(0),
            name + " is " + with_value(body.inertia.zz) +
                " and must not be negative: it is N^2 J of a rotor of inertia J behind a gear of ratio N"};
  }
  return {body.inertia.mass, Relation::at_least, Expression(0),
          name + " has the mass " + with_value(body.inertia.mass) +
              " kg: a mass is never negative; subtract a hole from the body it is cut from, as in Inertia::box(...) - "
              "Inertia::cylinder(...)"};
}

std::vector<SizeBound> bounds_of_moments(const SceneContent& scene, const BodyContent& body) {
  if (scene.is_rotor(body) || body.moments == Moments::as_read) return {};
  const Inertia& of = body.inertia;
  // In plane motion only one moment matters, and the others are often left out: zeros as written are not values.
  const bool complete = !of.xx.is_zero() && !of.yy.is_zero() && !of.zz.is_zero();
  const Expression sum = of.xx + of.yy + of.zz, slack = sum / 100000;
  std::array<Expression, 6> J{of.xx + slack, of.yy + slack, of.zz + slack, of.xy, of.xz, of.yz};
  if (complete && body.moments != Moments::as_given) {  // those of x xT dm: 1 sum/2 - J
    J = {sum / 2 - of.xx + slack, sum / 2 - of.yy + slack, sum / 2 - of.zz + slack, -of.xy, -of.xz, -of.yz};
  }
  const bool has_products = !of.xy.is_zero() || !of.xz.is_zero() || !of.yz.is_zero();
  std::vector<Expression> entries{of.xx, of.yy, of.zz};
  if (has_products) entries.insert(entries.end(), {of.xy, of.xz, of.yz});
  const std::string said =
      scene.name_of(body) + " has the moments of inertia xx = \1, yy = \1 and zz = \1 kg m^2" +
      (has_products ? ", the products xy = \1, xz = \1 and yz = \1 kg m^2," : "") +
      " about its centre of mass: of no matter is a principal one larger than the sum of the others, or negative; check the "
      "entries, the sign of the products (xy = -int x y dm) and that the operator is about the centre of mass";
  std::vector<SizeBound> bounds;
  for (const Expression& minor : minors(J)) bounds.push_back({minor, Relation::at_least, Expression(0), said, entries});
  return bounds;
}

std::vector<SizeBound> bounds_of_stated_sizes(const SceneContent& scene) {
  std::vector<SizeBound> bounds;
  for (const BodyContent& body : scene.bodies) {
    for (const StatedSize& size : body.inertia.sizes) bounds.push_back(bound_of_size(scene.name_of(body), size));
  }
  for (const PointContent& point : scene.points) {
    for (const StatedSize& size : point.sizes) bounds.push_back(bound_of_size(name_of(point), size));
  }
  return bounds;
}

std::vector<SizeBound> bounds_of_frictions(const SceneContent& scene) {
  std::vector<SizeBound> bounds;
  for (const ContactFriction& friction : scene.frictions) {
    bounds.push_back({friction.coefficient, Relation::at_least, Expression(0),
                      "friction '" + friction.name + "' has the coefficient " + friction.coefficient.to_string() +
                          " = \1 and must not have a negative one: its force would push along the slip; turn the "
                          "direction instead"});
  }
  return bounds;
}

std::vector<SizeBound> bounds_of_surfaces(const SceneContent& scene) {
  std::vector<SizeBound> bounds;
  for (const PointContent& point : scene.points) append(bounds, bounds_of_lowest_point(point));
  for (const ContactContent& contact : scene.contacts) append(bounds, bounds_of_contact(contact));
  append(bounds, bounds_of_stops(scene));
  return bounds;
}

void require_bounds(const SceneContent& scene, const std::vector<SizeBound>& bounds, WithoutValue how) {
  const auto value_of = [&](const Expression& formula) {
    return how == WithoutValue::made_up ? std::optional(parameter_value(scene, formula, true)) : known_value(scene, formula);
  };
  for (const SizeBound& each : bounds) {
    std::vector<Real> numbers;
    const std::vector<Expression> formulas = each.formulas();
    for (const Expression& formula : formulas) {
      if (const std::optional<Real> number = value_of(formula)) numbers.push_back(*number);
    }
    if (numbers.size() < formulas.size() || !each.broken(numbers[0], numbers[1])) continue;
    std::string said = each.said;
    for (std::size_t k = each.first_shown(); k < numbers.size(); ++k) {
      if (const std::size_t place = said.find(SizeBound::number); place != std::string::npos) {
        said.replace(place, 1, fmt::format("{:.6g}", numbers[k].to_double()));
      }
    }
    throw SceneError(said);
  }
}

std::vector<SizeBound> bounds_that_depend_on(const SceneContent& scene, const std::vector<SymbolPointer>& parameters) {
  std::vector<SizeBound> bounds;
  for (const BodyContent* body : scene.inertias()) {
    bounds.push_back(bound_of_mass(scene, *body));
    append(bounds, bounds_of_moments(scene, *body));
  }
  append(bounds, bounds_of_stated_sizes(scene));
  append(bounds, bounds_of_frictions(scene));
  append(bounds, bounds_of_surfaces(scene));
  append(bounds, bounds_of_axes(scene));
  std::erase_if(bounds, [&](const SizeBound& each) {
    const bool depends = depends_on(scene, each.value, parameters) || depends_on(scene, each.bound, parameters);
    return !depends || !of_parameters(each.value) || !of_parameters(each.bound);
  });
  return bounds;
}

}  // namespace torsor
