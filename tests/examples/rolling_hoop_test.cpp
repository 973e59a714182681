// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/rolling_hoop.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "generated/rolling_hoop_contact_forces.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/small_motions/stability.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::rolling_hoop_test {
namespace {

using namespace torsor::runtime;
using examples::amplification;
using examples::Amplification;
using examples::state_at;
using Hoop = rolling_hoop::Mechanism<double>;
using HoopWithForces = rolling_hoop_contact_forces::Mechanism<double>;
using State = StateVector<Hoop>;

// The values of the scene.
constexpr double m = 1.0, R = 1.0, g = 9.81;
constexpr double rounding = 1.1e-16;

// x, y, psi, theta, phi of the compatible parametrisation; the other has z after y.
constexpr int other_index(int i) { return i < 2 ? i : i + 1; }

template <class Mechanism>
struct Contact {
  typename Mechanism::Accelerations a{};
  typename Mechanism::Multipliers lambda{};
};

template <class Mechanism>
Contact<Mechanism> contact_at(const typename Mechanism::State& state) {
  Contact<Mechanism> contact;
  const auto precomputed = Mechanism::precompute(Mechanism::default_parameters());
  EXPECT_EQ(Mechanism::forward_dynamics(precomputed, state, {}, contact.a, contact.lambda), torsor::Status::ok);
  return contact;
}

// Runge-Kutta with the same steps on both sides, and nothing held on constraints, which are not the same: what remains is
// rounding, 10^4 steps of numbers up to 40 (the angle
// phi), 4e-15 each at most and 4e-13 together when they err at random.
TEST(RollingHoop, MovesTheSameInBothParametrisations) {
  const auto compatible = unprojected_motion<Hoop>();
  const auto incompatible = unprojected_motion<HoopWithForces>();
  auto y = compatible.initial();
  auto z = incompatible.initial();
  double motions = 0.0, forces = 0.0;
  for (int tenth = 0; tenth < 100; ++tenth) {
    const double from = 0.1 * tenth, to = 0.1 * (tenth + 1);
    y = state_at(compatible, y, from, to, RungeKutta4{.step = 1e-3});
    z = state_at(incompatible, z, from, to, RungeKutta4{.step = 1e-3});
    const auto one = unpack<Hoop>(to, y);
    const auto two = unpack<HoopWithForces>(to, z);
    for (int i = 0; i < Hoop::coordinate_count; ++i) {
      motions = std::fmax(motions, std::abs(one.q[i] - two.q[other_index(i)]));
      motions = std::fmax(motions, std::abs(one.v[i] - two.v[other_index(i)]));
    }
    motions = std::fmax(motions, std::abs(two.q.z - R * std::sin(two.q.theta)));
    const auto multipliers = contact_at<Hoop>(one).lambda;
    const auto reactions = contact_at<HoopWithForces>(two).lambda;
    forces = std::fmax(forces, std::abs(multipliers.lambda_along_x1 - reactions.X_F));
    forces = std::fmax(forces, std::abs(multipliers.lambda_along_y1 - reactions.Y_F));
  }
  EXPECT_LE(motions, 1e-12);
  EXPECT_LE(forces, 1e-12);
}

// At one and the same state: forces of some 10 N, a 3 x 3 solve of condition below 10: 100 roundings.
TEST(RollingHoop, HasMultipliersEqualToTheContactForces) {
  const auto motion = equations_of_motion<Hoop>();
  State y = motion.initial();
  for (int i = 0; i < 20; ++i) {
    y = state_at(motion, y, 0.3 * i, 0.3 * (i + 1), RungeKutta4{.step = 1e-3});
    const auto state = unpack<Hoop>(0.3 * (i + 1), y);
    HoopWithForces::State free{};
    for (int k = 0; k < Hoop::coordinate_count; ++k) {
      free.q[other_index(k)] = state.q[k];
      free.v[other_index(k)] = state.v[k];
    }
    free.q.z = R * std::sin(state.q.theta);
    free.v.z = R * std::cos(state.q.theta) * state.v.theta;
    const auto compatible = contact_at<Hoop>(state);
    const auto incompatible = contact_at<HoopWithForces>(free);
    constexpr double tolerance = 100 * 10 * rounding;
    EXPECT_NEAR(compatible.lambda.lambda_along_x1, incompatible.lambda.X_F, tolerance);
    EXPECT_NEAR(compatible.lambda.lambda_along_y1, incompatible.lambda.Y_F, tolerance);
    // N = m (g + z''), z = R sin(theta), with the accelerations of the parametrisation that knows no N.
    const double lift =
        R * (compatible.a.theta * std::cos(state.q.theta) - state.v.theta * state.v.theta * std::sin(state.q.theta));
    EXPECT_NEAR(incompatible.lambda.N, m * (g + lift), tolerance);
  }
}

/// A disc (m R^2 / 4, m R^2 / 2) whose lean, turning about the vertical and so on are those of the references: q1 =
/// psi, q2 = theta - pi/2, q3 = -phi, u1, u2, u3 the components of the rate of turn along x1, -z2 and y2.
Hoop::Parameters disc() {
  Hoop::Parameters parameters = Hoop::default_parameters();
  parameters.A = m * R * R / 4.0;
  parameters.C = m * R * R / 2.0;
  return parameters;
}

State disc_state(double lean, double u1, double u2, double u3) {
  Hoop::State state{};
  state.q.theta = std::numbers::pi / 2.0 + lean;
  state.q.y = R * std::cos(state.q.theta);  // psi = 0, the contact point at the origin
  state.v.theta = u1;
  state.v.psi = u3 / std::cos(lean);
  state.v.phi = -(u2 - u3 * std::tan(lean));
  state.v.x = -R * (state.v.phi + state.v.psi * std::cos(state.q.theta));
  state.v.y = -R * u1 * std::sin(state.q.theta);
  return pack<Hoop>(state);
}

/// q1, q2, q3, u1, u2, u3 and the contact point.
std::array<double, 8> as_in_the_reference(const State& y) {
  const auto s = unpack<Hoop>(0.0, y);
  const double sine = std::sin(s.q.theta), cosine = std::cos(s.q.theta);
  return {s.q.psi,
          s.q.theta - std::numbers::pi / 2.0,
          -s.q.phi,
          s.v.theta,
          -(s.v.phi + s.v.psi * cosine),
          s.v.psi * sine,
          s.q.x + R * cosine * std::sin(s.q.psi),
          s.q.y - R * cosine * std::cos(s.q.psi)};
}

constexpr DormandPrince54 tight{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14};

struct Circle {
  double lean, turning, rolling, radius;  // q2, q1', u2 and the radius of the contact point's circle
};
constexpr std::array<Circle, 3> circles{{{0.3, 1.0, -1.973805704670046014866666, 2.269325911331385589971987},
                                         {0.2, 0.5, -2.634891486887180980555082, 5.468452304569423176569576},
                                         {0.35, 3.0, -0.6243132150025998625375744, 0.551002212456317970035493}}};

TEST(RollingDisc, ComesBackAfterATurnOnASteadyCircle) {
  const auto motion = equations_of_motion<Hoop>(disc());
  for (const Circle& circle : circles) {
    const State start = disc_state(circle.lean, 0.0, circle.rolling, circle.turning * std::cos(circle.lean));
    const double turn = 2.0 * std::numbers::pi / circle.turning;
    const State end = state_at(motion, start, 0.0, turn, tight);
    const double kappa = amplification(motion, start, 0.0, turn);
    EXPECT_GE(kappa, 1.0);
    const auto before = as_in_the_reference(start), after = as_in_the_reference(end);
    for (std::size_t i = 0; i < 8; ++i) {
      double change = 0.0;
      if (i == 0) change = 2.0 * std::numbers::pi;
      if (i == 2) change = turn * (circle.rolling - circle.turning * std::sin(circle.lean));
      EXPECT_NEAR(after[i], before[i] + change, 1e-10 * kappa) << "lean " << circle.lean << ", component " << i;
    }
    // Half a turn later the point of contact is across the circle.
    const auto across = as_in_the_reference(state_at(motion, start, 0.0, turn / 2.0, tight));
    EXPECT_NEAR(std::hypot(across[6], across[7]), 2.0 * circle.radius, 1e-10 * kappa);
  }
}

/// The state matrix of the deviations from rolling straight ahead, upright, at u2; the coefficients of its
/// characteristic polynomial lambda^8 + c[1] lambda^7 + ... + c[8], by Leverrier's recursion.
constexpr int states = Hoop::independent_coordinate_count + Hoop::independent_velocity_count;
Eigen::Matrix<double, states, states> rolling_straight(double u2, double heading) {
  const auto precomputed = Hoop::precompute(disc());
  Hoop::State state = unpack<Hoop>(0.0, disc_state(0.0, 0.0, u2, 0.0));
  state.q.psi = heading;
  state.v.y = state.v.x * std::sin(heading);
  state.v.x *= std::cos(heading);
  Contact<Hoop> contact;
  EXPECT_EQ(Hoop::forward_dynamics(precomputed, state, {}, contact.a, contact.lambda), torsor::Status::ok);
  for (int i = 0; i < Hoop::velocity_count; ++i) EXPECT_NEAR(contact.a[i], 0.0, 100 * rounding);
  Hoop::Linearisation linear{};
  EXPECT_EQ(Hoop::linearisation(precomputed, state, contact.a, contact.lambda, {}, linear), torsor::Status::ok);
  return torsor::runtime::state_matrix(linear);
}

std::array<double, states + 1> characteristic_polynomial(double u2, double heading) {
  using Matrix = Eigen::Matrix<double, states, states>;
  const Matrix A = rolling_straight(u2, heading);
  std::array<double, states + 1> c{1.0};
  Matrix B = Matrix::Identity();
  for (int k = 1; k <= states; ++k) {
    c[static_cast<std::size_t>(k)] = -(A * B).trace() / k;
    B = A * B + c[static_cast<std::size_t>(k)] * Matrix::Identity();
  }
  return c;
}

// lambda^6 (lambda^2 - mu), mu = 4 g/(5 R) - 12 u2^2/5: the roots are +- sqrt(mu) and zeros, four of them of the lean,
// the heading, the roll and their rates, two more of the place of the disc. (As zeros of a defective matrix they are
// not asked of an eigenvalue solver.) Leverrier's sums have terms of up to |A^2|^(k/2), |A^2| below 75: what
// cancels in the k-th coefficient is known to eight roundings of that.
TEST(RollingDisc, HasThePublishedEigenvaluesWhenItRollsUpright) {
  for (const double heading : {0.0, 0.7}) {
    for (const double u2 : {0.0, 0.5, 1.5, 1.9, 4.0}) {
      const auto c = characteristic_polynomial(u2, heading);
      const double mu = 4.0 * g / (5.0 * R) - 12.0 * u2 * u2 / 5.0;
      EXPECT_NEAR(c[2], -mu, 8 * 75 * rounding) << u2;
      for (std::size_t k = 1; k <= states; ++k) {
        if (k == 2) continue;
        EXPECT_NEAR(c[k], 0.0, 8 * std::pow(75.0, static_cast<double>(k) / 2.0) * rounding) << u2 << ", " << k;
      }
    }
  }
}

// An upright disc falls over below sqrt(g/(3 R)): the coefficient -mu changes its sign there, by halving.
TEST(RollingDisc, StaysUprightAboveTheCriticalSpeed) {
  double slow = 0.5, fast = 4.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (slow + fast) / 2.0;
    (characteristic_polynomial(middle, 0.0)[2] < 0.0 ? slow : fast) = middle;
  }
  // mu is known to the tolerance above, its slope there is 24/5 u2.
  EXPECT_NEAR(slow, 1.808314132002512444004943, 8 * 75 * rounding / (24.0 / 5.0 * 1.8));
}

