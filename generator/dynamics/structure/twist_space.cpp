// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/twist_space.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/structure/joint_space.hpp"

namespace torsor {
namespace {

constexpr std::size_t six = 6;

RealVector first(const RealRow& screw) { return {screw[0], screw[1], screw[2]}; }
RealVector last(const RealRow& screw) { return {screw[3], screw[4], screw[5]}; }
RealRow as_row(const RealVector& v) { return {v[0], v[1], v[2]}; }

/// Rounding must not be taken for a small screw: entries below the tolerance are set to zero.
RealRows chopped(RealRows rows) {
  Real largest;
  for (const RealRow& row : rows) {
    for (const Real& entry : row) largest = std::max(largest, abs(entry));
  }
  for (RealRow& row : rows) {
    for (Real& entry : row) {
      if (abs(entry) <= largest * twist_tolerance()) entry = Real(0);
    }
  }
  return rows;
}

RealRows independent(const RealRows& rows) { return chopped(reduced_by_size(rows, six, twist_tolerance()).reduced()); }

/// A space of screws {S, T_O}, S the part that is the same at every point (the turn, or the force).
struct Screws {
  RealRows all;
  RealRows pure;        ///< with S = 0: translations, or couples
  RealRows directions;  ///< a basis of the S

  explicit Screws(const RealRows& rows) : all(independent(rows)) {
    RealRows heads;
    for (const RealRow& row : all) heads.push_back(as_row(first(row)));
    directions = reduced_by_size(heads, 3, twist_tolerance()).reduced();
    for (const RealRow& weights : null_space(transposed(heads, 3), heads.size(), twist_tolerance())) {
      pure.push_back(combination(weights, all, six));
    }
  }

  RealVector pure_direction(std::size_t k = 0) const { return last(pure[k]); }
  RealVector direction(std::size_t k = 0) const { return {directions[k][0], directions[k][1], directions[k][2]}; }

