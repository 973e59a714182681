// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/actions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"
#include "torsor/generator/mechanics/action_units.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

/// Whether a place in the axes of its link is not constant.
bool moves_in_frame(const Program& program, const Vector& place) {
  for (int i = 0; i < 3; ++i) {
    if (!place[i].is_zero() && program.stage(place[i]) > Stage::parameters) return true;
  }
  return false;
}

/// Collects what each action of a scene does.
class Collector {
 public:
  explicit Collector(const Model& model) : model_(model), program_(model.program()) {
    result_.passive.resize(model.coordinates().size());
  }

  void operator()(const ElongationSpring& spring) {
    const Value k = program_.lower(spring.stiffness);
    const Value elongation = model_.of_configuration(spring.elongation, "the elongation of spring '" + spring.name + "'");
    const Value stretch = program_.bind(elongation - program_.lower(spring.rest));
    const Value force = program_.bind(-(k * stretch));
    work_with(spring.elongation, force);
    vary_with(spring.rest, -force);
    vary_with(spring.stiffness, Number::rational(-1, 2) * pow(stretch, 2));
    result_.spring_force_function -= Number::rational(1, 2) * (k * pow(stretch, 2));
  }

  void operator()(const ElongationDamper& damper) {
    const Value elongation = model_.of_configuration(damper.elongation, "the elongation of damper '" + damper.name + "'");
    const Value speed = program_.bind(time_derivative(elongation));
    const Value force = program_.bind(-(program_.lower(damper.damping) * speed));
    work_with(damper.elongation, force);
    dissipative(damper.name, force * speed);
  }

  void operator()(const Motor& motor) {
    const std::vector<Value> partials = model_.partials(motor.displacement);
    result_.inputs.push_back(partials);
    const Value displacement =
        model_.of_configuration(motor.displacement, "the displacement of motor '" + motor.name + "'");
    const Value speed = program_.bind(time_derivative(displacement));
    dissipative(motor.name, program_.symbol(motor.input) * speed);
  }

  void operator()(const PointSpring& spring) {
    const std::string user = "spring '" + spring.name + "'";
    const Value k = program_.lower(spring.stiffness);
    const Value rest = program_.lower(spring.rest);
    const auto [at_a, at_b] = pair_of_places(spring.a, spring.b, user);
    const Value square = program_.bind(dot(at_a.to_other, at_a.to_other));
    Value tension_by_length = k;  // tension / |AB|: no square root when the spring has no natural length
    Value stretch_square = square;
    if (!rest.is_zero()) {
      const Value length = program_.sqrt(square);
      const Value inverse = program_.bind(pow(length, -1));
      tension_by_length = program_.bind(k - k * rest * inverse);
      const Value stretch = program_.bind(length - rest);
      vary_with(spring.rest, k * stretch);
      stretch_square = pow(stretch, 2);
    }
    vary_with(spring.stiffness, Number::rational(-1, 2) * stretch_square);
    result_.spring_force_function -= Number::rational(1, 2) * (k * stretch_square);
    pull(at_a, tension_by_length);
    pull(at_b, tension_by_length);
  }

  void operator()(const PointDamper& damper) {
    const std::string user = "damper '" + damper.name + "'";
    const auto [at_a, at_b] = pair_of_places(damper.a, damper.b, user);
    const Value square = program_.bind(dot(at_a.to_other, at_a.to_other));
    // d|AB|/dt = (d AB²/dt) / (2 |AB|), tension c d|AB|/dt along AB/|AB|.
    const Value half_rate = program_.bind(Number::rational(1, 2) * time_derivative(square));
    const Value c = program_.lower(damper.damping);
    const Value by_length = program_.bind(c * half_rate / square);
    pull(at_a, by_length);
    pull(at_b, by_length);
    dissipative(damper.name, -(by_length * half_rate));
  }

