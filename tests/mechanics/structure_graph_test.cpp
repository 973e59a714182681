// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/structure_graph.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::structure_graph_test {
namespace {

using namespace testing_mechanisms;

std::vector<std::string> body_names(const StructureGraph& graph) {
  std::vector<std::string> names;
  for (const GraphBody& body : graph.bodies) names.push_back(body.name);
  return names;
}
using Names = std::vector<std::string>;

TEST(StructureGraph, MakesOneBodyOfWeldedFramesAndNoneOfFramesInsideAJoint) {
  const Scene scene = isostatic_slider_crank();
  const StructureGraph graph = structure_graph(scene);
  EXPECT_EQ(body_names(graph), (Names{"ground", "crank", "piston", "rod"}));
  ASSERT_EQ(graph.joints.size(), 4U);
  EXPECT_EQ(graph.joints[1].name, "piston");
  EXPECT_EQ(graph.joints[1].type, JointType::cylindrical);
  EXPECT_TRUE(graph.joints[3].closes_loop);
  EXPECT_EQ(graph.joints[3].a, 1);
  EXPECT_EQ(graph.joints[3].b, 3);
  EXPECT_EQ(graph.parameter_count(), 7);
}

TEST(StructureGraph, CutsAJointWhereSomethingIsAttachedInsideIt) {
  Scene scene("cut");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), a = scene.coordinate("a", "rad");
  scene.planar("table", scene.ground(), {.x = x, .y = y, .angle = a});
  scene.body("carriage", "table.y", Inertia::point(kilograms("1")));
  const StructureGraph graph = structure_graph(scene);
  EXPECT_EQ(body_names(graph), (Names{"ground", "table.y", "table"}));
  ASSERT_EQ(graph.joints.size(), 2U);
  EXPECT_EQ(graph.joints[0].freedoms, 2);
  EXPECT_FALSE(graph.joints[0].type);
  EXPECT_EQ(graph.joints[1].type, JointType::revolute);
  EXPECT_EQ(graph.bodies[1].parts, (Names{"carriage"}));
}

TEST(StructureGraph, MakesAJointOfAWeldThatHasAName) {
  Scene scene("welded");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle cart = scene.prismatic("cart", scene.ground(), axis::x, x);
  const FrameHandle mast = scene.weld("mast", cart, {{0, metres("1"), 0}, {}});
  scene.weld("top", mast, {{0, metres("1"), 0}, {}});
  EXPECT_EQ(structure_graph(scene).bodies.size(), 2U);
  scene.name_joint(cart, "L1");
  scene.name_joint(mast, "L2");
  const StructureGraph graph = structure_graph(scene);
  EXPECT_EQ(body_names(graph), (Names{"ground", "cart", "mast"}));
  ASSERT_EQ(graph.joints.size(), 2U);
  EXPECT_EQ(graph.joints[0].name, "L1");
  EXPECT_EQ(graph.joints[1].name, "L2");
  EXPECT_EQ(graph.joints[1].type, JointType::weld);
  EXPECT_EQ(graph.joints[1].freedoms, 0);
  EXPECT_EQ(graph.body_of_frame[3], 2);  // the top belongs to the mast
  EXPECT_THROW(scene.name_joint(scene.ground(), "L3"), SceneError);
}

// A displacement that nothing changes is no freedom: released coordinates, constants.
TEST(StructureGraph, TakesWhatIsHeldForRigid) {
  Scene scene("held");
  const Expression x = scene.coordinate("x", "m"), N = scene.released_coordinate("N", "m");
  const Expression a = scene.coordinate("a", "rad");
  scene.prismatic("lifted", scene.ground(), axis::z, N);
  scene.planar("slider", "lifted", {.x = x, .y = 0, .angle = a});
  const StructureGraph graph = structure_graph(scene);
  EXPECT_EQ(body_names(graph), (Names{"ground", "slider"}));
  ASSERT_EQ(graph.joints.size(), 1U);
  EXPECT_EQ(graph.joints[0].freedoms, 2);
  EXPECT_FALSE(graph.joints[0].type);
}

// A cube's corners and edges: 12 − 8 + 1. Loops are independent when each has an edge of its own.
TEST(StructureGraph, CountsIndependentLoops) {
  std::vector<GraphEdge> edges;
  for (int corner = 0; corner < 8; ++corner) {
    for (int bit = 1; bit < 8; bit *= 2) {
      if ((corner & bit) == 0) edges.emplace_back(corner, corner | bit);
    }
  }
  EXPECT_EQ(cyclomatic_number(8, edges), 5);
  const std::vector<GraphLoop> loops = independent_loops(8, edges);
  ASSERT_EQ(loops.size(), 5U);
  for (const GraphLoop& loop : loops) {
    EXPECT_EQ(loop.bodies.front(), loop.bodies.back());
    ASSERT_EQ(loop.bodies.size(), loop.joints.size() + 1);
    for (std::size_t k = 0; k < loop.joints.size(); ++k) {
      const auto& [joint, sense] = loop.joints[k];
      const auto& [a, b] = edges[static_cast<std::size_t>(joint)];
      EXPECT_EQ(loop.bodies[k], sense > 0 ? a : b);
      EXPECT_EQ(loop.bodies[k + 1], sense > 0 ? b : a);
    }
    int loops_with_it = 0;
    for (const GraphLoop& other : loops) {
      for (const auto& each : other.joints) loops_with_it += each.first == loop.closing ? 1 : 0;
    }
    EXPECT_EQ(loops_with_it, 1);
  }
}

TEST(StructureGraph, CountsLoopsOfAGraphInPieces) {
  EXPECT_EQ(cyclomatic_number(5, {{0, 1}, {2, 3}, {3, 4}, {4, 2}}), 1);
  EXPECT_EQ(independent_loops(5, {{0, 1}, {2, 3}, {3, 4}, {4, 2}}).size(), 1U);
}

// Pommier prints the product of §3.5.4 in an order that does not close; what is read from the right goes once around.
TEST(StructureGraph, WritesTheClosureOfALoopInTheOrderThatCloses) {
  const StructureGraph graph = structure_graph(isostatic_slider_crank());
  const std::vector<GraphLoop> loops = independent_loops(4, graph.edges());
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(orientation_closure(graph, loops[0]), "P(ground/piston)·P(piston/rod)·P(rod/crank)·P(crank/ground) = I");
  EXPECT_EQ(position_closure(graph, loops[0]),
            "O_ground O_crank + O_crank O_rod + O_rod O_piston + O_piston O_ground = 0");
  EXPECT_EQ(twist_closure(graph, loops[0]),
            "{V(crank/ground)} + {V(rod/crank)} + {V(piston/rod)} + {V(ground/piston)} = 0");
}

}  // namespace
}  // namespace torsor::structure_graph_test