// Its verdict: unstable below the critical speed; above, roots on the imaginary axis and zeros prove nothing.
TEST(RollingDisc, IsSaidToFallBelowTheCriticalSpeedOnly) {
  using torsor::runtime::Stability;
  const auto verdict = [](double u2) { return torsor::runtime::stability_by_eigenvalues(rolling_straight(u2, 0.4)); };
  for (const double u2 : {0.0, 1.0, 1.80}) EXPECT_EQ(verdict(u2).verdict, Stability::unstable) << verdict(u2).reason;
  for (const double u2 : {1.82, 4.0}) EXPECT_EQ(verdict(u2).verdict, Stability::cannot_conclude) << verdict(u2).reason;
}

struct Unsteady {
  double time;
  std::array<double, 8> values;
};
constexpr std::array<Unsteady, 3> unsteady{{
    {1.0,
     {-0.45709301194487782239760748, 0.20920345769543760732953425, 4.1348957526640843783356896,
      -0.16153684013951182274066837, 4.0002260223433159629628788, -0.073699942537327970681712831,
      3.9918984343377288606412720, -0.83129242039865596268905700}},
    {5.0,
     {-2.0723505646663599905060293, 0.29897151296365539580230544, 20.610546425467790940289050,
      -0.0054015050900161584115777273, 4.0263707702522737092581189, -0.80429382218606593622421123,
      8.7675917842463885315788820, -14.678138958692462222679684}},
    {20.0,
     {-8.2781443246749404801502461, 0.20013953194818799218286992, 82.438516341716692290160364,
      0.020844820004872785036480535, 4.0000000519182619547264290, -0.00111627138440461830080507,
      8.9883408870727302164204161, -14.004034894586361799450060}},
}};