  void operator()(const GivenForce& force) {
    const std::string user = "force '" + force.name + "'";
    const int link = model_.place(force.body, user).link;
    const Vector f = components(force.components, force.axes, link, user);
    const Vector point = bound(program_, model_.locate(force.point, link, user));
    apply(link, {f, cross(point, f)}, force.name);
  }

  void operator()(const GivenTorque& torque) {
    const std::string user = "torque '" + torque.name + "'";
    const int link = model_.place(torque.body, user).link;
    apply(link, {Vector(), components(torque.components, torque.axes, link, user)}, torque.name);
  }

  void operator()(const GivenForceFunction& given) {
    const std::string user = "force function '" + given.name + "'";
    refuse_released(given.force_function, user);
    const Value u = program_.lower(given.force_function);
    if (program_.stage(u) > Stage::configuration) {
      throw SceneError(
          fmt::format("{} depends on more than coordinates, time and parameters: an action that depends on "
                      "velocities has no force function; use generalised_force(...)",
                      user));
    }
    result_.spring_force_function += u;
    std::vector<SymbolPointer> velocities;
    for (const CoordinateContent& c : model_.coordinates()) velocities.push_back(c.v);
    const std::vector<Value> forces = gradient_along(u, velocities);
    if (std::all_of(forces.begin(), forces.end(), [](const Value& force) { return force.is_zero(); })) {
      refuse_without_force(u, user);
    }
    for (std::size_t i = 0; i < forces.size(); ++i) result_.passive[i] += forces[i];
  }

  void operator()(const GeneralisedForce& given) {
    const std::string user = "generalised force '" + given.name + "'";
    refuse_released(given.displacement, user);
    const Value force = program_.bind(of_state(given.force, user));
    work_with(given.displacement, force);
    const Value displacement = model_.of_configuration(given.displacement, "the displacement of " + user);
    const Value speed = program_.bind(time_derivative(displacement));
    dissipative(given.name, force * speed);
  }

  void operator()(const Gravitation& attraction) {
    const std::string user = "gravitation '" + attraction.name + "'";
    const Value k = of_state(attraction.strength, user);
    const auto [at_a, at_b] = pair_of_places(attraction.a, attraction.b, user);
    const Value distance = program_.sqrt(program_.bind(dot(at_a.to_other, at_a.to_other)));
    const Value inverse = program_.bind(pow(distance, -1));
    vary_with(attraction.strength, inverse);
    result_.spring_force_function += k * inverse;
    const Value by_length = program_.bind(k * pow(inverse, 3));
    pull(at_a, by_length);
    pull(at_b, by_length);
  }

  void operator()(const GivenWrench& given) {
    const std::string user = "wrench '" + given.name + "'";
    const int link = model_.place(given.body, user).link;
    const Vector force = components(given.force, given.axes, link, user);
    const Vector moment = components(given.moment, given.axes, link, user);
    const Vector point = bound(program_, model_.locate(given.point, link, user));
    apply(link, {force, moment + cross(point, force)}, given.name);
  }

  void operator()(const Drag& drag) {
    const std::string user = "drag '" + drag.name + "'";
    const auto [link, other] = pair_of_links(drag.body, drag.relative_to, drag.name, user);
    const Vector point = bound(program_, model_.locate(drag.point, link, user));
    const Vector velocity = RelativeMotion(model_, link, other, model_.see(drag.point, link, user)).twist().linear;
    const Vector force = bound(program_, -(of_state(drag.coefficient, user) * velocity));
    exert(link, other, {force, cross(point, force)});
    dissipative(drag.name, dot(force, velocity));
  }

  void operator()(const RotationalDrag& drag) {
    const std::string user = "rotational drag '" + drag.name + "'";
    const auto [link, other] = pair_of_links(drag.body, drag.relative_to, drag.name, user);
    const Vector turning = RelativeMotion(model_, link, other, {{link, {}}, link}).twist().angular;
    const Vector torque = bound(program_, -(of_state(drag.coefficient, user) * turning));
    exert(link, other, {Vector(), torque});
    dissipative(drag.name, dot(torque, turning));
  }

