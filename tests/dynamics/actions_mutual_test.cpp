// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::actions_mutual_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

// Values of fifty digits: an identity holds to 1e-45.
constexpr double exact = 1e-45;

Expression newtons(const char* value) { return Expression::quantity(value, "N"); }
Expression newton_metres(const char* value) { return Expression::quantity(value, "N m"); }

/// Two carts on one rail and a wheel on each, turning about z.
class TwoCarts : public ::testing::Test {
 protected:
  Scene scene{"two_carts"};
  Expression x1 = scene.coordinate("x1", "m"), x2 = scene.coordinate("x2", "m");
  Expression a1 = scene.coordinate("a1", "rad"), a2 = scene.coordinate("a2", "rad");
  FrameHandle cart1 = scene.prismatic("cart1", scene.ground(), axis::x, x1);
  FrameHandle cart2 = scene.prismatic("cart2", scene.ground(), axis::x, x2);
  FrameHandle wheel1 = scene.revolute("wheel1", cart1, axis::z, a1);
  FrameHandle wheel2 = scene.revolute("wheel2", cart2, axis::z, a2);
  PointHandle p = scene.point("P", wheel1, {0, metres("0.5"), 0});
  Point state{{"x1", rational(1, 3)},  {"x2", rational(2, 7)},   {"a1", rational(4, 5)},  {"a2", rational(-1, 6)},
              {"x1'", rational(3, 8)}, {"x2'", rational(-2, 9)}, {"a1'", rational(7, 4)}, {"a2'", rational(5, 3)}};

  TwoCarts() {
    scene.body("cart1", cart1, Inertia::point(kilograms("1")));
    scene.body("cart2", cart2, Inertia::point(kilograms("2")));
    scene.body("wheel1", wheel1, Inertia::disk(kilograms("1"), metres("1"), 2));
    scene.body("wheel2", wheel2, Inertia::disk(kilograms("1"), metres("2"), 2));
  }
  const Real& of(const char* name) const { return state.at(name); }
  /// Q_i: the disks are centred, so that the bias holds nothing but actions.
  std::vector<Real> forces(const Equations& equations, NamedState& here) const {
    std::vector<Real> all;
    for (const Value& h : equations.bias()) all.push_back(-here(h));
    return all;
  }
};

TEST_F(TwoCarts, AreDraggedByTheirRelativeVelocityAtThePoint) {
  scene.drag("brake",
             {.body = wheel1, .point = p, .coefficient = Expression::quantity("3", "N s/m"), .relative_to = cart2});
  const Equations equations(scene);
  NamedState here(equations, state);
  // P = O1 + ½ (−sin a, cos a): V(P/cart2) = (ẋ1 − ẋ2 − ½ ȧ cos a, −½ ȧ sin a); the rails hold what is across.
  const Real half = rational(1, 2);
  const Real vx = of("x1'") - of("x2'") - half * of("a1'") * cos(of("a1"));
  const Real vy = -half * of("a1'") * sin(of("a1"));
  const Real turn = Real(-3) * (-half * cos(of("a1")) * vx - half * sin(of("a1")) * vy);
  const std::array<Real, 4> expected{Real(-3) * vx, Real(3) * vx, turn, Real(0)};
  const std::vector<Real> q = forces(equations, here);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(relative_difference(q[i], expected[i]), exact) << i;
  EXPECT_LT(relative_difference(here(equations.power()), Real(-3) * (vx * vx + vy * vy)), exact);
}

TEST_F(TwoCarts, AreBrakedByTheirRelativeTurn) {
  scene.rotational_drag("coupling", wheel1, Expression::quantity("5", "N m s"), wheel2);
  scene.rotational_drag("bearing", wheel2, Expression::quantity("2", "N m s"));
  const Equations equations(scene);
  NamedState here(equations, state);
  const Real slip = of("a1'") - of("a2'");
  const std::array<Real, 4> expected{Real(0), Real(0), Real(-5) * slip, Real(5) * slip - Real(2) * of("a2'")};
  const std::vector<Real> q = forces(equations, here);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(relative_difference(q[i], expected[i]), exact) << i;
  EXPECT_LT(relative_difference(here(equations.power()), Real(-5) * slip * slip - Real(2) * of("a2'") * of("a2'")),
            exact);
}

TEST_F(TwoCarts, PushEachOtherWithOppositeForcesAtOnePoint) {
  scene.force_between(
      "push",
      {.a = wheel1, .b = wheel2, .point = p, .components = {newtons("3"), newtons("-4"), 0}, .axes = scene.ground()});
  scene.torque_between(
      "twist", {.a = wheel1, .b = wheel2, .components = {newton_metres("1"), 0, newton_metres("6")}, .axes = wheel1});
  const Equations equations(scene);
  NamedState here(equations, state);
  const Real half = rational(1, 2);
  const Real px = -half * sin(of("a1"));
  const Real py = half * cos(of("a1"));
  const Real moment1 = px * Real(-4) - py * Real(3);
  const Real dx = of("x1") + px - of("x2");  // from the centre of the second wheel
  const Real moment2 = -(dx * Real(-4) - py * Real(3));
  const std::array<Real, 4> expected{Real(3), Real(-3), moment1 + Real(6), moment2 - Real(6)};
  const std::vector<Real> q = forces(equations, here);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(relative_difference(q[i], expected[i]), exact) << i;
  Real power(0);
  const char* rates[] = {"x1'", "x2'", "a1'", "a2'"};
  for (std::size_t i = 0; i < 4; ++i) power += expected[i] * of(rates[i]);
  EXPECT_LT(relative_difference(here(equations.power()), power), exact);
}