// A thousand steps a second whose rounding, up to 1e-15 each (of |y| below 10, but for the angle phi which nothing
// depends on), adds up as a random walk: 3e-14 a second times what the flow amplifies. The change to the reference's
// variables is a factor near 1.
TEST(RollingDisc, MeetsItsIndependentUnsteadyReference) {
  const auto motion = equations_of_motion<Hoop>(disc());
  const State start = disc_state(0.2, 0.0, 4.0, 0.0);
  Amplification growth(motion, start, 0.0);
  for (const Unsteady& at : unsteady) {
    const auto values = as_in_the_reference(state_at(motion, start, 0.0, at.time, tight));
    const double tolerance = 1e-13 * growth.until(at.time);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(values[i], at.values[i], tolerance) << at.time << ", " << i;
  }
}

// The tolerance is that of the test above. The committed reference comes from Lagrange's operator and an extrapolation
// in high precision.
TEST(RollingHoop, MeetsItsCommittedReference) {
  examples::expect_reference(equations_of_motion<Hoop>(), "rolling_hoop", {.error = 1e-13});
}

// --- misprints of the course, each against its correction ----------------------------------------------------------

constexpr double tolerance = 20 * 4 * rounding;  // twenty roundings of numbers below 4

Hoop::State some_state() {
  Hoop::State state{};
  state.q = {0.3, -0.2, 0.7, 1.1, 2.0};
  state.v = {0.4, 0.9, -0.8, 0.6, 1.3};
  return state;
}

