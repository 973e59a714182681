// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"

#include "torsor/generator/dynamics/forces/closure_wrench.hpp"

namespace torsor {
namespace {

class WrenchOfLaw {
 public:
  WrenchOfLaw(const Model& model, std::string user, WrenchOnLinks& wrenches)
      : model_(model), program_(model.program()), user_(std::move(user)), wrenches_(wrenches) {}

  /// AB · d = 0: a force d on the body of B at B and −d on that of A at A, one line where the loop is closed.
  bool operator()(const Closure& law) {
    const Vector direction = lower(program_, law.direction);
    const auto push = [&](const PointReference& point, const Vector& force) {
      add_one(model_, wrenches_, link_of(point), {{force, Vector()}, model_.see(point, 0, user_)});
    };
    push(law.b, direction);
    push(law.a, -direction);
    return true;
  }

  bool operator()(const NoSlip& law) {
    const int axes = model_.place(law.axes, user_).link;
    const Vector direction = bound(program_, model_.express(law.direction, law.axes, axes, user_));
    const SeenPoint point = model_.see(law.contact, axes, user_);
    const int on = model_.place(law.on, user_).link;
    add_pair(model_, wrenches_, {model_.place(law.body, user_).link, on}, {{direction, Vector()}, point});
    return true;
  }

  bool operator()(const PointInPlane& law) {
    const int plane = model_.place(law.plane, user_).link;
    const Vector normal = bound(program_, model_.express(axis::z, law.plane, plane, user_));
    const SeenPoint point = model_.see(law.point, plane, user_);
    add_pair(model_, wrenches_, {link_of(law.point), plane}, {{normal, Vector()}, point});
    return true;
  }

  bool operator()(const JointClosure& law) {
    const int a = model_.place(law.a, user_).link, b = model_.place(law.b, user_).link;
    const ClosureWrench wrench = closure_wrench(model_, law, user_);
    add_pair(model_, wrenches_, {b, a}, {wrench.at_point, wrench.point});
    return true;
  }

  template <class Formula>
  bool operator()(const Formula&) {
    return false;
  }

  static void add_one(const Model& model, WrenchOnLinks& wrenches, int on, const WrenchAtPoint& given) {
    Program& program = model.program();
    const Vector force = bound(program, given.wrench.resultant);
    const Vector moment = bound(program, given.wrench.moment);
    const int axes = given.point.axes;
    const Vector place = bound(program, model.locate(given.point, on));
    const Vector turned = bound(program, model.express(force, axes, on));
    Wrench& sum = wrenches[on];
    sum.resultant += turned;
    sum.moment += model.express(moment, axes, on);
    sum.moment += cross(place, turned);
  }

 private:
  int link_of(const PointReference& point) const {
    const SceneContent& scene = model_.scene();
    return model_.place(scene.points[static_cast<std::size_t>(scene.point_index(point, user_))].frame, user_).link;
  }

  const Model& model_;
  Program& program_;
  std::string user_;
  WrenchOnLinks& wrenches_;
};

void add_friction_of(const Model& model, int index, WrenchOnLinks& wrenches) {
  Program& program = model.program();
  for (const ContactFriction& friction : model.scene().frictions) {
    if (friction.constraint != index) continue;
    const std::string user = "friction '" + friction.name + "'";
    const int axes = model.place(friction.axes, user).link;
    const Vector given = lower(program, friction.direction);
    const Value length = friction.length.is_zero() ? program.sqrt(program.bind(dot(given, given)))
                                                   : program.bind(program.lower(friction.length));
    const Value intensity = program.bind(-(program.lower(friction.coefficient) / length));
    const Vector direction = bound(program, model.express(friction.direction, friction.axes, axes, user));
    const Vector effort = bound(program, intensity * direction);
    const SeenPoint point = friction.point ? model.see(*friction.point, axes, user) : SeenPoint{{axes, {}}, axes};
    const Wrench unit = friction.point ? Wrench{effort, Vector()} : Wrench{Vector(), effort};
    add_pair(model, wrenches, {model.place(friction.body, user).link, model.place(friction.other, user).link},
             {unit, point});
  }
}

std::optional<WrenchOnLinks> unbound_wrench(const Model& model, int index) {
  Program& program = model.program();
  const ConstraintContent& constraint = model.scene().constraints[static_cast<std::size_t>(index)];
  WrenchOnLinks wrenches;
  if (const auto& reaction = constraint.reaction) {
    const std::string user = "reaction '" + reaction->name + "'";
    const int axes = model.place(reaction->axes, user).link;
    const Vector direction = bound(program, model.express(reaction->direction, reaction->axes, axes, user));
    const SeenPoint point = model.see(reaction->contact, axes, user);
    add_pair(model, wrenches, {model.place(reaction->body, user).link, model.place(reaction->other, user).link},
             {{direction, Vector()}, point});
  } else if (!std::visit(WrenchOfLaw(model, "constraint '" + constraint.name + "'", wrenches), constraint.law)) {
    return std::nullopt;
  }
  return wrenches;
}

void bind_all(Program& program, WrenchOnLinks& wrenches) {
  for (auto& [link, wrench] : wrenches) {
    wrench.resultant = bound(program, wrench.resultant);
    wrench.moment = bound(program, wrench.moment);
  }
}

}  // namespace

void add_pair(const Model& model, WrenchOnLinks& wrenches, const ActionPair& pair, const WrenchAtPoint& given) {
  WrenchOfLaw::add_one(model, wrenches, pair.on, given);
  const Wrench opposite{-given.wrench.resultant, -given.wrench.moment};
  WrenchOfLaw::add_one(model, wrenches, pair.other, {opposite, given.point});
}

std::optional<WrenchOnLinks> ideal_wrench(const Model& model, int index) {
  std::optional<WrenchOnLinks> wrenches = unbound_wrench(model, index);
  if (wrenches) bind_all(model.program(), *wrenches);
  return wrenches;
}

std::optional<WrenchOnLinks> constraint_wrench(const Model& model, int index) {
  std::optional<WrenchOnLinks> wrenches = unbound_wrench(model, index);
  if (!wrenches) return std::nullopt;
  add_friction_of(model, index, *wrenches);
  bind_all(model.program(), *wrenches);
  return wrenches;
}

}  // namespace torsor
