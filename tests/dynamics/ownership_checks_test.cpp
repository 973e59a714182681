// SPDX-License-Identifier: GPL-3.0-or-later
// A symbol of another scene is refused wherever it stands, though it has the name of one of this scene.
#include "torsor/generator/dynamics/equations/ownership_checks.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::ownership_checks_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

struct Foreign { Expression theta, a, force, time; };

/// What validate says of a pendulum to which something was added.
std::string refusal(const std::function<void(Scene&, const Foreign&)>& add) {
  Scene other = pendulum();
  const Foreign foreign{other.coordinate("phi", "rad"), other.parameter("a", "m"), other.parameter("F", "N"), other.time()};
  Scene scene = pendulum();
  scene.point("tip", "arm", {0, metres("-1.5"), 0});
  add(scene, foreign);
  return error_of<SceneError>([&] { validate(scene); });
}

TEST(Ownership, NamesTheObjectTheSymbolAndTheRemedy) {
  EXPECT_EQ(refusal([](Scene& s, const Foreign& f) { s.spring("coil", 2 * f.theta, Expression::quantity("1", "J")); }),
            "'phi' belongs to another scene than 'pendulum', whose action 'coil' has the formula 2*phi: take the symbols "
            "that this scene gave out");
}

TEST(Ownership, IsLookedAtInEveryPartOfAScene) {
  using Add = std::function<void(Scene&, const Foreign&)>;
  const std::vector<std::pair<const char*, Add>> parts{
      {"joint 'slider'", [](Scene& s, const Foreign& f) { s.prismatic("slider", "arm", axis::x, f.a); }},
      {"joint 'placed'", [](Scene& s, const Foreign& f) { s.weld("placed", "arm", {{f.a, 0, 0}, {}}); }},
      {"body 'load'", [](Scene& s, const Foreign& f) { s.body("load", "arm", Inertia::point(kilograms("1")).at({f.a, 0, 0})); }},
      {"point 'P'", [](Scene& s, const Foreign& f) { s.point("P", "arm", {f.a, 0, 0}); }},
      {"action 'push'", [](Scene& s, const Foreign& f) { s.force("push", {"arm", PointReference("tip"), {f.force, 0, 0}, "ground"}); }},
      {"action 'drive'", [](Scene& s, const Foreign& f) { s.motor("drive", f.theta); }},
      {"constraint 'tie'", [](Scene& s, const Foreign& f) { s.holonomic("tie", f.theta); }},
      {"constraint 'held'", [](Scene& s, const Foreign& f) { s.nonholonomic("held", rate(f.theta)); }},
      {"contact 'drag'", [](Scene& s, const Foreign& f) { s.dry_friction("drag", f.a, {f.force}); }},
      {"coordinate 'psi'",
       [](Scene& s, const Foreign& f) { s.drive(s.coordinate("psi", "rad"), Expression::quantity("1", "s^-1") * f.time); }},
      {"parameter 'b'", [](Scene& s, const Foreign& f) { s.parameter("b", "m", f.a); }},
  };
  for (const auto& [object, add] : parts) {
    const std::string told = refusal(add);
    EXPECT_NE(told.find("belongs to another scene"), std::string::npos) << object << ": " << told;
    EXPECT_NE(told.find(object), std::string::npos) << object << ": " << told;
  }
  Scene other("other"), light("light");  // a scene has one gravity, and the pendulum has it
  light.gravity({0, other.parameter("a", "m") / (other.time() * other.time()), 0});
  const std::string told = error_of<SceneError>([&] { check_ownership(light); });
  EXPECT_NE(told.find("belongs to another scene"), std::string::npos) << told;
  EXPECT_NE(told.find("gravity"), std::string::npos) << told;
}

TEST(Ownership, IsOfWhatAnotherSceneMeasuresToo) {
  // The frame is welded to the ground: the direction is made of no coordinate of either scene.
  const auto told = [](bool foreign) {
    Scene other = pendulum(), scene = pendulum();
    for (Scene* each : {&other, &scene}) each->weld("shelf", "ground", {});
    const Triple along = (foreign ? other : scene).direction("shelf", {1, 0, 0}, "ground");
    scene.torque("twist", "arm", {0, 0, along[0] * Expression::quantity("1", "N m")}, "ground");
    return error_of<SceneError>([&] { validate(scene); });
  };
  EXPECT_EQ(told(true).substr(0, told(true).find(", whose")),
            "'direction(shelf, ground).x' belongs to another scene than 'pendulum'");
  EXPECT_EQ(told(false), "no error");
}

TEST(Ownership, LetsAnotherSceneOfTheSameNamesThrough) {
  const Scene first = pendulum(), second = pendulum();
  EXPECT_NO_THROW(check_ownership(first));
  EXPECT_NO_THROW(check_ownership(second));
}

}  // namespace
}  // namespace torsor::ownership_checks_test
