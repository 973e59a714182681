// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/placeless_loads.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/forces/actions.hpp"
#include "torsor/generator/dynamics/forces/bearing_loads.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/expression/expression_derivative.hpp"

namespace torsor {
namespace {

constexpr int states = 3;  // a law may be zero on one side of a place

/// What an action does with, as its author wrote it; null of those between points.
const Expression* formula_of(const ActionContent& action) {
  if (const auto* spring = std::get_if<ElongationSpring>(&action)) return &spring->elongation;
  if (const auto* damper = std::get_if<ElongationDamper>(&action)) return &damper->elongation;
  if (const auto* motor = std::get_if<Motor>(&action)) return &motor->displacement;
  if (const auto* given = std::get_if<GivenForceFunction>(&action)) return &given->force_function;
  if (const auto* force = std::get_if<GeneralisedForce>(&action)) return &force->displacement;
  return nullptr;
}

const Expression* formula_of(const ConstraintLaw& law) {
  if (const auto* given = std::get_if<HolonomicFormula>(&law)) return &given->f;
  if (const auto* given = std::get_if<NonholonomicFormula>(&law)) return &given->left_side;
  return nullptr;
}

const Expression* formula_of(const ContactGeometry& geometry) {
  if (const auto* stop = std::get_if<Stop>(&geometry)) return &stop->displacement;
  if (const auto* friction = std::get_if<FrictionAlong>(&geometry)) return &friction->displacement;
  return nullptr;
}

/// Gradients at generic states: along the unknowns, and along coordinates that a law of time drives, which move joints
/// too.
class Gradients {
 public:
  explicit Gradients(const Equations& equations) : model_(equations.model()) {
    for (int state = 0; state < states; ++state) places_.push_back(at_generic_state(equations, state));
    for (const CoordinateContent& c : model_.scene().coordinates) {
      if (c.law) driven_.push_back(c);
    }
  }

  RealRow at(int state, const std::vector<Value>& along_unknowns, const Expression* formula) {
    Evaluator<Real>& here = places_[as_index(state)];
    RealRow row;
    for (int i = 0; i < model_.unknown_count(); ++i) row.push_back(here(along_unknowns[as_index(i)]));
    for (const CoordinateContent& c : driven_) {
      Expression partial;
      if (formula != nullptr)
        partial = formula->depends_on(c.v) ? partial_derivative(*formula, c.v) : partial_derivative(*formula, c.q);
      row.push_back(here(model_.program().lower(partial)));
    }
    const Real size = length(row);
    if (size.is_nan() || size.is_zero()) return {};  // it says nothing there
    for (Real& entry : row) entry /= size;
    return row;
  }

  std::vector<RealRow> everywhere(const std::vector<Value>& along_unknowns, const Expression* formula) {
    std::vector<RealRow> rows;
    for (int state = 0; state < states; ++state) rows.push_back(at(state, along_unknowns, formula));
    return rows;
  }

  std::vector<Value> of(const Link& link) const {
    std::vector<Value> partials(as_index(model_.unknown_count()));
    for (const auto& [i, partial] : link.partials) {
      if (i < model_.unknown_count()) partials[as_index(i)] = partial;
    }
    return partials;
  }

 private:
  const Model& model_;
  std::vector<Evaluator<Real>> places_;
  std::vector<CoordinateContent> driven_;
};

std::size_t rank_of(const RealRows& rows) {
  return rows.empty() ? 0 : rank(rows, rows.front().size(), zero_tests::reactions.bound());
}

bool spanned(RealRows rows, const RealRow& row) {
  const std::size_t before = rank_of(rows);
  rows.push_back(row);
  return rank_of(rows) == before;
}

/// Rows of unknowns only.
RealRows without_driven(RealRows rows, int unknowns) {
  for (RealRow& row : rows) row.resize(as_index(unknowns));
  return rows;
}

}  // namespace

PlacelessLoads::PlacelessLoads(const Equations& equations, const std::vector<ContactRows>& contacts)
    : model_(equations.model()) {
  const WorkingDigits precision(zero_tests::reactions.digits);
  const SceneContent& scene = model_.scene();
  Gradients gradients(equations);
  std::vector<const Expression*> displacements(model_.links().size(), nullptr);
  for (std::size_t f = 1; f < scene.frames.size(); ++f) {
    const FrameContent& frame = scene.frames[f];
    if (frame.joint != JointKind::revolute && frame.joint != JointKind::prismatic) continue;
    displacements[as_index(model_.place(FrameHandle{static_cast<int>(f)}, frame.name).link)] = &frame.displacement;
  }
  const std::vector<bool> rotor = rotor_links(model_);
  joints_.assign(states, RealRows(model_.links().size()));
  for (std::size_t k = 1; k < model_.links().size(); ++k) {
    const Link& link = model_.links()[k];
    const std::vector<RealRow> rows = gradients.everywhere(gradients.of(link), displacements[k]);
    if (rotor[k]) {
      formulas_.push_back({fmt::format("reflected inertia '{}'", link.name), rows});
    } else {
      for (std::size_t state = 0; state < rows.size(); ++state) joints_[state][k] = rows[state];
    }
  }
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    if (constraint_wrench(model_, static_cast<int>(j))) continue;
    const ConstraintRow& row = equations.constraints()[j];
    formulas_.push_back({fmt::format("constraint '{}'", row.name),
                         gradients.everywhere(row.jacobian, formula_of(scene.constraints[j].law))});
  }
  for (const ActionContent& action : scene.actions) {
    const Expression* formula = formula_of(action);
    if (formula == nullptr && !works_on_formula(model_, action)) continue;
    const std::vector<Value> along =
        formula != nullptr
            ? model_.partials(*formula)
            : applied_actions(model_, [&action](const ActionContent& each) { return &each == &action; }).passive;
    formulas_.push_back({fmt::format("action '{}'", name_of(action)), gradients.everywhere(along, formula)});
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const ContactGeometry& geometry = scene.contacts[k].geometry;
    const Expression* formula = formula_of(geometry);
    if (formula == nullptr) continue;
    const char* kind = std::holds_alternative<Stop>(geometry) ? "stop" : "dry friction";
    formulas_.push_back(
        {fmt::format("{} '{}'", kind, contacts[k].name), gradients.everywhere(contacts[k].rows[0].jacobian, formula)});
  }
}

