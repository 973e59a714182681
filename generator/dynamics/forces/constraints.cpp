// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/constraints.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/closure_wrench.hpp"
#include "torsor/generator/dynamics/forces/friction.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

class RowBuilder {
 public:
  RowBuilder(const Model& model, const std::string& user, ConstraintRow& row)
      : model_(model), program_(model.program()), user_(user), row_(row) {}

  void operator()(const HolonomicFormula& law) {
    refuse_released(law.f);
    holonomic(model_.of_configuration(law.f, user_));
  }

  void operator()(const Closure& law) {
    const SeenPoint a = model_.see(law.a, 0, user_), b = model_.see(law.b, 0, user_);
    const Vector ab = bound(program_, model_.between(a.base, b.base, 0) + b.beyond - a.beyond);
    const Vector direction = lower(program_, law.direction);
    refuse_null(direction);
    holonomic(dot(ab, direction));
    const std::vector<Value> of_a = partial_velocities(model_, link_of(law.a), a, direction);
    const std::vector<Value> of_b = partial_velocities(model_, link_of(law.b), b, direction);
    fill_released(of_b, of_a);
  }

  void operator()(const NonholonomicFormula& law) {
    refuse_released(law.left_side);
    row_.rate = program_.bind(program_.lower(law.left_side));
    for (const CoordinateContent& c : model_.coordinates()) {
      row_.jacobian.push_back(program_.bind(partial_derivation(program_, c.v)(row_.rate)));
    }
    for (const Value& entry : row_.jacobian) {
      if (program_.stage(entry) <= Stage::configuration) continue;
      throw SceneError(fmt::format("{} is not linear in the velocities: its left-hand side must be Σ a(q, t) q̇ − b(q, t)",
                                   user_));
    }
  }

  void operator()(const NoSlip& law) {
    const int axes = model_.place(law.axes, user_).link;
    const int link = model_.place(law.body, user_).link;
    const SeenPoint point = model_.see(law.contact, axes, user_);
    refuse_null(lower(program_, law.direction));
    const Vector direction = model_.express(law.direction, law.axes, axes, user_);
    const int on = model_.place(law.on, user_).link;
    row_.jacobian = partial_velocities(model_, link, point, direction);
    if (on != 0) subtract(row_.jacobian, partial_velocities(model_, on, point, direction));
    // Each joint contributes its own rate: laws of time included.
    Value rate = velocity(link, point, direction);
    if (on != 0) rate -= velocity(on, point, direction);
    row_.rate = program_.bind(rate);
  }

  void operator()(const PointInPlane& law) {
    const FramePlace& at = model_.place(law.plane, user_);
    const Vector normal = bound(program_, model_.express(axis::z, law.plane, at.link, user_));
    const SceneContent& scene = model_.scene();
    const PointContent& content = scene.points[static_cast<std::size_t>(scene.point_index(law.point, user_))];
    const bool own_plane =
        content.lowest && scene.frame_index(content.lowest->plane, user_) == scene.frame_index(law.plane, user_);
    if (own_plane) {
      holonomic(model_.lowest_height(content, at.link, user_));
    } else {
      const Vector height = bound(program_, model_.locate(law.point, at.link, user_) - at.origin);
      holonomic(dot(height, normal));
    }
    release(link_of(law.point), at.link, model_.see(law.point, at.link, user_), normal);
  }

  void operator()(const JointClosure& law) {
    const FramePlace& at_a = model_.place(law.a, user_);
    const FramePlace& at_b = model_.place(law.b, user_);
    const int axes = at_a.link;
    const Vector b = bound(program_, model_.locate(at_b.origin, at_b.link, axes));
    const Vector ab = bound(program_, b - at_a.origin);
    const Vector a_i = frame_axis(model_, at_a, law.i, axes);
    switch (law.kind) {
      case JointClosure::Kind::offset:
        holonomic(dot(ab, a_i));
        break;
      case JointClosure::Kind::alignment: {
        const Vector b_j = frame_axis(model_, at_b, law.j, axes);
        holonomic(Number(law.sign) * dot(a_i, b_j));
        break;
      }
      case JointClosure::Kind::screw: {
        const Value pitch = program_.lower(law.pitch);
        const Value angle = program_.bind(dot(ab, a_i) / pitch);
        const Value sine = program_.sin(angle);
        const Value cosine = program_.cos(angle);
        const Vector b_y = frame_axis(model_, at_b, 1, axes);
        const Vector a_y = frame_axis(model_, at_a, 1, axes);
        const Value along_y = program_.bind(dot(a_y, b_y));
        const Vector a_z = frame_axis(model_, at_a, 2, axes);
        const Value along_z = program_.bind(dot(a_z, b_y));
        const Value difference = program_.bind(sine * along_y - cosine * along_z);
        holonomic(pitch * difference);
        break;
      }
    }
    if (model_.released_count() == 0) return;
    const ClosureWrench wrench = closure_wrench(model_, law, user_);
    release(at_b.link, at_a.link, wrench.point, wrench.at_point.resultant);
    release_turn(at_b.link, at_a.link, wrench.at_point.moment, axes);
  }

