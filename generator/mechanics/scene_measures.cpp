// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/measure.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {
namespace {

/// Symbols that a measured vector is a function of, each once.
class MadeOf {
 public:
  MadeOf(const SceneContent& scene, std::string user) : scene_(scene), user_(std::move(user)) {}

  void add(const Expression& formula) {
    for (const SymbolPointer& symbol : formula.symbols()) {
      add(symbol);
      for (const SymbolPointer& part : symbol->made_of) add(part);
    }
  }
  void add(const Triple& components) {
    for (const Expression& component : components) add(component);
  }
  /// What moves one frame relative to another: the joints on the way between them.
  void add_between(int a, int b) {
    const std::vector<int> to_a = chain(a), to_b = chain(b);
    for (const auto& [own, other] : {std::pair(&to_a, &to_b), std::pair(&to_b, &to_a)}) {
      for (const int f : *own) {
        if (std::find(other->begin(), other->end(), f) == other->end()) add_joint(scene_.frames[as_index(f)]);
      }
    }
  }
  void add_point(const PointContent& point, int seen_from) {
    const int frame = scene_.frame_index(point.frame, user_);
    add_between(frame, seen_from);
    if (!point.lowest) return add(point.components);
    add(point.lowest->radius);
    add(point.lowest->tube);
    if (point.lowest->support) add(point.lowest->support->h);
    add_between(frame, scene_.frame_index(point.lowest->plane, user_));
  }
  void add_rates() {
    const std::vector<SymbolPointer> places = all_;
    for (const SymbolPointer& place : places) {
      if (place->rate) add(place->rate);
      const auto attitude = place->attitude.lock();
      if (!attitude) continue;
      for (const SymbolPointer& omega : attitude->omega) add(omega);
    }
  }

  std::vector<SymbolPointer> take() { return std::move(all_); }

 private:
  void add(const SymbolPointer& symbol) {
    if (std::find(all_.begin(), all_.end(), symbol) == all_.end()) all_.push_back(symbol);
  }
  void add_joint(const FrameContent& frame) {
    if (frame.joint != JointKind::attitude) return add(frame.displacement);
    for (const SymbolPointer& e : scene_.attitudes[as_index(*frame.attitude)].symbols->e) add(e);
  }
  std::vector<int> chain(int frame) const {
    std::vector<int> all;
    for (; frame > 0; frame = scene_.frame_index(*scene_.frames[as_index(frame)].parent, user_)) {
      if (all.size() > scene_.frames.size()) {
        throw SceneError(fmt::format("{} is asked of a frame that hangs on itself", user_));
      }
      all.push_back(frame);
    }
    return all;
  }

  const SceneContent& scene_;
  std::string user_;
  std::vector<SymbolPointer> all_;
};

}  // namespace

std::array<Expression, 4> Scene::attitude_components(AttitudeHandle handle) const {
  if (handle.index < 0 || handle.index >= static_cast<int>(content_.attitudes.size())) {
    throw SceneError(fmt::format("attitude number {} belongs to another scene", handle.index));
  }
  const auto& e = content_.attitudes[as_index(handle.index)].symbols->e;
  return {Expression(e[0]), Expression(e[1]), Expression(e[2]), Expression(e[3])};
}

Triple Scene::measured(MeasuredVector vector, const std::string& name, const Unit& unit,
                       std::vector<SymbolPointer> made_of) {
  using Kind = MeasuredVector::Kind;
  vector.index = content_.measured_count++;
  vector.time = content_.time;
  const bool of_places = vector.kind == Kind::direction || vector.kind == Kind::position;
  const auto shared = std::make_shared<const MeasuredVector>(std::move(vector));
  Triple components;
  for (int i = 0; i < 3; ++i) {
    Symbol symbol{fmt::format("{}.{}", name, "xyz"[i]), unit, of_places ? SymbolKind::coordinate : SymbolKind::velocity,
                  content_.symbol_count++, nullptr};
    symbol.measure = std::make_shared<const Measure>(Measure{shared, i});
    symbol.made_of = made_of;
    components[as_index(i)] = Expression(std::make_shared<const Symbol>(std::move(symbol)));
  }
  return components;
}

