// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/reframing.hpp"

#include <algorithm>
#include <utility>

#include "torsor/generator/dynamics/motion/placement_cost.hpp"
#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

using Triplet = std::array<Number, 3>;

// What placements cost, in operations: all vectors of a recursion go through a joint's rotation, an arm is crossed with
// some of them, an entry of an inertia is met once or twice.
constexpr int vectors_turned = 5, of_component = 8, of_entry = 4, of_general_axis = 100;

Triplet operator*(const Rotation& r, const Triplet& v) {
  Triplet result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result[as_index(i)] += r(i, j) * v[as_index(j)];
  }
  return result;
}

Triplet sum(const Triplet& a, const Triplet& b, const Number& of_b) {
  return {a[0] + of_b * b[0], a[1] + of_b * b[1], a[2] + of_b * b[2]};
}

int component_count(const Triplet& v) {
  return static_cast<int>(std::count_if(v.begin(), v.end(), [](const Number& n) { return !n.is_zero(); }));
}

/// The components where all are numbers.
std::optional<Triplet> numbers(const Vector& v) {
  Triplet result;
  for (int i = 0; i < 3; ++i) {
    if (v[i].is_zero()) continue;
    if (!v[i].is_constant()) return std::nullopt;
    result[as_index(i)] = v[i].polynomial().constant();
  }
  return result;
}

/// Rz(φ) Rx(α) Rz(ψ).
struct Decomposition {
  ExactTurn phi, alpha, psi;
  bool parallel = false;  ///< sin α = 0: φ is none
};

Decomposition decomposed(const Rotation& r, int& rounded) {
  Decomposition parts;
  if (r(0, 2).is_zero() && r(1, 2).is_zero()) {
    parts.parallel = true;
    parts.alpha = {r(2, 2), Number()};
    parts.psi = {r(0, 0), -r(0, 1)};
    return parts;
  }
  parts.phi = turn_towards(-r(1, 2), r(0, 2), rounded);
  parts.alpha = turn_with_cosine(r(2, 2), rounded);
  parts.psi = turn_towards(r(2, 1), r(2, 0), rounded);
  return parts;
}

/// s + k π/12 + a rational number.
Value shifted(Program& program, const Value& displacement, const ExactTurn& shift, int& rounded) {
  const AngleParts parts = angle_of(shift, rounded);
  Value angle = displacement;
  if (parts.twelfths != 0) angle += Number::rational(parts.twelfths, 12) * program.symbol(pi().as_symbol());
  if (!parts.rest.is_zero()) angle += program.number(parts.rest);
  return angle;
}

Vector in_metres(Program& program, const Triplet& v) {
  Vector result;
  for (int i = 0; i < 3; ++i) {
    if (!v[as_index(i)].is_zero()) result[i] = program.number(v[as_index(i)], units::metre);
  }
  return result;
}

/// Along which axis of k' Rx(α) or Rz(φ) Rx(α) has its z.
Triplet axis_of(const Decomposition& parts, const ExactTurn& carrier) {
  if (parts.parallel) return {Number(), Number(), parts.alpha.cosine};
  const ExactTurn left = parts.phi * carrier.inverse();
  return {left.sine * parts.alpha.sine, -(left.cosine * parts.alpha.sine), parts.alpha.cosine};
}

/// A joint's constant rotation, and b of what goes into its angle.
struct Placement {
  Rotation rotation;
  ExactTurn given_back;
};

/// Rz(b) goes into the angle.
Placement absorbed(const Decomposition& parts, const ExactTurn& carrier) {
  if (parts.parallel) {
    const bool up = parts.alpha.cosine.sign() > 0;
    const ExactTurn rest = up ? carrier * parts.psi.inverse() : (carrier * parts.psi).inverse();
    return {turned_about(0, parts.alpha), rest};
  }
  const Rotation left = turned_about(2, parts.phi * carrier.inverse());
  return {left * turned_about(0, parts.alpha), parts.psi.inverse()};
}

class FrameChoice {
 public:
  FrameChoice(const SceneContent& scene, Program& program, const std::vector<Link>& links)
      : scene_(scene),
        program_(program),
        links_(links),
        frames_(links.size()),
        onto_(links.size()),
        between_(links.size()),
        turns_(links.size()),
        children_(links.size()) {}

