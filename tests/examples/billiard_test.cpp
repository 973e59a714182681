// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "generated/billiard.hpp"
#include "generated/billiard_soft_cloth.hpp"
#include "generated/billiard_two_balls.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::billiard_test {
namespace {

using namespace torsor::runtime;
using Triple = std::array<double, 3>;
using Ball = MechanismWithContacts<billiard::Mechanism<double>>;
using SoftCloth = MechanismWithContacts<billiard_soft_cloth::Mechanism<double>>;
using TwoBalls = MechanismWithContacts<billiard_two_balls::Mechanism<double>>;

// The sheets give twenty digits. A motion has up to a hundred steps, each within 1e-13 of places and velocities, and its
// events are located to that of its states.
constexpr double allowed = 1e-11;
constexpr double R = 0.028575, g = 9.81;

/// An angular velocity given along the axes that turn with the ball, in those of the ground: q ω q*.
Triple in_ground(const double* q, const double* w) {
  const double a = q[0], b = q[1], c = q[2], d = q[3];
  return {(a * a + b * b - c * c - d * d) * w[0] + 2 * (b * c - a * d) * w[1] + 2 * (b * d + a * c) * w[2],
          2 * (b * c + a * d) * w[0] + (a * a - b * b + c * c - d * d) * w[1] + 2 * (c * d - a * b) * w[2],
          2 * (b * d - a * c) * w[0] + 2 * (c * d + a * b) * w[1] + (a * a - b * b - c * c + d * d) * w[2]};
}

struct Moment {
  ContactEventKind kind;
  int contact;
  double time;
  std::vector<double> y, impulses;
  double energy_lost;
};

template <class S>
struct Motion {
  std::vector<Moment> events;
  ContactResult result;
  typename S::State y;

  Motion(const S& system, const typename S::State& start, double end) : y(start) {
    const auto log = [this](const ContactEvent& e) {
      events.push_back({e.kind,
                        e.contact,
                        e.time,
                        {e.state.begin(), e.state.end()},
                        {e.impulses.data(), e.impulses.data() + e.impulses.size()},
                        e.energy_lost});
    };
    result = integrate_contacts(system, y, 0, end,
                                DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}, {}, log);
    EXPECT_TRUE(result) << describe(result.status);
    EXPECT_LE(result.worst_residual, 1e-13);
  }

  const Moment& the(ContactEventKind kind, int contact = 0) const {
    for (const Moment& each : events) {
      if (each.kind == kind && each.contact == contact) return each;
    }
    ADD_FAILURE() << "no such event of contact " << contact;
    return events.at(0);
  }
};

// y = (x, y, z, quaternion, velocities, turning): the first ball's velocities come first.
Ball::State ball_at(const Triple& V, const Triple& W) { return {0, 0, R, 1, 0, 0, 0, V[0], V[1], V[2], W[0], W[1], W[2]}; }

Triple velocity(const std::vector<double>& y) { return {y[7], y[8], y[9]}; }
Triple turning(const std::vector<double>& y) { return in_ground(&y[3], &y[10]); }

void expect_near(const Triple& found, const Triple& expected, double size) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], allowed * size) << "component " << k;
}

// Exercise 3 of the course: the slip keeps its direction, G goes along a parabola, then straight on.
TEST(Billiard, SlidesAlongAParabolaThenRollsInALine) {
  const double f = 0.2;
  for (const auto& [V, W] : {std::pair(Triple{2, 0, 0}, Triple{0, 0, 0}), std::pair(Triple{3, 0, 0}, Triple{-126, 42, -94})}) {
    const Triple slip{V[0] - R * W[1], V[1] + R * W[0], 0};
    const double size = std::hypot(slip[0], slip[1]), tau = 2 * size / (7 * f * g);
    const Ball ball;
    const Motion<Ball> motion(ball, ball_at(V, W), tau + 0.1);
    const Moment& end = motion.the(ContactEventKind::slip_ends);
    EXPECT_NEAR(end.time, tau, allowed * tau);
    for (std::size_t k = 0; k < 2; ++k) {
      const double way = V[k] * tau - f * g * tau * tau / 2 * slip[k] / size, rolling = V[k] - 2 * slip[k] / 7;
      EXPECT_NEAR(end.y[k], way, allowed);
      EXPECT_NEAR(end.y[7 + k], rolling, allowed * size);
      EXPECT_NEAR(motion.y[k], way + 0.1 * rolling, allowed);
    }
    EXPECT_NEAR(turning(end.y)[2], W[2], allowed * 100);
    EXPECT_NEAR(motion.y[2], R, 1e-16);
  }
}

