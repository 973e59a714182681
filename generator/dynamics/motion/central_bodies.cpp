// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/central_bodies.hpp"

#include <algorithm>
#include <array>

namespace torsor {
namespace {

bool is_constant(const CentralBody& body) {
  bool constant = body.mass.is_constant();
  for (int i = 0; i < 3; ++i) {
    constant = constant && body.center[i].is_constant();
    for (int j = 0; j < 3; ++j) constant = constant && body.inertia(i, j).is_constant();
  }
  return constant;
}

CentralBody placed(const BodyTree& tree, const BodyContent& body) {
  Program& program = tree.program();
  const FramePlace& at = tree.place(body.frame, "body '" + body.name + "'");
  const Inertia& given = body.inertia;
  const std::array<const Expression*, 9> entries{&given.xx, &given.xy, &given.xz, &given.xy, &given.yy,
                                                 &given.yz, &given.xz, &given.yz, &given.zz};
  Matrix inertia;
  for (int i = 0; i < 9; ++i) inertia(i / 3, i % 3) = program.lower(*entries[static_cast<std::size_t>(i)]);
  const Matrix turn = constant_matrix(program, at.rotation);
  CentralBody central;
  central.link = static_cast<std::size_t>(at.link);
  central.mass = program.lower(given.mass);
  central.center = bound(program, at.origin + at.rotation * lower(program, given.center));
  central.inertia = bound(program, turn * inertia * transpose(turn));
  return central;
}

/// Of all bodies on a link, which are numbers: J − m (c² 1 − c cᵀ), c = h/m, is exact.
CentralBody whole(std::size_t link, const MassProperties& sum) {
  CentralBody body{link, sum.mass, {}, sum.inertia};
  if (sum.mass.is_zero()) return body;
  const Value inverse = pow(sum.mass, -1);
  body.center = inverse * sum.first_moment;
  const Value square = dot(body.center, sum.first_moment);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      body.inertia(i, j) += body.center[i] * sum.first_moment[j];
      if (i == j) body.inertia(i, j) -= square;
    }
  }
  return body;
}

}  // namespace

std::vector<CentralBody> central_bodies(const BodyTree& tree) {
  Program& program = tree.program();
  std::vector<std::vector<CentralBody>> by_link(tree.links().size());
  for (const BodyContent* body : tree.scene().inertias()) {
    CentralBody central = placed(tree, *body);
    by_link[central.link].push_back(std::move(central));
  }
  std::vector<CentralBody> all;
  for (std::size_t k = 1; k < by_link.size(); ++k) {
    std::vector<CentralBody>& bodies = by_link[k];
    if (bodies.size() > 1 && std::all_of(bodies.begin(), bodies.end(), is_constant)) {
      all.push_back(whole(k, tree.links()[k].mass));
      continue;
    }
    for (CentralBody& body : bodies) {
      if (tree.length_unit()) {
        const Value unit = tree.length();
        body.mass = program.bind(body.mass * unit * unit);
        const Value inverse = pow(unit, -1);
        body.center = bound(program, inverse * body.center);
      }
      all.push_back(std::move(body));
    }
  }
  return all;
}

}  // namespace torsor