Triple Scene::direction(const FrameReference& frame, const Triple& along, const FrameReference& axes) {
  const std::string user = "a direction";
  for (const Expression& component : along) {
    if (component.is_zero() || component.unit().is_dimensionless()) continue;
    throw UnitError(fmt::format("a component of a direction is {} [{}] and must be a plain number",
                                component.to_string(), component.unit().to_string()));
  }
  MeasuredVector vector;
  vector.frame = content_.frame_index(frame, user);
  vector.axes = content_.frame_index(axes, user);
  vector.along = along;
  MadeOf made_of(content_, user);
  made_of.add(along);
  made_of.add_between(vector.frame, vector.axes);
  const std::string name = fmt::format("direction({}, {})", name_of(vector.frame), name_of(vector.axes));
  return measured(std::move(vector), name, Unit(), made_of.take());
}

Triple Scene::position(const PointReference& point, const FrameReference& frame) {
  const std::string user = "a position";
  MeasuredVector vector;
  vector.kind = MeasuredVector::Kind::position;
  vector.point = content_.point_index(point, user);
  vector.axes = content_.frame_index(frame, user);
  const PointContent& content = content_.points[as_index(vector.point)];
  MadeOf made_of(content_, user);
  made_of.add_point(content, vector.axes);
  const std::string name = fmt::format("position({}, {})", content.name, name_of(vector.axes));
  return measured(std::move(vector), name, units::metre, made_of.take());
}

Triple Scene::angular_velocity(const FrameReference& frame, const FrameReference& axes,
                               const FrameReference& relative_to) {
  const std::string user = "an angular velocity";
  MeasuredVector vector;
  vector.kind = MeasuredVector::Kind::angular_velocity;
  vector.frame = content_.frame_index(frame, user);
  vector.axes = content_.frame_index(axes, user);
  vector.relative_to = content_.frame_index(relative_to, user);
  MadeOf made_of(content_, user);
  made_of.add_between(vector.frame, vector.relative_to);
  made_of.add_between(vector.frame, vector.axes);
  made_of.add_rates();
  const std::string name = fmt::format("angular_velocity({}, {}, {})", name_of(vector.frame), name_of(vector.axes),
                                       name_of(vector.relative_to));
  return measured(std::move(vector), name, units::radian_per_second, made_of.take());
}

Triple Scene::velocity(const PointReference& point, const FrameReference& body, const FrameReference& axes,
                       const FrameReference& relative_to) {
  const std::string user = "a velocity";
  MeasuredVector vector;
  vector.kind = MeasuredVector::Kind::velocity;
  vector.point = content_.point_index(point, user);
  vector.frame = content_.frame_index(body, user);
  vector.axes = content_.frame_index(axes, user);
  vector.relative_to = content_.frame_index(relative_to, user);
  const PointContent& content = content_.points[as_index(vector.point)];
  MadeOf made_of(content_, user);
  made_of.add_between(vector.frame, vector.relative_to);
  made_of.add_between(vector.frame, vector.axes);
  made_of.add_point(content, vector.frame);
  made_of.add_rates();
  const std::string name = fmt::format("velocity({}, {}, {}, {})", content.name, name_of(vector.frame),
                                       name_of(vector.axes), name_of(vector.relative_to));
  return measured(std::move(vector), name, units::metre_per_second, made_of.take());
}

std::string Scene::name_of(int frame) const { return content_.frames[as_index(frame)].name; }

void Scene::refuse_measured(const Expression& formula, const std::string& what) const {
  for (const SymbolPointer& symbol : formula.symbols()) {
    if (!symbol->measure) continue;
    throw SceneError(fmt::format("{} is given as {}, which needs {}: that is known on a motion only; give a formula of "
                                 "parameters",
                                 what, formula.to_string(), symbol->name));
  }
}

}  // namespace torsor