// Follow, stop and draw: v_final = 5/7 V0 + 2/7 R w0, which does not depend on f.
TEST(Billiard, FollowsStopsOrComesBackByItsSpin) {
  for (const double spin : {1.0, -2.5, -4.0}) {
    for (const double f : {0.2, 0.6}) {
      const double V = 0.5, tau = 2 * V * (1 - spin) / (7 * f * g);
      const Ball ball({.f = f, .e = 0});
      const Motion<Ball> motion(ball, ball_at({V, 0, 0}, {0, spin * V / R, 0}), 1.01 * tau + 0.01);
      EXPECT_NEAR(motion.y[7], V * (5 + 2 * spin) / 7, allowed);
    }
  }
}

// billiard_cue_masse.md, A: the cue's impulse drives the ball into the cloth; whatever friction does in that impact, the
// ball ends with one velocity.
TEST(Billiard, MasseEndsWithOneVelocityWhateverTheImpactDoes) {
  const Triple W{-125.9842519685039370078740157, 41.99475065616797900262467192, -94.48818897637795275590551181};
  const Triple W1{-35.9955005624296962879640045, 86.98912635920509936257967754, -94.48818897637795275590551181};
  const Ball cloth;
  const Motion<Ball> smooth(cloth, ball_at({3, 0, 0}, W), 0.6);
  const Moment& a1 = smooth.the(ContactEventKind::slip_ends);
  EXPECT_NEAR(a1.time, 0.5861252889907705626236366104, allowed);
  expect_near({a1.y[0], a1.y[1], a1.y[2]}, {1.607657935517542114624831846, 0.3014358629095391464921559711, R}, 1);
  expect_near(velocity(a1.y), {17.4 / 7, 7.2 / 7, 0}, 4);
  expect_near(turning(a1.y), W1, 100);

  const Motion<Ball> rough(cloth, ball_at({3, 0, -4}, W), 0.2);
  const Moment& a2 = rough.the(ContactEventKind::slip_ends);
  EXPECT_NEAR(a2.time, 0.1783780922527465281367278160192, allowed);
  expect_near({a2.y[0], a2.y[1], a2.y[2]}, {0.4573563812667707285749781835, 0.155555790982947362016939748, R}, 1);
  expect_near(velocity(a2.y), {17.4 / 7, 7.2 / 7, 0}, 4);
  expect_near(turning(a2.y), W1, 100);
}

// contact_zeno_billiard_grazing.md (1): dropped from 1 m its bounces end at t = sqrt(2 h/g) (1 + e)/(1 - e), and it rests.
// The gap is known to a rounding of the height, 1e-16 m: the end to 1e-10 s (docs/contacts.md).
TEST(Billiard, BouncesToRest) {
  const Ball ball({.f = 0.2, .e = 0.5});
  Ball::State y = ball_at({}, {});
  y[2] += 1;
  const Motion<Ball> motion(ball, y, 1.5);
  EXPECT_NEAR(motion.the(ContactEventKind::accumulation).time, 1.354570922957192713352433, 1e-10);
  EXPECT_NEAR(motion.y[2], R, 1e-16);
  EXPECT_NEAR(motion.y[9], 0, 1e-15);
}

TwoBalls::State two_balls(double z, const Triple& V, const Triple& W) {
  TwoBalls::State y = TwoBalls().initial();
  y[2] = y[9] = z;
  for (std::size_t k = 0; k < 3; ++k) {
    y[14 + k] = V[k];
    y[17 + k] = W[k];
  }
  return y;
}

// The same stroke on a cloth that resists rolling and spinning (B): it slides, rolls on slower and slower, and rests.
TEST(BilliardSoftCloth, BringsTheBallToRest) {
  const SoftCloth cloth;
  const Motion motion(cloth, {0, 0, R, 1, 0, 0, 0, 2, 0, 0, 0, 52.4934383202099737532808399, -69.99125109361329833770778653}, 16);
  const Moment& rolls = motion.the(ContactEventKind::slip_ends, 0);
  EXPECT_NEAR(rolls.time, 0.07766548558051587005524645644, allowed);
  EXPECT_NEAR(rolls.y[0], 0.149413650135933110629547259, allowed);
  EXPECT_NEAR(rolls.y[7], 1.847620317291027862951606452, allowed);
  EXPECT_NEAR(motion.the(ContactEventKind::slip_ends, 2).time, 11.65137614678899082568807339, allowed);
  EXPECT_NEAR(motion.the(ContactEventKind::slip_ends, 1).time, 15.14678899082568807339449541, allowed);
  EXPECT_NEAR(motion.y[0], 14.07042302616531863029883477, 20 * allowed);  // after some hundred steps
  for (std::size_t i = 7; i < 13; ++i) EXPECT_NEAR(motion.y[i], 0, 1e-13);
}

