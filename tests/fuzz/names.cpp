// SPDX-License-Identifier: GPL-3.0-or-later
// Names and texts of a scene, and all that is written of it.
#include <array>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/fuzz/text_rules.hpp"

namespace torsor::fuzzing {
namespace {

/// A pendulum on a spring whose names are the lines of the input, one after the other.
Scene named_by(std::string_view input) {
  std::array<std::string, 8> names{"scene", "a pendulum", "m", "l", "angle", "arm", "bob", "torque"};
  for (std::string& name : names) {
    const std::size_t end = input.find('\n');
    if (!input.empty()) name = std::string(input.substr(0, end));
    input = end == std::string_view::npos ? std::string_view() : input.substr(end + 1);
  }
  Scene scene(names[0], names[1]);
  const Expression mass = scene.parameter(names[2], "kg", 2);
  const Expression length = scene.run_time_parameter(names[3], "m", 1);
  const Expression angle = scene.coordinate(names[4], "rad");
  const FrameHandle arm = scene.revolute(names[5], scene.ground(), axis::z, angle);
  scene.body(names[6], arm, Inertia::point(mass).at({0, -length, 0}));
  scene.motor(names[7], angle);
  scene.damper(names[5] + names[7], angle, Expression::quantity("1", "N m s"));
  scene.name_joint(arm, names[6] + names[5]);
  return scene;
}

}  // namespace

void name_everything(std::string_view input) {
  try {
    const Scene scene = named_by(input);
    expect_source_text(emit_header(scene, {"mass_matrix"}));
    expect_clean_text(print_equations(scene, Format::text));
    expect_clean_text(print_equations(scene, Format::latex));
    expect_clean_text(list_text(scene));
    const std::string json = list_json(scene, {});
    expect_clean_text(json);
    if (nlohmann::json::parse(json)["title"] != scene.content().title) throw std::logic_error("JSON that is not read back");
    for (const char* kind : {"structure", "analysis", "reduced"}) {
      expect_dot(graph_text(scene, {.kind = kind}));
      expect_xml(graph_text(scene, {.kind = kind, .format = "svg"}));
    }
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

}  // namespace torsor::fuzzing
