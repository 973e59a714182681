// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>

#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/dynamics/recursions/composite_bodies.hpp"
#include "torsor/generator/program/flattening.hpp"

namespace torsor {
namespace {

/// The power of a wrench, at the link's origin and in its axes, per unit rate of the link's joint.
Value effort(const BodyTree& tree, const Link& link, const Wrench& wrench) {
  return tree.program().bind(dot(link.axis, link.joint == JointKind::revolute ? wrench.moment : wrench.resultant));
}

/// Whether many joints follow the same coordinates, so that wrenches had better be summed by coordinate on their way to the
/// ground: each joint would have its own pair with each joint that carries it otherwise, 20,000 for 200 in a row.
bool many_follow_few(const BodyTree& tree) {
  constexpr std::size_t few_pairs = 400, worth_it = 4;
  const auto& links = tree.links();
  std::vector<std::set<int>> below(links.size());
  std::vector<std::size_t> depth(links.size(), 0);
  std::size_t by_joints = 0, by_coordinates = 0;
  for (std::size_t k = 1; k < links.size(); ++k) by_joints += depth[k] = depth[static_cast<std::size_t>(links[k].parent)] + 1;
  if (by_joints <= few_pairs) return false;
  for (std::size_t k = links.size(); k-- > 1;) {
    for (const auto& [i, partial] : links[k].partials) below[k].insert(i);
    by_coordinates += below[k].size();
    below[static_cast<std::size_t>(links[k].parent)].insert(below[k].begin(), below[k].end());
  }
  return by_joints > worth_it * by_coordinates;
}

using WrenchesOfCoordinates = std::map<int, Wrench>;

void add(Program& program, WrenchesOfCoordinates& all, int coordinate, const Wrench& wrench) {
  Wrench& sum = all[coordinate];
  sum.resultant = bound(program, sum.resultant + wrench.resultant);
  sum.moment = bound(program, sum.moment + wrench.moment);
}

/// M_ij = Σ_k p_ki p_kj e_k + Σ_k (p_ki dot(s_k, W_kj) + p_kj dot(s_k, W_ki)): e_k the effort in joint k of its composite's
/// unit acceleration, p_ki the partial of its displacement, W_kj the wrench that unit acceleration of q_j gives to what
/// joint k carries, the joint's own part left out.
std::vector<std::vector<Value>> by_coordinates(const BodyTree& tree) {
  Program& program = tree.program();
  const auto& links = tree.links();
  const auto n = static_cast<std::size_t>(tree.unknown_count());
  const CompositeBodies composites = composite_bodies(tree, UnitWrenches::not_at_all);
  std::vector<std::vector<Value>> mass(n, std::vector<Value>(n));
  const auto entry = [&](int i, int j) -> Value& { return mass[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; };
  std::vector<WrenchesOfCoordinates> carried(links.size());
  for (std::size_t k = links.size(); k-- > 1;) {
    const Link& link = links[k];
    const Wrench& unit = composites.unit_wrenches[k].front().wrench;
    for (const auto& [i, partial_i] : link.partials) {
      if (i >= tree.unknown_count()) continue;
      for (const auto& [j, wrench] : carried[k]) {
        const Value power = program.bind(partial_i * effort(tree, link, wrench));
        entry(i, j) += power;
        entry(j, i) += power;
      }
      const Value own = program.bind(partial_i * effort(tree, link, unit));
      for (const auto& [j, partial_j] : link.partials) {
        if (j < tree.unknown_count()) entry(i, j) += program.bind(own * partial_j);
      }
    }
    for (const auto& [i, partial] : link.partials) {
      if (i >= tree.unknown_count()) continue;
      Wrench part;
      part.resultant = bound(program, partial * unit.resultant);
      part.moment = bound(program, partial * unit.moment);
      add(program, carried[k], i, part);
    }
    if (link.parent == 0) continue;
    for (const auto& [i, wrench] : carried[k]) {
      const Wrench seen = in_parent(tree, link, wrench);
      add(program, carried[static_cast<std::size_t>(link.parent)], i, seen);
    }
    carried[k].clear();
  }
  for (auto& row : mass) {
    for (Value& each : row) each = program.bind(each);
  }
  return mass;
}

}  // namespace

std::vector<std::vector<Value>> mass_matrix(const BodyTree& tree) {
  if (many_follow_few(tree)) return by_coordinates(tree);
  Program& program = tree.program();
  const auto& links = tree.links();
  const CompositeBodies composites = composite_bodies(tree);
  const auto n = static_cast<std::size_t>(tree.unknown_count());
  std::vector<std::vector<Value>> joints(n, std::vector<Value>(n));
  for (std::size_t k = links.size(); k-- > 1;) {
    for (const WrenchAt& unit : composites.unit_wrenches[k]) {
      const Link& here = links[unit.link];
      const Value of_unit = effort(tree, here, unit.wrench);
      for (const auto& [i, partial_i] : here.partials) {
        for (const auto& [j, partial_j] : links[k].partials) {
          if (i >= tree.unknown_count() || j >= tree.unknown_count()) continue;
          const auto row = static_cast<std::size_t>(i);
          const auto column = static_cast<std::size_t>(j);
          const Value entry = program.bind(partial_i * of_unit) * partial_j;
          joints[row][column] += entry;
          if (unit.link != k) joints[column][row] += entry;
        }
      }
    }
  }
  const bool several = moves_by_several(tree);
  for (auto& row : joints) {
    for (Value& entry : row) entry = program.bind(several ? cancelled(program, entry) : entry);
  }
  return joints;
}

}  // namespace torsor