  void operator()(const MutualAction& action) {
    const std::string user = "action '" + action.name + "'";
    const auto [link, other] = pair_of_links(action.a, action.b, action.name, user);
    const Vector given = components(action.components, action.axes, link, user);
    Vector point;
    if (action.point) point = bound(program_, model_.locate(*action.point, link, user));
    const SeenPoint seen = action.point ? model_.see(*action.point, link, user) : SeenPoint{{link, {}}, link};
    const Twist moving = RelativeMotion(model_, link, other, seen).twist();
    exert(link, other, action.point ? Wrench{given, cross(point, given)} : Wrench{Vector(), given});
    dissipative(action.name, dot(given, action.point ? moving.linear : moving.angular));
  }

  AppliedActions take() {
    for (auto& [link, wrench] : result_.wrenches) {
      wrench.resultant = bound(program_, wrench.resultant);
      wrench.moment = bound(program_, wrench.moment);
    }
    return std::move(result_);
  }

 private:
  /// One end of a spring or damper: its link, its place and the vector to the other end, in the link's axes. An end that
  /// moves in its frame is pulled along on the link where it is, and its force works with its own motion too.
  struct End {
    int link = 0;
    Vector place, to_other;
    bool moves = false;
  };

  End end_of(const PointReference& own, const PointReference& other, const std::string& user) {
    const PointContent& point = model_.scene().points[static_cast<std::size_t>(model_.scene().point_index(own, user))];
    End end;
    end.link = model_.place(point.frame, user).link;
    end.place = bound(program_, model_.locate(own, end.link, user));
    for (const Expression& component : point.components) refuse_released(component, user, true);
    end.moves = moves_in_frame(program_, end.place);
    if (end.moves) check_moving_end(point, end.place, user);
    end.to_other = bound(program_, model_.locate(other, end.link, user) - end.place);
    return end;
  }

  /// Its place must be that of a configuration; that of a point of contact is not known against released coordinates.
  void check_moving_end(const PointContent& point, const Vector& place, const std::string& user) const {
    for (int i = 0; i < 3; ++i) {
      if (place[i].is_zero() || program_.stage(place[i]) <= Stage::configuration) continue;
      throw SceneError(
          fmt::format("{} is attached to point '{}', whose place depends on more than coordinates, time and parameters: "
                      "give its components as formulas of those",
                      user, point.name));
    }
    if (!point.lowest) return;
    for (const CoordinateContent& c : model_.coordinates()) {
      if (!c.released) continue;
      throw SceneError(
          fmt::format("{} is attached to the point of contact '{}', whose motion against the released coordinate '{}' is "
                      "not known: attach it to a point of a body, or release nothing",
                      user, point.name, c.q->name));
    }
  }

  std::pair<End, End> pair_of_places(const PointReference& a, const PointReference& b, const std::string& user) {
    End at_a = end_of(a, b, user);
    End at_b = end_of(b, a, user);
    if (at_a.link == at_b.link && !at_a.moves && !at_b.moves) {
      throw SceneError(fmt::format("{} ties two points of one rigid body: its length never changes", user));
    }
    return {std::move(at_a), std::move(at_b)};
  }

  /// A formula of coordinates, velocities, time and parameters.
  Value of_state(const Expression& formula, const std::string& user) {
    const Value value = program_.lower(formula);
    if (value.is_zero() || program_.stage(value) <= Stage::state) return value;
    throw SceneError(
        fmt::format("{} depends on accelerations, inputs or multipliers through {}: give a formula of "
                    "coordinates, their rates, time and parameters",
                    user, formula.to_string()));
  }

  Vector components(const Triple& given, const FrameReference& axes, int link, const std::string& user) {
    for (const Expression& component : given) of_state(component, user);
    return bound(program_, model_.express(given, axes, link, user));
  }

