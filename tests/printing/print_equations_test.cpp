// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/print_equations.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "tests/scenes/bodies.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::print_equations_test {
namespace {

std::string print(const Scene& scene, const PrintOptions& options = {}) {
  return print_equations(scene, Format::text, options);
}

/// The lines of one section, without its heading.
std::string section(const std::string& text, const std::string& heading) {
  const std::size_t start = text.find("\n" + heading + "\n");
  if (start == std::string::npos) return "no section " + heading;
  const std::size_t body = start + heading.size() + 2;
  const std::size_t end = text.find("\n\n", body);
  return text.substr(body, end == std::string::npos ? std::string::npos : end + 1 - body);
}

// Beside a label that is longer than a line there is no room for a term that has to be broken.
TEST(PrintEquations, BreaksTermsBesideNamesAsLongAsALine) {
  for (const std::size_t length : {60U, 120U, 150U, 160U, 200U, 1000U}) {
    const std::string name(length, 'q');
    Scene scene("long_name");
    const Expression q = scene.coordinate(name, "rad"), mass = scene.parameter("m", "kg", 2);
    const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, q);
    scene.body("bob", arm, Inertia::point(mass).at({0, Expression::quantity("1", "m"), 0}));
    scene.damper("d", q, Expression::quantity("1", "N m s"));
    const std::string text = print(scene);
    EXPECT_NE(text.find(name + "''"), std::string::npos) << length;
  }
}

