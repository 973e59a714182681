// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/theorem_equations.hpp"

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/theorems/joint_actions.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// Keeps the names that a result is written with, in the order of the joints and of the constraints: those whose factor
/// does not vanish identically, for what cancels stands in the program all the same.
void name_unknowns(TheoremEquation& equation, const Equations& equations, const std::vector<const JointAction*>& joints) {
  Program& program = equations.program();
  std::vector<SymbolPointer> all;
  for (const JointAction* joint : joints) all.insert(all.end(), joint->unknowns.begin(), joint->unknowns.end());
  for (const ConstraintRow& row : equations.constraints()) all.push_back(row.multiplier);
  std::vector<Value> factors;
  for (const SymbolPointer& unknown : all) {
    factors.push_back(program.bind(partial_derivation(program, unknown)(equation.right)));
  }
  const std::vector<bool> absent = identically_zero_entries(factors);
  std::size_t next = 0;
  for (const JointAction* joint : joints) {
    bool used = false;
    for (const SymbolPointer& unknown : joint->unknowns) {
      if (absent[next++]) continue;
      equation.unknowns.push_back(unknown);
      used = true;
    }
    if (used) equation.remarks.insert(equation.remarks.end(), joint->remarks.begin(), joint->remarks.end());
  }
  for (; next < all.size(); ++next) {
    if (!absent[next]) equation.multipliers.push_back(all[next]);
  }
}

}  // namespace

TheoremEquation theorem_equation(const Equations& equations, const BodyNames& bodies, const TheoremQuery& query,
                                 const NaturalLanguage& say) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const std::vector<bool> inside = isolated_links(equations, bodies, "Newton-Euler's theorem");
  const NewtonEulerEquation known = newton_euler_along(equations, bodies, query);
  const Vector u = lower(program, query.direction);
  const std::vector<JointAction> joints = joint_actions(equations, say);
  TheoremEquation equation;
  equation.left = known.dynamic;
  equation.right = known.known + known.constraints;
  std::vector<const JointAction*> across;
  for (const JointAction& joint : joints) {
    const bool on_body = inside[as_index(joint.connection.bottom)];
    if (on_body == inside[as_index(joint.connection.from)]) continue;
    across.push_back(&joint);
    const Wrench wrench = as_asked(model, joint, query.screw);
    const bool resultant = query.theorem == Theorem::resultant;
    const Value along = dot(bound(program, resultant ? wrench.resultant : wrench.moment), u);
    if (on_body) {
      equation.right += along;
    } else {
      equation.right -= along;
    }
  }
  name_unknowns(equation, equations, across);
  return equation;
}

EnergyEquation energy_equation(const Equations& equations, const BodyNames& bodies, const FrameReference& observer,
                               const NaturalLanguage& say) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const std::string user = "the energy theorem";
  const std::vector<bool> inside = isolated_links(equations, bodies, user);
  const int reference = model.place(observer, user).link;
  EnergyEquation result;
  result.kinetic_energy = program.bind(kinetic_energy(model, bodies, observer));
  const EnergyTheorem without_joints = energy_theorem_without_joints(equations, bodies, observer);
  result.equation.left = without_joints.kinetic_rate;
  result.external_power = without_joints.external_power;
  result.internal_power = without_joints.internal_power;
  const std::vector<JointAction> joints = joint_actions(equations, say);
  std::vector<const JointAction*> concerned;
  for (const JointAction& joint : joints) {
    const int top = joint.connection.top, bottom = joint.connection.bottom, from = joint.connection.from;
    const bool on_body = inside[as_index(bottom)], on_parent = inside[as_index(from)];
    if (!on_body && !on_parent) continue;
    concerned.push_back(&joint);
    const Vector force = bound(program, model.express(joint.wrench.resultant, top, bottom));
    const Wrench wrench{force, bound(program, model.express(joint.wrench.moment, top, bottom))};
    const Twist of_joint = relative_twist(model, bottom, from);
    if (on_body && on_parent) {
      result.internal_power += reciprocal_product(wrench, of_joint);
      continue;
    }
    const Twist of_body = relative_twist(model, bottom, reference);
    // The opposite acts on the parent, at its own point there.
    result.external_power +=
        on_body
            ? reciprocal_product(wrench, of_body)
            : reciprocal_product(wrench, Twist{of_joint.angular - of_body.angular, of_joint.linear - of_body.linear});
  }
  result.equation.right = result.external_power + result.internal_power;
  name_unknowns(result.equation, equations, concerned);
  return result;
}

}  // namespace torsor
