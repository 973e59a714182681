// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {
namespace {

/// Spanning trees of the components: for each body the joint towards the root, and its distance from it.
struct Forest {
  std::vector<int> joint, depth;
  std::vector<bool> in_tree;  ///< by edge
  int components = 0;
};

Forest span(int bodies, const std::vector<GraphEdge>& edges) {
  std::vector<int> component(as_index(bodies));
  std::iota(component.begin(), component.end(), 0);
  const auto root = [&](int body) {
    while (component[as_index(body)] != body) body = component[as_index(body)];
    return body;
  };
  Forest forest{std::vector<int>(as_index(bodies), -1), std::vector<int>(as_index(bodies), -1),
                std::vector<bool>(edges.size(), false), bodies};
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int a = root(edges[e].first), b = root(edges[e].second);
    if (a == b) continue;
    component[as_index(std::max(a, b))] = std::min(a, b);
    forest.in_tree[e] = true;
    --forest.components;
  }
  for (int body = 0; body < bodies; ++body) {
    if (root(body) == body) forest.depth[as_index(body)] = 0;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (!forest.in_tree[e]) continue;
      const auto hang = [&](int parent, int child) {
        if (forest.depth[as_index(parent)] < 0 || forest.depth[as_index(child)] >= 0) return;
        forest.depth[as_index(child)] = forest.depth[as_index(parent)] + 1;
        forest.joint[as_index(child)] = static_cast<int>(e);
        changed = true;
      };
      hang(edges[e].first, edges[e].second);
      hang(edges[e].second, edges[e].first);
    }
  }
  return forest;
}

int parent_of(const Forest& forest, const std::vector<GraphEdge>& edges, int body) {
  const auto& [a, b] = edges[as_index(forest.joint[as_index(body)])];
  return a == body ? b : a;
}

/// The body itself, then those towards the root, up to `top`.
std::vector<int> path_up(const Forest& forest, const std::vector<GraphEdge>& edges, int body, int top) {
  std::vector<int> path{body};
  while (body != top) {
    body = parent_of(forest, edges, body);
    path.push_back(body);
  }
  return path;
}

int meeting(const Forest& forest, const std::vector<GraphEdge>& edges, int a, int b) {
  while (a != b) {
    int& lower = forest.depth[as_index(a)] > forest.depth[as_index(b)] ? a : b;
    lower = parent_of(forest, edges, lower);
  }
  return a;
}

}  // namespace

int cyclomatic_number(int bodies, const std::vector<GraphEdge>& edges) {
  return static_cast<int>(edges.size()) - bodies + span(bodies, edges).components;
}

std::vector<GraphLoop> independent_loops(int bodies, const std::vector<GraphEdge>& edges) {
  const Forest forest = span(bodies, edges);
  std::vector<GraphLoop> loops;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (forest.in_tree[e]) continue;
    const auto& [a, b] = edges[e];
    const int top = meeting(forest, edges, a, b);
    GraphLoop loop;
    loop.closing = static_cast<int>(e);
    // Down from the top to a, across the edge to b, and up again.
    std::vector<int> down = path_up(forest, edges, a, top);
    std::reverse(down.begin(), down.end());
    const auto step = [&](int from, int to, int joint) {
      loop.joints.emplace_back(joint, edges[as_index(joint)].first == from ? 1 : -1);
      loop.bodies.push_back(to);
    };
    loop.bodies.push_back(top);
    for (std::size_t k = 1; k < down.size(); ++k) step(down[k - 1], down[k], forest.joint[as_index(down[k])]);
    loop.joints.emplace_back(static_cast<int>(e), 1);
    loop.bodies.push_back(b);
    const std::vector<int> up = path_up(forest, edges, b, top);
    for (std::size_t k = 1; k < up.size(); ++k) step(up[k - 1], up[k], forest.joint[as_index(up[k - 1])]);
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::string orientation_closure(const StructureGraph& graph, const GraphLoop& loop) {
  std::string text;
  for (std::size_t k = loop.bodies.size() - 1; k > 0; --k) {
    text += fmt::format("{}P({}/{})", text.empty() ? "" : "·", graph.bodies[as_index(loop.bodies[k])].name,
                        graph.bodies[as_index(loop.bodies[k - 1])].name);
  }
  return text + " = I";
}

std::string position_closure(const StructureGraph& graph, const GraphLoop& loop) {
  std::string text;
  for (std::size_t k = 1; k < loop.bodies.size(); ++k) {
    text += fmt::format("{}O_{} O_{}", text.empty() ? "" : " + ", graph.bodies[as_index(loop.bodies[k - 1])].name,
                        graph.bodies[as_index(loop.bodies[k])].name);
  }
  return text + " = 0";
}

std::string twist_closure(const StructureGraph& graph, const GraphLoop& loop) {
  std::string text;
  for (std::size_t k = 1; k < loop.bodies.size(); ++k) {
    text += fmt::format("{}{{V({}/{})}}", text.empty() ? "" : " + ", graph.bodies[as_index(loop.bodies[k])].name,
                        graph.bodies[as_index(loop.bodies[k - 1])].name);
  }
  return text + " = 0";
}

}  // namespace torsor
