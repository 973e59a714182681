// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "generated/bead_on_hoop.hpp"
#include "generated/kapitza_pendulum.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/vibration_absorber.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::misprints_test {

// Statements of the course (Pommier) that are wrong as printed, each against what is right, where no other test of the
// operation or the example does so. A kernel made of the printed version fails here.

namespace {

constexpr double rounding = 1.1e-16;

// §7.2.1, "K is always symmetric". Ziegler's column: two links of 1 m, absolute angles, springs k in both hinges, a
// thrust P that follows the second link: Q_1 = -P l sin(theta_2 - theta_1), Q_2 = 0, so that
// K = [2 k - P l, P l - k; -k, k].
TEST(Misprint, StiffnessOfAFollowingForceIsNotSymmetric) {
  using namespace torsor;
  Scene scene("ziegler_column");
  const Expression theta_1 = scene.coordinate("theta_1", "rad"), theta_2 = scene.coordinate("theta_2", "rad");
  const Expression metre = Expression::quantity("1", "m"), k = Expression::quantity("2", "N m");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, theta_1);
  const FrameHandle second = scene.revolute("second", first, axis::z, theta_2 - theta_1, {.origin = {metre, 0, 0}});
  scene.body("middle", first, Inertia::point(Expression::quantity("2", "kg")).at({metre, 0, 0}));
  scene.body("end", second, Inertia::point(Expression::quantity("1", "kg")).at({metre, 0, 0}));
  scene.point("tip", second, {metre, 0, 0});
  scene.spring("hinge_1", theta_1, k);
  scene.spring("hinge_2", theta_2 - theta_1, k);
  scene.force("thrust", {.body = second,
                         .point = scene.point("tip"),
                         .components = {Expression::quantity("-3", "N"), 0, 0},
                         .axes = second});
  const Equations equations(scene);
  const Linearisation linear = linearisation(equations);
  testing_mechanisms::NamedState rest(equations, {});
  EXPECT_EQ(rest.in_double(linear.K[0][0]), 1);
  EXPECT_EQ(rest.in_double(linear.K[0][1]), 1);
  EXPECT_EQ(rest.in_double(linear.K[1][0]), -2);
  EXPECT_EQ(rest.in_double(linear.K[1][1]), 2);
}

// The same without any such force, about a motion: of the absorber's first equation
// ... + M2 d (theta'' cos - theta'² sin) = -K (X - X0) the derivative with respect to theta is -M2 d theta'² cos(theta)
// when theta'' = 0; the second one, M2 d² theta'' + M2 d X'' cos = -M2 g d sin, holds no X.
TEST(Misprint, StiffnessAboutAMotionIsNotSymmetric) {
  using Absorber = vibration_absorber::Mechanism<double>;
  constexpr double M2 = 1.0, d = 0.0981;
  Absorber::State state{};
  state.q.theta = 0.4;
  state.v.theta = 3.0;
  Absorber::Linearisation linear{};
  ASSERT_EQ(Absorber::linearisation(Absorber::precompute(Absorber::default_parameters()), state, {}, {}, {}, linear),
            torsor::Status::ok);
  EXPECT_NEAR(linear.K[2], -M2 * d * 3.0 * 3.0 * std::cos(0.4), 10 * rounding);
  EXPECT_EQ(linear.K[1], 0.0);
}

// §7.2.1 forgets what the acceleration at fixed coordinates, d²OP/dt² explicit, gives to the stiffness. A pivot shaken
// by a cos(omega t) along the vertical: K = -m L (g - a omega² cos(omega t)) cos(theta), theta from the upward
// vertical; printed, -m L g cos(theta). On a hoop that turns: m g R cos(theta) - m omega² R² cos(2 theta).
TEST(Misprint, StiffnessHoldsTheImposedAcceleration) {
  using Pendulum = kapitza_pendulum::Mechanism<double>;
  using Bead = bead_on_hoop::Mechanism<double>;
  constexpr double m = 1.0, L = 1.0, R = 1.0, g = 9.81, a = 0.1, omega = 100.0;
  for (const double t : {0.0, 0.02, 0.05}) {
    for (const double theta : {0.0, 0.7, 2.5}) {
      Pendulum::State state{};
      state.time = t;
      state.q.theta = theta;
      Pendulum::Linearisation linear{};
      const auto pendulum = Pendulum::precompute({.a = a, .omega = omega});
      ASSERT_EQ(Pendulum::linearisation(pendulum, state, {}, {}, {}, linear), torsor::Status::ok);
      const double expected = -m * L * (g - a * omega * omega * std::cos(omega * t)) * std::cos(theta);
      EXPECT_NEAR(linear.K[0], expected, 20 * 1000 * rounding) << t << ", " << theta;

      Bead::State bead{};
      bead.time = t;
      bead.q.theta = theta;
      Bead::Linearisation turning{};
      ASSERT_EQ(Bead::linearisation(Bead::precompute({.omega = 5.0}), bead, {}, {}, {}, turning), torsor::Status::ok);
      const double centrifugal = m * 25.0 * R * R * std::cos(2 * theta);
      EXPECT_NEAR(turning.K[0], m * g * R * std::cos(theta) - centrifugal, 20 * 35 * rounding) << theta;
    }
  }
}

