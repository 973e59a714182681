// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#define TORSOR_NO_MAIN
#include "examples/passenger_in_vehicle/scene.cpp"
#include "examples/satellite_arms/scene.cpp"
#include "examples/vibration_absorber/scene.cpp"
#include "examples/winder/scene.cpp"
#include "generator/cli/commands.hpp"

// The pictures that answer "draw the graph" on the examples' pages (those of the press have their own test).

namespace {

// When it fails: <name>_scene graph --of <kind> --format svg -o examples/<name>/<kind>.svg.
void expect_picture(const torsor::Scene& scene, const std::string& kind) {
  std::ifstream file(TORSOR_SOURCE_DIR "/examples/" + scene.name() + "/" + kind + ".svg");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), torsor::graph_text(scene, "svg", kind, {})) << scene.name();
}

TEST(GraphPictures, AreThoseOfTheScenes) {
  expect_picture(passenger_in_vehicle_scene(), "structure");
  expect_picture(satellite_arms_scene(), "analysis");
  expect_picture(vibration_absorber_scene(), "analysis");
  expect_picture(winder_scene(), "analysis");
}

}  // namespace
