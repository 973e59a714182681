// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/internal_motions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"

namespace torsor {
namespace {

constexpr const char* twist_components[] = {"Omega_x", "Omega_y", "Omega_z", "V_x", "V_y", "V_z"};
constexpr const char* wrench_components[] = {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"};

/// Six rows for each body: its twist relative to the ground from the freedoms that are left.
std::vector<RealRows> body_twists(const Mobility& mobility, const std::vector<TwistEdge>& edges,
                                  const std::vector<bool>& blocked) {
  const std::size_t columns = blocked.size();
  std::vector<RealRows> twists(mobility.graph.bodies.size(), RealRows(6, RealRow(columns, Real(0))));
  std::vector<bool> reached(twists.size(), false);
  reached[0] = true;
  for (bool changed = true; changed;) {
    changed = false;
    std::size_t column = 0;
    for (const TwistEdge& edge : edges) {
      const std::size_t first = column;
      column += edge.motion.twists.size();
      if (reached[as_index(edge.a)] == reached[as_index(edge.b)]) continue;
      const bool down = reached[as_index(edge.a)];
      const std::size_t from = as_index(down ? edge.a : edge.b), to = as_index(down ? edge.b : edge.a);
      twists[to] = twists[from];
      for (std::size_t c = 0; c < edge.motion.twists.size(); ++c) {
        for (std::size_t k = 0; k < 6; ++k) twists[to][k][first + c] += Real(down ? 1 : -1) * edge.motion.twists[c][k];
      }
      reached[to] = changed = true;
    }
  }
  for (RealRows& rows : twists) rows = without_columns(rows, blocked);
  return twists;
}

RealRow times(const RealRows& rows, const RealRow& x) {
  RealRow result;
  for (const RealRow& row : rows) {
    Real sum;
    for (std::size_t i = 0; i < x.size(); ++i) sum += row[i] * x[i];
    result.push_back(sum + Real(0));
  }
  return result;
}

/// Twists that a body can have while all others rest: what each of its joints allows. Only its own joints move then.
RealRows twists_alone(const std::vector<TwistEdge>& edges, int body) {
  struct Side {
    const TwistEdge* edge;
    std::size_t first;  ///< its first column
    Real sign;          ///< of the body's twist relative to the other end
  };
  std::vector<Side> sides;
  std::size_t columns = 0;
  for (const TwistEdge& edge : edges) {
    if (edge.a == edge.b || (edge.a != body && edge.b != body)) continue;
    sides.push_back({&edge, columns, Real(edge.b == body ? 1 : -1)});
    if (!edge.outside) columns += edge.motion.twists.size();
  }
  if (sides.empty()) return {};
  const auto rows_of = [columns](const Side& side) {
    RealRows rows(6, RealRow(columns, Real(0)));
    if (side.edge->outside) return rows;
    for (std::size_t c = 0; c < side.edge->motion.twists.size(); ++c) {
      for (std::size_t k = 0; k < 6; ++k) rows[k][side.first + c] = side.sign * side.edge->motion.twists[c][k];
    }
    return rows;
  };
  const RealRows by_first = rows_of(sides.front());
  RealRows differences;
  for (std::size_t s = 1; s < sides.size(); ++s) {
    RealRows rows = rows_of(sides[s]);
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t c = 0; c < columns; ++c) rows[k][c] -= by_first[k][c];
      differences.push_back(std::move(rows[k]));
    }
  }
  RealRows twists;
  for (const RealRow& x : null_space(differences, columns, twist_tolerance())) twists.push_back(times(by_first, x));
  return twists;
}

std::string motion_text(const RealRows& twists, const NaturalLanguage& say) {
  const TwistClass found = recognise_twists(twists);
  if (!found.type) return say("moves with {} freedoms", found.freedoms);
  switch (*found.type) {
    case JointType::revolute:
      return say("turns about {}", direction_text(*found.direction));
    case JointType::prismatic:
      return say("slides along {}", direction_text(*found.direction));
    case JointType::helical:
      return say("screws along {}", direction_text(*found.direction));
    case JointType::spherical:
      return say("turns about a point");
    default:
      return say("moves as in a joint: {}", found.text(say));
  }
}

}  // namespace

RealRows without_columns(const RealRows& matrix, const std::vector<bool>& marked) {
  RealRows result;
  for (const RealRow& row : matrix) {
    result.emplace_back();
    for (std::size_t j = 0; j < marked.size(); ++j) {
      if (!marked[j]) result.back().push_back(row[j]);
    }
  }
  return result;
}

