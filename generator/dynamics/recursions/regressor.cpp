// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/regressor.hpp"

#include <set>

#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// Twists of all links per unit rate of one unknown, at the links' origins, in their axes, linear ones over the tree's
/// length unit as accelerations are; null for the ground and what the unknown does not move.
std::vector<Twist> partial_twists(const BodyTree& tree, int unknown) {
  Program& program = tree.program();
  const auto& links = tree.links();
  std::vector<Twist> all(links.size());
  for (std::size_t k = 1; k < links.size(); ++k) {
    const Link& link = links[k];
    const Twist& parent = all[static_cast<std::size_t>(link.parent)];
    const Vector origin = bound(program, tree.arm(link));
    Vector linear = bound(program, parent.linear + cross(parent.angular, origin));
    linear = tree.from_parent(link, linear);
    Vector angular = tree.from_parent(link, parent.angular);
    for (const auto& [i, partial] : link.partials) {
      if (i != unknown) continue;
      (link.joint == JointKind::revolute ? angular : linear) += partial * link.axis;
    }
    all[k].linear = bound(program, linear);
    all[k].angular = bound(program, angular);
  }
  return all;
}

/// The ten powers of unit parameters on a partial twist.
std::array<Value, 10> powers(const BodyTree& tree, Acceleration& motion, const Twist& partial) {
  Program& program = tree.program();
  constexpr std::array<std::size_t, 3> diagonal{4, 7, 9};
  constexpr std::array<std::size_t, 3> beside{5, 8, 6};  // J_xy, J_yz, J_zx
  std::array<Value, 10> result;
  const Vector& v = partial.linear;
  const Vector& w = partial.angular;
  result[0] = dot(motion.linear(), v);
  const Vector turned = cross(motion.linear(), w);  // (e_j ∧ Γ) · w = (Γ ∧ w)_j
  for (int j = 0; j < 3; ++j) {
    Value power = turned[j];
    for (int i = 0; i < 3; ++i) {
      if (!v[i].is_zero()) power += motion.u(i, j) * v[i];
    }
    result[static_cast<std::size_t>(1 + j)] = power;
  }
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    const int z = (x + 2) % 3;
    // Moment of J_xx = 1: {Ω̇_x, Ω_z Ω_x, −Ω_x Ω_y}; of J_xy = 1: {−U_zx, U_zy, Ω_x² − Ω_y²}, along x, y, z.
    Value power = motion.angular()[x] * w[x];
    if (!w[y].is_zero()) power += motion.product(z, x) * w[y];
    if (!w[z].is_zero()) power -= motion.product(x, y) * w[z];
    result[diagonal[static_cast<std::size_t>(x)]] = power;
    Value across;
    if (!w[x].is_zero()) across -= motion.u(z, x) * w[x];
    if (!w[y].is_zero()) across += motion.u(z, y) * w[y];
    if (!w[z].is_zero()) {
      const Value square = motion.product(x, x);
      const Value spread = program.bind(square - motion.product(y, y));
      across += spread * w[z];
    }
    result[beside[static_cast<std::size_t>(x)]] = across;
  }
  for (Value& power : result) power = program.bind(power);
  if (!tree.length_unit()) return result;
  const Value length = tree.length();
  for (std::size_t p = 0; p < 4; ++p) result[p] = program.bind(length * result[p]);
  result[0] = program.bind(length * result[0]);
  return result;
}

}  // namespace

std::vector<std::size_t> links_with_inertia(const Model& model) {
  std::set<std::size_t> links;
  for (const BodyContent* body : model.scene().inertias()) {
    const int link = model.place(body->frame, "body '" + body->name + "'").link;
    if (link > 0) links.insert(static_cast<std::size_t>(link));
  }
  return {links.begin(), links.end()};
}

std::vector<Value> inertial_parameters(const Model& model) {
  std::vector<Value> all;
  for (const std::size_t k : links_with_inertia(model)) {
    const MassProperties& body = model.links()[k].mass;
    const Vector& h = body.first_moment;
    const Matrix& j = body.inertia;
    for (const Value& value : {body.mass, h[0], h[1], h[2], j(0, 0), j(0, 1), j(0, 2), j(1, 1), j(1, 2), j(2, 2)}) {
      all.push_back(value);
    }
  }
  return all;
}

ValueMatrix regressor(const Model& model) {
  const std::vector<std::size_t> links = links_with_inertia(model);
  const BodyTree tree = model.options().passes.length_unit ? in_length_unit(model) : BodyTree(model);
  const std::vector<Axes> axes(tree.links().size(), Axes::own);
  std::vector<Acceleration> motion = accelerations(tree, AccelerationInput::symbols, axes);
  const std::vector<bool> rotor = rotor_links(model);
  std::vector<Value> entries;
  for (int i = 0; i < model.unknown_count(); ++i) {
    const std::vector<Twist> partials = partial_twists(tree, i);
    for (const std::size_t k : links) {
      const std::array<Value, 10> all = powers(tree, motion[k], partials[k]);
      // A rotor has no place, so that gravity and centripetal accelerations do not act on it: its moment about its axis alone.
      for (std::size_t p = 0; p < all.size(); ++p) entries.push_back(rotor[k] && p != 9 ? Value() : all[p]);
    }
  }
  const std::vector<bool> zero = identically_zero_entries(entries);
  ValueMatrix y(static_cast<std::size_t>(model.unknown_count()));
  for (std::size_t e = 0; e < entries.size(); ++e) {
    y[e / (10 * links.size())].push_back(zero[e] ? Value() : entries[e]);
  }
  return y;
}

}  // namespace torsor
