// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/selected_actions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

constexpr const char* weight = "gravity";

/// Whether an action is made of wrenches on bodies, so that each body's share is known.
bool has_ends(const ActionContent& action) {
  return !std::holds_alternative<ElongationSpring>(action) && !std::holds_alternative<ElongationDamper>(action) &&
         !std::holds_alternative<Motor>(action) && !std::holds_alternative<GivenForceFunction>(action) &&
         !std::holds_alternative<GeneralisedForce>(action);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Gatherer {
 public:
  Gatherer(const Model& model, const ActionSelection& query) : model_(model), program_(model.program()), query_(query) {
    check_names();
  }

  SelectedActions gather() {
    SelectedActions result;
    result.forces.resize(static_cast<std::size_t>(model_.unknown_count()));
    for (const ContactFriction& friction : model_.scene().frictions) {
      if (wanted(friction.name)) result.frictions.push_back(friction.name);
    }
    add_actions(result);
    if (wanted(weight)) add_gravity(result);
    for (Value& force : result.forces) force = program_.bind(force);
    result.power = program_.bind(result.power);
    return result;
  }

 private:
  bool wanted(const std::string& name) const { return query_.actions.empty() || contains(query_.actions, name); }

  void check_names() const {
    const SceneContent& scene = model_.scene();
    std::vector<std::string> known{weight};
    for (const ActionContent& action : scene.actions) known.push_back(name_of(action));
    for (const ContactFriction& friction : scene.frictions) known.push_back(friction.name);
    refuse_unknown(query_.actions, known, "action");
    std::vector<std::string> bodies;
    for (const BodyContent& body : scene.bodies) bodies.push_back(body.name);
    refuse_unknown(query_.bodies, bodies, "body");
    if (query_.bodies.empty()) return;
    for (const ActionContent& action : scene.actions) {
      if (!wanted(name_of(action)) || (has_ends(action) && !works_on_formula(model_, action))) continue;
      throw SceneError(
          fmt::format("the action '{}' works on a formula, and its share on one body is not known: ask for it "
                      "without bodies, or write it between points",
                      name_of(action)));
    }
  }

  static void refuse_unknown(const std::vector<std::string>& names, const std::vector<std::string>& known,
                             const std::string& kind) {
    for (const std::string& name : names) {
      if (contains(known, name)) continue;
      throw SceneError(fmt::format("unknown {} '{}' in a selection of actions: {}the scene has {}", kind, name,
                                   did_you_mean(name, known),
                                   known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
  }

  std::vector<Value> along_coordinates(const Value& u) const {
    std::vector<SymbolPointer> velocities;
    for (int i = 0; i < model_.unknown_count(); ++i) {
      velocities.push_back(model_.coordinates()[static_cast<std::size_t>(i)].v);
    }
    return u.program() == nullptr ? std::vector<Value>(velocities.size()) : gradient_along(u, velocities);
  }

  Value work_rate(const std::vector<Value>& forces) const {
    Value sum;
    for (std::size_t i = 0; i < forces.size(); ++i) sum += forces[i] * model_.v(static_cast<int>(i));
    return sum;
  }

  void add_actions(SelectedActions& result) {
    AppliedActions actions =
        applied_actions(model_, [this](const ActionContent& action) { return wanted(name_of(action)); });
    result.force_function += actions.spring_force_function;
    if (!query_.bodies.empty()) {
      keep_bodies(actions, result);
      return;
    }
    const std::vector<Value> applied = applied_forces(model_, actions);
    for (std::size_t i = 0; i < result.forces.size(); ++i) result.forces[i] += applied[i];
    const std::vector<SymbolPointer> inputs = wanted_inputs();
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      for (std::size_t i = 0; i < result.forces.size(); ++i) {
        if (!actions.inputs[k][i].is_zero()) result.forces[i] += actions.inputs[k][i] * program_.symbol(inputs[k]);
      }
    }
    // Mutual actions do dU/dt at both ends; what is given by formula acts on the coordinates alone.
    const AppliedActions given = applied_actions(model_, [this](const ActionContent& action) {
      return wanted(name_of(action)) && std::holds_alternative<GivenForceFunction>(action);
    });
    result.power += actions.power;
    result.power += time_derivative(program_.bind(actions.spring_force_function - given.spring_force_function));
    result.power -= actions.rate_without_work;
    result.power += work_rate(along_coordinates(given.spring_force_function));
  }

  std::vector<SymbolPointer> wanted_inputs() const {
    std::vector<SymbolPointer> inputs;
    for (const ActionContent& action : model_.scene().actions) {
      const auto* motor = std::get_if<Motor>(&action);
      if (motor != nullptr && wanted(motor->name)) inputs.push_back(motor->input);
    }
    return inputs;
  }

  /// Wrenches on the links of the bodies asked for, with the twists of these links.
  void keep_bodies(const AppliedActions& all, SelectedActions& result) {
    AppliedActions kept;
    kept.passive.resize(model_.coordinates().size());
    const std::vector<Twist> moving = twists(model_);
    for (const BodyContent& body : model_.scene().bodies) {
      const int link = model_.place(body.frame, body.name).link;
      const auto wrench = all.wrenches.find(link);
      if (!contains(query_.bodies, body.name) || wrench == all.wrenches.end()) continue;
      if (kept.wrenches.emplace(link, wrench->second).second) {
        result.power += reciprocal_product(wrench->second, moving[static_cast<std::size_t>(link)]);
      }
    }
    const std::vector<Value> applied = applied_forces(model_, kept);
    for (std::size_t i = 0; i < result.forces.size(); ++i) result.forces[i] += applied[i];
  }

  void add_gravity(SelectedActions& result) {
    const Vector g = lower(program_, model_.scene().gravity);
    Value u;
    for (const BodyContent& body : model_.scene().bodies) {
      if (!query_.bodies.empty() && !contains(query_.bodies, body.name)) continue;
      const FramePlace& at = model_.place(body.frame, body.name);
      const Vector center = at.origin + at.rotation * lower(program_, body.inertia.center);
      const Value mass = program_.lower(body.inertia.mass);
      const Vector place = bound(program_, model_.locate(center, at.link, 0));
      u += mass * dot(g, place);
      for (int k = 0; k < 3; ++k) {
        if (!place[k].is_zero() && !g[k].is_zero()) result.power += mass * g[k] * time_derivative(place[k]);
      }
    }
    result.force_function += u;
    const std::vector<Value> forces = along_coordinates(u);
    for (std::size_t i = 0; i < forces.size(); ++i) result.forces[i] += forces[i];
  }

  const Model& model_;
  Program& program_;
  const ActionSelection& query_;
};

}  // namespace

SelectedActions selected_actions(const Model& model, const ActionSelection& selection) {
  return Gatherer(model, selection).gather();
}

}  // namespace torsor
