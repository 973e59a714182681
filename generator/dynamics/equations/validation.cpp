// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"
#include "torsor/generator/dynamics/equations/contact_checks.hpp"
#include "torsor/generator/dynamics/equations/dependence_checks.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/friction_checks.hpp"
#include "torsor/generator/dynamics/equations/law_checks.hpp"
#include "torsor/generator/dynamics/equations/ownership_checks.hpp"
#include "torsor/generator/dynamics/equations/scene_checks.hpp"
#include "torsor/generator/dynamics/equations/start_error.hpp"
#include "torsor/generator/mechanics/axis_bounds.hpp"
#include "torsor/generator/mechanics/inertia_validity.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

constexpr int generic_digits = 50;

void check_coordinates(const Scene& scene) {
  const SceneContent& content = scene.content();
  for (const AttitudeContent& attitude : content.attitudes) {
    if (attitude.frame.empty()) {
      throw SceneError(fmt::format("attitude '{}' turns nothing: give it to a spherical, point_contact, "
                                   "sphere_in_cylinder or free joint",
                                   attitude.name));
    }
    if (attitude.initial && std::all_of(attitude.initial->begin(), attitude.initial->end(),
                                        [](const Expression& e) { return e.is_zero(); })) {
      throw SceneError(fmt::format("attitude '{}' starts from the null quaternion, which is no orientation: start from "
                                   "(1, 0, 0, 0)",
                                   attitude.name));
    }
  }
  for (const CoordinateContent& c : content.coordinates) {
    if (c.law && (c.initial_value || c.initial_rate)) {
      throw SceneError(fmt::format("coordinate '{}' is driven by the law {} and cannot also be an unknown with an "
                                   "initial value: drop initial('{}') or drive('{}')",
                                   c.q->name, c.law->to_string(), c.q->name, c.q->name));
    }
    if (c.law && c.released) {
      throw SceneError(fmt::format("coordinate '{}' is released, held at zero, and cannot follow a law of time", c.q->name));
    }
  }
  if (std::none_of(content.coordinates.begin(), content.coordinates.end(), [](const auto& c) { return c.unknown(); })) {
    throw SceneError(fmt::format("the scene '{}' has no unknown coordinate: nothing is left to derive; add "
                                 "coordinate(...) and use it in a joint",
                                 scene.name()));
  }
}

/// Every coordinate must appear in a joint, a released one as a joint's whole displacement.
void check_joints(const Model& model) {
  const auto& coordinates = model.coordinates();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const auto moves = [i](const Link& link) {
      return std::any_of(link.partials.begin(), link.partials.end(),
                         [i](const auto& partial) { return partial.first == static_cast<int>(i); });
    };
    if (std::any_of(model.links().begin(), model.links().end(), moves)) continue;
    throw SceneError(fmt::format("coordinate '{}' moves nothing: no joint uses it{}", coordinates[i].q->name,
                                 coordinates[i].released ? " in its displacement" : ""));
  }
}

/// Bodies on frames that move with a coordinate.
std::vector<const BodyContent*> bodies_moved_by(const Model& model, int coordinate) {
  std::vector<bool> moved(model.links().size(), false);
  for (std::size_t k = 1; k < moved.size(); ++k) {
    const Link& link = model.links()[k];
    moved[k] = moved[static_cast<std::size_t>(link.parent)];
    for (const auto& [i, partial] : link.partials) moved[k] = moved[k] || i == coordinate;
  }
  std::vector<const BodyContent*> bodies;
  for (const BodyContent* body : model.scene().inertias()) {
    if (moved[static_cast<std::size_t>(model.place(body->frame, body->name).link)]) bodies.push_back(body);
  }
  return bodies;
}

/// The same for the message about missing mass.
std::string moved_by(const Model& model, int coordinate) {
  std::string bodies;
  for (const BodyContent* body : bodies_moved_by(model, coordinate)) {
    const std::string name = model.scene().name_of(*body);
    const bool of_list = name.starts_with("body") && bodies.starts_with("body");
    bodies += bodies.empty() ? name : ", " + (of_list ? "'" + body->name + "'" : name);
  }
  return bodies.empty() ? "frames without any body" : bodies;
}

/// A state at which the mass matrix is looked at: the start, then its neighbourhood, then any. The last ones have other
/// values of the parameters too: one that can change may be zero in the scene.
Evaluator<Real>::SymbolValue tried_state(const SceneContent& scene, int trial) {
  return [&scene, trial](const SymbolPointer& symbol) {
    return at_unit_quaternions(symbol, [&scene, trial](const SymbolPointer& each) {
      const Real generic = generic_value(each, trial);
      const bool parameter = each->kind == SymbolKind::parameter;
      if (trial > 2 || (trial == 2 && !parameter)) return generic;
      const Real start = initial_value(scene, each, true);
      if (trial == 0 || parameter) return start;
      const Real step = generic / Real(64);
      return start.is_zero() ? step : start + start * step;
    });
  };
}

