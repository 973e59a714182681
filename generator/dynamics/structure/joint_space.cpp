// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/joint_space.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/structure/twist_space.hpp"
#include "torsor/generator/mechanics/joint_screws.hpp"

namespace torsor {
namespace {

RealRow row_of(const RealVector& angular, const RealVector& linear) {
  return {angular[0], angular[1], angular[2], linear[0], linear[1], linear[2]};
}
RealVector angular_of(const RealRow& twist) { return {twist[0], twist[1], twist[2]}; }
RealVector velocity_at(const RealRow& twist, const RealVector& point) {
  return RealVector{twist[3], twist[4], twist[5]} + cross(angular_of(twist), point);
}

/// Directions of files are products of decimals of some sixteen digits: what they leave of a component that is zero.
constexpr double rounding_of_files = 1e-12;

RealRotation identity_rotation() {
  RealRotation r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = Real(i == j ? 1 : 0);
  }
  return r;
}

/// R_ij of a unit quaternion (w, x, y, z).
RealRotation rotation_of(const std::array<Real, 4>& e) {
  RealRotation r;
  const Real two(2), one(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    r[i][i] = one - two * (e[j + 1] * e[j + 1] + e[k + 1] * e[k + 1]);
    r[i][j] = two * (e[i + 1] * e[j + 1] - e[0] * e[k + 1]);
    r[j][i] = two * (e[i + 1] * e[j + 1] + e[0] * e[k + 1]);
  }
  return r;
}

}  // namespace

std::string direction_text(const RealVector& direction) {
  RealVector unit = (Real(1) / norm(direction)) * direction;
  for (Real& component : unit) {
    if (abs(component) < Real::from_double(rounding_of_files)) component = Real(0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (unit[(i + 1) % 3].is_zero() && unit[(i + 2) % 3].is_zero()) return std::string(1, "xyz"[i]);
  }
  // An axis has two directions: it is written by the one whose first component is positive, wherever it comes from.
  const auto first = std::find_if(unit.begin(), unit.end(), [](const Real& each) { return !each.is_zero(); });
  const double sign = *first < Real(0) ? -1 : 1;
  const auto component = [&](std::size_t i) { return unit[i].is_zero() ? 0.0 : sign * unit[i].to_double(); };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", component(0), component(1), component(2));
}

JointSpace::JointSpace(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& language)
    : say_(language), scene_(&scene.content()), graph_(&graph), length_(1) {
  InitialNumbers number(scene);
  const auto numbers = [&number](const Triple& triple) {
    const Real x = number(triple[0]);
    const Real y = number(triple[1]);
    return RealVector{x, y, number(triple[2])};
  };
  for (const FrameContent& content : scene_->frames) {
    Frame frame;
    if (content.parent) frame.parent = scene_->frame_index(*content.parent, "joint '" + content.name + "'");
    frame.placement.origin = numbers(content.placement.origin);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Number& entry = content.placement.rotation(static_cast<int>(i), static_cast<int>(j));
        frame.placement.rotation[i][j] = Real(entry, Real::working_digits());
      }
    }
    frame.kind = content.joint;
    frame.turned = identity_rotation();
    frame.displacement = Real(0);
    if (frame.kind == JointKind::attitude) {
      std::array<Real, 4> e;
      for (std::size_t k = 0; k < 4; ++k)
        e[k] = number(initial_component(scene_->attitudes[as_index(*content.attitude)], k));
      frame.turned = rotation_of(e);
    } else if (frame.kind != JointKind::weld) {
      frame.axis = numbers(content.axis);
      frame.axis = (Real(1) / norm(frame.axis)) * frame.axis;
      frame.displacement = number(content.displacement);
    }
    frames_.push_back(std::move(frame));
  }
  for (const JointContent& joint : scene_->joints) joint_pitches_.push_back(number(joint.pitch));
  for (const ConstraintContent& constraint : scene_->constraints) {
    if (const auto* closure = std::get_if<JointClosure>(&constraint.law)) {
      closures_.push_back(*closure);
      pitches_.push_back(number(closure->pitch));
    }
  }
  for (const GraphJoint& joint : graph.joints) {
    for (const int f : joint.frames) {
      const JointContent& content = scene_->joints[as_index(joint.scene_joint)];
      Frame& frame = frames_[as_index(f)];
      frame.slides_with_turn = content.type == JointType::helical && frame.kind == JointKind::prismatic;
      frame.variable = variables_;
      frame.per_variable = frame.slides_with_turn ? joint_pitches_[as_index(joint.scene_joint)] : Real(1);
      if (!frame.slides_with_turn) variables_ += frame.kind == JointKind::attitude ? 3 : 1;
    }
  }
  place_frames();
  Real size;
  for (const RealPose& pose : poses_) size = std::max(size, norm(pose.origin));
  if (!size.is_zero()) {
    const Real scale = Real(1) / size;
    length_ = size;
    for (Frame& frame : frames_) {
      frame.placement.origin = scale * frame.placement.origin;
      if (frame.kind == JointKind::prismatic) frame.displacement *= scale;
      if (frame.slides_with_turn) frame.per_variable *= scale;
    }
    for (Real& pitch : joint_pitches_) pitch *= scale;
    for (Real& pitch : pitches_) pitch *= scale;
    place_frames();
  }
}

