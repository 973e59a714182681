// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/mobility.hpp"

#include <algorithm>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/structure/internal_motions.hpp"

namespace torsor {
namespace {

/// Bodies that are one with the ground: joints without freedom change nothing.
std::vector<bool> fixed_bodies(const StructureGraph& graph) {
  std::vector<bool> fixed(graph.bodies.size(), false);
  fixed[0] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (const GraphJoint& joint : graph.joints) {
      if (joint.freedoms > 0 || fixed[as_index(joint.a)] == fixed[as_index(joint.b)]) continue;
      fixed[as_index(joint.a)] = fixed[as_index(joint.b)] = true;
      changed = true;
    }
  }
  return fixed;
}

std::vector<bool> outside_joints(const StructureGraph& graph, const std::vector<std::string>& names) {
  std::vector<bool> outside(graph.joints.size(), false);
  const std::vector<bool> fixed = fixed_bodies(graph);
  for (std::size_t j = 0; j < outside.size() && names.empty(); ++j) {
    outside[j] = fixed[as_index(graph.joints[j].a)] || fixed[as_index(graph.joints[j].b)];
  }
  for (const std::string& name : names) {
    std::vector<std::string> known;
    bool found = false;
    for (std::size_t j = 0; j < outside.size(); ++j) {
      known.push_back(graph.joints[j].name);
      if (graph.joints[j].name == name) outside[j] = found = true;
    }
    if (found) continue;
    throw UsageError(fmt::format("unknown joint '{}': {}the scene has {}", name, did_you_mean(name, known),
                                 known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
  }
  return outside;
}

std::vector<TwistEdge> edges_at(const JointSpace& space, const StructureGraph& graph,
                                const std::vector<bool>& outside) {
  std::vector<TwistEdge> edges;
  std::vector<JointTwists> twists = space.twists();
  for (std::size_t j = 0; j < graph.joints.size(); ++j) {
    const GraphJoint& joint = graph.joints[j];
    edges.push_back({joint.name, joint.a, joint.b, outside[j], std::move(twists[j])});
  }
  return edges;
}

/// Closes the loops from the initial values with as many independent conditions as possible.
bool close_initially(JointSpace& space) {
  const Real small = power_of_ten(-40);
  const RealRow errors = space.closure_errors();
  if (std::all_of(errors.begin(), errors.end(), [&](const Real& e) { return abs(e) <= small; })) return false;
  const std::size_t most = std::min(errors.size(), as_index(space.variable_count()));
  for (std::size_t conditions = most; conditions > 0; --conditions) {
    if (space.close(conditions, small)) return true;
  }
  const auto worst =
      std::max_element(errors.begin(), errors.end(), [](const Real& a, const Real& b) { return abs(a) < abs(b); });
  throw SceneError(
      fmt::format("the joints that close loops cannot all be closed near the initial values: they are off by "
                  "{} of the mechanism's size; give the joints' coordinates initial values that close them",
                  abs(*worst).to_string(3)));
}

/// A configuration near the given one, reached along its freedoms, that has the rank of almost all configurations.
/// Nothing when none is found.
std::optional<JointSpace> generic_near(const JointSpace& given, std::uint64_t seed) {
  const auto variables = as_index(given.variable_count());
  const RealRows jacobian = given.closure_jacobian();
  const RealRows freedoms = null_space(jacobian, variables, twist_tolerance());
  if (freedoms.empty()) return given;
  const std::size_t rank_here = variables - freedoms.size();
  const std::size_t most = std::min(jacobian.size(), variables);
  std::optional<JointSpace> best;
  std::size_t best_rank = 0;
  std::mt19937_64 random(seed);
  for (int attempt = 0; attempt < 4; ++attempt) {
    RealRow by(variables, Real(0));
    for (const RealRow& freedom : freedoms) {
      const long parts = static_cast<long>(random() % 2001U) - 1000;
      const Real amount(Number::rational(parts, attempt < 2 ? 4000 : 40000), mobility_digits);
      for (std::size_t v = 0; v < by.size(); ++v) by[v] += amount * freedom[v];
    }
    for (std::size_t conditions = rank_here; conditions <= most; ++conditions) {
      JointSpace moved = given;
      moved.move(by);
      if (!moved.close(conditions, power_of_ten(-40))) continue;
      // Newton's method creeps back to where nothing can move: half as far at each step, so to the root of its bound.
      if (moved.distance_from(given) < power_of_ten(-10)) continue;
      const std::size_t rank_there = rank(moved.closure_jacobian(), variables, twist_tolerance());
      if (!best || rank_there > best_rank) best = moved, best_rank = rank_there;
      break;
    }
  }
  return best;
}

/// The six components of the twist that a joint allows its second body relative to its first, at the ground's origin,
/// as rows over the coordinates.
std::vector<std::vector<Value>> relative_motion_rows(const Model& model, const StructureGraph& graph,
                                                     const GraphJoint& joint) {
  const auto link_of = [&](int body) {  // the last of its frames: those inside the joint that carries it come before
    const auto frame = std::find(graph.body_of_frame.rbegin(), graph.body_of_frame.rend(), body);
    return model.place(FrameHandle{static_cast<int>(graph.body_of_frame.rend() - frame) - 1}, "a joint").link;
  };
  const int a = link_of(joint.a), b = link_of(joint.b);
  std::vector<std::vector<Value>> rows;
  for (int k = 0; k < 6; ++k) {
    Vector direction;
    direction[k % 3] = model.program().number(Number(1), Unit());
    const auto row = [&](int link) {
      if (k < 3) return partial_turns(model, link, direction, 0);
      return partial_velocities(model, link, {}, direction);
    };
    const std::vector<Value> of_a = row(a);
    rows.push_back(row(b));
    for (std::size_t i = 0; i < of_a.size(); ++i) rows.back()[i] -= of_a[i];
  }
  return rows;
}

}  // namespace

RealRows closure_matrix(const std::vector<TwistEdge>& edges, const std::vector<GraphLoop>& loops) {
  std::vector<std::size_t> first;
  std::size_t columns = 0;
  for (const TwistEdge& edge : edges) {
    first.push_back(columns);
    columns += edge.motion.twists.size();
  }
  RealRows matrix(6 * loops.size(), RealRow(columns, Real(0)));
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (const auto& [joint, sense] : loops[l].joints) {
      const RealRows& twists = edges[as_index(joint)].motion.twists;
      for (std::size_t c = 0; c < twists.size(); ++c) {
        for (std::size_t k = 0; k < 6; ++k) matrix[6 * l + k][first[as_index(joint)] + c] = Real(sense) * twists[c][k];
      }
    }
  }
  return matrix;
}

MobilityCount count_mobility(int bodies, const std::vector<TwistEdge>& edges) {
  std::vector<GraphEdge> ends;
  std::vector<bool> outside;
  for (const TwistEdge& edge : edges) {
    ends.emplace_back(edge.a, edge.b);
    outside.insert(outside.end(), edge.motion.twists.size(), edge.outside);
  }
  const std::vector<GraphLoop> loops = independent_loops(bodies, ends);
  const RealRows matrix = closure_matrix(edges, loops);
  MobilityCount count;
  count.bodies = bodies;
  count.joints = static_cast<int>(edges.size());
  count.loops = static_cast<int>(loops.size());
  count.parameters = static_cast<int>(outside.size());
  count.equations = 6 * count.loops;
  count.rank = static_cast<int>(rank(matrix, as_index(count.parameters), twist_tolerance()));
  count.mobility = count.parameters - count.rank;
  count.redundancy = count.equations - count.rank;
  count.internal =
      static_cast<int>(null_space(without_columns(matrix, outside), inner_count(outside), twist_tolerance()).size());
  count.useful = count.mobility - count.internal;
  return count;
}

Mobility analyse_mobility(const Scene& scene, const MobilityOptions& options) {
  const WorkingDigits precision(mobility_digits);
  Mobility result;
  result.graph = structure_graph(scene);
  const StructureGraph& graph = result.graph;
  const int bodies = static_cast<int>(graph.bodies.size());
  result.loops = independent_loops(bodies, graph.edges());
  result.outside = outside_joints(graph, options.inputs_outputs);
  JointSpace space(scene, graph, options.language);
  result.moved_to_close = close_initially(space);
  result.given_edges = edges_at(space, graph, result.outside);
  result.given = count_mobility(bodies, result.given_edges);
  const std::optional<JointSpace> elsewhere = generic_near(space, options.seed);
  const JointSpace& generic = elsewhere ? *elsewhere : space;
  result.generic_edges = edges_at(generic, graph, result.outside);
  result.generic = count_mobility(bodies, result.generic_edges);
  result.singular = result.given.rank < result.generic.rank;
  result.immobile = !elsewhere;
  const std::vector<TwistEdge>& named = result.singular ? result.generic_edges : result.given_edges;
  describe_internal_motions(result, named, options.language);
  describe_indeterminate(result, named, result.singular ? generic : space, options.language);
  return result;
}

SceneFreedoms scene_freedoms(const Scene& scene, const std::vector<std::string>& inputs_outputs,
                             std::optional<std::size_t> closed_rank) {
  const WorkingDigits precision(mobility_digits);
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program);
  InitialNumbers number(scene);
  Evaluator<Real> evaluate(program, [&number](const SymbolPointer& symbol) { return number(symbol); });
  SceneFreedoms result;
  result.coordinates = model.unknown_count();
  for (const CoordinateContent& c : scene.content().coordinates) result.driven += c.law ? 1 : 0;
  RealRows rows;
  const auto add = [&](const std::vector<Value>& entries) {
    rows.emplace_back();
    for (int i = 0; i < result.coordinates; ++i) {
      const Value& entry = entries[as_index(i)];
      rows.back().push_back(entry.is_zero() ? Real(0) : evaluate(entry));
    }
  };
  for (const ConstraintRow& row : constraint_rows(model)) add(row.jacobian);
  result.constraints = static_cast<int>(rows.size());
  const auto columns = as_index(result.coordinates);
  // Beside a closed state, of which the start has some digits, rows that repeat others look independent by what is missing.
  const Real off = Real::from_double(1e-9);
  const bool fewer = closed_rank && *closed_rank < rank(rows, columns, twist_tolerance());
  const Real tolerance = fewer && *closed_rank == rank(rows, columns, off) ? off : twist_tolerance();
  result.rank = static_cast<int>(rank(rows, columns, tolerance));
  for (const ConstraintContent& constraint : scene.content().constraints) {
    if (!std::holds_alternative<JointClosure>(constraint.law)) result.no_joints.push_back(constraint.name);
  }
  const StructureGraph graph = structure_graph(scene);
  const std::vector<bool> outside = outside_joints(graph, inputs_outputs);
  for (std::size_t j = 0; j < outside.size(); ++j) {
    if (!outside[j]) continue;
    for (const std::vector<Value>& row : relative_motion_rows(model, graph, graph.joints[j])) add(row);
  }
  result.internal = static_cast<int>(null_space(rows, columns, tolerance).size());
  return result;
}

}  // namespace torsor