  std::optional<NewFrames> run() {
    if (all_permutations()) return std::nullopt;
    for (std::size_t k = 1; k < links_.size(); ++k) {
      children_[parent(k)].push_back(k);
      frames_[k].turns_about_z = may_turn(k) && find_axis(k);
    }
    for (std::size_t k = 1; k < links_.size(); ++k) {
      if (moves(k)) between_[k] = decomposed(seen_from_parent(k), rounded_);
    }
    int before = 0, after = 0;
    for (std::size_t k = 1; k < links_.size(); ++k) {
      before += cost_as_it_is(k);
      place(k);
      after += cost(k);
    }
    if (after >= before) return std::nullopt;
    return NewFrames{std::move(frames_), rounded_};
  }

 private:
  std::size_t parent(std::size_t k) const { return static_cast<std::size_t>(links_[k].parent); }
  bool moves(std::size_t k) const { return frames_[k].turns_about_z; }
  bool slides(std::size_t k) const { return links_[k].joint == JointKind::prismatic; }
  /// What the ground carries is turned once, and by constants.
  int weight(std::size_t k) const { return parent(k) == 0 ? 1 : vectors_turned; }

  bool all_permutations() const {
    return std::all_of(links_.begin() + 1, links_.end(), [](const Link& link) {
      const bool general = !link.aligned && link.in_group == 0 && !link.axis.is_zero();
      return !general && (link.parent == 0 || is_permutation(link.placement_rotation));
    });
  }

  bool may_turn(std::size_t k) const {
    const Link& link = links_[k];
    const bool in_group = link.in_group > 0 || (k + 1 < links_.size() && links_[k + 1].in_group == 1);
    if (in_group || link.joint == JointKind::weld) return false;
    return slides(k) || !(link.displacement.is_zero() || link.displacement.is_constant());
  }

  /// Q turns z to the joint's axis. False where that depends on parameters.
  bool find_axis(std::size_t k) {
    const Vector& axis = links_[k].axis;
    std::optional<Triplet> n = numbers(axis);
    if (!n) {
      const WorkingDigits precision(direction_digits + 30);
      Evaluator<Real> evaluate(program_, [](const SymbolPointer&) { return Real::pi(); });
      std::array<Real, 3> direction;
      for (int i = 0; i < 3; ++i) {
        if (!axis[i].is_zero() && program_.stage(axis[i]) > Stage::generation) return false;
        direction[as_index(i)] = axis[i].is_zero() ? Real(0) : evaluate(axis[i]);
      }
      n = rational_direction(direction, rounded_);
    }
    onto_[k] = rotation_onto(*n);
    return true;
  }

  /// Q_pᵀ P Q.
  Rotation seen_from_parent(std::size_t k) const {
    return onto_[parent(k)].transpose() * links_[k].placement_rotation * onto_[k];
  }

  /// Of the joint, from its parent's origin, in axes that turn by `turn` about z of Q_p.
  Vector arm(std::size_t k, const ExactTurn& turn) const {
    const std::size_t p = parent(k);
    const Vector from_parent = links_[k].placement_origin - in_metres(program_, frames_[p].origin);
    return turned_about(2, turn.inverse()) * (onto_[p].transpose() * from_parent);
  }

  // ---- one link after the other, parents first ----

  void place(std::size_t k) {
    const std::size_t p = parent(k);
    NewFrame& frame = frames_[k];
    if (!moves(k)) {
      frame.placement_rotation = turned_about(2, turns_[p].inverse()) * seen_from_parent(k);
      frame.placement_origin = arm(k, turns_[p]);
      return;
    }
    if (p != 0) slide(k);
    turns_[k] = best_turn(k);
    if (p == 0) slide_on_ground(k);
    const Placement own = placement(k, turns_[k]);
    frame.placement_rotation = own.rotation;
    frame.shift = turns_[k] * own.given_back.inverse();
    frame.rotation = onto_[k] * turned_about(2, turns_[k]);
  }

  /// How far along the axis to where a component vanishes that the axis has not too little of; none where that leaves
  /// as many components.
  Number way_along(const Triplet& at, const Triplet& axis) const {
    Number best;
    int fewest = component_count(at);
    for (const std::size_t i : {1U, 2U, 0U}) {
      if (axis[i].abs() < Number::rational(1, 2) || at[i].is_zero()) continue;
      const Number way = -(at[i] / axis[i]);
      const int left = component_count(sum(at, axis, way));
      if (left >= fewest) continue;
      fewest = left;
      best = way;
    }
    return best;
  }