void JointSpace::place_frames() {
  poses_.assign(frames_.size(), {});
  std::vector<bool> done(frames_.size(), false);
  poses_[0] = {identity_rotation(), {Real(0), Real(0), Real(0)}};
  done[0] = true;
  for (std::size_t remaining = frames_.size() - 1; remaining > 0;) {
    for (std::size_t f = 1; f < frames_.size(); ++f) {
      const Frame& frame = frames_[f];
      if (done[f] || !done[as_index(*frame.parent)]) continue;
      const RealPose& parent = poses_[as_index(*frame.parent)];
      RealPose& pose = poses_[f];
      pose.origin = parent.origin + parent.rotation * frame.placement.origin;
      pose.rotation = parent.rotation * frame.placement.rotation;
      if (frame.kind == JointKind::prismatic) {
        pose.origin = pose.origin + frame.displacement * (pose.rotation * frame.axis);
      } else if (frame.kind == JointKind::revolute) {
        pose.rotation = pose.rotation * rotation_about(frame.axis, frame.displacement);
      } else if (frame.kind == JointKind::attitude) {
        pose.rotation = pose.rotation * frame.turned;
      }
      done[f] = true;
      --remaining;
    }
  }
}

void JointSpace::move(const RealRow& by) {
  for (Frame& frame : frames_) {
    if (!frame.variable) continue;
    const std::size_t v = as_index(*frame.variable);
    if (frame.kind == JointKind::attitude) {
      frame.turned = frame.turned * rotation_by({by[v], by[v + 1], by[v + 2]});
    } else {
      frame.displacement += frame.per_variable * by[v];
    }
  }
  place_frames();
}

Real JointSpace::distance_from(const JointSpace& other) const {
  Real largest;
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    largest = std::max(largest, abs(frames_[f].displacement - other.frames_[f].displacement));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        largest = std::max(largest, abs(frames_[f].turned[i][j] - other.frames_[f].turned[i][j]));
      }
    }
  }
  return largest;
}

RealRow JointSpace::variable_twist(int variable) const {
  RealRow sum(6, Real(0));
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const Frame& frame = frames_[f];
    if (!frame.variable) continue;
    const int component = variable - *frame.variable;
    const bool attitude = frame.kind == JointKind::attitude;
    if (component < 0 || component > (attitude ? 2 : 0)) continue;
    const RealPose& pose = poses_[f];
    const RealVector axis = attitude ? column(pose.rotation, component) : pose.rotation * frame.axis;
    const RealVector none{Real(0), Real(0), Real(0)};
    const RealRow twist = frame.kind == JointKind::prismatic ? row_of(none, frame.per_variable * axis)
                                                             : row_of(axis, cross(pose.origin, axis));
    for (std::size_t i = 0; i < 6; ++i) sum[i] += twist[i];
  }
  return sum;
}

std::vector<JointTwists> JointSpace::twists() const {
  std::vector<JointTwists> all;
  for (const GraphJoint& joint : graph_->joints) {
    JointTwists here;
    const auto add = [&here, this](const RealRow& twist) {
      const RealVector angular = angular_of(twist);
      const bool slide = norm(angular).is_zero();
      const RealVector direction = slide ? RealVector{twist[3], twist[4], twist[5]} : angular;
      here.twists.push_back(twist);
      const bool screw = !is_small(dot(angular, RealVector{twist[3], twist[4], twist[5]}));
      const std::string along = direction_text(direction);
      here.names.push_back(slide   ? say_("slide along {}", along)
                           : screw ? say_("screw along {}", along)
                                   : say_("turn about {}", along));
    };
    std::optional<int> last;
    for (const int f : joint.frames) {
      const Frame& frame = frames_[as_index(f)];
      if (frame.variable == last) continue;  // both frames of a helical joint are one freedom
      last = frame.variable;
      for (int k = 0; k < (frame.kind == JointKind::attitude ? 3 : 1); ++k) add(variable_twist(*frame.variable + k));
    }
    if (joint.closes_loop) {
      const JointContent& content = scene_->joints[as_index(joint.scene_joint)];
      const RealPose& a = poses_[as_index(scene_->frame_index(content.a, joint.name))];
      const RealPose& b = poses_[as_index(scene_->frame_index(content.b, joint.name))];
      PlacedJoint<RealVector, Real> placed;
      for (int i = 0; i < 3; ++i) {
        placed.a[as_index(i)] = column(a.rotation, i);
        placed.b[as_index(i)] = column(b.rotation, i);
      }
      placed.point = b.origin;
      placed.pitch = joint_pitches_[as_index(joint.scene_joint)];
      for (const JointFreedom& freedom : freedoms(content.type)) {
        const auto [angular, linear] = twist_of(freedom, placed);
        add(row_of(angular, linear));
      }
    }
    all.push_back(std::move(here));
  }
  return all;
}

