// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/bearing_loads.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"
#include "torsor/generator/dynamics/theorems/placeless_loads.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// The links that a contact pushes, the first along its directions and the second against them.
std::optional<std::pair<int, int>> pushed_links(const Model& model, const ContactContent& contact) {
  const std::string user = "contact '" + contact.name + "'";
  const SceneContent& scene = model.scene();
  if (const auto* on = std::get_if<PointOnPlane>(&contact.geometry)) {
    const PointContent& point = scene.points[static_cast<std::size_t>(scene.point_index(on->point, user))];
    return std::pair(model.place(point.frame, user).link, model.place(on->plane, user).link);
  }
  if (const auto* spheres = std::get_if<SphereOnSphere>(&contact.geometry)) {
    return std::pair(model.place(spheres->a, user).link, model.place(spheres->b, user).link);
  }
  return std::nullopt;
}

class Reactions {
 public:
  explicit Reactions(const Equations& equations)
      : equations_(equations),
        model_(equations.model()),
        program_(equations.program()),
        transmitted_(transmitted_wrenches(equations)),
        places_(contact_places(model_)) {
    for (const ContactContent& contact : model_.scene().contacts) pushed_.push_back(pushed_links(model_, contact));
  }

  std::vector<BearingReaction> of(const ContactRows& contact) {
    const int carried = *contact.joint;
    const std::vector<bool> inside = carried_links(model_, carried);
    std::vector<BearingReaction> components;
    const std::vector<Vector> across = across_axis(program_, model_.links()[static_cast<std::size_t>(carried)]);
    for (std::size_t which = 0; which < across.size(); ++which) {
      const Vector& direction = across[which];
      BearingReaction reaction;
      reaction.across = which;
      reaction.without_contacts = program_.bind(dot(transmitted_[static_cast<std::size_t>(carried)].resultant, direction));
      for (std::size_t k = 0; k < places_.size(); ++k) add_rows(k, {carried, inside, direction}, reaction.by_reactions);
      clear_identically_zero(reaction.by_reactions);
      const auto acts = [](const Value& entry) { return !entry.is_zero(); };
      if (identically_zero(reaction.without_contacts) &&
          std::none_of(reaction.by_reactions.begin(), reaction.by_reactions.end(), acts)) {
        continue;
      }
      expand(reaction);
      components.push_back(std::move(reaction));
    }
    if (!components.empty()) return components;
    throw SceneError(fmt::format("the friction '{}' is in proportion to what its joint transmits across its axis, and it "
                                 "transmits nothing: give the bound of a dry_friction",
                                 contact.name));
  }

 private:
  /// What a joint transmits along a direction of the link that it carries.
  struct Transmitted {
    int carried;
    const std::vector<bool>& inside;  ///< which links the joint carries, that one among them
    const Vector& direction;          ///< in its axes
  };

  /// What a unit reaction along each row of contact k takes from the joint.
  void add_rows(std::size_t k, const Transmitted& by, std::vector<Value>& entries) const {
    const auto& [carried, inside, direction] = by;
    for (const Vector& along : places_[k].directions) {
      Value entry;
      if (pushed_[k]) {
        const int sides = (inside[static_cast<std::size_t>(pushed_[k]->first)] ? 1 : 0) -
                          (inside[static_cast<std::size_t>(pushed_[k]->second)] ? 1 : 0);
        if (sides != 0) entry = Number(-sides) * dot(bound(program_, model_.express(along, 0, carried)), direction);
      }
      entries.push_back(program_.bind(entry));
    }
  }

  void expand(BearingReaction& reaction) const {
    for (int i = 0; i < model_.unknown_count(); ++i) {
      Derivation along = partial_derivation(program_, model_.coordinates()[static_cast<std::size_t>(i)].a);
      reaction.by_accelerations.push_back(program_.bind(along(reaction.without_contacts)));
    }
    for (const ConstraintRow& constraint : equations_.constraints()) {
      Derivation along = partial_derivation(program_, constraint.multiplier);
      reaction.by_multipliers.push_back(program_.bind(along(reaction.without_contacts)));
    }
    Substitution steady(program_, [this](const SymbolPointer& symbol) -> std::optional<Value> {
      const bool given = symbol->kind != SymbolKind::acceleration && symbol->kind != SymbolKind::multiplier;
      if (given) return std::nullopt;
      return program_.number(Number(), symbol->unit);
    });
    reaction.rest = program_.bind(steady(reaction.without_contacts));
    clear_identically_zero(reaction.by_accelerations);
    clear_identically_zero(reaction.by_multipliers);
  }

  const Equations& equations_;
  const Model& model_;
  Program& program_;
  const std::vector<Wrench> transmitted_;
  const std::vector<ContactPlace> places_;
  std::vector<std::optional<std::pair<int, int>>> pushed_;
};

}  // namespace

std::vector<std::vector<BearingReaction>> bearing_reactions(const Equations& equations) {
  const std::vector<ContactRows> contacts = contact_rows(equations.model());
  std::vector<std::vector<BearingReaction>> all(contacts.size());
  std::optional<PlacelessLoads> placeless;
  std::optional<Reactions> reactions;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (!contacts[k].joint) continue;
    if (!placeless) placeless.emplace(equations, contacts);
    placeless->refuse(contacts[k]);
    if (!reactions) reactions.emplace(equations);
    all[k] = reactions->of(contacts[k]);
  }
  return all;
}

}  // namespace torsor