  /// What a released coordinate would contribute to a formula's derivatives is lost: it is zero there.
  void refuse_released(const Expression& formula, const std::string& user, bool itself = false) const {
    for (const CoordinateContent& c : model_.coordinates()) {
      if (!c.released || (!itself && formula.as_symbol() == c.q) || !(formula.depends_on(c.q) || formula.depends_on(c.v))) continue;
      throw SceneError(
          fmt::format("{} names the released coordinate '{}', which its joint holds at zero: write it "
                      "without, or between points",
                      user, c.q->name));
    }
  }

  std::pair<int, int> pair_of_links(const FrameReference& body, const FrameReference& other, const std::string& name,
                                    const std::string& user) const {
    const int link = model_.place(body, user).link;
    const int other_link = model_.place(other, user).link;
    if (link == 0) throw SceneError(fmt::format("action '{}' is applied to the ground, which it cannot move", name));
    if (link == other_link) {
      throw SceneError(fmt::format("{} acts between two frames of one rigid body: nothing moves between them", user));
    }
    return {link, other_link};
  }

  /// A wrench on a link, in its axes at its origin, and the opposite on another.
  void exert(int link, int other, const Wrench& wrench) {
    add(link, wrench);
    if (other == 0) return;
    const Vector origin = bound(program_, model_.locate(Vector(), link, other));
    const Vector force = bound(program_, model_.express(bound(program_, -wrench.resultant), link, other));
    const Vector moment = model_.express(bound(program_, -wrench.moment), link, other);
    add(other, {force, moment + cross(origin, force)});
  }

  void pull(const End& end, const Value& tension_by_length) {
    if (end.link == 0 && !end.moves) return;
    const Vector f = bound(program_, tension_by_length * end.to_other);
    if (end.link != 0) add(end.link, {f, cross(end.place, f)});
    for (std::size_t i = 0; i < result_.passive.size() && end.moves; ++i) {
      Derivation along = model_.along(static_cast<int>(i));
      for (int k = 0; k < 3; ++k) {
        const Value slope = along(end.place[k]);
        if (!slope.is_zero()) result_.passive[i] += f[k] * slope;
      }
    }
  }

  void add(int link, const Wrench& wrench) {
    Wrench& sum = result_.wrenches[link];
    sum.resultant += wrench.resultant;
    sum.moment += wrench.moment;
  }

  /// A force function whose derivatives all vanish.
  [[noreturn]] void refuse_without_force(const Value& u, const std::string& user) const {
    for (const ValueNumber value_number : program_.live({u})) {
      const SymbolPointer& symbol = program_[value_number].symbol;
      const bool moves = symbol && std::any_of(model_.coordinates().begin(), model_.coordinates().end(),
                                               [&](const CoordinateContent& c) { return c.q == symbol && c.unknown(); });
      if (!moves) continue;
      throw SceneError(fmt::format("{} has the slope 0 along {} but at its steps, where no force is finite: use a smooth "
                                   "function such as tanh, or a stop",
                                   user, symbol->name));
    }
    throw SceneError(fmt::format("{} depends on no unknown coordinate: it makes no force; drop it", user));
  }

  void apply(int link, const Wrench& wrench, const std::string& name) {
    if (link == 0) throw SceneError(fmt::format("action '{}' is applied to the ground, which it cannot move", name));
    add(link, wrench);
    if (twists_.empty()) twists_ = twists(model_);
    dissipative(name, reciprocal_product(wrench, twists_[static_cast<std::size_t>(link)]));
  }

