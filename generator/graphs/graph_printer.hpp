// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/structure/mobility.hpp"
#include "torsor/generator/dynamics/structure/reduced_graph.hpp"
#include "torsor/generator/mechanics/analysis_graph.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {

/// A graph as it is drawn: bodies as vertices, joints as full lines, other constraints dotted, actions dashed. A link
/// with one end, or more than two, is a small vertex of its own.
struct GraphDrawing {
  enum class Line { joint, constraint, action };
  struct Node {
    std::string label;
    bool ground = false;
    bool link = false;  ///< stands for a link, not for a body
    Line line = Line::joint;
  };
  struct Edge {
    int a = 0, b = 0;
    std::string name, what;  ///< one line of text each; both may be empty
    Line line = Line::joint;
  };
  std::string name, title;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

GraphDrawing draw_structure(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& say = {});
GraphDrawing draw_analysis(const Scene& scene, const StructureGraph& graph, const std::vector<AnalysisLink>& links,
                           const NaturalLanguage& say = {});
GraphDrawing draw_reduced(const Scene& scene, const ReducedGraph& graph, const NaturalLanguage& say = {});

/// Text of Graphviz's language.
std::string graph_dot(const GraphDrawing& drawing);

/// A picture without any other program: bodies on a circle, the ground at the bottom, in the order of fewest crossings.
/// The same bytes for the same graph.
std::string graph_svg(const GraphDrawing& drawing);

}  // namespace torsor
