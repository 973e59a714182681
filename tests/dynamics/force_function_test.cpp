// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/force_function.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::force_function_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

constexpr double exact = 1e-45;  // of fifty digits

Expression stiffness() { return Expression::quantity("5", "N/m"); }

/// A support shaken along y by h sin ωt and a mass on a spring from it (course, §6.5.3); y of the mass is absolute.
struct Shaker {
  Scene scene{"shaker"};
  Expression y = scene.coordinate("y", "m");
  Expression phase = Expression::quantity("3", "rad/s") * scene.time();
  FrameHandle support = scene.prismatic("support", scene.ground(), axis::y, metres("0.1") * sin(phase));
  FrameHandle mass = scene.prismatic("mass", scene.ground(), axis::y, y);
  Shaker() {
    scene.body("M", mass, Inertia::point(kilograms("2")));
    scene.body("S", support, Inertia::point(kilograms("7")));
    scene.point("A", support, {0, 0, 0});
    scene.point("B", mass, {0, 0, 0});
    scene.spring("spring",
                 {.a = scene.point("A"), .b = scene.point("B"), .stiffness = stiffness(), .rest = metres("0.5")});
  }
};

Point at_time(const Real& t) { return {{"t", t}, {"y", rational(4, 5)}, {"y'", rational(2, 3)}}; }

TEST(ShakenSpring, HasAPotentialEnergyWhenBothEndsOfTheSpringAreSeen) {
  const Shaker it;
  const Equations equations(it.scene);
  const ForceFunctionReport report = classify_force_function(equations, {{"spring"}, {}});
  EXPECT_EQ(report.kind, ForceFunctionCase::potential_energy);
  EXPECT_TRUE(report.reasons.empty());
  ASSERT_TRUE(report.force_function);
  EXPECT_EQ(report.remark, "U of the springs, attractions, given functions and weight");
  NamedState here(equations, at_time(rational(1, 4)));
  const Real support = rational(1, 10) * sin(rational(3, 4));
  const Real stretch = rational(4, 5) - support - rational(1, 2);
  EXPECT_LT(relative_difference(here(*report.force_function), rational(-5, 2) * stretch * stretch), exact);
  // d/dy of −½ k (y − h sin ωt − l0)²: the square belongs there; without it the force would be the constant −½ k.
  EXPECT_LT(relative_difference(here(report.forces[0]), Real(-5) * stretch), exact);
  const Real support_rate = rational(3, 10) * cos(rational(3, 4));
  EXPECT_LT(relative_difference(here(report.power), Real(-5) * stretch * (rational(2, 3) - support_rate)), exact);
}

TEST(ShakenSpring, HasAForceFunctionAndNoPotentialEnergySeenFromTheMassAlone) {
  const Shaker it;
  const Equations equations(it.scene);
  const ForceFunctionReport report = classify_force_function(equations, {{"spring"}, {"M"}});
  EXPECT_EQ(report.kind, ForceFunctionCase::force_function);
  EXPECT_EQ(report.reasons,
            std::vector<std::string>{"Q_y changes with time at fixed coordinates, and all the power is sum Q_i q_i': "
                                     "nothing supplies dU/dt|explicit"});
  ASSERT_TRUE(report.force_function);
  NamedState here(equations, at_time(rational(1, 4)));
  const Real stretch = rational(4, 5) - rational(1, 10) * sin(rational(3, 4)) - rational(1, 2);
  EXPECT_LT(relative_difference(here(report.power), Real(-5) * stretch * rational(2, 3)), exact);
  EXPECT_LT(relative_difference(here(*report.force_function), rational(-5, 2) * stretch * stretch), exact);
}

TEST(ShakenSpring, HasNoForceFunctionWithADamper) {
  Shaker it;
  it.scene.damper("damper", it.scene.point("A"), it.scene.point("B"), Expression::quantity("2", "N s/m"));
  const Equations equations(it.scene);
  const ForceFunctionReport report = classify_force_function(equations, {{"spring", "damper"}, {}});
  EXPECT_EQ(report.kind, ForceFunctionCase::none);
  EXPECT_EQ(report.reasons, std::vector<std::string>{"Q_y depends on the velocity y'"});
  EXPECT_FALSE(report.force_function);
  // The spring alone keeps its own.
  EXPECT_EQ(classify_force_function(equations, {{"spring"}, {}}).kind, ForceFunctionCase::potential_energy);
}