// To update: print the scene, read the difference, and paste it only if the new text is right and reads better.
TEST(PrintEquations, WritesTheAbsorberAsAPersonWould) {
  EXPECT_EQ(print(test::absorber()), R"(vibration_absorber

Parameters
  M1 = 10 kg
  M2 = 1 kg
  M3 = 0.5 kg
  d = 0.25 m
  R = 0.05 m
  omega = 6 rad/s
  K = 1000 N/m
  X0 = 0.1 m
  g = 9.81 m/s^2

Coordinates
  X [m]
  theta [rad]
  phi = omega t

Kinetic energy [J]
  T = 1/2 (M1 + M2 + M3) X'^2 + M2 d cos(theta) X' theta' + 1/2 M2 d^2 theta'^2 + M3 R omega cos(omega t) X' + 1/2 M3 R^2 omega^2

Force function [J]
  U = -1/2 K (X - X0)^2 + M3 R g cos(omega t) + M2 d g cos(theta)

Lagrange's equations
  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.
  X:  (M1 + M2 + M3) X'' + M2 d cos(theta) theta'' - M2 d sin(theta) theta'^2 - M3 R omega^2 sin(omega t) = -K (X - X0)
  theta:  M2 d^2 theta'' + M2 d cos(theta) X'' = -M2 d g sin(theta)

Painleve's equation and first integrals
  d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i', dT/dt at constant q and q'.
  T2 - T0 = 1/2 (M1 + M2 + M3) X'^2 + M2 d cos(theta) X' theta' + 1/2 M2 d^2 theta'^2 - 1/2 M3 R^2 omega^2    (in J)
  dT/dt = -M3 R omega^2 sin(omega t) X'    (partial derivative at constant q and q', in W)
  T2 - T0 - U is not conserved: T depends on time explicitly; the force function U depends on time explicitly.
  No momentum integral along X: U depends on it.
  No momentum integral along theta: T depends on it, U depends on it.

Linearised equations
  M e'' + C e' + K e = F + E u, e the deviation from the state, in the order of the coordinates.
  About any state without acceleration.
  M = [ M1 + M2 + M3   ,  M2 d cos(theta) ]
      [ M2 d cos(theta),  M2 d^2          ]
  C = [ 0,  -2 M2 d sin(theta) theta' ]
      [ 0,  0                         ]
  K = [ K,  -M2 d cos(theta) theta'^2 ]
      [ 0,  M2 d g cos(theta)         ]
  F = [ M2 d sin(theta) theta'^2 - K (X - X0) + M3 R omega^2 sin(omega t) ]
      [ -M2 d g sin(theta)                                                ]
)");
}

TEST(PrintEquations, LinearisesAboutAStateGivenByName) {
  const std::string text = print(test::absorber(), {.about = {{"theta", "0"}, {"X", "X0"}}});
  EXPECT_EQ(section(text, "Linearised equations"),
            "  M e'' + C e' + K e = F + E u, e the deviation from the state, in the order of the coordinates.\n"
            "  About theta = 0, X = X0; velocities and accelerations not named are zero.\n"
            "  M = [ M1 + M2 + M3,  M2 d   ]\n"
            "      [ M2 d        ,  M2 d^2 ]\n"
            "  C = [ 0,  0 ]\n"
            "      [ 0,  0 ]\n"
            "  K = [ K,  0      ]\n"
            "      [ 0,  M2 d g ]\n"
            "  F = [ M3 R omega^2 sin(omega t) ]\n"
            "      [ 0                         ]\n");
  EXPECT_THROW(print(test::absorber(), {.about = {{"alpha", "0"}}}), UsageError);
  EXPECT_THROW(print(test::absorber(), {.about = {{"X", "g"}}}), UnitError);
}

// A drag -c V v with V = |v| has the slope zero at rest; -f v/V has none there.
TEST(LinearisedEquations, HaveTheLimitsOfADragAtRest) {
  const auto floating = [](const std::function<Expression(const Expression&, const Expression&)>& drag) {
    Scene scene("floating");
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), m = scene.parameter("m", "kg", 2);
    scene.prismatic("slide", scene.ground(), axis::x, x);
    scene.body("block", scene.prismatic("block", "slide", axis::y, y), Inertia::point(m));
    scene.spring("k", x, scene.parameter("k", "N/m", 5));
    const Expression speed = sqrt(rate(x) * rate(x) + rate(y) * rate(y));
    scene.generalised_force("drag x", x, drag(rate(x), speed));
    scene.generalised_force("drag y", y, drag(rate(y), speed));
    return scene;
  };
  const Expression c = Expression::quantity("3", "kg/m"), d = Expression::quantity("1", "N s/m");
  const Expression f = Expression::quantity("1", "N");
  const auto quadratic = [&](const Expression& v, const Expression& speed) { return -(d + c * speed) * v; };
  const std::string text =
      section(print(floating(quadratic), {.about = {{"x", "0"}, {"y", "0"}}}), "Linearised equations");
  EXPECT_NE(text.find("  C = [ 1,  0 ]\n      [ 0,  1 ]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  K = [ k,  0 ]\n      [ 0,  0 ]\n"), std::string::npos) << text;
  const auto dry = [&](const Expression& v, const Expression& speed) { return -f * v / speed; };
  EXPECT_THROW(print(floating(dry), {.about = {{"x", "0"}, {"y", "0"}}}), UsageError);
}

// Euler's equations about a spin n: I1 w1' = (I2 - I3) n w2 and I2 w2' = (I3 - I1) n w1, here with 1, 2, 3 kg m^2 and n = 5.
TEST(PrintEquations, LinearisesAboutTheSpinOfAnAttitude) {
  const std::string text =
      section(print(testing_mechanisms::torque_free_body(), {.about = {{"e_omega_z", "5"}}}), "Linearised equations");
  EXPECT_NE(text.find("  C = [ 0  ,  5,  0 ]\n      [ -10,  0,  0 ]\n      [ 0  ,  0,  0 ]\n"), std::string::npos) << text;
}

// C of a free body turns with omega: that e' is no rate there must be said, and where nothing turns so it is not.
TEST(PrintEquations, SaysWhatTheRateOfATurnStandsFor) {
  Scene scene("top");
  const FrameHandle top = scene.spherical("top", scene.ground(), scene.attitude("e"));
  scene.body("top", top, testing_mechanisms::generic_body());
  const std::string sentence = "w = de/dt + omega x e.";
  EXPECT_NE(section(print(scene, {}), "Linearised equations").find(sentence), std::string::npos) << print(scene, {});
  EXPECT_EQ(print(test::absorber(), {}).find(sentence), std::string::npos);
}

// A motor that pulls where x grows and pushes where y does: E u stands on the right.
TEST(PrintEquations, LinearisesMotorsOnTheRight) {
  Scene scene("cart");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle cart = scene.prismatic("cart", scene.ground(), axis::x, x);
  const Expression mass = scene.parameter("m", "kg");
  scene.body("cart", scene.prismatic("lift", cart, axis::z, y), Inertia::point(mass));
  scene.motor("pull", 2 * y - 3 * x);
  const std::string text = section(print(scene, {.about = {{"x", "0"}}}), "Linearised equations");
  EXPECT_NE(text.find("  F = [ 0 ]\n      [ 0 ]\n  E = [ -3 ]\n      [ 2  ]\n"), std::string::npos) << text;
}

TEST(PrintEquations, UsesTheDifferenceOfAbsoluteAngles) {
  const std::string text = print(test::double_pendulum({}), {.linearisation = false});
  EXPECT_EQ(section(text, "Kinetic energy [J]"),
            "  T = 1/2 (m_1 + m_2) l_1^2 theta_1'^2 + m_2 l_1 l_2 cos(theta_1 - theta_2) theta_1' theta_2' + 1/2 m_2 "
            "l_2^2 theta_2'^2\n");
  EXPECT_EQ(section(text, "Force function [J]"), "  U = (m_1 + m_2) l_1 g cos(theta_1) + m_2 l_2 g cos(theta_2)\n");
  EXPECT_EQ(
      section(text, "Lagrange's equations"),
      "  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.\n"
      "  theta_1:  (m_1 + m_2) l_1^2 theta_1'' + m_2 l_1 l_2 cos(theta_1 - theta_2) theta_2'' + m_2 l_1 l_2 "
      "sin(theta_1 - theta_2) theta_2'^2\n"
      "              = -(m_1 + m_2) l_1 g sin(theta_1)\n"
      "  theta_2:  m_2 l_2^2 theta_2'' + m_2 l_1 l_2 cos(theta_1 - theta_2) theta_1'' - m_2 l_1 l_2 sin(theta_1 - "
      "theta_2) theta_1'^2 = -m_2 l_2 g sin(theta_2)\n");
}

TEST(PrintEquations, UsesTheSumOfRelativeAngles) {
  EXPECT_EQ(section(print(test::double_pendulum({.second = test::Angle::of_the_joint})), "Force function [J]"),
            "  U = (m_1 + m_2) l_1 g cos(theta_1) + m_2 l_2 g cos(theta_1 + theta_2)\n");
}

TEST(PrintEquations, PutsSpringsFrictionAndMotorsOnTheRight) {
  EXPECT_EQ(
      section(print(test::satellite()), "Lagrange's equations"),
      "  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.\n"
      "  psi:  (C + A sin(theta)^2 + m (a + b sin(theta))^2) psi'' + 2 cos(theta) (a b m + (b^2 m + "
      "A) sin(theta)) psi' theta' = 0\n"
      "  theta:  (b^2 m + B) theta'' - cos(theta) (a b m + (b^2 m + A) sin(theta)) psi'^2 = -c theta' - k (theta - "
      "1/2 pi) + tau\n");
}

TEST(PrintEquations, WritesTheLengthOfAPointSpringAsARoot) {
  EXPECT_EQ(section(print(test::elastic_pendulum()), "Lagrange's equations"),
            "  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.\n"
            "  x:  m x'' = k l x/sqrt(x^2 + y^2) - k x\n"
            "  y:  m y'' = -m g + k l y/sqrt(x^2 + y^2) - k y\n");
}

TEST(PrintEquations, GivesTheReactionOfAReleasedCoordinate) {
  EXPECT_EQ(section(print(test::released_block()), "Lagrange's equations"),
            "  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.\n"
            "  x:  m x'' = 1/2 m g + F\n"
            "  N:  0 = -1/2 sqrt(3) m g + reaction_N\n");
}

TEST(PrintEquations, AddsMultipliersAndStatesTheirConstraints) {
  const std::string text = print(test::sled());
  EXPECT_EQ(
      section(text, "Lagrange's equations"),
      "  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i + sum_j lambda_j a_ji on the right.\n"
      "  x:  m x'' = -sin(psi) lambda_edge\n"
      "  y:  m y'' = cos(psi) lambda_edge\n"
      "  psi:  I psi'' = 0\n");
  EXPECT_EQ(section(text, "Constraints"), "  -sin(psi) x' + cos(psi) y' = 0    (edge, non-holonomic)\n");
}

TEST(PrintEquations, SwitchesToDefinitionsAndSaysSo) {
  const std::string text = print(test::chain(7));
  EXPECT_NE(text.find("too long to be written out (up to "), std::string::npos);
  EXPECT_NE(text.find("limits: 20000 of those, 400 to be read): named definitions are at the end."), std::string::npos);
  EXPECT_NE(text.find("\nDefinitions\n  z1 = "), std::string::npos);
  EXPECT_NE(text.find("\n  q7:  "), std::string::npos);
  EXPECT_NE(text.find("generate the kernel linearisation"), std::string::npos);
  // 300 definitions of at most a few lines each.
  EXPECT_LT(text.size(), 40000U);
}

TEST(PrintEquations, UsesEveryDefinitionThatItPrints) {
  const std::string text = print(test::chain(7));
  std::size_t count = 0;
  for (int k = 1;; ++k) {
    std::string name = "z";
    name += std::to_string(k);
    std::string line = "\n  ";
    line.append(name).append(" = ");
    if (text.find(line) == std::string::npos) break;
    int uses = 0;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const char next = text[at + name.size()];  // the text ends with a line break
      uses += std::isdigit(static_cast<unsigned char>(next)) != 0 ? 0 : 1;
    }
    EXPECT_GE(uses, 2) << name;
    ++count;
  }
  EXPECT_GT(count, 100U);
}