bool has_nan(const RealRow& row) {
  return std::any_of(row.begin(), row.end(), [](const Real& entry) { return entry.is_nan(); });
}

/// How many coordinates, from the first, have a pivot of M that is not zero at one of a few states. A pivot is what the
/// inertia along a coordinate leaves when those before it give way, no more than the diagonal entry and zero wherever
/// the matrix is singular at all states. Of the states the first ones have the parameters as they are, `tried` of five.
std::size_t regular_pivots(const Equations& equations, int tried) {
  const WorkingDigits precision(zero_tests::masses.digits);
  const ValueMatrix& mass = equations.mass();
  const std::size_t n = mass.size();
  std::size_t regular = 0;
  bool decided = false;
  for (int trial = 0; trial < tried && regular < n; ++trial) {
    Evaluator<Real> evaluate(equations.program(), tried_state(equations.scene().content(), trial));
    RealRows m;
    for (const auto& row : mass) m.push_back(evaluate(row));
    if (std::any_of(m.begin(), m.end(), has_nan)) continue;  // a length of zero may be a divisor: that is another fault
    decided = true;
    // Invented moments of inertia may be those of no matter, and the matrix indefinite.
    regular = std::max(regular, SymmetricPivots(std::move(m), zero_tests::masses.bound()).first_small());
  }
  return decided ? regular : n;
}

void require_masses(const Equations& equations, int tried) {
  if (equations.scene().content().keeps_massless) return;  // kernels that solve with the mass matrix look at it
  const Model& model = equations.model();
  const ValueMatrix& mass = equations.mass();
  const std::size_t n = mass.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::all_of(mass[i].begin(), mass[i].end(), [](const Value& m) { return identically_zero(m); })) continue;
    const auto bodies = bodies_moved_by(model, static_cast<int>(i));
    const bool on_axis = std::any_of(bodies.begin(), bodies.end(), [&](const BodyContent* body) {
      return !identically_zero(model.program().lower(body->inertia.mass));
    });
    throw SceneError(fmt::format("coordinate '{}' must accelerate but has no inertia: it moves {} {}, or drive the "
                                 "coordinate by a law of time",
                                 model.coordinates()[i].q->name, moved_by(model, static_cast<int>(i)),
                                 on_axis ? "whose mass lies on the axis; give a moment of inertia about it"
                                         : "with zero mass; give a mass"));
  }
  const std::size_t k = regular_pivots(equations, tried);
  if (k == n) return;
  throw SceneError(fmt::format("the mass matrix is singular at every state: coordinate '{}' can accelerate without moving "
                               "any mass; it moves {}: give masses or inertias, or remove a redundant coordinate",
                               model.coordinates()[k].q->name, moved_by(model, static_cast<int>(k))));
}

void check_reactions(const Equations& equations) {
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    const ConstraintRow& row = equations.constraints()[j];
    const auto& reaction = equations.scene().content().constraints[j].reaction;
    if (!reaction) continue;
    for (int i = 0; i < equations.model().unknown_count(); ++i) {
      Value difference = row.ideal[static_cast<std::size_t>(i)];
      difference -= row.jacobian[static_cast<std::size_t>(i)];
      if (identically_zero(difference)) continue;
      throw SceneError(fmt::format("reaction '{}' does not enforce constraint '{}': along coordinate '{}' its power is "
                                   "{} and the constraint needs {}; check the point and the direction",
                                   reaction->name, row.name, equations.model().coordinates()[static_cast<std::size_t>(i)].q->name,
                                   to_string(row.ideal[static_cast<std::size_t>(i)]),
                                   to_string(row.jacobian[static_cast<std::size_t>(i)])));
    }
  }
}

bool lacks_values(const Scene& scene) {
  const auto& parameters = scene.content().parameters;
  return std::any_of(parameters.begin(), parameters.end(), [](const auto& p) { return !p.value; });
}

/// A disc that lies flat has no lowest point; for any other constraint nothing is known.
std::string why_undefined(const SceneContent& scene, const ConstraintRow& row) {
  for (const ConstraintContent& constraint : scene.constraints) {
    if (constraint.name != row.name) continue;
    const PointReference* point = nullptr;
    if (const auto* in_plane = std::get_if<PointInPlane>(&constraint.law)) point = &in_plane->point;
    if (const auto* no_slip = std::get_if<NoSlip>(&constraint.law)) point = &no_slip->contact;
    if (point == nullptr) continue;
    const PointContent& contact = scene.points[as_index(scene.point_index(*point, row.name))];
    if (!contact.lowest || !contact.lowest->axis) continue;
    return fmt::format(": the disc of the point of contact '{}' lies flat there, and no point of its rim is the lowest",
                       contact.name);
  }
  return ": what it is made of is not defined there";
}

