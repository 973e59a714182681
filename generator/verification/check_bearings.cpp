// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_bearings.hpp"

#include <cmath>
#include <string>

#include "torsor/generator/dynamics/forces/bearing_loads.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

class BearingCheck {
 public:
  BearingCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene), options_(options), precision_(options.digits + 10), equations_(scene), forces_(scene) {
    const std::vector<ContactRows> contacts = contact_rows(equations_.model());
    const auto bearings = bearing_reactions(equations_);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      if (contacts[k].joint) add(scene.content().contacts[k], *contacts[k].joint, bearings[k]);
    }
  }

  std::vector<CheckResult> run() {
    if (pairs_.empty()) return {};
    double worst = 0;
    const auto n = static_cast<std::size_t>(equations_.model().unknown_count());
    for (int k = 0; k < options_.states; ++k) {
      const RandomState state(scene_, static_cast<std::uint64_t>(k) + 1);
      Evaluator<Real> here(equations_.program(), state.in_real()), there(forces_.program(), state.in_real());
      for (const Pair& pair : pairs_) {
        Real sum = here(pair.parts.rest), size = abs(sum);
        const auto take = [&](const Value& factor, const Real& of) {
          const Real term = here(factor) * of;
          sum += term;
          size += abs(term);
        };
        for (std::size_t i = 0; i < n; ++i) {
          take(pair.parts.by_accelerations[i], here(equations_.model().a(static_cast<int>(i))));
        }
        for (std::size_t j = 0; j < equations_.constraints().size(); ++j) {
          take(pair.parts.by_multipliers[j], here(equations_.program().symbol(equations_.constraints()[j].multiplier)));
        }
        const Real difference = sum - there(pair.whole);
        if (size == Real(0)) size = Real(1);
        const double relative = (abs(difference) / size).to_double();
        if (is_worse(relative, worst)) worst = relative;
      }
    }
    // Five digits for rounding and cancellation.
    return {{"joint_reactions", "what joints with friction transmit against Newton's theorem from positions", worst,
             std::pow(10.0, 5 - options_.digits)}};
  }

 private:
  struct Pair {
    BearingReaction parts;  ///< in `equations_`
    Value whole;            ///< in `forces_`
  };

  void add(const ContactContent& contact, int carried, const std::vector<BearingReaction>& components) {
    const Model& model = forces_.model();
    Program& program = forces_.program();
    const std::string user = "contact '" + contact.name + "'";
    const std::vector<bool> inside = carried_links(model, carried);
    BodyNames bodies;
    for (const BodyContent& body : model.scene().bodies) {
      if (inside[static_cast<std::size_t>(model.place(body.frame, user).link)]) bodies.push_back(body.name);
    }
    Vector force;  // Σ m Γ_G − m g, along the axes of the ground
    if (!bodies.empty()) {
      for (const auto& [link, mass] : mass_by_link(model, bodies, user)) {
        const Vector origin = bound(program, model.locate(Vector(), link, 0));
        const Vector first = bound(program, mass.mass * origin + model.express(mass.first_moment, link, 0));
        for (int i = 0; i < 3; ++i) force[i] += time_derivative(program.bind(time_derivative(first[i])));
        force = force - mass.mass * lower(program, model.scene().gravity);
      }
    }
    force = model.express(bound(program, force), 0, carried);
    const auto take = [&](int link, const Vector& resultant) {
      if (inside[static_cast<std::size_t>(link)]) force = force - model.express(bound(program, resultant), link, carried);
    };
    for (const auto& [link, wrench] : forces_.actions().wrenches) take(link, wrench.resultant);
    for (std::size_t j = 0; j < forces_.constraints().size(); ++j) {
      const auto unit = constraint_wrench(model, static_cast<int>(j));
      if (!unit) continue;
      const Value lambda = program.symbol(forces_.constraints()[j].multiplier);
      for (const auto& [link, wrench] : *unit) take(link, lambda * bound(program, wrench.resultant));
    }
    force = bound(program, force);
    const std::vector<Vector> across = across_axis(program, model.links()[static_cast<std::size_t>(carried)]);
    for (const BearingReaction& component : components) {
      pairs_.push_back({component, program.bind(dot(force, across[component.across]))});
    }
  }

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Equations equations_, forces_;
  std::vector<Pair> pairs_;
};

}  // namespace

std::vector<CheckResult> check_bearings(const Scene& scene, const CheckOptions& options) {
  return BearingCheck(scene, options).run();
}

}  // namespace torsor
