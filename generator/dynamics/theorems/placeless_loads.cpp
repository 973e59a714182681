// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/placeless_loads.hpp"

#include <algorithm>
#include <optional>
#include <utility>
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
#include "torsor/generator/expression/generic_form.hpp"
#include "torsor/generator/mechanics/measure.hpp"

namespace torsor {
namespace {

constexpr int states = 3;

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

/// Of those between points, which may be zero on one side of a place.
bool takes_forms(const ActionContent& action) {
  if (const auto* spring = std::get_if<PointSpring>(&action))
    return takes_forms(spring->stiffness) || takes_forms(spring->rest);
  if (const auto* attraction = std::get_if<Gravitation>(&action)) return takes_forms(attraction->strength);
  return false;
}

/// That of what a formula's force works with; none where it says energy.
std::optional<Unit> unit_of(const ActionContent& action) {
  if (std::holds_alternative<GivenForceFunction>(action)) return {};
  const Expression* formula = formula_of(action);
  return formula == nullptr ? std::nullopt : std::optional<Unit>(formula->unit());
}

std::optional<Unit> unit_of(const ConstraintLaw& law) {
  if (const auto* given = std::get_if<HolonomicFormula>(&law)) return given->f.unit();
  if (const auto* given = std::get_if<NonholonomicFormula>(&law)) return given->left_side.unit() * units::second;
  return {};
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

  /// Each coordinate along which a force may be, by what it is a function of: where the states looked at do not tell.
  RealRows by_structure(const std::vector<Value>& along_unknowns, const Expression* formula) const {
    RealRows rows;
    const std::size_t unknowns = as_index(model_.unknown_count()), all = unknowns + driven_.size();
    for (std::size_t i = 0; i < all; ++i) {
      const auto moves = [&](const CoordinateContent& c) {
        return formula != nullptr && (formula->depends_on(c.q) || formula->depends_on(c.v));
      };
      if (i < unknowns ? along_unknowns[i].is_zero() : !moves(driven_[i - unknowns])) continue;
      rows.emplace_back(all, Real(0));
      rows.back()[i] = Real(1);
    }
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

bool spanned(RealRows rows, const RealRows& others) {
  const std::size_t before = rank_of(rows);
  rows.insert(rows.end(), others.begin(), others.end());
  return rank_of(rows) == before;
}

bool overlap(const RealRow& a, const RealRow& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!a[i].is_zero() && !b[i].is_zero()) return true;
  }
  return false;
}

/// Rows of unknowns only.
RealRows without_driven(RealRows rows, int unknowns) {
  for (RealRow& row : rows) row.resize(as_index(unknowns));
  return rows;
}

class Reader {
 public:
  using Formula = PlacelessLoads::Formula;

  Reader(const Equations& equations, Gradients& gradients) : model_(equations.model()), gradients_(gradients) {}

  /// `takes_forms`: what it is along takes one of several, and no formula is known to put all of them into.
  Formula read(std::string name, std::vector<Value> along, const Expression* formula, std::optional<Unit> unit,
               bool forms = false) {
    Formula result{std::move(name), {}, unit, {}};
    Expression generic;
    const Expression* looked_at = formula;
    if (formula != nullptr) {
      note_measured(*formula, result);
      if (!forms && takes_forms(*formula)) {
        try {
          generic = generic_form(*formula);
          along = model_.partials(generic);
          looked_at = &generic;
        } catch (const Error&) {  // it has more operations than a formula may have
          forms = true;
        }
      }
    }
    bool seen = false;
    if (!forms) {
      for (RealRow& row : gradients_.everywhere(along, looked_at)) {
        seen = seen || !row.empty();
        result.forces.push_back(row.empty() ? RealRows{} : RealRows{std::move(row)});
      }
    }
    if (!seen) result.forces = {gradients_.by_structure(along, formula)};
    return result;
  }

 private:
  void note_measured(const Expression& formula, Formula& result) const {
    using Kind = MeasuredVector::Kind;
    const auto link = [&](int frame) { return model_.place(FrameHandle{frame}, result.name).link; };
    for (const SymbolPointer& symbol : formula.symbols()) {
      if (!symbol->measure) continue;
      const MeasuredVector& vector = *symbol->measure->vector;
      const SceneContent& scene = model_.scene();
      if (vector.kind == Kind::position) {
        const FrameReference& frame = scene.points[as_index(vector.point)].frame;
        result.measured.emplace_back(model_.place(frame, result.name).link, link(vector.axes));
      } else if (vector.kind == Kind::velocity) {
        result.measured.emplace_back(link(vector.frame), link(vector.relative_to));
      }
    }
  }