// x' cos(psi) + y' sin(psi) + R (phi' + psi' cos(theta)) = 0, sin(theta) is printed;
// -x' sin(psi) + y' cos(psi) + R theta' sin(theta) = 0.
TEST(RollingHoop, RollsWithTheCorrectedNoSlipConditions) {
  const Hoop::State s = some_state();
  Hoop::Constraints c{};
  Hoop::constraints(Hoop::precompute(Hoop::default_parameters()), s, c);
  const double sine = std::sin(s.q.psi), cosine = std::cos(s.q.psi);
  const std::array<double, 10> expected{
      cosine, -sine, sine, cosine, R * std::cos(s.q.theta), 0.0, 0.0, R * std::sin(s.q.theta), R, 0.0};
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(c.jacobian[i], expected[i], tolerance) << i;
  EXPECT_NEAR(c.rate[0], s.v.x * cosine + s.v.y * sine + R * (s.v.phi + s.v.psi * std::cos(s.q.theta)), tolerance);
  EXPECT_NEAR(c.rate[1], -s.v.x * sine + s.v.y * cosine + R * s.v.theta * std::sin(s.q.theta), tolerance);
  EXPECT_EQ(c.value, (std::array<double, 2>{}));
}

// 2 T = m (x'^2 + y'^2 + (R theta' cos(theta))^2) + A (theta'^2 + (psi' sin(theta))^2) + C (phi' + psi' cos(theta))^2.
TEST(RollingHoop, HasTheCorrectedKineticEnergy) {
  const Hoop::State s = some_state();
  const Hoop::Parameters p = Hoop::default_parameters();
  Hoop::Energy energy{};
  Hoop::energy(Hoop::precompute(p), s, {}, energy);
  const double sine = std::sin(s.q.theta), cosine = std::cos(s.q.theta);
  const double doubled = m * (s.v.x * s.v.x + s.v.y * s.v.y + std::pow(R * s.v.theta * cosine, 2)) +
                         p.A * (s.v.theta * s.v.theta + std::pow(s.v.psi * sine, 2)) +
                         p.C * std::pow(s.v.phi + s.v.psi * cosine, 2);
  EXPECT_NEAR(energy.kinetic, doubled / 2.0, tolerance);
  EXPECT_NEAR(energy.force_function, -m * g * R * sine, 10 * tolerance);
  EXPECT_EQ(energy.power, 0.0);
}

