// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/friction_checks.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/dynamics/equations/configuration_sample.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"

namespace torsor {
namespace {

/// The direction that a constraint names for its force; nothing for a formula without a reaction.
const Triple* named_direction(const ConstraintContent& constraint) {
  if (constraint.reaction) return &constraint.reaction->direction;
  if (const auto* closure = std::get_if<Closure>(&constraint.law)) return &closure->direction;
  if (const auto* no_slip = std::get_if<NoSlip>(&constraint.law)) return &no_slip->direction;
  return nullptr;
}

/// One friction and its constraint, in formulas.
class NormalCheck {
 public:
  NormalCheck(const Equations& equations, const ContactFriction& friction)
      : model_(equations.model()),
        constraint_(equations.scene().content().constraints[static_cast<std::size_t>(friction.constraint)]),
        row_(equations.constraints()[static_cast<std::size_t>(friction.constraint)]),
        user_("friction '" + friction.name + "'") {
    Program& program = model_.program();
    const int axes = model_.place(friction.axes, user_).link;
    const RelativeMotion contact(model_, model_.place(friction.body, user_).link, model_.place(friction.other, user_).link,
                                 model_.see(*friction.point, axes, user_));
    for (int k = 0; k < 3; ++k) {
      Wrench unit;
      unit.resultant[k] = program.number(Number(1));
      unit_forces_.push_back(contact.generalised_forces(unit));
    }
    slip_ = listed(model_.express(friction.direction, friction.axes, axes, user_));
    if (const Triple* direction = named_direction(constraint_)) named_ = listed(lower(program, *direction));
  }

  void look_from(ConfigurationSample& at, const char* where) const {
    RealRows forces;
    for (const std::vector<Value>& each : unit_forces_) forces.push_back(at(each));
    const RealRows effects = transposed(forces, forces[0].size());
    const RealRow wanted = at(row_.ideal), normal = least_norm_solution({effects, wanted, 3}, tolerance_);
    if (std::any_of(normal.begin(), normal.end(), [](const Real& n) { return n.is_nan(); })) return;  // no contact there
    require_force_at_the_point(effects, wanted, normal);
    const bool is_plane = std::holds_alternative<PointInPlane>(constraint_.law);
    const std::optional<Real> given = named_ ? std::optional(length(at(*named_))) : is_plane ? std::optional(Real(1)) : std::nullopt;
    require_unit(given, length(normal), rank(effects, 3, tolerance_) == 3, where);
    // What the point cannot do shows no part of n: where all of n is seen, it is a unit vector.
    const RealRow slip = at(slip_);
    if (length(normal) < Real(1) - tolerance_ || !(abs(product(slip, normal)) > tolerance_ * length(slip))) return;
    throw SceneError(fmt::format("the direction of {} is not across the normal of constraint '{}' in {}: friction acts in the "
                                 "tangential plane; give a direction in it",
                                 user_, row_.name, where));
  }

 private:
  static std::vector<Value> listed(const Vector& vector) { return {vector[0], vector[1], vector[2]}; }

  void require_force_at_the_point(const RealRows& effects, const RealRow& wanted, const RealRow& normal) const {
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (abs(product(effects[i], normal) - wanted[i]) <= tolerance_ * (length(effects[i]) + abs(wanted[i]))) continue;
      const std::string& name = model_.coordinates()[i].v->name;
      if (i >= static_cast<std::size_t>(model_.unknown_count()) && !constraint_.reaction) {
        throw SceneError(
            fmt::format("{} takes the multiplier of constraint '{}' for a normal force, whose effect on the released '{}' its "
                        "formula does not give: write it by point_in_plane(...) or closure(...), or name its reaction(...)",
                        user_, row_.name, name));
      }
      throw SceneError(
          fmt::format("{} takes the multiplier of constraint '{}' for the normal force at its point, and no force there does "
                      "what that multiplier does to '{}': give the point at which the constraint's force acts",
                      user_, row_.name, name));
    }
  }

  /// A part of n along what cannot move is not seen: then a formula's n may be longer than it seems.
  void require_unit(const std::optional<Real>& given, const Real& seen, bool all_seen, const char* where) const {
    const Real size = given ? *given : seen;
    if (size <= Real(1) + tolerance_ && (size >= Real(1) - tolerance_ || !(given || all_seen))) return;
    throw SceneError(
        fmt::format("{} needs the normal force of its contact, and the multiplier of constraint '{}' is {:.6g} times that in {}: "
                    "write the constraint as the distance itself, with a rate of 1 along the normal, (z - h)/sqrt(1 + h'^2) "
                    "for z = h(x)",
                    user_, row_.name, (Real(1) / size).to_double(), where));
  }

  const Model& model_;
  const ConstraintContent& constraint_;
  const ConstraintRow& row_;
  const std::string user_;
  std::vector<std::vector<Value>> unit_forces_;  ///< row k: what a unit force along axis k does to each coordinate
  std::vector<Value> slip_;
  std::optional<std::vector<Value>> named_;
  // Decimals that are given for an irrational position carry some twelve digits.
  const Real tolerance_ = Real::from_double(1e-9);
};

/// A configuration that fulfils the holonomic constraints, away from the start: on a curved surface a formula may have a
/// rate of 1 along the normal where it starts, and nowhere else.
std::optional<ConfigurationSample> elsewhere(const Equations& equations) {
  const Model& model = equations.model();
  ConfigurationSample at(model);
  const Real extent = at.extent(units::metre), reach = extent > Real(0) ? extent : Real(1);
  const auto n = static_cast<std::size_t>(model.unknown_count());
  RealRow move;
  for (std::size_t i = 0; i < n; ++i) {
    const Real part = Real::from_double(0.13 + 0.07 * static_cast<double>(i % 5));
    move.push_back(model.coordinates()[i].q->unit == units::metre ? part * reach : part);
  }
  at.displace(move);
  for (int iteration = 0; iteration < 40; ++iteration) {
    RealRows rows;
    RealRow left;
    bool closed = true;
    for (const ConstraintRow& row : equations.constraints()) {
      if (!row.holonomic) continue;
      rows.push_back(at(row.jacobian));
      left.push_back(-at(row.value));
      if (left.back().is_nan()) return std::nullopt;
      closed = closed && abs(left.back()) <= Real::from_double(1e-20) * length(rows.back()) * reach;
      rows.back().resize(n);  // released coordinates stay
    }
    if (closed) return at;
    at.displace(least_norm_solution({rows, left, n}, Real::from_double(1e-12)));
  }
  return std::nullopt;
}

}  // namespace

void check_friction_normals(const Equations& equations, bool start_is_known) {
  const SceneContent& scene = equations.scene().content();
  std::optional<ConfigurationSample> start, away;
  for (const ContactFriction& friction : scene.frictions) {
    if (!friction.point) continue;
    const NormalCheck check(equations, friction);
    if (!start) {
      start.emplace(equations.model());
      away = elsewhere(equations);
    }
    if (start_is_known) check.look_from(*start, "the initial configuration");
    if (away) check.look_from(*away, "another configuration");
  }
}

}  // namespace torsor