  void slide(std::size_t k) {
    NewFrame& frame = frames_[k];
    const ExactTurn& carrier = turns_[parent(k)];
    frame.placement_origin = arm(k, carrier);
    const std::optional<Triplet> at = numbers(frame.placement_origin);
    if (!at) return;
    if (slides(k)) {
      frame.origin = sum({}, links_[k].placement_rotation.transpose() * from_parent(k), Number(-1));
      frame.placement_origin = {};
      return;
    }
    const Triplet axis = axis_of(between_[k], carrier);
    const Number way = way_along(*at, axis);
    if (way.is_zero()) return;
    frame.placement_origin = in_metres(program_, sum(*at, axis, way));
    frame.origin = along_axis(k, way);
  }

  Triplet from_parent(std::size_t k) const {
    return sum(*numbers(links_[k].placement_origin), frames_[parent(k)].origin, Number(-1));
  }

  Triplet along_axis(std::size_t k, const Number& way) const { return onto_[k] * Triplet{Number(), Number(), way}; }

  /// On the ground no arm is turned: the origin goes where the first link that this one carries has the shortest.
  void slide_on_ground(std::size_t k) {
    NewFrame& frame = frames_[k];
    for (const std::size_t child : children_[k]) {
      const std::optional<Triplet> at = numbers(arm(child, turns_[k]));
      if (!moves(child) || !at) continue;
      if (slides(k)) {
        frame.origin = *numbers(links_[child].placement_origin);
      } else {
        const Triplet axis = axis_of(between_[child], turns_[k]);
        const bool across = axis[1].abs() >= Number::rational(1, 2);
        const Number way = slides(child) || !across ? Number() : -((*at)[1] / axis[1]);
        frame.origin = along_axis(k, sum(*at, axis, way)[2]);
      }
      break;
    }
    frame.placement_origin =
        links_[k].placement_origin + links_[k].placement_rotation * in_metres(program_, frame.origin);
  }

  // ---- turns about z ----

  /// The turns that make some rotation or inertia cheap.
  std::vector<ExactTurn> candidates(std::size_t k) {
    std::vector<ExactTurn> all{ExactTurn()};
    const auto add = [&](const Triplet& v) {
      if (!v[0].is_zero() && !v[1].is_zero()) all.push_back(turn_towards(v[0], v[1], rounded_));
    };
    for (const std::size_t child : children_[k]) {
      if (!moves(child)) continue;
      if (!between_[child].parallel) {
        all.push_back(between_[child].phi);
      } else if (const auto at = numbers(arm(child, ExactTurn()))) {
        add(*at);
      }
    }
    if (slides(k)) all.push_back(absorbed(between_[k], turns_[parent(k)]).given_back);
    if (children_[k].empty() && !slides(k)) {
      const MassProperties& body = links_[k].mass;
      const std::optional<Triplet> h = numbers(body.first_moment);
      if (h && body.mass.is_constant()) {
        const Number mass = body.mass.is_zero() ? Number() : body.mass.polynomial().constant();
        add(onto_[k].transpose() * sum(*h, frames_[k].origin, -mass));
      }
    }
    return all;
  }

