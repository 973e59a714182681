// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/lagrange_derivation.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::lagrange_derivation_test {
namespace {

using namespace testing_mechanisms;
using namespace testing_symbols;

/// Closed form of a double pendulum with absolute angles a, b, masses 2 and 3, lengths 1 and 1/2:
/// P_a = 5 ä + 3/2 cos(a − b) b̈ + 3/2 sin(a − b) ḃ², Q_a = −5 g sin a.
TEST(LagrangeDerivation, GivesTheEquationsOfADoublePendulum) {
  const Scene scene = double_pendulum({.masses = {2, 3}, .lengths = {1, Expression(Number::rational(1, 2))}});
  const LagrangeDerivation derivation(scene);
  const Real ra = rational(1, 3), rb = rational(-5, 4), va = rational(7, 5), vb = rational(-2, 3);
  const Real aa = rational(11, 7), ab = rational(13, 9), g = rational(981, 100);
  NamedState state(
      derivation.equations(),
      {{"theta_1", ra}, {"theta_2", rb}, {"theta_1'", va}, {"theta_2'", vb}, {"theta_1''", aa}, {"theta_2''", ab}});
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