TEST(PrintEquations, TakesTheLimitsOfTheCaller) {
  const std::string text = print(test::absorber(), {.terms = 3});
  EXPECT_NE(text.find("limits: 20000 of those, 3 to be read"), std::string::npos);
  EXPECT_NE(text.find("\nDefinitions\n"), std::string::npos);
}

TEST(PrintEquations, TellsTheFirstIntegralOrTheConditionThatFails) {
  const std::string pendulum = print(test::double_pendulum({}));
  EXPECT_NE(pendulum.find("\n  constant = 1/2 (m_1 + m_2) l_1^2 theta_1'^2"), std::string::npos) << pendulum;
  const std::string absorber = print(test::absorber());
  EXPECT_NE(absorber.find("T2 - T0 - U is not conserved: T depends on time explicitly"), std::string::npos) << absorber;
}

// Euler's equations. A quaternion's components have no unit, least of all that of an angle.
TEST(PrintEquations, WritesEulersEquationsOfABodyPlacedByAQuaternion) {
  const std::string text = print(testing_mechanisms::torque_free_body());
  EXPECT_NE(text.find("\n  e_w [1]  component of a unit quaternion\n"), std::string::npos) << text;
  EXPECT_EQ(section(text, "Lagrange's equations"),
            R"(  P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i on the right.
  Along the angular velocity w of an attitude, P = d/dt(dT/dw) + w x dT/dw, less the derivative of T along the same turn.
  e_omega_x:  e_omega_x' + e_omega_y e_omega_z = 0
  e_omega_y:  2 e_omega_y' - 2 e_omega_x e_omega_z = 0
  e_omega_z:  3 e_omega_z' + e_omega_x e_omega_y = 0
)");
}

TEST(PrintEquations, PrintsTheSameBytesFromFreshSymbolsAtOtherAddresses) {
  for (const auto make : {test::absorber, test::satellite, test::elastic_pendulum}) {
    const std::string first = print(make());
    std::vector<std::unique_ptr<char[]>> noise;  // moves what is allocated next
    for (std::size_t i = 1; i <= 20; ++i) {
      noise.push_back(std::make_unique<char[]>(977 * i));
      ASSERT_EQ(print(make()), first);
    }
  }
}

TEST(PrintEquations, RefusesASceneThatCannotStand) {
  Scene scene("nothing");
  EXPECT_THROW(print(scene), SceneError);
}

TEST(ParseFormat, KnowsTextAndLatexOnly) {
  EXPECT_EQ(parse_format("text"), Format::text);
  EXPECT_EQ(parse_format("latex"), Format::latex);
  EXPECT_THROW(parse_format("html"), UsageError);
}

}  // namespace
}  // namespace torsor::print_equations_test
