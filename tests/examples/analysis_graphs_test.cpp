// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/dynamics/structure/mobility.hpp"
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::analysis_graphs_test {

// What the course asks of a graph: to be drawn (the press has its own test), and to say which equations to write.

namespace {

// When it fails: <name>_scene graph --of <kind> --format svg -o examples/<name>/<kind>.svg.
void expect_picture(const torsor::Scene& scene, const std::string& kind) {
  std::ifstream file(TORSOR_SOURCE_DIR "/examples/" + scene.name() + "/" + kind + ".svg");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), torsor::graph_text(scene, {.kind = kind, .format = "svg"})) << scene.name();
}

/// Components of joints that enter one of the six theorems for isolated bodies, moments at a point along given axes.
enum Theorem : std::size_t { resultant_x, moment_y = 4, moment_z = 5 };
std::vector<std::string> unknown(const torsor::Equations& equations, const torsor::BodyNames& bodies,
                                 const torsor::ScrewQuery& query, Theorem theorem) {
  std::vector<std::string> names;
  for (const auto& each : torsor::isolation_report(equations, bodies, query).unknowns) {
    if (each.enters[theorem]) names.push_back(each.name);
  }
  return names;
}
using Names = std::vector<std::string>;

// Pommier, 8.3.2 exercise 5, question 2: one equation for each motion, with nothing unknown from the joints.
TEST(AnalysisGraphs, ChooseTheEquationsOfTheSatellite) {
  const torsor::Equations equations(satellite_arms_scene());
  EXPECT_EQ(unknown(equations, {"S1", "S2", "S3"}, {torsor::Scene::point("O"), "S1"}, moment_z), Names{});
  EXPECT_EQ(unknown(equations, {"S2"}, {torsor::Scene::point("O2"), "S1"}, moment_y), Names{});
  EXPECT_EQ(unknown(equations, {"S3"}, {torsor::Scene::point("O3"), "S1"}, moment_y), Names{});
  // The arms taken together, or the body alone, would not do: of each hinge Y, L and N enter.
  const Names hinges{"S2 Y", "S2 L", "S2 N", "S3 Y", "S3 L", "S3 N"};
  EXPECT_EQ(unknown(equations, {"S2", "S3"}, {torsor::Scene::point("O"), "S1"}, moment_z), hinges);
  EXPECT_EQ(unknown(equations, {"S1"}, {torsor::Scene::point("O"), "S1"}, moment_z), hinges);
}

// Pommier, §6.2.4: mobility 3, hence three equations; the third holds the torque of the motor that imposes phi, and
// leaves two for X and theta.
TEST(AnalysisGraphs, ChooseTheEquationsOfTheAbsorber) {
  const torsor::Scene scene = vibration_absorber_scene();
  const torsor::MobilityCount count = torsor::analyse_mobility(scene).generic;
  EXPECT_EQ(count.bodies, 4);
  EXPECT_EQ(count.joints, 3);
  EXPECT_EQ(count.mobility, 3);
  const torsor::Equations equations(scene);
  EXPECT_EQ(equations.model().unknown_count(), 2);
  EXPECT_EQ(unknown(equations, {"support", "pendulum", "unbalance"}, {torsor::Scene::point("G1"), "ground"}, resultant_x), Names{});
  EXPECT_EQ(unknown(equations, {"pendulum"}, {torsor::Scene::point("G1"), "ground"}, moment_y), Names{});
  EXPECT_EQ(unknown(equations, {"unbalance"}, {torsor::Scene::point("G1"), "ground"}, moment_y), Names{"rotor M"});
}

TEST(AnalysisGraphs, AreDrawnOnThePages) {
  expect_picture(passenger_in_vehicle_scene(), "structure");
  expect_picture(satellite_arms_scene(), "analysis");
  expect_picture(vibration_absorber_scene(), "analysis");
  expect_picture(winder_scene(), "analysis");
}

}  // namespace
}  // namespace torsor::analysis_graphs_test