  const Model& model_;
  Gradients& gradients_;
};

}  // namespace

PlacelessLoads::PlacelessLoads(const Equations& equations, const std::vector<ContactRows>& contacts)
    : model_(equations.model()) {
  const WorkingDigits precision(zero_tests::reactions.digits);
  const SceneContent& scene = model_.scene();
  Gradients gradients(equations);
  Reader reader(equations, gradients);
  std::vector<const Expression*> displacements(model_.links().size(), nullptr);
  for (std::size_t f = 1; f < scene.frames.size(); ++f) {
    const FrameContent& frame = scene.frames[f];
    if (frame.joint != JointKind::revolute && frame.joint != JointKind::prismatic) continue;
    displacements[as_index(model_.place(FrameHandle{static_cast<int>(f)}, frame.name).link)] = &frame.displacement;
  }
  const std::vector<bool> rotor = rotor_links(model_);
  joints_.assign(states, RealRows(model_.links().size()));
  units_.resize(model_.links().size());
  for (std::size_t k = 1; k < model_.links().size(); ++k) {
    const Link& link = model_.links()[k];
    if (rotor[k]) {
      formulas_.push_back(reader.read(fmt::format("reflected inertia '{}'", link.name), gradients.of(link),
                                      displacements[k], Unit()));
      continue;
    }
    if (displacements[k] != nullptr) units_[k] = displacements[k]->unit();
    const std::vector<RealRow> rows = gradients.everywhere(gradients.of(link), displacements[k]);
    for (std::size_t state = 0; state < rows.size(); ++state) joints_[state][k] = rows[state];
  }
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    if (constraint_wrench(model_, static_cast<int>(j))) continue;
    const ConstraintRow& row = equations.constraints()[j];
    const ConstraintLaw& law = scene.constraints[j].law;
    const Expression* formula = formula_of(law);
    const bool forms = !row.holonomic && formula != nullptr && takes_forms(*formula);
    formulas_.push_back(reader.read(fmt::format("constraint '{}'", row.name), row.jacobian, formula, unit_of(law), forms));
  }
  for (const ActionContent& action : scene.actions) {
    const Expression* formula = formula_of(action);
    if (formula == nullptr && !works_on_formula(model_, action)) continue;
    const std::vector<Value> along =
        formula != nullptr
            ? model_.partials(*formula)
            : applied_actions(model_, [&action](const ActionContent& each) { return &each == &action; }).passive;
    formulas_.push_back(reader.read(fmt::format("action '{}'", name_of(action)), along, formula, unit_of(action),
                                    takes_forms(action)));
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const ContactGeometry& geometry = scene.contacts[k].geometry;
    const Expression* formula = formula_of(geometry);
    if (formula == nullptr) continue;
    const char* kind = std::holds_alternative<Stop>(geometry) ? "stop" : "dry friction";
    formulas_.push_back(reader.read(fmt::format("{} '{}'", kind, contacts[k].name), contacts[k].rows[0].jacobian, formula,
                                    formula->unit()));
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
  result.inside = inside;
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

namespace {

constexpr const char* ties = "a formula that ties joints has no place in space";

}  // namespace

bool PlacelessLoads::has_unit_of(const std::vector<std::size_t>& links, std::size_t state, const Formula& formula) const {
  if (!formula.unit) return true;
  return std::any_of(links.begin(), links.end(), [&](std::size_t link) {
    const RealRows& forces = formula.forces[state];
    return units_[link] == *formula.unit && std::any_of(forces.begin(), forces.end(), [&](const RealRow& force) {
             return overlap(joints_[state][link], force);
           });
  });
}

const char* PlacelessLoads::reason(const Sides& sides, std::size_t state, const Formula& formula) const {
  RealRows forces = formula.forces[state];
  if (forces.empty()) return nullptr;
  RealRows own = rows_of(sides.own, state), carried = rows_of(sides.carried, state),
           others = rows_of(sides.others, state);
  RealRows all = own;
  all.insert(all.end(), carried.begin(), carried.end());
  all.insert(all.end(), others.begin(), others.end());
  if (!spanned(all, forces)) {
    // It follows a law of time that moves no joint, or coordinates that move none: the ends of massless sliders.
    const int unknowns = model_.unknown_count();
    for (RealRows* rows : {&own, &carried, &others}) *rows = without_driven(std::move(*rows), unknowns);
    for (RealRow& force : forces) {
      for (std::size_t i = 0; i < force.size(); ++i) {
        if (std::none_of(all.begin(), all.end(), [i](const RealRow& joint) { return !joint[i].is_zero(); }))
          force[i] = Real(0);
      }
    }
    forces = without_driven(std::move(forces), unknowns);
  }
  if (spanned(others, forces)) return nullptr;
  const bool of_own = spanned(own, forces);
  if (!of_own && !spanned(carried, forces)) return ties;
  if (has_unit_of(of_own ? sides.own : sides.carried, state, formula)) return nullptr;
  return "a formula in another unit than the joint that it moves, as that of a rope pulled by hand, has no place in space";
}

const char* PlacelessLoads::reason(const Sides& sides, const Formula& formula) const {
  for (const auto& [a, b] : formula.measured) {
    if (sides.inside[as_index(a)] != sides.inside[as_index(b)])
      return "a formula of a measured position or velocity works at a point that it does not name";
  }
  for (std::size_t state = 0; state < formula.forces.size(); ++state) {
    if (const char* found = reason(sides, state, formula)) return found;
  }
  return nullptr;
}

void PlacelessLoads::refuse(const ContactRows& friction) const {
  const WorkingDigits precision(zero_tests::reactions.digits);
  const Sides of_joint = sides(*friction.joint);
  for (const Formula& formula : formulas_) {
    const char* found = reason(of_joint, formula);
    if (found == nullptr) continue;
    throw SceneError(fmt::format(
        "the friction '{}' is in proportion to what its joint transmits across its axis, and how much of that the {} adds is "
        "not said: {}; give a rope or a gear by no_slip, a loop by closure, a spring or a force between points, the reaction "
        "of a constraint by reaction, or the bound of a dry_friction",
        friction.name, formula.name, found));
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