// Q_theta = -m g R cos(theta), R is lost in print; the other forces of gravity vanish. At rest the bias is -Q.
TEST(RollingHoop, HasTheCorrectedForceOfGravity) {
  Hoop::State rest = some_state();
  rest.v = {};
  Hoop::GeneralizedForces bias{};
  Hoop::bias(Hoop::precompute(Hoop::default_parameters()), rest, bias);
  EXPECT_NEAR(bias.theta, m * g * R * std::cos(rest.q.theta), 10 * tolerance);
  for (const double other : {bias.x, bias.y, bias.psi, bias.phi}) EXPECT_EQ(other, 0.0);
}

// With six coordinates gravity gives Q_z = -m g and Q_theta = 0, the contact Q_z = N and Q_theta = -N R cos(theta).
TEST(RollingHoop, SharesTheWeightCorrectlyAmongSixCoordinates) {
  HoopWithForces::State rest{};
  rest.q = {0.3, -0.2, R * std::sin(1.1), 0.7, 1.1, 2.0};
  const auto precomputed = HoopWithForces::precompute(HoopWithForces::default_parameters());
  HoopWithForces::GeneralizedForces bias{}, held{};
  HoopWithForces::bias(precomputed, rest, bias);
  EXPECT_NEAR(bias.z, m * g, 10 * tolerance);
  EXPECT_EQ(bias.theta, 0.0);
  HoopWithForces::Multipliers contact{};
  contact.N = 2.0;
  HoopWithForces::inverse_dynamics(precomputed, rest, {}, contact, held);  // bias - A' lambda
  EXPECT_NEAR(bias.z - held.z, contact.N, 10 * tolerance);
  EXPECT_NEAR(bias.theta - held.theta, -contact.N * R * std::cos(rest.q.theta), tolerance);
}

}  // namespace
}  // namespace torsor::rolling_hoop_test