  /// A coefficient of an action that has a force function U, with ∂U/∂(coefficient): Q_i = ∂U/∂q_i holds its slope too. A
  /// change that follows from no unknown coordinate, that of time and of driven ones, changes U without work.
  void vary_with(const Expression& coefficient, const Value& slope) {
    work_with(coefficient, slope);
    const Value value = program_.bind(program_.lower(coefficient));
    if (value.is_zero()) return;
    Value unmoved = time_derivative(value);
    const std::vector<Value> partials = model_.partials(coefficient);
    for (std::size_t i = 0; i < partials.size(); ++i) {
      if (!partials[i].is_zero()) unmoved -= partials[i] * model_.v(static_cast<int>(i));
    }
    if (!unmoved.is_zero()) result_.rate_without_work += slope * unmoved;
  }

  /// Q_i = force ∂(formula)/∂q_i.
  void work_with(const Expression& formula, const Value& force) {
    const std::vector<Value> partials = model_.partials(formula);
    for (std::size_t i = 0; i < partials.size(); ++i) {
      if (!partials[i].is_zero()) result_.passive[i] += force * partials[i];
    }
  }

  void dissipative(const std::string& name, const Value& power) {
    result_.power += power;
    result_.without_force_function.push_back(name);
  }

  const Model& model_;
  Program& program_;
  std::vector<Twist> twists_;
  AppliedActions result_;
};

}  // namespace

bool has_force_function(const ActionContent& action) {
  return std::holds_alternative<ElongationSpring>(action) || std::holds_alternative<PointSpring>(action) ||
         std::holds_alternative<GivenForceFunction>(action) || std::holds_alternative<Gravitation>(action);
}

bool works_on_formula(const Model& model, const ActionContent& action) {
  const auto moves = [&](const PointReference& reference) {
    const std::string user = "action '" + name_of(action) + "'";
    const PointContent& point = model.scene().points[static_cast<std::size_t>(model.scene().point_index(reference, user))];
    return moves_in_frame(model.program(), model.locate(reference, model.place(point.frame, user).link, user));
  };
  const auto varies = [&](const Expression& coefficient) {
    const std::vector<Value> partials = model.partials(coefficient);
    return std::any_of(partials.begin(), partials.end(), [](const Value& partial) { return !partial.is_zero(); });
  };
  const auto either = [&](const auto& mutual) { return moves(mutual.a) || moves(mutual.b); };
  if (const auto* spring = std::get_if<PointSpring>(&action)) {
    return either(*spring) || varies(spring->stiffness) || varies(spring->rest);
  }
  if (const auto* damper = std::get_if<PointDamper>(&action)) return either(*damper);
  if (const auto* attraction = std::get_if<Gravitation>(&action)) return either(*attraction) || varies(attraction->strength);
  return false;
}

AppliedActions applied_actions(const Model& model, const std::function<bool(const ActionContent&)>& wanted) {
  Collector collector(model);
  for (const ActionContent& action : model.scene().actions) {
    if (!wanted(action)) continue;
    require_action_units(action);
    std::visit(collector, action);
  }
  return collector.take();
}

AppliedActions applied_actions(const Model& model, ActionKind kind) {
  AppliedActions actions = applied_actions(
      model, [kind](const ActionContent& action) { return kind == ActionKind::all || !has_force_function(action); });
  for (const ContactFriction& friction : model.scene().frictions) {
    actions.without_force_function.push_back(friction.name);
  }
  return actions;
}

std::vector<Value> applied_forces(const Model& model, const AppliedActions& actions) {
  Program& program = model.program();
  std::vector<Value> forces = actions.passive;
  const std::vector<Twist> all = actions.wrenches.empty() ? std::vector<Twist>() : twists(model);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    Derivation partial = partial_derivation(program, model.coordinates()[i].v);
    for (const auto& [link, wrench] : actions.wrenches) {
      const Twist& twist = all[static_cast<std::size_t>(link)];
      Twist partial_twist;
      for (int k = 0; k < 3; ++k) {
        partial_twist.angular[k] = partial(twist.angular[k]);
        partial_twist.linear[k] = partial(twist.linear[k]);
      }
      forces[i] += reciprocal_product(wrench, partial_twist);
    }
  }
  return forces;
}

}  // namespace torsor
