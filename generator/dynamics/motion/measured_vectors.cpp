// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"
#include "torsor/generator/mechanics/measure.hpp"

namespace torsor {

/// Whether all frames that a formula measures are in the tree of links, those that laws in it measure included.
bool Model::is_placed(const Expression& formula, const std::vector<bool>& done) const {
  const std::vector<SymbolPointer> symbols = formula.symbols();
  return std::all_of(symbols.begin(), symbols.end(), [&](const SymbolPointer& symbol) {
    for (const CoordinateContent& c : scene_->coordinates) {
      if (c.law && (c.q == symbol || c.v == symbol)) return is_placed(*c.law, done);
    }
    if (!symbol->measure) return true;
    const MeasuredVector& wanted = *symbol->measure->vector;
    std::vector<int> frames{wanted.frame, wanted.axes, wanted.relative_to};
    const bool of_point =
        wanted.kind == MeasuredVector::Kind::position || wanted.kind == MeasuredVector::Kind::velocity;
    if (of_point) {
      const PointContent& point = scene_->points[as_index(wanted.point)];
      frames.push_back(scene_->frame_index(point.frame, symbol->name));
      if (point.lowest) frames.push_back(scene_->frame_index(point.lowest->plane, symbol->name));
      for (const Expression& component : point.components) {
        if (!is_placed(component, done)) return false;
      }
    }
    for (const Expression& component : wanted.along) {
      if (!is_placed(component, done)) return false;
    }
    return std::all_of(frames.begin(), frames.end(), [&](int frame) { return done[as_index(frame)]; });
  });
}

Value Model::measured(const Symbol& symbol) {
  const Measure& measure = *symbol.measure;
  auto place = measured_.find(measure.vector->index);
  if (place == measured_.end()) {
    Vector vector = measured(*measure.vector);
    place = measured_.emplace(measure.vector->index, Measured{std::move(vector), program_->size()}).first;
  }
  const Value& component = place->second.vector[measure.component];
  // A zero fits any unit and may belong to no program.
  return {*program_, component.polynomial(), symbol.unit};
}

Vector Model::measured(const MeasuredVector& wanted) {
  using Kind = MeasuredVector::Kind;
  const FramePlace& axes = places_[as_index(wanted.axes)];
  const FramePlace& frame = places_[as_index(wanted.frame)];
  const std::string user = "a measured vector";
  const auto turned = [&](const Vector& v) { return bound(*program_, axes.rotation.transpose() * bound(*program_, v)); };
  if (wanted.kind == Kind::direction) {
    return turned(express(frame.rotation * lower(*program_, wanted.along), frame.link, axes.link));
  }
  SeenPoint point{{axes.link, {}}, axes.link};
  if (wanted.kind != Kind::angular_velocity) point = see(PointHandle{wanted.point}, axes.link, user);
  if (wanted.kind == Kind::position) {
    return turned(between({axes.link, axes.origin}, point.base, axes.link) + point.beyond);
  }
  const int other = places_[as_index(wanted.relative_to)].link;
  const Twist twist = RelativeMotion(*this, frame.link, other, point).twist();
  return turned(wanted.kind == Kind::velocity ? twist.linear : twist.angular);
}

}  // namespace torsor