  ExactTurn best_turn(std::size_t k) {
    const int rounded = rounded_;
    const std::vector<ExactTurn> all = candidates(k);
    std::size_t best = 0;
    int least = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      int cost = cost_of_own(k, all[i]);
      for (const std::size_t child : children_[k]) cost += cost_of_carrying(child, all[i]);
      cost += of_entry * entries(k, onto_[k] * turned_about(2, all[i]), frames_[k].origin);
      if (i > 0 && cost >= least) continue;
      least = cost;
      best = i;
    }
    if (best == 0) rounded_ = rounded;
    return all[best];
  }

  Placement placement(std::size_t k, const ExactTurn& own) const {
    const std::size_t p = parent(k);
    const Rotation kept = turned_about(2, turns_[p].inverse()) * seen_from_parent(k);
    Placement best = absorbed(between_[k], turns_[p]);
    if (slides(k)) {  // there is no angle: b is the frame's own turn
      if ((best.given_back * own.inverse()).is_none()) return best;
      return {kept * turned_about(2, own), own};
    }
    int least = cost_of_placement(k, best, own);
    std::vector<Placement> others{{kept, {}}};
    if (p == 0) others.push_back({kept * turned_about(2, own), own});
    for (Placement& other : others) {
      const int cost = cost_of_placement(k, other, own);
      if (cost > least) continue;
      least = cost;
      best = std::move(other);
    }
    return best;
  }

  int cost_of_placement(std::size_t k, const Placement& placement, const ExactTurn& own) const {
    const int shift = slides(k) ? 0 : cost_of_shift(own * placement.given_back.inverse());
    return weight(k) * cost_of_turning(placement.rotation) + shift;
  }

  int cost_of_own(std::size_t k, const ExactTurn& own) const { return cost_of_placement(k, placement(k, own), own); }

  /// Of a link that this one carries, when this one turns.
  int cost_of_carrying(std::size_t k, const ExactTurn& carrier) const {
    const Rotation kept = turned_about(2, carrier.inverse()) * seen_from_parent(k);
    int cost = weight(k) * cost_of_turning(kept);
    const Vector from = arm(k, carrier);
    const std::optional<Triplet> at = numbers(from);
    int count = 0;
    for (int i = 0; i < 3; ++i) count += from[i].is_zero() ? 0 : 1;
    if (moves(k)) {
      cost = std::min(cost, weight(k) * cost_of_turning(absorbed(between_[k], carrier).rotation) + (slides(k) ? 0 : 1));
      const Triplet axis = axis_of(between_[k], carrier);
      if (at) count = slides(k) ? 0 : component_count(sum(*at, axis, way_along(*at, axis)));
    }
    return cost + of_component * count;
  }

  // ---- what a link costs ----

  int cost_as_it_is(std::size_t k) const {
    const Link& link = links_[k];
    int cost = weight(k) * cost_of_turning(link.placement_rotation) + of_entry * entries(k, Rotation(), {});
    for (int i = 0; i < 3 && parent(k) != 0; ++i) cost += link.placement_origin[i].is_zero() ? 0 : of_component;
    return moves(k) && !link.aligned ? cost + of_general_axis : cost;
  }

  int cost(std::size_t k) const {
    const NewFrame& frame = frames_[k];
    int cost =
        weight(k) * cost_of_turning(frame.placement_rotation) + of_entry * entries(k, frame.rotation, frame.origin);
    for (int i = 0; i < 3 && parent(k) != 0; ++i) cost += frame.placement_origin[i].is_zero() ? 0 : of_component;
    return moves(k) && !slides(k) ? cost + cost_of_shift(frame.shift) : cost;
  }

  int entries(std::size_t k, const Rotation& rotation, const Triplet& origin) const {
    const bool own = rotation.is_identity() && links_[k].aligned;
    return inertia_entries(scene_, links_[k].mass,
                           {.rotation = rotation, .origin = origin, .axis = own ? *links_[k].aligned : 2});
  }

  const SceneContent& scene_;
  Program& program_;
  const std::vector<Link>& links_;
  std::vector<NewFrame> frames_;
  std::vector<Rotation> onto_;  ///< Q
  std::vector<Decomposition> between_;
  std::vector<ExactTurn> turns_;  ///< of the frame, about its z
  std::vector<std::vector<std::size_t>> children_;
  int rounded_ = 0;
};

}  // namespace

std::optional<NewFrames> cheaper_frames(const SceneContent& scene, Program& program, const std::vector<Link>& links) {
  return FrameChoice(scene, program, links).run();
}

namespace {

/// The joint's axis is its z, and the joint's angle is counted from elsewhere.
void turn_about_z(Program& program, Link& link, const ExactTurn& shift, int& rounded) {
  link.axis = {{}, {}, program.number(Number(1))};
  link.aligned = 2;
  if (link.joint != JointKind::revolute) return;
  link.turn = Turn::aligned;
  link.rotation = {};
  link.angle = shifted(program, link.displacement, shift, rounded);
  link.sine = program.sin(link.angle);
  link.cosine = program.cos(link.angle);
}

}  // namespace

BodyTree reframed(const BodyTree& tree) {
  BodyTree result = tree;
  Program& program = tree.program();
  const std::optional<NewFrames> found = cheaper_frames(tree.scene(), program, tree.links());
  if (!found) return result;
  int rounded = found->rounded;
  const std::vector<NewFrame>& frames = found->of_links;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    Link& link = result.links_[k];
    const NewFrame& frame = frames[k];
    link.placement_rotation = frame.placement_rotation;
    link.placement_factors = plane_factors(frame.placement_rotation).value_or(std::vector<Rotation>());
    link.placement_origin = frame.placement_origin;
    link.scene_rotation = frame.rotation.transpose();
    link.scene_origin = -(link.scene_rotation * in_metres(program, frame.origin));
    if (frame.turns_about_z) turn_about_z(program, link, frame.shift, rounded);
  }
  for (FramePlace& place : result.places_) {
    const Link& link = result.links_[static_cast<std::size_t>(place.link)];
    place.origin = link.scene_origin + link.scene_rotation * place.origin;
    place.rotation = link.scene_rotation * place.rotation;
  }
  result.rounded_directions_ = rounded;
  result.gather_bodies();
  return result;
}

}  // namespace torsor
