// SPDX-License-Identifier: GPL-3.0-or-later
// A length sqrt(x^2) in a scene: |x|, whose square has slopes at x = 0.
#include "tests/cli/scene_runner.hpp"

namespace torsor::measured_length_test {
namespace {

using namespace testing_programs;

/// A point on a rail with U = -h d^2/2 and a damper c along d, its distance from the origin of the ground as it is measured.
Scene measured() {
  Scene scene("measured");
  const Expression x = scene.coordinate("x", "m"), h = scene.parameter("h", "N/m", 4);
  const FrameHandle rail = scene.prismatic("rail", scene.ground(), axis::x, x);
  scene.body("bead", rail, Inertia::point(Expression::quantity("2", "kg")));
  const auto p = scene.position(scene.point("bead", rail, {0, 0, 0}), scene.ground());
  const Expression d = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  scene.force_function("elastic", -h * d * d / 2);
  scene.damper("oil", d, scene.parameter("c", "N s/m", 1));
  return scene;
}

/// m z'' of a bead on a parabola z = |x|^2/(2 l), from which x'^2/l^2 x^2 and the weight m g/l come.
Scene on_a_parabola() {
  Scene scene("parabola");
  const Expression x = scene.coordinate("x", "m"), l = scene.parameter("l", "m", 1), d = sqrt(x * x);
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  scene.body("bead", scene.prismatic("up", across, axis::z, d * d / (2 * l)), Inertia::point(scene.parameter("m", "kg", 1)));
  scene.gravity({0, 0, -Expression::quantity("9.81", "m/s^2")});
  return scene;
}

TEST(MeasuredLength, HasTheStiffnessAndTheDampingOfItsSquare) {
  const Outcome outcome = run(measured, {"statics", "--about", "x=0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("With the scene's values: asymptotically stable"), std::string::npos) << outcome.out;
  const Outcome matrices = run(measured, {"equations", "--about", "x=0"});
  EXPECT_NE(matrices.out.find("K = [ h ]"), std::string::npos) << matrices.out;
  EXPECT_NE(matrices.out.find("C = [ c ]"), std::string::npos) << matrices.out;
  EXPECT_EQ(matrices.out.find("sign"), std::string::npos) << matrices.out;
}

TEST(MeasuredLength, CurvesWhatABeadSlidesOn) {
  const Outcome matrices = run(on_a_parabola, {"equations", "--about", "x=0"});
  EXPECT_NE(matrices.out.find("K = [ 9.81 m/l ]"), std::string::npos) << matrices.out;
}

}  // namespace
}  // namespace torsor::measured_length_test
