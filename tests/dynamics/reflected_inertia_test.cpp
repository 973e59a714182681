// SPDX-License-Identifier: GPL-3.0-or-later
// Reflected inertias: half a e'^2 in the kinetic energy, and nothing anywhere else.
#include <gtest/gtest.h>

#include <functional>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/recursions/centroidal_momentum.hpp"
#include "torsor/generator/dynamics/recursions/regressor.hpp"
#include "torsor/generator/dynamics/structure/mobility.hpp"
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::reflected_inertia_test {
namespace {

using namespace testing_mechanisms;
using testing_symbols::rational;

/// A base that is free in the plane x z, and an arm on it that a motor turns about y.
struct FloatingArm {
  Scene scene{"floating_arm"};
  Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  Expression lean = scene.coordinate("lean", "rad"), turn = scene.coordinate("turn", "rad");

  explicit FloatingArm(bool with_rotor) {
    const FrameHandle at = scene.prismatic("at_z", scene.prismatic("at_x", scene.ground(), axis::x, x), axis::z, z);
    const FrameHandle base = scene.revolute("base", at, axis::y, lean);
    const FrameHandle arm = scene.revolute("arm", base, axis::y, turn, {{metres("0.2"), 0, metres("0.1")}});
    scene.body("base", base, Inertia::general({.mass = kilograms("3"), .yy = Expression::quantity("0.4", "kg m^2")}));
    scene.body("arm", arm, Inertia::rod(kilograms("1"), metres("0.6"), 0).at({metres("0.3"), 0, 0}));
    scene.motor("drive", turn);
    if (with_rotor) scene.reflected_inertia("rotor", turn, Expression::quantity("0.7", "kg m^2"));
  }
};

TEST(ReflectedInertia, StandsOnTheDiagonalOfTheMassMatrixAlone) {
  const WorkingDigits precision(50);
  const Equations with(FloatingArm(true).scene), without(FloatingArm(false).scene);
  NamedState here(with, {{"lean", Real(1)}, {"turn", Real(2)}, {"lean'", Real(3)}, {"turn'", Real(-1)}});
  NamedState there(without, {{"lean", Real(1)}, {"turn", Real(2)}, {"lean'", Real(3)}, {"turn'", Real(-1)}});
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Real more = here(with.mass()[i][j]) - there(without.mass()[i][j]);
      EXPECT_LT(abs(more - (i == 3 && j == 3 ? rational(7, 10) : Real(0))), power_of_ten(-45)) << i << j;
    }
    EXPECT_LT(abs(here(with.inverse_dynamics()[i]) - there(without.inverse_dynamics()[i])), power_of_ten(-45)) << i;
  }
}

// What the motor exerts between base and arm is internal: from rest it changes no momentum.
TEST(ReflectedInertia, HasNoMomentumAndLeavesThatOfTheWholeAlone) {
  const WorkingDigits precision(50);
  const Equations equations(FloatingArm(true).scene);
  const CentroidalMomentum found = centroidal_momentum(equations.model());
  NamedState here(equations, {{"lean", Real(1)}, {"turn", Real(2)}, {"drive", Real(5)}});
  Real largest(0);
  for (int axis = 0; axis < 3; ++axis) {
    Real resultant(0), moment(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const Real a = here(equations.forward().accelerations[i]);
      resultant += a * here(found.columns[i].resultant[axis]);
      moment += a * here(found.columns[i].moment[axis]);
      largest = std::max(largest, abs(a));
    }
    EXPECT_LT(abs(resultant), power_of_ten(-45)) << axis;
    EXPECT_LT(abs(moment), power_of_ten(-45)) << axis;
  }
  EXPECT_GT(largest, Real(1));
}

