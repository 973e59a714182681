// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/graphs/graph_printer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "tests/scenes/bodies.hpp"

namespace torsor::graph_printer_test {
namespace {

using namespace testing_mechanisms;

/// A cart with a pendulum whose coordinate is absolute, sprung, driven, falling, in contact.
Scene cart() {
  Scene scene("cart");
  const Expression x = scene.coordinate("x", "m"), a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  const FrameHandle body = scene.prismatic("cart", scene.ground(), axis::x, x);
  const FrameHandle upper = scene.revolute("upper", body, axis::z, a);
  const FrameHandle lower = scene.revolute("lower", upper, axis::z, b - a, {{metres("1"), 0, 0}, {}});
  scene.body("bob", lower, Inertia::point(kilograms("1")));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  scene.spring("k", x, Expression::quantity("1", "N/m"));
  scene.motor("M", b);  // the absolute angle of the lower arm: from the cart
  scene.damper("d", b - a, Expression::quantity("1", "N m s"));
  const PointHandle tip = scene.point("tip", lower, {metres("1"), 0, 0});
  const FrameHandle floor = scene.weld("floor", scene.ground(), {{}, Rotation::about(0, -6)});
  scene.point_in_plane("touch", tip, floor);
  return scene;
}

// Two parts of one body that a joint ties: a curve that leaves the body and comes back.
TEST(GraphSvg, DrawsAJointOfABodyWithItselfAsALoop) {
  GraphDrawing drawing;
  drawing.title = "loop";
  drawing.nodes = {{"ground", true}, {"A", false}};
  drawing.edges = {{0, 1, "B", "revolute", {}}, {1, 1, "D", "revolute", {}}};
  const std::string svg = graph_svg(drawing);
  const std::size_t loop = svg.find(" C ");
  ASSERT_NE(loop, std::string::npos) << svg;
  std::istringstream numbers(svg.substr(loop + 3));
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  numbers >> x1 >> y1 >> x2 >> y2;
  EXPECT_GT(std::hypot(x1 - x2, y1 - y2), 50);
  EXPECT_EQ(svg.find(" C ", loop + 3), std::string::npos) << "the other edge is an arc";
}

TEST(AnalysisGraph, TiesEachActionToTheBodiesItActsOn) {
  const Scene scene = cart();
  const StructureGraph graph = structure_graph(scene);
  const std::vector<AnalysisLink> links = analysis_links(scene, graph);
  const auto bodies = [&](const std::string& name) -> std::vector<int> {
    for (const AnalysisLink& link : links) {
      if (link.name == name) return link.bodies;
    }
    return {};
  };
  EXPECT_EQ(bodies("touch"), (std::vector<int>{0, 3}));
  EXPECT_EQ(bodies("gravity"), (std::vector<int>{0, 3}));
  EXPECT_EQ(bodies("k"), (std::vector<int>{0, 1}));
  EXPECT_EQ(bodies("M"), (std::vector<int>{1, 3}));
  EXPECT_EQ(bodies("d"), (std::vector<int>{2, 3}));
}

// A rotor on a rod that a law of time turns in the wagon, and a pump that a formula of time moves: two motors.
TEST(AnalysisGraph, ShowsWhatImposesAMotion) {
  Scene scene("driven");
  const Expression x = scene.coordinate("x", "m"), phi = scene.coordinate("phi", "rad");
  const Expression still = scene.coordinate("still", "m");
  scene.drive(phi, Expression::quantity("3", "rad/s") * scene.time());
  scene.drive(still, 0);  // moves nothing
  const FrameHandle wagon = scene.prismatic("wagon", scene.ground(), axis::x, x);
  const FrameHandle rotor = scene.revolute("rotor", wagon, axis::z, phi);
  const FrameHandle pump = scene.prismatic("pump", rotor, axis::x, Expression::quantity("2", "m/s") * scene.time());
  for (const FrameHandle& each : {wagon, rotor, pump}) {
    scene.body("b" + std::to_string(each.index), each, Inertia::point(Expression::quantity("1", "kg")));
  }
  const std::vector<AnalysisLink> links = analysis_links(scene, structure_graph(scene));
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].what, "imposes phi(t)");
  EXPECT_EQ(links[0].bodies, (std::vector<int>{1, 2}));
  EXPECT_EQ(links[1].what, "imposes pump(t)");
  EXPECT_EQ(links[1].bodies, (std::vector<int>{2, 3}));
}

TEST(GraphPrinter, WritesTextForGraphviz) {
  const Scene scene = cart();
  const StructureGraph graph = structure_graph(scene);
  EXPECT_EQ(graph_dot(draw_structure(scene, graph)),
            "graph \"cart\" {\n"
            "  label=\"structure graph of cart\";\n"
            "  node [shape=ellipse, fontname=\"sans-serif\"];\n"
            "  edge [fontname=\"sans-serif\", fontsize=11];\n"
            "  n0 [label=\"ground\", shape=box, style=filled];\n"
            "  n1 [label=\"cart\"];\n"
            "  n2 [label=\"upper\"];\n"
            "  n3 [label=\"lower\"];\n"
            "  n0 -- n1 [label=\"cart\\nprismatic\"];\n"
            "  n1 -- n2 [label=\"upper\\nrevolute\"];\n"
            "  n2 -- n3 [label=\"lower\\nrevolute\"];\n"
            "}\n");
  const std::string analysis = graph_dot(draw_analysis(scene, graph, analysis_links(scene, graph)));
  for (const char* line :
       {"n0 -- n1 [label=\"k\\nspring\", style=dashed", "n1 -- n3 [label=\"M\\nmotor\", style=dashed",
        "n0 -- n3 [label=\"gravity\", style=dashed", "n0 -- n3 [label=\"touch\\npoint in plane\", style=dotted"}) {
    EXPECT_NE(analysis.find(line), std::string::npos) << line << " is missing from\n" << analysis;
  }
}

