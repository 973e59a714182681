// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/motion/inertia_wrench.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

/// Wrenches of one action, the ground's share of a mutual one included.
WrenchOnLinks wrenches_of(const Model& model, const ActionContent& action) {
  const AppliedActions one = applied_actions(model, [&](const ActionContent& other) { return &other == &action; });
  WrenchOnLinks all = one.wrenches;
  if (is_external(action)) return all;
  Wrench ground;
  for (const auto& [link, wrench] : one.wrenches) {
    const Vector force = bound(model.program(), model.express(wrench.resultant, link, 0));
    const Vector moment = model.express(wrench.moment, link, 0);
    const Vector origin = bound(model.program(), model.locate(Vector(), link, 0));
    ground = ground - Wrench{force, moment + cross(origin, force)};
  }
  if (!identically_zero(ground.resultant) || !identically_zero(ground.moment)) {
    const Vector force = bound(model.program(), ground.resultant);
    all[0] = {force, bound(model.program(), ground.moment)};
  }
  return all;
}

/// Sorts powers by whether both sides of what works belong to the bodies.
class Balance {
 public:
  Balance(const Equations& equations, const BodyNames& bodies, const FrameReference& observer)
      : equations_(equations),
        model_(equations.model()),
        program_(equations.program()),
        inside_(isolated_links(equations_, bodies, user_)),
        observer_(model_.place(observer, user_).link) {}

  void add(const WrenchOnLinks& wrenches, bool external) {
    const bool within = !external && std::all_of(wrenches.begin(), wrenches.end(),
                                                 [this](const auto& entry) { return inside(entry.first); });
    for (const auto& [link, wrench] : wrenches) {
      if (inside(link)) (within ? internal_ : external_) += power(wrench, link);
    }
  }

  void add_actions() {
    for (const ActionContent& action : model_.scene().actions) add(wrenches_of(model_, action), is_external(action));
  }

  void add_constraints() {
    for (std::size_t j = 0; j < equations_.constraints().size(); ++j) {
      const auto unit = constraint_wrench(model_, static_cast<int>(j));
      if (!unit) continue;
      const Value lambda = program_.symbol(equations_.constraints()[j].multiplier);
      WrenchOnLinks wrenches;
      for (const auto& [link, wrench] : *unit) wrenches[link] = lambda * wrench;
      add(wrenches, false);
    }
  }

  void add_joints() {
    const std::vector<Wrench> transmitted = transmitted_wrenches(equations_);
    for (std::size_t k = 1; k < transmitted.size(); ++k) {
      const int link = static_cast<int>(k);
      const int parent = model_.links()[k].parent;
      if (inside(link) && inside(parent)) {
        internal_ += reciprocal_product(transmitted[k], relative_twist(model_, link, parent));
      } else if (inside(link)) {
        external_ += power(transmitted[k], link);
      } else if (inside(parent)) {  // the opposite acts on the parent, at its own point there
        const Twist child = relative_twist(model_, link, observer_);
        const Twist joint = relative_twist(model_, link, parent);
        external_ -=
            reciprocal_product(transmitted[k], Twist{child.angular - joint.angular, child.linear - joint.linear});
      }
    }
  }

  /// Weight and inertia wrenches of one link's bodies at its origin.
  void add_carried(const BodyNames& bodies) {
    const Vector g = lower(program_, model_.scene().gravity);
    for (const auto& [link, mass] : mass_by_link(model_, bodies, user_)) {
      const Vector turned = bound(program_, model_.express(g, 0, link));
      external_ += power({mass.mass * turned, cross(mass.first_moment, turned)}, link);
      if (observer_ != 0) external_ += power(inertia_wrench_at_origin(model_, mass, link, observer_), link);
    }
  }

  EnergyTheorem take() const {
    EnergyTheorem theorem;
    theorem.external_power = program_.bind(external_);
    theorem.internal_power = program_.bind(internal_);
    return theorem;
  }

 private:
  bool inside(int link) const { return inside_[static_cast<std::size_t>(link)]; }
  Value power(const Wrench& wrench, int link) const {
    return reciprocal_product(wrench, relative_twist(model_, link, observer_));
  }

  const std::string user_ = "the energy theorem";
  const Equations& equations_;
  const Model& model_;
  Program& program_;
  std::vector<bool> inside_;
  int observer_;
  Value external_, internal_;
};

}  // namespace

bool is_external(const ActionContent& action) {
  return std::holds_alternative<GivenForce>(action) || std::holds_alternative<GivenTorque>(action) ||
         std::holds_alternative<GivenWrench>(action);
}

namespace {

EnergyTheorem theorem(const Equations& equations, const BodyNames& bodies, const FrameReference& observer,
                      bool with_joints) {
  Balance balance(equations, bodies, observer);
  balance.add_carried(bodies);
  balance.add_actions();
  balance.add_constraints();
  if (with_joints) balance.add_joints();
  EnergyTheorem result = balance.take();
  const Value energy = equations.program().bind(kinetic_energy(equations.model(), bodies, observer));
  result.kinetic_rate = energy.is_zero() ? Value() : equations.program().bind(time_derivative(energy));
  return result;
}

}  // namespace

EnergyTheorem energy_theorem(const Equations& equations, const BodyNames& bodies, const FrameReference& observer) {
  return theorem(equations, bodies, observer, true);
}

EnergyTheorem energy_theorem_without_joints(const Equations& equations, const BodyNames& bodies,
                                            const FrameReference& observer) {
  return theorem(equations, bodies, observer, false);
}

Value action_power(const Equations& equations, const std::string& name, const FrameReference& observer) {
  const Model& model = equations.model();
  const std::string user = "the power of action '" + name + "'";
  const auto& actions = model.scene().actions;
  const auto action =
      std::find_if(actions.begin(), actions.end(), [&](const ActionContent& any) { return name_of(any) == name; });
  if (action == actions.end()) {
    std::vector<std::string> known;
    for (const ActionContent& any : actions) known.push_back(name_of(any));
    throw SceneError(fmt::format("unknown action '{}': {}the scene has {}", name, did_you_mean(name, known),
                                 known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
  }
  const int reference = model.place(observer, user).link;
  const AppliedActions one = applied_actions(model, [&](const ActionContent& other) { return &other == &*action; });
  Value sum;
  if (one.wrenches.empty() || works_on_formula(model, *action)) {  // it works on a formula
    if (!has_force_function(*action)) return one.power;
    if (!std::holds_alternative<GivenForceFunction>(*action)) {
      return time_derivative(one.spring_force_function) - one.rate_without_work;
    }
    for (std::size_t i = 0; i < one.passive.size(); ++i) sum += one.passive[i] * model.v(static_cast<int>(i));
    return sum;
  }
  for (const auto& [link, wrench] : wrenches_of(model, *action)) {
    sum += reciprocal_product(wrench, relative_twist(model, link, reference));
  }
  return sum;
}

}  // namespace torsor