TEST(ReflectedInertia, IsAmongTheParametersThatAreIdentified) {
  const WorkingDigits precision(50);
  FloatingArm it(true);
  it.scene.gravity({Expression::quantity("-9.81", "m/s^2"), 0, 0});  // across the axis of a rotor's own frame
  const Equations equations(it.scene);
  const ValueMatrix y = regressor(equations.model());
  const std::vector<Value> parameters = inertial_parameters(equations.model());
  NamedState here(equations, {{"lean", Real(1)}, {"turn", Real(2)}, {"lean'", Real(3)}, {"turn'", Real(-1)},
                              {"x''", Real(4)}, {"z''", Real(-2)}, {"lean''", Real(7)}, {"turn''", Real(5)}});
  for (std::size_t i = 0; i < 4; ++i) {
    Real sum(0);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (!y[i][p].is_zero() && !parameters[p].is_zero()) sum += here(y[i][p]) * here(parameters[p]);
    }
    EXPECT_LT(abs(sum - here(equations.inverse_dynamics()[i])), power_of_ten(-44)) << i;
    for (std::size_t p = y[i].size() - 10; p + 1 < y[i].size(); ++p) {
      EXPECT_TRUE(y[i][p].is_zero()) << "the rotor has no place: " << p;
    }
  }
}

// Its name is taken, but nothing can be fixed to it.
TEST(ReflectedInertia, HasNoPlaceThatCouldBeNamed) {
  FloatingArm it(true);
  it.scene.body("load", "rotor", Inertia::point(kilograms("1")));
  try {
    static_cast<void>(Equations(it.scene));
    FAIL() << "a body on a rotor";
  } catch (const SceneError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("names 'rotor', a reflected inertia, which has no place"), std::string::npos) << said;
  }
}

TEST(ReflectedInertia, IsNoBodyAndNoJoint) {
  const FloatingArm with(true), without(false);
  EXPECT_EQ(unknowns_report(Equations(with.scene)), unknowns_report(Equations(without.scene)));
  EXPECT_EQ(structure_graph(with.scene).bodies.size(), structure_graph(without.scene).bodies.size());
  EXPECT_EQ(structure_graph(with.scene).joints.size(), structure_graph(without.scene).joints.size());
  EXPECT_THROW(body_indices(Equations(with.scene).model(), {"rotor"}, "this test"), SceneError);
}

TEST(ReflectedInertia, IsAMassAlongASlide) {
  Scene scene("slide");
  const Expression x = scene.coordinate("x", "m");
  scene.body("block", scene.prismatic("block", scene.ground(), axis::x, x), Inertia::point(kilograms("2")));
  scene.reflected_inertia("rotor", 3 * x, kilograms("5"));
  const Equations equations(scene);
  NamedState here(equations, {});
  EXPECT_EQ(here.in_double(equations.mass()[0][0]), 2 + 5 * 9);
}

TEST(ReflectedInertia, RefusesUnitsThatAreNotOfItsDisplacement) {
  Scene scene("units");
  const Expression x = scene.coordinate("x", "m"), q = scene.coordinate("q", "rad");
  EXPECT_THROW(scene.reflected_inertia("a", q, kilograms("1")), UnitError);
  EXPECT_THROW(scene.reflected_inertia("b", x, Expression::quantity("1", "kg m^2")), UnitError);
  EXPECT_THROW(scene.reflected_inertia("c", x * x, kilograms("1")), UnitError);
}

// What is wrong with one is said of it, not of a body that nobody wrote; a body may be its namesake.
TEST(ReflectedInertia, IsNamedAsItWasWritten) {
  const auto refusal = [](const Expression& inertia, const std::function<Expression(Scene&, const Expression&)>& displacement) {
    Scene scene("slide");
    const Expression x = scene.coordinate("x", "m");
    scene.body("rotor", scene.prismatic("block", scene.ground(), axis::x, x), Inertia::point(kilograms("2")));
    scene.reflected_inertia("rotor", displacement(scene, x), inertia);
    return testing_symbols::error_of<Error>([&] { validate(scene); });
  };
  const auto along = [](Scene&, const Expression& x) { return x; };
  EXPECT_EQ(refusal(kilograms("3"), along), "no error");
  EXPECT_EQ(refusal(-kilograms("3"), along),
            "reflected inertia 'rotor' is -3 and must not be negative: it is N^2 J of a rotor of inertia J behind a gear of ratio N");
  EXPECT_EQ(refusal(kilograms("3"), [](Scene& scene, const Expression& x) { return x + scene.time() * rate(x); })
                .substr(0, 52),
            "the displacement of reflected inertia 'rotor' depend");
}

}  // namespace
}  // namespace torsor::reflected_inertia_test
