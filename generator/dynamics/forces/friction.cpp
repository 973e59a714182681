// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/friction.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"

namespace torsor {
namespace {

/// direction/|direction|, or over the length that is given for it, in the axes of a link.
Vector unit_direction(const Model& model, const ContactFriction& friction, int axes, const std::string& user) {
  Program& program = model.program();
  // In the axes in which it is given its length shows best: a turn adds sines and cosines that cancel.
  const Vector given = lower(program, friction.direction);
  const Value square = program.bind(dot(given, given));
  if (square.is_zero()) {
    throw SceneError(
        fmt::format("the direction of {} is the null vector: give the direction of the relative motion", user));
  }
  if (!friction.length.is_zero()) {  // divided before it is turned: a component beside the length that holds its square
    const Value inverse = program.bind(pow(program.lower(friction.length), -1));
    const FramePlace& at = model.place(friction.axes, user);
    return bound(program, model.express(at.rotation * bound(program, inverse * given), at.link, axes));
  }
  const Vector turned = model.express(friction.direction, friction.axes, axes, user);
  if (square.is_number(1)) return turned;
  const Value length = program.sqrt(square);
  const Value inverse = program.bind(pow(length, -1));
  return bound(program, inverse * turned);
}

ConstraintRow& row_of(const Model& model, const ContactFriction& friction, std::vector<ConstraintRow>& rows,
                      const std::string& user) {
  const ConstraintContent& normal = model.scene().constraints[static_cast<std::size_t>(friction.constraint)];
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const ConstraintRow& r) { return r.multiplier == normal.multiplier; });
  if (row->multiplier->unit == units::newton) return *row;
  throw SceneError(
      fmt::format("{} needs the normal force of its contact, and the multiplier of constraint '{}' is in {}: "
                  "write the constraint as a distance [m], or as a velocity along the normal",
                  user, row->name, row->multiplier->unit.to_string()));
}

}  // namespace

void add_friction(const Model& model, std::vector<ConstraintRow>& rows) {
  Program& program = model.program();
  for (const ContactFriction& friction : model.scene().frictions) {
    const std::string user = "friction '" + friction.name + "'";
    ConstraintRow& row = row_of(model, friction, rows, user);
    const int axes = model.place(friction.axes, user).link;
    const int body = model.place(friction.body, user).link;
    const int other = model.place(friction.other, user).link;
    if (body == other) {
      throw SceneError(fmt::format("{} acts between two frames of one rigid body: nothing slips there", user));
    }
    const Vector direction = unit_direction(model, friction, axes, user);
    const SeenPoint point = friction.point ? model.see(*friction.point, axes, user) : SeenPoint{{axes, {}}, axes};
    const Vector effort = bound(program, -(program.lower(friction.coefficient) * direction));
    const Wrench unit = friction.point ? Wrench{effort, Vector()} : Wrench{Vector(), effort};
    const RelativeMotion contact(model, body, other, point);
    const std::vector<Value> forces = contact.generalised_forces(unit);
    for (std::size_t i = 0; i < forces.size(); ++i) row.column[i] = program.bind(row.column[i] + forces[i]);
    row.friction = true;
    row.friction_power = program.bind(row.friction_power + reciprocal_product(unit, contact.twist()));
  }
}

}  // namespace torsor