// §6.5.5, second illustration: the virtual velocities of X_F x1 and Y_F y1 hold cos(psi) and sin(psi), cos(theta) and
// sin(theta) are printed; and, as in the first one, R cos(theta) in the column of psi. With six coordinates
//   Q = X_F (cos psi, sin psi, 0, R cos theta, 0, R) + Y_F (-sin psi, cos psi, 0, 0, R sin theta, 0).
TEST(Misprint, ContactForcesOfTheHoopWorkAlongTheDirectionItRolls) {
  using Hoop = rolling_hoop_contact_forces::Mechanism<double>;
  constexpr double R = 1.0, psi = 0.7, theta = 1.1;
  const auto hoop = Hoop::precompute(Hoop::default_parameters());
  Hoop::State state{};
  state.q = {0.3, -0.2, R * std::sin(theta), psi, theta, 2.0};
  Hoop::GeneralizedForces without{}, with{};
  Hoop::inverse_dynamics(hoop, state, {}, {}, without);
  const auto force = [&](const Hoop::Multipliers& multipliers, const std::array<double, 6>& expected) {
    Hoop::inverse_dynamics(hoop, state, {}, multipliers, with);  // M a + bias - A' lambda
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(without[i] - with[i], expected[static_cast<std::size_t>(i)], 10 * 10 * rounding) << i;
    }
  };
  Hoop::Multipliers X{}, Y{};
  X.X_F = 1.0;
  Y.Y_F = 1.0;
  force(X, {std::cos(psi), std::sin(psi), 0.0, R * std::cos(theta), 0.0, R});
  force(Y, {-std::sin(psi), std::cos(psi), 0.0, 0.0, R * std::sin(theta), 0.0});
}

// §7.2.2: the motion that is imposed is that of the unbalance S3 relative to the support S1, not of the absorber S2.
// What moves without X' and theta' is S3, T0 = M3 R² omega²/2, and it shakes the support with M3 R omega²; the
// absorber's angle is an unknown.
TEST(Misprint, MotionImposedInTheAbsorberIsThatOfTheUnbalance) {
  using Absorber = vibration_absorber::Mechanism<double>;
  constexpr double M3 = 0.1, R = 0.02, X0 = 0.1, omega = 10.0, t = 0.13;
  const torsor::Equations equations(vibration_absorber_scene());
  ASSERT_EQ(equations.model().unknown_count(), 2);
  EXPECT_EQ(equations.model().coordinates()[0].q->name, "X");
  EXPECT_EQ(equations.model().coordinates()[1].q->name, "theta");
  const auto absorber = Absorber::precompute(Absorber::default_parameters());
  Absorber::State rest{};
  rest.time = t;
  rest.q.X = X0;
  Absorber::Energy energy{};
  Absorber::energy(absorber, rest, {}, energy);
  EXPECT_NEAR(energy.kinetic, M3 * R * R * omega * omega / 2, 10 * rounding);
  Absorber::Linearisation linear{};
  ASSERT_EQ(Absorber::linearisation(absorber, rest, {}, {}, {}, linear), torsor::Status::ok);
  EXPECT_NEAR(linear.F[0], M3 * R * omega * omega * std::sin(omega * t), 20 * 100 * rounding);
  EXPECT_EQ(linear.F[1], 0.0);
}

}  // namespace
}  // namespace torsor::misprints_test