TEST(ShakenSpring, HasAPotentialEnergyInTheCoordinateRelativeToTheSupport) {
  Scene scene("relative");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle support = scene.prismatic("support", scene.ground(), axis::y,
                                              metres("0.1") * sin(Expression::quantity("3", "rad/s") * scene.time()));
  scene.body("M", scene.prismatic("mass", support, axis::y, x), Inertia::point(kilograms("2")));
  scene.spring("spring", x, stiffness(), metres("0.5"));
  const ForceFunctionReport report = classify_force_function(Equations(scene), {{"spring"}, {}});
  EXPECT_EQ(report.kind, ForceFunctionCase::potential_energy);
}

TEST(Weight, OfAMassOnADrivenSupportHasAPotentialEnergyInTheAbsoluteFrame) {
  // Ep = m g (x + h sin ωt): the whole power of the weight, the support's part included.
  Scene scene("lifted");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle support = scene.prismatic("support", scene.ground(), axis::y,
                                              metres("0.1") * sin(Expression::quantity("3", "rad/s") * scene.time()));
  scene.body("M", scene.prismatic("mass", support, axis::y, x), Inertia::point(kilograms("2")));
  scene.gravity({0, Expression::quantity("-10", "m/s^2"), 0});
  const Equations equations(scene);
  const ForceFunctionReport report = classify_force_function(equations, {{"gravity"}, {}});
  EXPECT_EQ(report.kind, ForceFunctionCase::potential_energy);
  NamedState here(equations, {{"t", rational(1, 4)}, {"x'", rational(2, 3)}});
  EXPECT_LT(
      relative_difference(here(report.power), Real(-20) * (rational(2, 3) + rational(3, 10) * cos(rational(3, 4)))),
      exact);
}

// Of two masses one above the other, U = -m g y for the one that is asked for.
TEST(Weight, OfSomeBodiesIsTheirsAlone) {
  Scene scene("pair");
  const Expression y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle lower = scene.prismatic("lower", scene.ground(), axis::y, y);
  scene.body("A", lower, Inertia::point(kilograms("2")));
  scene.body("B", scene.prismatic("upper", lower, axis::y, z), Inertia::point(kilograms("7")));
  scene.gravity({0, Expression::quantity("-10", "m/s^2"), 0});
  const Equations equations(scene);
  NamedState here(equations, {{"y", Real(3)}, {"z", Real(5)}, {"y'", rational(1, 2)}, {"z'", rational(1, 4)}});
  const auto expect = [&](const std::vector<std::string>& bodies, const std::array<int, 4>& y_z_u_power) {
    const ForceFunctionReport report = classify_force_function(equations, {{"gravity"}, bodies});
    EXPECT_LT(relative_difference(here(report.forces[0]), Real(y_z_u_power[0])), exact);
    EXPECT_LT(relative_difference(here(report.forces[1]), Real(y_z_u_power[1])), exact);
    EXPECT_LT(relative_difference(here(*report.force_function), Real(y_z_u_power[2])), exact);
    EXPECT_LT(relative_difference(Real(2) * here(report.power), Real(y_z_u_power[3])), exact);
  };
  expect({"A"}, {-20, 0, -60, -20});
  expect({"B"}, {-70, -70, -560, -105});
  expect({"A", "B"}, {-90, -70, -620, -125});
  expect({}, {-90, -70, -620, -125});
}

/// A point free in a plane.
struct FreePoint : SlidingPoint {
  FreePoint() : SlidingPoint("free_point") {}
  void force(const Expression& fx, const Expression& fy) {
    scene.force("field", {.body = point, .point = scene.point("P"), .components = {fx, fy, 0}, .axes = scene.ground()});
  }
};

TEST(ForceFunction, OfAPolynomialFieldIsIntegratedAlongStraightLines) {
  FreePoint it;
  const Expression k = Expression::quantity("1", "N/m^4");
  const Expression x = it.x;
  const Expression y = it.y;
  const Expression c = Expression::quantity("1", "N");
  // U = x³ y² + 2 x − y⁵/5, by its gradient.
  it.force(3 * k * x * x * y * y + 2 * c, 2 * k * x * x * x * y - k * pow(y, 4));
  const Equations equations(it.scene);
  const ForceFunctionReport report = classify_force_function(equations);
  EXPECT_EQ(report.kind, ForceFunctionCase::potential_energy);
  EXPECT_EQ(report.remark, "U by integration along straight lines from q = 0");
  ASSERT_TRUE(report.force_function);
  const Real a = rational(7, 5);
  const Real b = rational(-4, 3);
  NamedState here(equations, {{"x", a}, {"y", b}});
  EXPECT_LT(
      relative_difference(here(*report.force_function), a * a * a * b * b + Real(2) * a - b * b * b * b * b / Real(5)),
      exact);
}