// billiard_cue_masse.md, C1: one ball strikes the other in the air, so that no cloth holds it.
TEST(BilliardTwoBalls, ExchangeTheImpulseOfTheSheetInTheAir) {
  const TwoBalls balls;
  const Motion<TwoBalls> motion(balls, two_balls(1, {2, 0, 0}, {0, 2 / R, 0}), 1e-9);
  const auto& y = motion.y;
  const double fall = g * 1e-9;
  expect_near({y[14], y[15], y[16] + fall}, {0.5274285645604405011761902142, -0.7922895146519832941269928598, 0.08685}, 2);
  expect_near({y[20], y[21], y[22] + fall}, {1.472571435439559498823809786, 0.7922895146519832941269928598, -0.08685}, 2);
  // In 1e-9 s the axes of the ball that spins at 70 rad/s turn by 7e-8 of the components.
  const Triple W1 = in_ground(&y[3], &y[17]), W2 = in_ground(&y[10], &y[23]);
  expect_near(W1, {3.799212598425196850393700787, 63.41082184438508342332201598, 4.386952832818809942923847033}, 70);
  expect_near(W2, {3.799212598425196850393700787, -6.580429249228214914385770549, 4.386952832818809942923847033}, 70);
}

// C2: side spin throws the second ball off the line of centres, and both slide on over the cloth until they roll.
TEST(BilliardTwoBalls, ThrowsTheSecondBallBySideSpin) {
  const TwoBalls balls;
  const Motion<TwoBalls> motion(balls, two_balls(R, {2, 0, 0}, {0, 0, 30}), 0.25);
  const Moment& first = motion.the(ContactEventKind::slip_ends, 0);
  EXPECT_NEAR(first.time, 0.1429272029101368472398554318, allowed);
  const double x0 = -2 * R * std::cos(std::acos(-1.0) / 6), y0 = -R;
  EXPECT_NEAR(first.y[0] - x0, 0.06643708507425427119123218787, allowed);
  EXPECT_NEAR(first.y[1] - y0, -0.1002189762306007748145501952, allowed);
  EXPECT_NEAR(first.y[14], 0.3873596938775510204081632653, allowed);
  EXPECT_NEAR(first.y[15], -0.5843241302218014736799416873, allowed);
  const Moment& second = motion.the(ContactEventKind::slip_ends, 1);
  EXPECT_NEAR(second.time, 0.2434182947115099356406689464, allowed);
  EXPECT_NEAR(second.y[7], 0.3041399818713561360655629607, allowed);
  EXPECT_NEAR(second.y[8], 0.1706822200048526767407133615, allowed);
  EXPECT_NEAR(second.y[20], 1.041211734693877551020408163, allowed);
  EXPECT_NEAR(second.y[21], 0.5843241302218014736799416873, allowed);
}

// One ball upright on the other is an equilibrium, whichever is named first: it lasts, as long as rounding takes to grow.
// Let fall together on the cloth, which gives nothing back, they stop at sqrt(2 h/g) and stand.
TEST(BilliardTwoBalls, StandOnEachOtherWhicheverIsNamedFirst) {
  const TwoBalls balls;
  for (const std::size_t upper : {2U, 9U}) {
    for (const double height : {0.0, 0.5}) {
      SCOPED_TRACE(testing::Message() << "upper " << upper << ", height " << height);
      TwoBalls::State y = two_balls(R + height, {}, {});
      y[0] = y[1] = y[7] = y[8] = 0;
      y[upper] += 2 * R;
      const double fall = std::sqrt(2 * height / g);
      const Motion<TwoBalls> motion(balls, y, fall + 0.5);
      if (height > 0) {
        EXPECT_NEAR(motion.the(ContactEventKind::impact, upper == 2 ? 1 : 0).time, fall, allowed);
      }
      y[2] -= height;
      y[9] -= height;
      for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(motion.y[i], y[i], 1e-13) << i;
    }
  }
}

}  // namespace
}  // namespace torsor::billiard_test