// A screw and a cylinder turn about the axis along which they slide: what couples both acts along it.
PlacelessLoads::Sides PlacelessLoads::sides(int joint) const {
  const std::vector<bool> inside = carried_links(model_, joint);
  std::vector<bool> own(inside.size(), false);
  own[as_index(joint)] = true;
  for (const JointContent& each : model_.scene().joints) {
    if (!each.of_tree || (each.type != JointType::helical && each.type != JointType::cylindrical)) continue;
    std::vector<std::size_t> links;
    for (int f = each.of_tree->first; f <= each.of_tree->last; ++f) {
      if (model_.scene().frames[as_index(f)].joint == JointKind::weld) continue;
      links.push_back(as_index(model_.place(FrameHandle{f}, each.name).link));
    }
    if (std::find(links.begin(), links.end(), as_index(joint)) == links.end()) continue;
    for (const std::size_t link : links) own[link] = true;
  }
  Sides result;
  for (std::size_t k = 1; k < inside.size(); ++k)
    (own[k] ? result.own : inside[k] ? result.carried : result.others).push_back(k);
  return result;
}

RealRows PlacelessLoads::rows_of(const std::vector<std::size_t>& links, std::size_t state) const {
  RealRows rows;
  for (const std::size_t link : links) {
    if (!joints_[state][link].empty()) rows.push_back(joints_[state][link]);
  }
  return rows;
}

bool PlacelessLoads::may_load(const Sides& sides, std::size_t state, const RealRow& row) const {
  RealRows own = rows_of(sides.own, state), carried = rows_of(sides.carried, state),
           others = rows_of(sides.others, state);
  const auto on_one_side = [&](const RealRow& force) {
    return spanned(own, force) || spanned(carried, force) || spanned(others, force);
  };
  RealRows all = own;
  all.insert(all.end(), carried.begin(), carried.end());
  all.insert(all.end(), others.begin(), others.end());
  if (spanned(all, row)) return !on_one_side(row);
  // It follows a law of time that moves no joint, or coordinates that move none: the ends of massless sliders.
  const int unknowns = model_.unknown_count();
  for (RealRows* rows : {&own, &carried, &others}) *rows = without_driven(std::move(*rows), unknowns);
  RealRow rest = row;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const bool moves = std::any_of(all.begin(), all.end(), [i](const RealRow& joint) { return !joint[i].is_zero(); });
    if (!moves) rest[i] = Real(0);
  }
  rest.resize(as_index(unknowns));
  return !on_one_side(rest);
}

void PlacelessLoads::refuse(const ContactRows& friction) const {
  const WorkingDigits precision(zero_tests::reactions.digits);
  const Sides of_joint = sides(*friction.joint);
  for (const Formula& formula : formulas_) {
    for (std::size_t state = 0; state < formula.rows.size(); ++state) {
      if (formula.rows[state].empty() || !may_load(of_joint, state, formula.rows[state])) continue;
      throw SceneError(fmt::format(
          "the friction '{}' is in proportion to what its joint transmits across its axis, and how much of that the {} adds is not "
          "said: a formula that ties joints has no place in space; give a rope or a gear by no_slip, a loop by closure, a spring "
          "or a force between points, the reaction of a constraint by reaction, or the bound of a dry_friction",
          friction.name, formula.name));
    }
  }
  refuse_shared_coordinates(friction);
}

// Displacements of joints that depend on each other hide a transmission, whose forces are those of a formula.
void PlacelessLoads::refuse_shared_coordinates(const ContactRows& friction) const {
  const Sides of_joint = sides(*friction.joint);
  const auto unknowns_of = [&](const std::vector<std::size_t>& links) {
    return without_driven(rows_of(links, 0), model_.unknown_count());
  };
  RealRows all;
  std::size_t apart = 0;
  for (const auto* links : {&of_joint.own, &of_joint.carried, &of_joint.others}) {
    const RealRows rows = unknowns_of(*links);
    apart += rank_of(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (rank_of(all) == apart) return;
  throw SceneError(fmt::format(
      "the friction '{}' is in proportion to what its joint transmits across its axis, and one coordinate moves that joint "
      "together with others: what ties them has no place in space, and how much of that it adds is not said; give each joint a "
      "coordinate of its own and tie them by no_slip or closure, or give the bound of a dry_friction",
      friction.name));
}

}  // namespace torsor
