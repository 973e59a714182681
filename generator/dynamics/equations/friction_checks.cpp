// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/friction_checks.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

class NormalCheck {
 public:
  explicit NormalCheck(const Equations& equations)
      : equations_(equations),
        model_(equations.model()),
        evaluate_(equations.program(),
                  [&equations](const SymbolPointer& symbol) { return initial_value(equations.scene().content(), symbol); }) {}

  void look_at(const ContactFriction& friction) {
    const ConstraintRow& row = row_of(friction);
    const std::string user = "friction '" + friction.name + "'";
    const int axes = model_.place(friction.axes, user).link;
    const RealRows effects = effects_of_unit_forces(friction, axes, user);
    const RealRow wanted = evaluate_(row.ideal);
    const RealRow normal = least_norm_solution({effects, wanted, 3}, tolerance_);
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const Real rest = product(effects[i], normal) - wanted[i];
      if (rest.is_nan()) return;  // nothing is known of a start where the contact is not defined
      if (abs(rest) <= tolerance_ * (length(effects[i]) + abs(wanted[i]))) continue;
      throw SceneError(
          fmt::format("{} takes the multiplier of constraint '{}' for the normal force at its point, and no force there "
                      "does what that multiplier does to '{}': give the point at which the constraint's force acts",
                      user, row.name, model_.coordinates()[i].v->name));
    }
    const Real size = length(normal);
    // Along what cannot move a force does nothing: where most cannot, a part of n is not seen.
    const bool seen = rank(effects, 3, tolerance_) > 1;
    if (size > Real(1) + tolerance_ || (seen && size < Real(1) - tolerance_)) {
      throw SceneError(
          fmt::format("{} needs the normal force of its contact, and the multiplier of constraint '{}' is {:.6g} times that in "
                      "the initial configuration: write the constraint as the distance itself, with a rate of 1 along the "
                      "normal",
                      user, row.name, (Real(1) / size).to_double()));
    }
    const RealRow slip = components(model_.express(friction.direction, friction.axes, axes, user));
    if (!(abs(product(slip, normal)) > tolerance_ * length(slip))) return;
    throw SceneError(fmt::format("the direction of {} is not across the normal of constraint '{}' in the initial configuration: "
                                 "friction acts in the tangential plane; give a direction in it",
                                 user, row.name));
  }

 private:
  const ConstraintRow& row_of(const ContactFriction& friction) const {
    return equations_.constraints()[static_cast<std::size_t>(friction.constraint)];
  }

  RealRow components(const Vector& vector) { return evaluate_(std::vector<Value>{vector[0], vector[1], vector[2]}); }

  /// Row i: what unit forces along the three axes do to coordinate i.
  RealRows effects_of_unit_forces(const ContactFriction& friction, int axes, const std::string& user) {
    Program& program = model_.program();
    const Vector point = bound(program, model_.locate(*friction.point, axes, user));
    const RelativeMotion contact(model_, model_.place(friction.body, user).link, model_.place(friction.other, user).link,
                                 {.link = axes, .place = point});
    RealRows forces;
    for (int k = 0; k < 3; ++k) {
      Wrench unit;
      unit.resultant[k] = program.number(Number(1));
      forces.push_back(evaluate_(contact.generalised_forces(unit)));
    }
    return transposed(forces, forces[0].size());
  }

  const Equations& equations_;
  const Model& model_;
  Evaluator<Real> evaluate_;
  // Decimals that are given for an irrational position carry some twelve digits.
  const Real tolerance_ = Real::from_double(1e-9);
};

}  // namespace

void check_friction_normals(const Equations& equations) {
  const SceneContent& scene = equations.scene().content();
  const auto& parameters = scene.parameters;
  if (!std::all_of(parameters.begin(), parameters.end(), [](const auto& p) { return p.value.has_value(); })) return;
  NormalCheck check(equations);
  for (const ContactFriction& friction : scene.frictions) {
    if (friction.point) check.look_at(friction);
  }
}

}  // namespace torsor