TEST(ForceFunction, ExistsLocallyWhereItCannotBeWrittenDown) {
  FreePoint it;
  const Expression square = it.x * it.x + it.y * it.y;  // the field of an angle: U = atan2(y, x)
  const Expression torque = Expression::quantity("1", "N m");
  it.force(-torque * it.y / square, torque * it.x / square);
  const ForceFunctionReport report = classify_force_function(Equations(it.scene));
  EXPECT_EQ(report.kind, ForceFunctionCase::potential_energy);
  EXPECT_FALSE(report.force_function);
  EXPECT_EQ(report.remark,
            "U exists locally; the forces are no polynomials of the coordinates and it is not written down");
}

TEST(ForceFunction, DoesNotExistForAFieldThatTurns) {
  FreePoint it;
  const Expression k = stiffness();
  it.force(-k * it.y, k * it.x);
  const ForceFunctionReport report = classify_force_function(Equations(it.scene));
  EXPECT_EQ(report.kind, ForceFunctionCase::none);
  EXPECT_EQ(report.reasons, std::vector<std::string>{"dQ_x/dy is not dQ_y/dx"});
}

TEST(ForceFunction, DoesNotExistForMotorsAndFriction) {
  FreePoint it;
  it.scene.motor("push", it.x);
  const ConstraintHandle floor = it.scene.holonomic("floor", it.y);
  it.scene.sliding_friction("rub", floor,
                            {.coefficient = 0.1_r,
                             .body = it.point,
                             .point = it.scene.point("P"),
                             .direction = axis::x,
                             .axes = it.scene.ground()});
  const ForceFunctionReport report = classify_force_function(Equations(it.scene));
  EXPECT_EQ(report.kind, ForceFunctionCase::none);
  EXPECT_EQ(report.reasons, (std::vector<std::string>{"'rub' depends on the normal force of its contact, and is left out of forces and power",
                                                      "Q_x depends on the input push"}));
}

TEST(ForceFunction, IsRecognisedAlongQuasiVelocities) {
  // Along the components of an angular velocity cross derivatives differ although U exists: the weight of a body off
  // its pivot. A constant moment in the body's axes has none: it does work around closed paths.
  Scene scene("top");
  const AttitudeHandle attitude = scene.attitude("e");
  const FrameHandle top = scene.spherical("top", scene.ground(), attitude);
  scene.body("top", top,
             Inertia::box(kilograms("1"), metres("1"), metres("2"), metres("3")).at({metres("0.3"), 0, metres("1")}));
  scene.gravity(
      {Expression::quantity("1", "m/s^2"), Expression::quantity("2", "m/s^2"), Expression::quantity("-9", "m/s^2")});
  EXPECT_EQ(classify_force_function(Equations(scene)).kind, ForceFunctionCase::potential_energy);
  scene.torque("motor", top, {0, 0, Expression::quantity("2", "N m")}, top);
  const ForceFunctionReport report = classify_force_function(Equations(scene), {{"motor"}, {}});
  EXPECT_EQ(report.kind, ForceFunctionCase::none);
  EXPECT_EQ(report.reasons.size(), 1U);
}

TEST(ForceFunction, GivenByFormulaWithTimeIsNoPotentialEnergy) {
  FreePoint it;
  it.scene.force_function(
      "field",
      -stiffness() / 2 * pow(it.x - metres("0.1") * sin(Expression::quantity("3", "rad/s") * it.scene.time()), 2));
  const Equations equations(it.scene);
  const ForceFunctionReport report = classify_force_function(equations);
  EXPECT_EQ(report.kind, ForceFunctionCase::force_function);
  // It works on the coordinates alone: Q_x x', without dU/dt at fixed ones.
  NamedState here(equations, {{"t", rational(1, 4)}, {"x", rational(4, 5)}, {"x'", rational(2, 3)}});
  const Real stretch = rational(4, 5) - rational(1, 10) * sin(rational(3, 4));
  EXPECT_LT(relative_difference(here(report.power), Real(-5) * stretch * rational(2, 3)), exact);
}

TEST(ForceFunction, RefusesUnknownNamesAndActionsWithoutEnds) {
  FreePoint it;
  it.scene.spring("spring", it.x, stiffness());
  const Equations equations(it.scene);
  EXPECT_EQ(error_of([&] {
              classify_force_function(equations, {{"sprong"}, {}});
            }),
            "unknown action 'sprong' in a selection of actions: did you mean 'spring'? the scene has gravity, spring");
  EXPECT_EQ(error_of([&] {
              classify_force_function(equations, {{}, {"Q"}});
            }),
            "unknown body 'Q' in a selection of actions: the scene has point");
  EXPECT_EQ(
      error_of([&] {
        classify_force_function(equations, {{"spring"}, {"point"}});
      }),
      "the action 'spring' works on a formula, and its share on one body is not known: ask for it without bodies, "
      "or write it between points");
}

}  // namespace
}  // namespace torsor::force_function_test
