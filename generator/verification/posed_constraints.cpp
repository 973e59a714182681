// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/posed_constraints.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace torsor {
namespace {

using Function = std::function<Real(const Poses&)>;
using Place = std::function<RealVector(const Poses&)>;

const Pose& of(const Poses& poses, int link) { return poses[static_cast<std::size_t>(link)]; }

RealVector numbers(const Vector& v, Evaluator<Real>& here) { return {here(v[0]), here(v[1]), here(v[2])}; }

RealRotation numbers(const Rotation& r) {
  RealRotation result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = Real(r(i, j), Real::working_digits());
    }
  }
  return result;
}

class PosedLaw {
 public:
  PosedLaw(const Model& model, Evaluator<Real>& here) : model_(model), here_(here) {}

  std::optional<PosedConstraint> operator()(const Closure& law) const {
    const auto a = fixed_point(law.a), b = fixed_point(law.b);
    if (!a || !b) return std::nullopt;
    const RealVector direction = numbers(lower(model_.program(), law.direction), here_);
    return PosedConstraint{[=, from = *a, to = *b](const Poses& p) { return dot(to(p) - from(p), direction); },
                           [from = *a, to = *b](const Poses& p) { return norm(to(p) - from(p)); }};
  }

  std::optional<PosedConstraint> operator()(const PointInPlane& law) const {
    const SceneContent& scene = model_.scene();
    const PointContent& point = scene.points[static_cast<std::size_t>(scene.point_index(law.point, user_))];
    const FramePlace& plane = model_.place(law.plane, user_);
    const Place origin = frame_origin(plane), normal = frame_axis(plane, 2);
    if (!point.lowest) {
      const auto fixed = fixed_point(law.point);
      if (!fixed) return std::nullopt;
      const Place place = *fixed;
      return PosedConstraint{[=](const Poses& p) { return dot(place(p) - origin(p), normal(p)); },
                             [=](const Poses& p) { return norm(place(p) - origin(p)); }};
    }
    if (scene.frame_index(point.lowest->plane, user_) != scene.frame_index(law.plane, user_)) return std::nullopt;
    const FramePlace& body = model_.place(point.frame, user_);
    const Place center = frame_origin(body);
    if (point.lowest->support) {
      const Function below = supported(*point.lowest->support, body, normal);
      return PosedConstraint{[=](const Poses& p) { return dot(center(p) - origin(p), normal(p)) - below(p); },
                             [=](const Poses& p) { return norm(center(p) - origin(p)) + abs(below(p)); }};
    }
    const Real tube = here_(model_.program().lower(point.lowest->tube));
    const Real radius = here_(model_.program().lower(point.lowest->radius));
    Function below = [radius](const Poses&) { return radius; };
    if (point.lowest->axis) {  // the disc's support function: r |n ∧ k|
      const RealVector own = numbers(lower(model_.program(), *point.lowest->axis), here_);
      const RealVector k = numbers(body.rotation) * own;
      below = [=, link = body.link](const Poses& p) {
        return radius * norm(cross(normal(p), of(p, link).rotation * k));
      };
    }
    return PosedConstraint{[=](const Poses& p) { return dot(center(p) - origin(p), normal(p)) - below(p) - tube; },
                           [=](const Poses& p) { return norm(center(p) - origin(p)) + abs(radius) + abs(tube); }};
  }

  std::optional<PosedConstraint> operator()(const JointClosure& law) const {
    const FramePlace& at_a = model_.place(law.a, user_);
    const FramePlace& at_b = model_.place(law.b, user_);
    const Place a = frame_origin(at_a), b = frame_origin(at_b), a_i = frame_axis(at_a, law.i);
    const Function distance = [=](const Poses& p) { return norm(b(p) - a(p)); };
    if (law.kind == JointClosure::Kind::offset) {
      return PosedConstraint{[=](const Poses& p) { return dot(b(p) - a(p), a_i(p)); }, distance};
    }
    if (law.kind == JointClosure::Kind::alignment) {
      const Place b_j = frame_axis(at_b, law.j);
      const Real sign(law.sign);
      return PosedConstraint{[=](const Poses& p) { return sign * dot(a_i(p), b_j(p)); },
                             [](const Poses&) { return Real(1); }};
    }
    // p times the component of b_y along a_z turned by the angle AB·a_x/p: p sin(AB·a_x/p − θ) where a_x = b_x.
    const Real pitch = here_(model_.program().lower(law.pitch));
    const Place a_y = frame_axis(at_a, 1), a_z = frame_axis(at_a, 2), b_y = frame_axis(at_b, 1);
    return PosedConstraint{[=](const Poses& p) {
                             const Real angle = dot(b(p) - a(p), a_i(p)) / pitch;
                             const RealVector turned = sin(angle) * a_y(p) - cos(angle) * a_z(p);
                             return pitch * dot(turned, b_y(p));
                           },
                           [=](const Poses& p) { return distance(p) + abs(pitch); }};
  }