RealPose JointSpace::place(const GraphJoint& joint) const {
  const JointContent& content = scene_->joints[as_index(joint.scene_joint)];
  if (joint.closes_loop) {
    return {poses_[as_index(scene_->frame_index(content.a, joint.name))].rotation,
            poses_[as_index(scene_->frame_index(content.b, joint.name))].origin};
  }
  if (joint.frames.empty()) return poses_[as_index(content.of_tree->last)];  // a weld
  const Frame& first = frames_[as_index(joint.frames.front())];
  return {poses_[as_index(*first.parent)].rotation * first.placement.rotation, poses_[as_index(joint.frames.back())].origin};
}

RealRow JointSpace::closure_errors() const {
  RealRow errors;
  for (std::size_t c = 0; c < closures_.size(); ++c) {
    const Closure& law = closures_[c];
    const RealPose& a = poses_[as_index(scene_->frame_index(law.a, "a closure"))];
    const RealPose& b = poses_[as_index(scene_->frame_index(law.b, "a closure"))];
    const RealVector a_i = column(a.rotation, law.i), ab = b.origin - a.origin;
    if (law.kind == Closure::Kind::offset) errors.push_back(dot(ab, a_i));
    if (law.kind == Closure::Kind::alignment) errors.push_back(dot(a_i, column(b.rotation, law.j)));
    if (law.kind == Closure::Kind::screw) {
      Real sine, cosine;
      sincos(dot(ab, a_i) / pitches_[c], sine, cosine);
      const RealVector b_y = column(b.rotation, 1);
      errors.push_back(pitches_[c] *
                       (sine * dot(column(a.rotation, 1), b_y) - cosine * dot(column(a.rotation, 2), b_y)));
    }
  }
  return errors;
}

RealRows JointSpace::closure_jacobian() const {
  std::vector<RealRow> twists;
  for (int v = 0; v < variables_; ++v) twists.push_back(variable_twist(v));
  // +1 for what moves b, −1 for what moves a, 0 for what moves both.
  const auto add = [this](std::vector<int>& sides, int f, int side) {
    for (; f > 0; f = *frames_[as_index(f)].parent) {
      const Frame& frame = frames_[as_index(f)];
      if (!frame.variable) continue;
      // A helical joint's two frames are both in the chain or both out of it.
      for (int k = 0; k < (frame.kind == JointKind::attitude ? 3 : 1) && !frame.slides_with_turn; ++k) {
        sides[as_index(*frame.variable + k)] += side;
      }
    }
  };
  RealRows jacobian;
  for (std::size_t c = 0; c < closures_.size(); ++c) {
    const Closure& law = closures_[c];
    const int frame_a = scene_->frame_index(law.a, "a closure"), frame_b = scene_->frame_index(law.b, "a closure");
    std::vector<int> sides(as_index(variables_), 0);
    add(sides, frame_b, 1);
    add(sides, frame_a, -1);
    const RealPose& a = poses_[as_index(frame_a)];
    const RealPose& b = poses_[as_index(frame_b)];
    const RealVector a_i = column(a.rotation, law.i);
    RealRow row;
    for (std::size_t v = 0; v < twists.size(); ++v) {
      const RealVector angular = angular_of(twists[v]);
      const RealVector velocity = velocity_at(twists[v], b.origin);
      Real entry = dot(velocity, a_i);
      if (law.kind == Closure::Kind::alignment) entry = dot(angular, cross(column(b.rotation, law.j), a_i));
      if (law.kind == Closure::Kind::screw) entry -= pitches_[c] * dot(angular, a_i);
      row.push_back(Real(sides[v]) * entry);
    }
    jacobian.push_back(std::move(row));
  }
  return jacobian;
}

bool JointSpace::close(std::size_t largest_rank, const Real& small) {
  const JointSpace before = *this;
  const Real longest(Number::rational(1, 2), Real::working_digits());  // a turn of half a radian
  for (int iteration = 0; iteration < 100; ++iteration) {
    const RealRow errors = closure_errors();
    if (std::all_of(errors.begin(), errors.end(), [&](const Real& e) { return abs(e) <= small; })) return true;
    const RealRows jacobian = closure_jacobian();
    RealRow step = least_norm_solution({.rows = jacobian, .right_side = errors, .columns = as_index(variables_)},
                                       twist_tolerance(), largest_rank);
    const Real size = torsor::length(step);
    if (size.is_nan()) break;
    const Real scale = size > longest ? longest / size : Real(1);
    for (Real& entry : step) entry = -(scale * entry);
    move(step);
  }
  *this = before;
  return false;
}

}  // namespace torsor