TEST(GraphPrinter, DrawsEveryBodyAndEveryLink) {
  const Scene scene = cart();
  const StructureGraph graph = structure_graph(scene);
  const GraphDrawing drawing = draw_analysis(scene, graph, analysis_links(scene, graph));
  const std::string svg = graph_svg(drawing);
  std::size_t paths = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, drawing.edges.size());
  for (const auto& node : drawing.nodes) EXPECT_NE(svg.find(">" + node.label + "</text>"), std::string::npos);
  EXPECT_EQ(svg, graph_svg(drawing));
}

// Five bodies in a ring given in an order that crosses: the picture puts neighbours side by side.
TEST(GraphPrinter, OrdersBodiesForFewestCrossings) {
  GraphDrawing drawing{"ring", "ring", {{"a", true}, {"b"}, {"c"}, {"d"}, {"e"}}, {}};
  for (const auto& [a, b] : {std::pair(0, 2), {2, 4}, {4, 1}, {1, 3}, {3, 0}}) drawing.edges.push_back({a, b, "", ""});
  const std::string svg = graph_svg(drawing);
  int paths = 0;
  for (std::size_t at = svg.find("M "); at != std::string::npos; at = svg.find("M ", at + 1)) {
    std::istringstream numbers(svg.substr(at + 2));
    double x = 0, y = 0, control_x = 0, control_y = 0, end_x = 0, end_y = 0;
    char q = 0;
    numbers >> x >> y >> q >> control_x >> control_y >> end_x >> end_y;
    EXPECT_NEAR(std::hypot(end_x - x, end_y - y), 170, 2) << "neighbours are 170 apart, coordinates are rounded to 1";
    ++paths;
  }
  EXPECT_EQ(paths, 5);
}

// Four bodies each tied to the ground and to each other: in the middle of the circle texts would lie upon each other.
TEST(GraphPrinter, KeepsTextsOfEdgesApart) {
  GraphDrawing drawing{"crowd", "crowd", {{"ground", true}, {"frame"}, {"fork"}, {"rear"}, {"front"}}, {}};
  for (const auto& [a, b] : {std::pair(1, 2), {1, 3}, {2, 4}, {0, 1}, {0, 1}, {0, 1}, {0, 2}, {0, 2}, {0, 3}, {0, 4}}) {
    drawing.edges.push_back({a, b, "touches_ground", "point"});
  }
  struct Text {
    double x = 0, y = 0;
  };
  std::vector<Text> names;
  const std::string svg = graph_svg(drawing), end = ">touches_ground</text>";
  for (std::size_t at = svg.find(end); at != std::string::npos; at = svg.find(end, at + 1)) {
    Text text;
    const std::size_t begin = svg.rfind("<text x=", at);
    ASSERT_EQ(std::sscanf(svg.c_str() + begin, "<text x=\"%lf\" y=\"%lf\"", &text.x, &text.y), 2);
    names.push_back(text);
  }
  ASSERT_EQ(names.size(), 10U);
  // A letter of 11 px is some 6 wide; a name and what it is are two lines of 13 px.
  const double width = 6 * 14, height = 26;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(std::abs(names[i].x - names[j].x) < width && std::abs(names[i].y - names[j].y) < height)
          << "texts " << j << " and " << i << " overlap";
    }
  }
}

/// The text without what stands in quotes of dot, or empty where a quote is not closed.
std::string outside_quotes(const std::string& dot) {
  std::string rest;
  bool quoted = false;
  for (std::size_t i = 0; i < dot.size(); ++i) {
    if (quoted && dot[i] == '\\') {
      ++i;
    } else if (dot[i] == '"') {
      quoted = !quoted;
    } else if (!quoted) {
      rest += dot[i];
    }
  }
  return quoted ? "" : rest;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Names that close a quote, an element, a comment or a section of whatever language they are printed in.
TEST(GraphPrinter, QuotesNamesThatAreMarkup) {
  const std::string joint = "a\"]; x [label=\"\\", action = "</text><script>]]>--&amp;\\";
  Scene scene("cart");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("block", slide, Inertia::point(kilograms("1")));
  scene.name_joint(slide, joint);
  scene.spring(action, x, Expression::quantity("1", "N/m"));
  const StructureGraph graph = structure_graph(scene);
  const GraphDrawing drawing = draw_analysis(scene, graph, analysis_links(scene, graph));
  const std::string svg = graph_svg(drawing), outside = outside_quotes(graph_dot(drawing));
  EXPECT_EQ(count_of(svg, "</text>&lt;"), 0U);
  EXPECT_EQ(count_of(svg, "&lt;/text&gt;&lt;script&gt;]]&gt;--&amp;amp;\\</text>"), 1U) << svg;
  EXPECT_EQ(count_of(svg, "<text "), count_of(svg, "</text>"));
  EXPECT_EQ(count_of(svg, "<script"), 0U);
  EXPECT_NE(outside, "");
  EXPECT_EQ(outside.find("x [label"), std::string::npos) << outside;
  EXPECT_EQ(outside.find("script"), std::string::npos) << outside;
}

}  // namespace
}  // namespace torsor::graph_printer_test
