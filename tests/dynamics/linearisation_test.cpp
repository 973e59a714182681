// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the residual against central differences of it in sixty digits.
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/central_differences.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::linearisation_test {
namespace {

using namespace testing_mechanisms;

/// Six joints, so many that inertia is differentiated by the recursion and everything else beside it: springs, a damper
/// whose law is a formula, motors, and a constraint that moves in time.
Scene sprung_chain() {
  Scene scene("sprung_chain");
  FrameHandle end = scene.ground();
  std::vector<Expression> q;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string number = std::to_string(i);
    const bool slides = i == 3;
    q.push_back(scene.coordinate("q" + number, slides ? "m" : "rad"));
    const Placement place{.origin = {metres("0.3"), 0, metres("0.1")}};
    const Triple axis = i % 2 == 0 ? axis::z : axis::x;
    end = slides ? scene.prismatic("link" + number, end, axis, q[i], place)
                 : scene.revolute("link" + number, end, axis, q[i], place);
    scene.body("link" + number, end,
               Inertia::box(kilograms("2"), metres("1"), metres("0.5"), metres("0.2")).at({metres("0.2"), 0, 0}));
  }
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  scene.spring("spring", q[0] * q[1] - q[4], Expression::quantity("40", "N m"));
  scene.damper("damper", q[2] * q[2] + q[5], Expression::quantity("0.3", "N m s"));
  scene.motor("push", q[3] * q[0]);
  scene.motor("turn", q[5]);
  scene.holonomic("guide", q[3] - metres("0.4") * sin(q[1]) - Expression::quantity("0.1", "m/s") * scene.time());
  return scene;
}

void expect_slopes(Inputs act) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Scene scene = sprung_chain();
  const Equations one(scene), other(scene);
  const ForceDerivatives exact = residual_derivatives(one, act);
  std::vector<Value> residual = other.inverse_dynamics();
  const std::vector<Value> of_motors = other.of_inputs();
  for (std::size_t i = 0; i < residual.size() && act == Inputs::act; ++i) residual[i] -= of_motors[i];
  const RandomState state(scene, 3);
  Evaluator<Real> at(one.program(), state.in_real());
  CentralDifferences differences(other, 3);
  for (std::size_t j = 0; j < residual.size(); ++j) {
    const SymbolPointer& velocity = other.model().coordinates()[j].v;
    EXPECT_LT(largest_difference(at(column(exact.by_position, j)), differences(residual, differences.along(j))),
              CentralDifferences::bound)
        << j;
    EXPECT_LT(
        largest_difference(at(column(exact.by_velocity, j)), differences(residual, CentralDifferences::of(velocity))),
        CentralDifferences::bound)
        << j;
  }
}

TEST(ResidualDerivatives, AreSlopesOfTheForcesOfASprungChain) { expect_slopes(Inputs::act); }

TEST(ResidualDerivatives, AreThoseWithoutMotorsWhereTheseAreLeftOut) { expect_slopes(Inputs::left_out); }

// F = -r, so that M e'' + C e' + K e = F + E u is the residual's own expansion; E u is what the motors do.
TEST(Linearisation, HasTheResidualForItsRest) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Scene scene = sprung_chain();
  const Equations equations(scene);
  const Linearisation linear = linearisation(equations);
  const RandomState state(scene, 3);
  Evaluator<Real> at(equations.program(), state.in_real());
  const std::vector<SymbolPointer> inputs = equations.model().inputs();
  for (std::size_t i = 0; i < linear.F.size(); ++i) {
    Real of_motors(0);
    for (std::size_t k = 0; k < inputs.size(); ++k)
      of_motors += at(linear.E[i][k]) * at(equations.program().symbol(inputs[k]));
    const Real rest = of_motors - at(equations.inverse_dynamics()[i]);
    // Sixty digits less those of a few hundred operations on numbers below 1e3.
    EXPECT_LT(abs(at(linear.F[i]) - rest).to_double(), 1e-50) << i;
  }
}

}  // namespace
}  // namespace torsor::linearisation_test