TEST_F(TwoCarts, RefuseActionsWithinOneBodyOrOnTheGround) {
  const auto refusal = [&](const auto& add) {
    Scene bad = scene;
    return error_of([&] {
      add(bad);
      Equations(bad).actions();
    });
  };
  const Expression c = Expression::quantity("1", "N s/m");
  EXPECT_EQ(refusal([&](Scene& s) { s.drag("wind", {.body = "ground", .point = p, .coefficient = c}); }),
            "action 'wind' is applied to the ground, which it cannot move");
  EXPECT_EQ(refusal([&](Scene& s) {
              const FrameHandle rim = s.weld("rim", wheel1, {});
              s.torque_between("inner",
                               {.a = rim, .b = wheel1, .components = {newton_metres("1"), 0, 0}, .axes = wheel1});
            }),
            "action 'inner' acts between two frames of one rigid body: nothing moves between them");
  EXPECT_EQ(refusal([&](Scene& s) { s.drag("wind", {.body = wheel1, .point = p, .coefficient = newtons("1")}); }),
            "the coefficient of the drag 'wind' is 1 [N] and must be in N s/m");
  EXPECT_EQ(
      refusal([&](Scene& s) {
        s.wrench(
            "w",
            {.body = wheel1, .point = p, .force = {newton_metres("1"), 0, 0}, .moment = {0, 0, 0}, .axes = wheel1});
      }),
      "a force component of the wrench 'w' is 1 [N m] and must be in N");
}

/// Two bodies on a carriage that turns about z at Ω and moves along y at V, or stands; the coordinates are relative to
/// it.
struct OnACarriage {
  Scene scene;
  OnACarriage(const char* turn, const char* speed, bool mutual) : scene("carriage") {
    const Expression t = scene.time();
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::y, Expression::quantity(speed, "m/s") * t);
    const FrameHandle carriage = scene.revolute("carriage", slide, axis::z, Expression::quantity(turn, "rad/s") * t);
    const Expression x = scene.coordinate("x", "m");
    const Expression a = scene.coordinate("a", "rad");
    const Expression b = scene.coordinate("b", "rad");
    const FrameHandle first = scene.revolute("first", scene.prismatic("rail", carriage, axis::x, x), {1, 2, 2}, a);
    const FrameHandle second = scene.revolute("second", carriage, axis::x, b, {.origin = {0, metres("2"), 0}});
    scene.body("first", first, Inertia::box(kilograms("1"), metres("1"), metres("2"), metres("3")));
    scene.body("second", second, Inertia::box(kilograms("2"), metres("1"), metres("1"), metres("1")));
    scene.point("P", first, {metres("0.5"), metres("0.25"), 0});
    const Triple force{newtons("3"), newtons("-1"), newtons("2")};
    const Triple moment{newton_metres("5"), 0, newton_metres("4")};
    if (mutual) {
      scene.force_between("push",
                          {.a = first, .b = second, .point = scene.point("P"), .components = force, .axes = second});
      scene.torque_between("twist", {.a = first, .b = second, .components = moment, .axes = second});
      scene.drag("drag", {.body = first,
                          .point = scene.point("P"),
                          .coefficient = Expression::quantity("7", "N s/m"),
                          .relative_to = second});
      scene.rotational_drag("turning_drag", first, Expression::quantity("3", "N m s"), second);
    } else {
      scene.wrench("push",
                   {.body = first, .point = scene.point("P"), .force = force, .moment = moment, .axes = carriage});
    }
  }
  Point state{{"t", rational(1, 2)},  {"x", rational(3, 4)},   {"a", rational(1, 3)}, {"b", rational(-2, 5)},
              {"x'", rational(5, 7)}, {"a'", rational(-4, 3)}, {"b'", rational(9, 8)}};
};

TEST(PowerOfAMutualAction, IsTheSameInEveryFrameOfReference) {
  const OnACarriage moving("1.5", "2.5", true), standing("0", "0", true);
  const Equations first(moving.scene), second(standing.scene);
  NamedState in_motion(first, moving.state), at_rest(second, standing.state);
  const Real power = at_rest(second.power());
  EXPECT_GT(abs(power), Real(1));
  EXPECT_LT(relative_difference(in_motion(first.power()), power), exact);
}

TEST(PowerOfAnExternalAction, ChangesWithTheFrameByTheVelocityOfTheFrame) {
  const OnACarriage moving("1.5", "2.5", false), standing("0", "0", false);
  const Equations first(moving.scene), second(standing.scene);
  NamedState in_motion(first, moving.state), at_rest(second, standing.state);
  // {F; M_P} of the push with the twist of the carriage: V(P) = V y + Ω z ∧ OP, OP from the place of P at rest.
  const Vector p = second.model().locate(PointReference("P"), 0, "P");
  const Real omega = rational(3, 2);
  const Real angle = omega * rational(1, 2);
  const Real c = cos(angle);
  const Real s = sin(angle);
  // V y in the carriage's axes, where the force is given.
  const Real vx = rational(5, 2) * s - omega * at_rest(p[1]);
  const Real vy = rational(5, 2) * c + omega * at_rest(p[0]);
  const Real difference = Real(3) * vx - vy + Real(4) * omega;
  EXPECT_GT(abs(difference), Real(1));
  EXPECT_LT(relative_difference(in_motion(first.power()) - at_rest(second.power()), difference), exact);
}

}  // namespace
}  // namespace torsor::actions_mutual_test