  /// A point C where T_C = T_O + S ∧ OC vanishes for all the screws; nothing when there is none.
  std::optional<RealVector> common_point() const {
    RealRows rows;
    RealRow right;
    for (const RealRow& screw : all) {
      const RealVector s = first(screw), t = last(screw);
      rows.push_back({Real(0), -s[2], s[1]});
      rows.push_back({s[2], Real(0), -s[0]});
      rows.push_back({-s[1], s[0], Real(0)});
      for (const Real& component : t) right.push_back(-component);
    }
    const auto found = solution({.rows = rows, .right_side = right, .columns = 3}, twist_tolerance());
    if (!found) return std::nullopt;
    return RealVector{(*found)[0], (*found)[1], (*found)[2]};
  }
};

/// S·T_O of a screw: zero for a turn, or for a force.
Real invariant(const RealRow& screw) { return dot(first(screw), last(screw)); }

TwistClass one_freedom(const Screws& twists) {
  const RealRow& twist = twists.all[0];
  if (!twists.pure.empty()) return {1, JointType::prismatic, last(twist), std::nullopt};
  const RealVector axis = first(twist);
  const RealVector point = (Real(1) / dot(axis, axis)) * cross(axis, last(twist));
  return {1, is_small(invariant(twist)) ? JointType::revolute : JointType::helical, axis, point};
}

TwistClass two_freedoms(const Screws& twists) {
  TwistClass found{2, std::nullopt, std::nullopt, std::nullopt};
  if (twists.pure.size() == 1) {
    const RealVector axis = twists.direction();
    const RealVector across = cross(axis, twists.pure_direction());
    if (is_small(norm(across))) {
      // Any screw with a turn, less its slide, turns about the axis.
      const RealRow& turning = is_small(norm(first(twists.all[0]))) ? twists.all[1] : twists.all[0];
      const RealVector omega = first(turning);
      return {2, JointType::cylindrical, axis, (Real(1) / dot(omega, omega)) * cross(omega, last(turning))};
    }
  } else if (twists.pure.empty()) {
    if (const auto centre = twists.common_point()) {
      return {2, JointType::universal, cross(twists.direction(0), twists.direction(1)), centre};
    }
  }
  return found;
}

TwistClass three_freedoms(const Screws& twists) {
  if (twists.pure.empty()) {
    if (const auto centre = twists.common_point()) return {3, JointType::spherical, std::nullopt, centre};
  } else if (twists.pure.size() == 2) {
    const RealVector normal = cross(twists.pure_direction(0), twists.pure_direction(1));
    const RealVector across = cross(normal, twists.direction());
    if (is_small(norm(across))) return {3, JointType::planar, normal, std::nullopt};
  }
  return {3, std::nullopt, std::nullopt, std::nullopt};
}

TwistClass four_freedoms(const Screws& wrenches) {
  if (wrenches.pure.size() == 1) {
    const RealVector normal = wrenches.direction(), couple = wrenches.pure_direction();
    // A couple across the normal, and a force that is a sliding vector: its line meets the line of contact.
    const RealRow& pushing = is_small(norm(first(wrenches.all[0]))) ? wrenches.all[1] : wrenches.all[0];
    if (is_small(dot(normal, couple)) && is_small(invariant(pushing)))
      return {4, JointType::line_contact, normal, std::nullopt};
  } else if (wrenches.pure.empty()) {
    if (const auto centre = wrenches.common_point()) {
      return {4, JointType::sphere_in_cylinder, cross(wrenches.direction(0), wrenches.direction(1)), centre};
    }
  }
  return {4, std::nullopt, std::nullopt, std::nullopt};
}

TwistClass five_freedoms(const Screws& wrenches) {
  const RealRow& wrench = wrenches.all[0];
  if (wrenches.pure.empty() && is_small(invariant(wrench))) {
    const RealVector normal = first(wrench);
    return {5, JointType::point_contact, normal, (Real(1) / dot(normal, normal)) * cross(normal, last(wrench))};
  }
  return {5, std::nullopt, std::nullopt, std::nullopt};
}

}  // namespace

Real twist_tolerance() { return zero_tests::twists.bound(); }
bool is_small(const Real& entry) { return abs(entry) <= twist_tolerance(); }

RealRows span_of(const RealRows& a, const RealRows& b) {
  RealRows both = a;
  both.insert(both.end(), b.begin(), b.end());
  return independent(both);
}

RealRows intersection_of(const RealRows& a, const RealRows& b) {
  // Σ x_i a_i = Σ y_j b_j.
  const RealRows own = independent(a);
  RealRows both = own;
  for (const RealRow& row : independent(b)) {
    both.push_back(row);
    for (Real& entry : both.back()) entry = -entry;
  }
  RealRows common;
  for (const RealRow& weights : null_space(transposed(both, six), both.size(), twist_tolerance())) {
    common.push_back(combination(weights, own, six));
  }
  return independent(chopped(common));
}

RealRows reciprocal_to(const RealRows& twists) {
  RealRows wrenches;
  for (const RealRow& x : null_space(twists, six, twist_tolerance())) {
    wrenches.push_back({x[3], x[4], x[5], x[0], x[1], x[2]});  // what multiplies V is the force
  }
  return wrenches;
}

TwistClass recognise_twists(const RealRows& rows) {
  const Screws twists(rows);
  switch (twists.all.size()) {
    case 0:
      return {0, JointType::weld, std::nullopt, std::nullopt};
    case 1:
      return one_freedom(twists);
    case 2:
      return two_freedoms(twists);
    case 3:
      return three_freedoms(twists);
    case 4:
      return four_freedoms(Screws(reciprocal_to(rows)));
    case 5:
      return five_freedoms(Screws(reciprocal_to(rows)));
    default:
      return {6, JointType::free, std::nullopt, std::nullopt};
  }
}

std::string TwistClass::text(const NaturalLanguage& say) const {
  if (!type) return say("{} freedoms, no joint of the table", freedoms);
  const std::string name = name_of(*type, say);
  if (!direction) return name;
  const bool normal = *type == JointType::planar || *type == JointType::line_contact ||
                      *type == JointType::point_contact || *type == JointType::universal;
  return normal ? say("{} of normal {}", name, direction_text(*direction)) : say("{} along {}", name, direction_text(*direction));
}

}  // namespace torsor