std::size_t inner_count(const std::vector<bool>& marked) {
  return static_cast<std::size_t>(std::count(marked.begin(), marked.end(), false));
}

void describe_internal_motions(Mobility& mobility, const std::vector<TwistEdge>& edges, const NaturalLanguage& say) {
  std::vector<bool> blocked;
  std::vector<std::string> names;
  for (const TwistEdge& edge : edges) {
    blocked.insert(blocked.end(), edge.motion.twists.size(), edge.outside);
    for (const std::string& name : edge.motion.names) {
      if (!edge.outside) names.push_back(edge.name + ": " + name);
    }
  }
  const std::size_t columns = inner_count(blocked);
  const RealRows closure = without_columns(closure_matrix(edges, mobility.loops), blocked);
  const RealRows motions = null_space(closure, columns, twist_tolerance());
  if (motions.empty()) return;
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (std::any_of(motions.begin(), motions.end(), [c](const RealRow& x) { return !is_small(x[c]); })) {
      mobility.internal_freedoms.push_back(names[c]);
    }
  }
  const std::vector<RealRows> twists = body_twists(mobility, edges, blocked);
  int alone = 0;
  std::vector<int> alone_of(twists.size(), 0);
  for (std::size_t body = 1; body < twists.size(); ++body) {
    const RealRows own = twists_alone(edges, static_cast<int>(body));
    const auto freedoms = static_cast<int>(rank(own, 6, twist_tolerance()));
    if (freedoms == 0) continue;
    alone_of[body] = freedoms;
    alone += freedoms;
    mobility.internal.push_back({{mobility.graph.bodies[body].name}, freedoms, motion_text(own, say)});
  }
  const int together = static_cast<int>(motions.size()) - alone;
  if (together == 0) return;
  InternalMotion rest{{}, together, say("move together")};
  for (std::size_t body = 1; body < twists.size(); ++body) {
    RealRows all;
    for (const RealRow& x : motions) all.push_back(times(twists[body], x));
    // What it cannot do alone, it does with others.
    if (static_cast<int>(rank(all, 6, twist_tolerance())) > alone_of[body]) rest.bodies.push_back(mobility.graph.bodies[body].name);
  }
  mobility.internal.push_back(std::move(rest));
}

void describe_indeterminate(Mobility& mobility, const std::vector<TwistEdge>& edges, const JointSpace& space,
                            const NaturalLanguage& say) {
  const RealRows matrix = closure_matrix(edges, mobility.loops);
  if (matrix.empty()) return;
  const RealRows stresses = null_space(transposed(matrix, matrix[0].size()), matrix.size(), twist_tolerance());
  if (stresses.empty()) return;
  for (std::size_t e = 0; e < matrix.size(); ++e) {
    if (std::all_of(stresses.begin(), stresses.end(), [e](const RealRow& y) { return is_small(y[e]); })) continue;
    mobility.redundant.push_back(say("loop {}: {}", e / 6 + 1, twist_components[e % 6]));
  }
  for (std::size_t j = 0; j < edges.size(); ++j) {
    const RealPose place = space.place(mobility.graph.joints[j]);
    std::array<bool, 6> felt{};
    for (const RealRow& y : stresses) {
      RealVector force{Real(0), Real(0), Real(0)}, moment = force;
      for (std::size_t l = 0; l < mobility.loops.size(); ++l) {
        for (const auto& [joint, sense] : mobility.loops[l].joints) {
          if (joint != static_cast<int>(j)) continue;
          for (std::size_t k = 0; k < 3; ++k) {
            moment[k] += Real(sense) * y[6 * l + k];  // what multiplies Ω is a moment, at the ground's origin
            force[k] += Real(sense) * y[6 * l + 3 + k];
          }
        }
      }
      moment = moment + cross(force, place.origin);
      for (int k = 0; k < 3; ++k) {
        felt[as_index(k)] = felt[as_index(k)] || !is_small(dot(force, column(place.rotation, k)));
        felt[as_index(k + 3)] = felt[as_index(k + 3)] || !is_small(dot(moment, column(place.rotation, k)));
      }
    }
    IndeterminateReaction reaction{mobility.graph.joints[j].name, {}};
    for (std::size_t k = 0; k < 6; ++k) {
      if (felt[k]) reaction.components.emplace_back(wrench_components[k]);
    }
    if (!reaction.components.empty()) mobility.indeterminate.push_back(std::move(reaction));
  }
}

}  // namespace torsor