/// The unknowns of a constraint as the scene's `initial` takes them: coordinates, and attitudes by their own names.
std::string tied_coordinates(const Equations& equations, const ConstraintRow& row) {
  const Model& model = equations.model();
  std::vector<std::string> names;
  for (int i = 0; i < model.unknown_count(); ++i) {
    const CoordinateContent& coordinate = model.coordinates()[as_index(i)];
    if (identically_zero(row.jacobian[as_index(i)])) continue;
    const std::string& name = coordinate.attitude ? equations.scene().content().attitudes[as_index(*coordinate.attitude)].name
                                                  : coordinate.q->name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

void check_initial_state(const Equations& equations) {
  if (equations.constraints().empty() || lacks_values(equations.scene())) return;
  Evaluator<Real> evaluate(equations.program(), [&equations](const SymbolPointer& symbol) {
    return initial_value(equations.scene().content(), symbol);
  });
  const std::vector<ConstraintRow>& rows = equations.constraints();
  const ConstraintSizes sizes = constraint_sizes(equations.model(), rows);
  // Reaches a second; 1 at least, so that a rate of rounding is none where nothing moves.
  Real speed(1);
  for (std::size_t i = 0; i < sizes.reach.size(); ++i)
    speed = std::max(speed, abs(initial_value(equations.scene().content(), equations.model().coordinates()[i].v)) / sizes.reach[i]);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const ConstraintRow& row = rows[j];
    // Decimals given for irrational positions carry some twelve digits.
    const Real small = Real::from_double(1e-9) * sizes.size[j];
    const std::array<std::tuple<const Value*, Real, const char*>, 2> residuals{
        {{&row.value, small, "value"}, {&row.rate, small * speed, "rate"}}};
    for (const auto& [residual, tolerance, what] : residuals) {
      const Real off = evaluate(*residual);
      if (abs(off) <= tolerance) continue;
      const double size = off.to_double();
      if (off.is_nan()) {
        const SceneContent& scene = equations.scene().content();
        throw StartError(fmt::format("constraint '{}' has no {} at t = 0{}; {}{}", row.name, what, why_undefined(scene, row),
                                     another_start(scene),
                                     scene.origin.file.empty() ? ", or give the orientation by attitude(...)" : ""));
      }
      const Unit& unit = residual->unit();
      throw StartError(fmt::format("inconsistent initial state: constraint '{}' has the {} {:.6g}{} at t = 0 and must "
                                   "have 0; {} of the coordinates it ties: {}",
                                   row.name, what, size, unit.is_dimensionless() ? "" : " " + written_unit(unit),
                                   another_start(equations.scene().content()), tied_coordinates(equations, row)));
    }
  }
}

}  // namespace

void check_values(const SceneContent& scene) {
  const WorkingDigits precision(generic_digits);
  for (const ParameterContent& parameter : scene.parameters) {
    if (parameter.run_time) require_double(scene, parameter);
  }
  for (const BodyContent* body : scene.inertias()) check_inertia(scene, *body);
  require_bounds(scene, bounds_of_stated_sizes(scene));
  require_bounds(scene, bounds_of_axes(scene), WithoutValue::made_up);
  require_bounds(scene, bounds_of_frictions(scene));
  check_surfaces(scene);
}

void check_masses(const Scene& scene, const ModelOptions& options) {
  const WorkingDigits precision(generic_digits);
  const Equations equations(scene, options);
  require_masses(equations, 3);
}

void validate(const Scene& scene) {
  const WorkingDigits precision(generic_digits);
  check_ownership(scene);
  check_coordinates(scene);
  check_values(scene.content());
  check_shown_forms(scene.content());
  check_dependences(scene);
  const Equations equations(scene);
  check_joints(equations.model());
  check_laws(scene);
  check_slipping_bodies(equations.model());
  check_support_functions(equations.model());
  equations.actions();
  equations.constraints();
  require_masses(equations, 5);
  check_reactions(equations);
  equations.bias();
  for (std::size_t i = 0; i < scene.content().points.size(); ++i) {
    equations.model().locate(PointHandle{static_cast<int>(i)}, 0, name_of(scene.content().points[i]));
  }
  check_initial_state(equations);
  check_friction_normals(equations, !lacks_values(scene));
  check_contacts(equations);
  if (!lacks_values(scene)) check_closing_joints(equations);
  equations.redundancy();
}

std::vector<Real> initial_state(const Scene& scene) {
  if (lacks_values(scene)) return {};
  std::vector<Real> state;
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program);
  for (const SymbolPointer& q : model.positions()) state.push_back(initial_value(scene.content(), q));
  for (int i = 0; i < model.unknown_count(); ++i) {
    state.push_back(initial_value(scene.content(), model.coordinates()[static_cast<std::size_t>(i)].v));
  }
  return state;
}

}  // namespace torsor