  void refuse_null(const Vector& direction) const {
    if (!program_.bind(dot(direction, direction)).is_zero()) return;
    throw SceneError(fmt::format("the direction of {} is the null vector, along which nothing is held: give the direction",
                                 user_));
  }

  /// Velocity along a direction of the point of a link that is there, all joints at their rates.
  Value velocity(int link, const SeenPoint& point, const Vector& direction) const {
    Value sum;
    for (const int k : model_.chain(link)) {
      const Link& joint = model_.links()[static_cast<std::size_t>(k)];
      const Value part = joint_velocity(k, point, direction);
      sum += part * joint.rate;
    }
    return sum;
  }

  /// Velocity of the point along the direction for a unit rate of one joint.
  Value joint_velocity(int k, const SeenPoint& point, const Vector& direction) const {
    const Link& joint = model_.links()[static_cast<std::size_t>(k)];
    const int axes = point.axes;
    const Vector axis = model_.express(model_.axis_in_parent(joint), joint.parent, axes);
    if (joint.joint == JointKind::prismatic) return program_.bind(dot(axis, direction));
    return program_.bind(dot(bound(program_, cross(axis, model_.arm_of(k, point))), direction));
  }

 private:
  /// A released coordinate is zero in every formula: its part of a constraint would be lost without a word.
  void refuse_released(const Expression& formula) const {
    for (const CoordinateContent& c : model_.coordinates()) {
      if (!c.released || !(formula.depends_on(c.q) || formula.depends_on(c.v))) continue;
      throw SceneError(fmt::format("{} names the released coordinate '{}', which its joint holds at zero: write the "
                                   "constraint without it",
                                   user_, c.q->name));
    }
  }

  int link_of(const PointReference& point) const {
    const SceneContent& scene = model_.scene();
    return model_.place(scene.points[static_cast<std::size_t>(scene.point_index(point, user_))].frame, user_).link;
  }

  void subtract(std::vector<Value>& a, const std::vector<Value>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = program_.bind(a[i] - b[i]);
  }

  /// A released coordinate is held at zero and cannot be differentiated by: its joint's own twist moves the ends.
  void fill_released(const std::vector<Value>& of_b, const std::vector<Value>& of_a) {
    if (!model_.options().hold_released) return;  // a coordinate like any other, differentiated by already
    for (auto i = static_cast<std::size_t>(model_.unknown_count()); i < of_a.size(); ++i) {
      row_.jacobian[i] = program_.bind(row_.jacobian[i] + of_b[i] - of_a[i]);
    }
  }

  void release(int b, int a, const SeenPoint& point, const Vector& direction) {
    if (model_.released_count() == 0) return;
    const std::vector<Value> of_b = partial_velocities(model_, b, point, direction);
    const std::vector<Value> of_a = partial_velocities(model_, a, point, direction);
    fill_released(of_b, of_a);
  }

  void release_turn(int b, int a, const Vector& moment, int axes) {
    if (model_.released_count() == 0) return;
    const std::vector<Value> of_b = partial_turns(model_, b, moment, axes);
    const std::vector<Value> of_a = partial_turns(model_, a, moment, axes);
    fill_released(of_b, of_a);
  }

