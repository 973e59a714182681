// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/point_motion.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::hodograph_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

// Hamilton, "The hodograph, or a new method of expressing in symbolical language the Newtonian law of attraction",
// Proc. R. Irish Acad. 3 (1846): in a Keplerian orbit it is a circle. On r = p/(1 + e cos θ) with the areal constant h,
// θ' = h/r² and r' = (h/p) e sin θ: the centre is at (0, e h/p), the radius h/p.
TEST(Hodograph, OfAKeplerianOrbitIsACircle) {
  const WorkingDigits precision(60);
  Scene scene("planet");
  const Expression theta = scene.coordinate("theta", "rad"), r = scene.coordinate("r", "m");
  const FrameHandle planet =
      scene.prismatic("planet", scene.revolute("ray", scene.ground(), axis::z, theta), axis::x, r);
  scene.body("planet", planet, Inertia::point(kilograms("1")));
  const PointHandle place = scene.point("place", planet, {0, 0, 0});
  const Equations equations(scene);
  const Model& model = equations.model();
  const GeometricPoint drawn = hodograph(model, place, scene.ground());
  EXPECT_EQ(drawn.link, 0);
  const Real p = rational(7, 5), h = rational(11, 3), e = rational(3, 5), k = h / p;
  for (const long twelfths : {0L, 1L, 5L, 8L, 17L, 30L}) {
    const Real angle = rational(twelfths, 5), s = sin(angle), c = cos(angle);
    const Real distance = p / (Real(1) + e * c);
    NamedState here(equations,
                    {{"theta", angle}, {"r", distance}, {"theta'", h / distance / distance}, {"r'", k * e * s}});
    const Real x = here(drawn.place[0]), y = here(drawn.place[1]) - e * k;
    EXPECT_LT(relative_difference(sqrt(x * x + y * y), k), 1e-50) << twelfths;
    EXPECT_LT(abs(x + k * s).to_double() + abs(y - k * c).to_double(), 1e-50) << twelfths;
  }
}

TEST(Hodograph, StartsWhereItIsAskedTo) {
  const Scene scene = pendulum();
  const Equations equations(scene);
  const Model& model = equations.model();
  Program& program = equations.program();
  const Vector centre(program.number(Number(3), units::metre), Value(), program.number(Number(-2), units::metre));
  const int arm = model.place("arm", "test").link;
  const GeometricPoint tip{arm, {program.number(Number(2), units::metre), Value(), Value()}};
  const GeometricPoint drawn = hodograph(model, tip, 0, centre);
  NamedState here(equations, {{"theta", rational(1, 2)}, {"theta'", Real(3)}});
  EXPECT_NEAR(here.in_double(drawn.place[0]), 3 - 6 * std::sin(0.5), 1e-14);
  EXPECT_NEAR(here.in_double(drawn.place[1]), 6 * std::cos(0.5), 1e-14);
  EXPECT_NEAR(here.in_double(drawn.place[2]), -2, 1e-14);
}

// In any frame, for points that move in their own: values of 50 digits that are of order one to a thousand.
TEST(Hodograph, IsRunAlongByTheAcceleration) {
  const WorkingDigits precision(50);
  for (unsigned seed = 900; seed < 910; ++seed) {
    const Scene scene = random_mechanism(seed, {.actions = false, .constraints = false});
    const Equations equations(scene);
    const Model& model = equations.model();
    Program& program = equations.program();
    const RandomState state(scene, 3);
    Evaluator<Real> at(program, state.in_real());
    const int links = static_cast<int>(model.links().size());
    const Value second = program.number(Number(1), units::second);
    for (int reference = 0; reference < links; ++reference) {
      const GeometricPoint point = geometric_point(model, Scene::point("P1"), "test");
      const GeometricPoint drawn = hodograph(model, point, reference);
      const Vector gamma = point_motion(model, point, {point.link, reference, reference}).absolute_acceleration;
      const Vector difference = velocity(model, drawn, reference) - second * gamma;
      for (int i = 0; i < 3; ++i) EXPECT_LT(abs(at(difference[i])).to_double(), 1e-44) << seed << ", " << reference;
    }
  }
}

}  // namespace
}  // namespace torsor::hodograph_test
