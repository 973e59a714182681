// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/graphs/graph_printer.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/printable.hpp"

namespace torsor {
namespace {

using Line = GraphDrawing::Line;

std::string freedoms_text(int freedoms, const NaturalLanguage& say) { return say("{} freedom{}", freedoms, freedoms == 1 ? "" : "s"); }

std::string what(const GraphJoint& joint, const NaturalLanguage& say) {
  return joint.type ? name_of(*joint.type, say) : freedoms_text(joint.freedoms, say);
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

const char* style(Line line) {
  switch (line) {
    case Line::joint:
      return "";
    case Line::constraint:
      return ", style=dotted, color=\"#a03000\", fontcolor=\"#a03000\"";
    case Line::action:
      return ", style=dashed, color=\"#0050a0\", fontcolor=\"#0050a0\"";
  }
  return "";
}

}  // namespace

GraphDrawing draw_structure(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& say) {
  GraphDrawing drawing{scene.name(), say("structure graph of {}", scene.name()), {}, {}};
  for (const GraphBody& body : graph.bodies) drawing.nodes.push_back({body.name, drawing.nodes.empty()});
  for (const GraphJoint& joint : graph.joints) drawing.edges.push_back({joint.a, joint.b, joint.name, what(joint, say)});
  return drawing;
}

GraphDrawing draw_analysis(const Scene& scene, const StructureGraph& graph, const std::vector<AnalysisLink>& links,
                           const NaturalLanguage& say) {
  GraphDrawing drawing = draw_structure(scene, graph, say);
  drawing.title = say("analysis graph of {}", scene.name());
  for (const AnalysisLink& link : links) {
    const Line line = link.kind == AnalysisLink::Kind::action ? Line::action : Line::constraint;
    const std::string name = link.name == link.what ? "" : link.name;
    if (link.bodies.size() == 2) {
      drawing.edges.push_back({link.bodies[0], link.bodies[1], name, link.what, line});
      continue;
    }
    const int node = static_cast<int>(drawing.nodes.size());
    drawing.nodes.push_back({link.what + (name.empty() ? "" : " " + name), false, true, line});
    for (const int body : link.bodies) drawing.edges.push_back({body, node, "", "", line});
  }
  return drawing;
}

GraphDrawing draw_reduced(const Scene& scene, const ReducedGraph& graph, const NaturalLanguage& say) {
  GraphDrawing drawing{scene.name(), say("reduced structure graph of {}", scene.name()), {}, {}};
  for (const std::string& body : graph.bodies) drawing.nodes.push_back({body, drawing.nodes.empty()});
  for (const EquivalentJoint& joint : graph.joints) {
    const std::string type =
        joint.allows.type ? name_of(*joint.allows.type, say) : freedoms_text(joint.allows.freedoms, say);
    drawing.edges.push_back({joint.edge.a, joint.edge.b, joint.edge.name, type});
  }
  return drawing;
}

std::string graph_dot(const GraphDrawing& drawing) {
  std::string text = fmt::format(
      "graph {} {{\n  label={};\n  node [shape=ellipse, fontname=\"sans-serif\"];\n"
      "  edge [fontname=\"sans-serif\", fontsize=11];\n",
      quoted(drawing.name), quoted(drawing.title));
  for (std::size_t n = 0; n < drawing.nodes.size(); ++n) {
    const GraphDrawing::Node& node = drawing.nodes[n];
    text += fmt::format(
        "  n{} [label={}{}{}];\n", n, quoted(node.label),
        node.ground ? ", shape=box, style=filled"
        : node.link ? ", shape=plaintext"
                    : "",
        node.link ? (node.line == Line::action ? ", fontcolor=\"#0050a0\"" : ", fontcolor=\"#a03000\"") : "");
  }
  for (const GraphDrawing::Edge& edge : drawing.edges) {
    const std::string gap = edge.name.empty() || edge.what.empty() ? "" : "\\n";
    const std::string first = quoted(edge.name), second = quoted(edge.what);
    const std::string label = first.substr(0, first.size() - 1) + gap + second.substr(1);
    text += fmt::format("  n{} -- n{} [label={}{}];\n", edge.a, edge.b, label, style(edge.line));
  }
  return text + "}\n";
}

}  // namespace torsor