  void holonomic(const Value& f) {
    row_.holonomic = true;
    row_.value = program_.bind(f);
    row_.rate = program_.bind(time_derivative(row_.value));
    for (std::size_t i = 0; i < model_.coordinates().size(); ++i) {
      Derivation along = model_.along(static_cast<int>(i));
      row_.jacobian.push_back(program_.bind(along(row_.value)));
    }
  }

  const Model& model_;
  Program& program_;
  std::string user_;
  ConstraintRow& row_;
};

}  // namespace

std::vector<Value> partial_velocities(const Model& model, int link, const SeenPoint& point,
                                      const Vector& direction) {
  Program& program = model.program();
  ConstraintRow unused;
  const RowBuilder builder(model, "partial velocity", unused);
  std::vector<Value> partials(model.coordinates().size());
  for (const int k : model.chain(link)) {
    const Link& joint = model.links()[static_cast<std::size_t>(k)];
    if (joint.partials.empty()) continue;
    const Value velocity = builder.joint_velocity(k, point, direction);
    for (const auto& [i, partial] : joint.partials) partials[static_cast<std::size_t>(i)] += velocity * partial;
  }
  for (Value& partial : partials) partial = program.bind(partial);
  return partials;
}

std::vector<Value> partial_turns(const Model& model, int link, const Vector& moment, int axes) {
  Program& program = model.program();
  std::vector<Value> partials(model.coordinates().size());
  for (const int k : model.chain(link)) {
    const Link& joint = model.links()[static_cast<std::size_t>(k)];
    if (joint.partials.empty() || joint.joint != JointKind::revolute) continue;
    const Vector axis = model.express(model.axis_in_parent(joint), joint.parent, axes);
    const Value turn = program.bind(dot(axis, moment));
    for (const auto& [i, partial] : joint.partials) partials[static_cast<std::size_t>(i)] += turn * partial;
  }
  for (Value& partial : partials) partial = program.bind(partial);
  return partials;
}

std::vector<ConstraintRow> constraint_rows(const Model& model) {
  Program& program = model.program();
  std::vector<ConstraintRow> rows;
  for (const ConstraintContent& constraint : model.scene().constraints) {
    const std::string user = "constraint '" + constraint.name + "'";
    ConstraintRow row;
    row.name = constraint.name;
    row.multiplier = constraint.multiplier;
    std::visit(RowBuilder(model, user, row), constraint.law);
    const auto unknowns = row.jacobian.begin() + model.unknown_count();
    if (std::all_of(row.jacobian.begin(), unknowns, [](const Value& a) { return a.is_zero(); })) {
      // A joint that closes a loop may lock what the mechanism locks already; a formula is a mistake.
      const bool formula = std::holds_alternative<HolonomicFormula>(constraint.law) ||
                           std::holds_alternative<NonholonomicFormula>(constraint.law);
      if (formula || !identically_zero(row.value) || !identically_zero(row.rate)) {
        throw SceneError(fmt::format("{} involves no coordinate: no motion can satisfy or violate it; drop it or write "
                                     "it with the scene's coordinates",
                                     user));
      }
    }
    // γ = d(rate)/dt with q̈ = 0: differentiate with velocities held.
    Derivation at_constant_velocity(
        program,
        [&](const SymbolPointer& symbol) -> Value {
          if (symbol->kind == SymbolKind::time) return program.number(Number(1));
          if (symbol->kind == SymbolKind::coordinate) return rate_of(program, symbol);
          return {};
        },
        units::second);
    row.gamma = program.bind(at_constant_velocity(row.rate));
    row.column = row.jacobian;
    if (const auto& reaction = constraint.reaction) {
      const std::string who = "reaction '" + reaction->name + "'";
      const int axes = model.place(reaction->axes, who).link;
      const SeenPoint point = model.see(reaction->contact, axes, who);
      const Vector direction = model.express(reaction->direction, reaction->axes, axes, who);
      row.column = partial_velocities(model, model.place(reaction->body, who).link, point, direction);
      const int other = model.place(reaction->other, who).link;
      const std::vector<Value> opposite = partial_velocities(model, other, point, direction);
      for (std::size_t i = 0; other != 0 && i < opposite.size(); ++i) {
        row.column[i] = program.bind(row.column[i] - opposite[i]);
      }
    }
    row.ideal = row.column;
    rows.push_back(std::move(row));
  }
  add_friction(model, rows);
  return rows;
}

}  // namespace torsor