  template <class Other>
  std::optional<PosedConstraint> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  Place frame_origin(const FramePlace& at) const { return carried(at.link, numbers(at.origin, here_)); }

  Place frame_axis(const FramePlace& at, int i) const {
    return [link = at.link, axis = column(numbers(at.rotation), i)](const Poses& p) {
      return of(p, link).rotation * axis;
    };
  }

  static Place carried(int link, const RealVector& own) {
    return [=](const Poses& p) { return of(p, link).origin + of(p, link).rotation * own; };
  }

  /// h(−n), the normal along the axes of the body's frame: the formula itself, at numbers.
  Function supported(const SupportFunction& support, const FramePlace& body, const Place& normal) const {
    Program& program = model_.program();
    const Value h = program.bind(program.lower(support.h));
    std::map<const Symbol*, Real> parameters;
    for (const ValueNumber value_number : program.live({h})) {
      const SymbolPointer& symbol = program[value_number].symbol;
      const bool formal = std::find(support.direction.begin(), support.direction.end(), symbol) != support.direction.end();
      if (symbol && !formal) parameters.emplace(symbol.get(), here_(program.symbol(symbol)));
    }
    const auto own = numbers(body.rotation);
    return [=, &program, direction = support.direction, link = body.link](const Poses& p) {
      const RealVector n = normal(p);
      std::map<const Symbol*, Real> values = parameters;
      for (int i = 0; i < 3; ++i) {
        const RealVector axis = of(p, link).rotation * column(own, i);
        values[direction[static_cast<std::size_t>(i)].get()] = -dot(axis, n);
      }
      return Evaluator<Real>(program, [&values](const SymbolPointer& symbol) { return values.at(symbol.get()); })(h);
    };
  }

  std::optional<Place> fixed_point(const PointReference& reference) const {
    const SceneContent& scene = model_.scene();
    const PointContent& point = scene.points[static_cast<std::size_t>(scene.point_index(reference, user_))];
    if (point.lowest) return std::nullopt;
    const Vector components = lower(model_.program(), point.components);
    for (int i = 0; i < 3; ++i) {
      if (!components[i].is_constant() && model_.program().stage(components[i]) > Stage::parameters) return std::nullopt;
    }
    const FramePlace& at = model_.place(point.frame, user_);
    return carried(at.link, numbers(at.origin + at.rotation * lower(model_.program(), point.components), here_));
  }

  const Model& model_;
  Evaluator<Real>& here_;
  std::string user_ = "a check of constraints";
};

}  // namespace

Poses displaced(Poses poses, int link, std::size_t direction, const Real& h) {
  Pose& pose = poses[static_cast<std::size_t>(link)];
  RealVector unit{Real(0), Real(0), Real(0)};
  unit[direction % 3] = Real(1);
  if (direction < 3) {
    pose.origin = pose.origin + h * (pose.rotation * unit);
  } else {
    pose.rotation = pose.rotation * rotation_about(unit, h);
  }
  return poses;
}

PosedScene::PosedScene(const Model& model) : model_(&model) {
  Program& program = model.program();
  for (std::size_t link = 0; link < model.links().size(); ++link) {
    origins_.push_back(bound(program, model.locate(Vector(), static_cast<int>(link), 0)));
    Matrix rotation;
    for (int j = 0; j < 3; ++j) {
      Vector unit;
      unit[j] = program.number(Number(1));
      const Vector axis = bound(program, model.express(unit, static_cast<int>(link), 0));
      for (int i = 0; i < 3; ++i) rotation(i, j) = axis[i];
    }
    rotations_.push_back(rotation);
  }
}

Poses PosedScene::at(Evaluator<Real>& here) const {
  Poses poses;
  for (std::size_t link = 0; link < origins_.size(); ++link) {
    Pose pose{{}, numbers(origins_[link], here)};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        pose.rotation[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = here(rotations_[link](i, j));
      }
    }
    poses.push_back(std::move(pose));
  }
  return poses;
}

std::optional<PosedConstraint> PosedScene::constraint(const ConstraintLaw& law, Evaluator<Real>& here) const {
  return std::visit(PosedLaw(*model_, here), law);
}

}  // namespace torsor
