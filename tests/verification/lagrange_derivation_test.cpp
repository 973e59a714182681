// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/lagrange_derivation.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/simple_scenes.hpp"

namespace torsor::lagrange_derivation_test {
namespace {

using namespace testing_mechanisms;
using namespace testing_symbols;

/// Closed form of a double pendulum with absolute angles a, b, masses 2 and 3, lengths 1 and 1/2:
/// P_a = 5 ä + 3/2 cos(a − b) b̈ + 3/2 sin(a − b) ḃ², Q_a = −5 g sin a.
TEST(LagrangeDerivation, GivesTheEquationsOfADoublePendulum) {
  Scene scene("double_pendulum");
  const Expression a = scene.coordinate("a", "rad");
  const Expression b = scene.coordinate("b", "rad");
  const FrameHandle upper = scene.revolute("upper", scene.ground(), axis::z, a);
  const FrameHandle lower = scene.revolute("lower", upper, axis::z, b - a, {.origin = {0, metres("-1"), 0}});
  scene.body("first", upper, Inertia::point(kilograms("2")).at({0, metres("-1"), 0}));
  scene.body("second", lower, Inertia::point(kilograms("3")).at({0, metres("-0.5"), 0}));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  const LagrangeDerivation derivation(scene);
  const Real ra = rational(1, 3), rb = rational(-5, 4), va = rational(7, 5), vb = rational(-2, 3);
  const Real aa = rational(11, 7), ab = rational(13, 9), g = rational(981, 100);
  NamedState state(derivation.equations(), {{"a", ra}, {"b", rb}, {"a'", va}, {"b'", vb}, {"a''", aa}, {"b''", ab}});
  const Real c = cos(ra - rb) * rational(3, 2), s = sin(ra - rb) * rational(3, 2);
  EXPECT_LT(relative_difference(state(derivation.operators()[0]), Real(5) * aa + c * ab + s * vb * vb), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.operators()[1]), rational(3, 4) * ab + c * aa - s * va * va), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.forces()[0]), -Real(5) * g * sin(ra)), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.forces()[1]), -rational(3, 2) * g * sin(rb)), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.mass()[0][0]), Real(5)), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.mass()[0][1]), c), 1e-45);
  EXPECT_LT(relative_difference(state(derivation.operators_at_rest()[0]), s * vb * vb), 1e-45);
  const Real kinetic = rational(5, 2) * va * va + c * va * vb + rational(3, 8) * vb * vb;
  EXPECT_LT(relative_difference(state(derivation.kinetic_energy()), kinetic), 1e-45);
}

}  // namespace
}  // namespace torsor::lagrange_derivation_test
