// SPDX-License-Identifier: GPL-3.0-or-later
// Motions in pieces, events at one time, and runs that are refused.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>

#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/told_motion.hpp"

namespace contact_runs_test {
namespace {

using namespace told_motion;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A force of given bound gives no impulse: a block that lands on a sticky floor keeps its speed, then loses b/m each second.
TEST(StickyFloor, GivesNoImpulseAlongItself) {
  const ByHand<2, 2, 1> block{{ContactRule{.tangents = 1, .bound = 3, .restitution = 0.5}}, [](double, const auto& y, auto& r) {
                                r.M.setIdentity();
                                r.F << 0, -g;
                                r.gap[0] = y[1];
                                r.J << 0, 1, 1, 0;
                                r.w << y[3], y[2];
                                r.drift.setZero();
                              }};
  std::array<double, 4> y{0, 1, 4, 0};
  const Motion motion = move(block, y, 2);
  EXPECT_EQ(motion.all(ContactEventKind::impact).at(0).state[2], 4);
  const double rests = std::sqrt(2 / g) * 3;  // the bounces end: (1 + e)/(1 - e)
  EXPECT_NEAR(y[2], 4 - 3 * (2 - rests), 1e-11);
}

/// Two blocks of 1 kg that slide apart from each other, each held back by 5 N.
ByHand<2, 2, 2> two_blocks() {
  const ContactRule rule{.tangents = 1, .normal = false, .bound = 5};
  return {{rule, rule}, [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F.setZero();
            r.J.setIdentity();
            r.w << y[2], y[3];
            r.drift.setZero();
          }};
}

// A table of A w² = (1 + ε) g falls faster than a ball for 2 sqrt(2 ε)/w at the top of each swing, and the ball is off by some
// ε² g/w²: with ε = 1e-9 that is 1e-19 m, and no flight is seen. It rests on, or strikes again in the same instant.
TEST(BallOnShakenTable, RestsWhereItsFlightsDoNotLeaveRounding) {
  constexpr double w = 10;
  for (const double more : {1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6}) {
    SCOPED_TRACE(testing::Message() << "A w^2 = (1 + " << more << ") g");
    const double A = g / (w * w) * (1 + more);
    std::array<double, 2> y{0, A * w};
    const Motion motion = move(ball_on_table(0, A, w), y, 3);
    EXPECT_NEAR(y[0], A * std::sin(3 * w), 1e-16);
    EXPECT_NEAR(y[1], A * w * std::cos(3 * w), 1e-15);
    EXPECT_LE(motion.result.events, 10);  // five tops: it opens and strikes
  }
}

// The lowest point of a disc that lies flat: its row is 0/0. Before, no laws were fulfilled (Painlevé), or the start was below.
TEST(ContactWithoutPoint, IsNamed) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  ByHand<1, 1, 1> flat = ball(0.5);
  const auto usual = flat.fill;
  flat.fill = [usual, none](double t, const auto& state, auto& r) {
    usual(t, state, r);
    r.J(0, 0) = r.drift(0) = none;
  };
  std::array<double, 2> y{1, 0};
  auto result = integrate_contacts(flat, y, 0.0, 1.0, precise);
  EXPECT_EQ(result.status, ContactStatus::no_point);
  EXPECT_EQ(result.contact, 0);
  EXPECT_NEAR(result.time, std::sqrt(2 / g), 1e-12);
  y = {1, 0};
  EXPECT_EQ(step_contacts(flat, y, 0, 1, {.count = 100}), ContactStatus::no_point);
  EXPECT_LT(y[0], 0.1);  // until then its rows have no part

  flat.fill = [usual, none](double t, const auto& state, auto& r) {
    usual(t, state, r);
    r.gap[0] = none;
  };
  y = {0, 0};
  EXPECT_EQ(integrate_contacts(flat, y, 0.0, 1.0, precise).status, ContactStatus::no_point);
}

// A ball that bounces without loss ends with the limit of events, not with the time.
TEST(EventLimit, EndsAMotion) {
  std::array<double, 2> y{1, 0};
  const auto result = integrate_contacts(ball(1), y, 0.0, 100.0, DormandPrince853{}, {.event_limit = 5});
  EXPECT_EQ(result.status, ContactStatus::too_many_events);
  EXPECT_EQ(result.events, 6);
  EXPECT_NEAR(result.time, std::sqrt(2 / g) * 11, 1e-6);
}

// Bounces of a nanometre, without loss: a motion of a day would take 3e9 of them, one of 4 ms takes 140.
TEST(EventLimit, EndsAMotionWhoseEventsLeadNowhere) {
  const DormandPrince853 method{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-13};
  const ContactOptions options{.event_limit = 20'000};
  std::array<double, 2> y{1e-9, 0};
  const auto day = integrate_contacts(ball(1), y, 0.0, 86400.0, method, options);
  EXPECT_EQ(day.status, ContactStatus::too_many_events);
  EXPECT_LT(day.events, 300);
  y = {1e-9, 0};
  EXPECT_EQ(integrate_contacts(ball(1), y, 0.0, 4e-3, method, options).status, ContactStatus::reached_end);
  // Bounces that accumulate become as dense, and end.
  y = {0.01, 0};
  EXPECT_EQ(integrate_contacts(ball(0.95), y, 0.0, 100.0, method, options).status, ContactStatus::reached_end);
}

// Slips that end at one time are two events: no block is driven by its own friction.
TEST(TwoSlips, ThatEndAtOneTimeBothEnd) {
  for (const double second : {2.0, -2.0, 2 * (1 + epsilon), 2 * (1 - epsilon)}) {
    std::array<double, 4> y{0, 0, 2, second};
    const Motion motion = move(two_blocks(), y, 1);
    EXPECT_EQ(motion.all(ContactEventKind::slip_ends).size(), 2U);
    EXPECT_EQ(y[2], 0);
    EXPECT_EQ(y[3], 0);
  }
}

// A motion in pieces is the same wherever a piece ends: at an event, a rounding before it or after.
TEST(MotionInPieces, HasTheEventsThatFallOnTheEndOfAPiece) {
  for (const double speed : {0.5, 1.0, 1.5, 2.0, 3.0}) {
    const double stop = speed / 5;
    for (const double first : {stop, std::nextafter(stop, 0), std::nextafter(stop, 1), stop / 2}) {
      const auto blocks = two_blocks();
      const ContactMechanismOf<ByHand<2, 2, 2>> mechanism(blocks);
      std::array<double, 4> y{0, 0, speed, -speed};
      IgnoreSteps none;
      ContactRun<4, 2, DormandPrince853, IgnoreSteps> run(mechanism, y, precise, {}, none);
      ASSERT_TRUE(run.start(0) && run.advance(first) && run.advance(1));
      EXPECT_EQ(run.result().events, 2) << speed << ' ' << first;
      EXPECT_EQ(y[2], 0);
      EXPECT_EQ(y[3], 0);
      EXPECT_NEAR(y[0], speed * speed / 10, 1e-14);
    }
  }
}

// The same of a contact that opens: the table below a ball falls away faster than g from 0.5 s on.
TEST(MotionInPieces, OpensContactsAtTheEndOfAPiece) {
  const auto drop = ball_on_table(0, 0.04, 20);
  constexpr double lift = 0.03300051570501920010183122455;
  for (const double first : {lift, std::nextafter(lift, 0), std::nextafter(lift, 1), 0.02}) {
    const ContactMechanismOf<ByHand<1, 1, 1>> mechanism(drop);
    std::array<double, 2> y{0, 0.8};
    IgnoreSteps none;
    ContactRun<2, 1, DormandPrince853, IgnoreSteps> run(mechanism, y, precise, {}, none);
    ASSERT_TRUE(run.start(0) && run.advance(first) && run.advance(0.1));
    const double t = 0.1 - lift, z = 0.04 * std::sin(20 * lift), v = 0.8 * std::cos(20 * lift);
    EXPECT_NEAR(y[0], z + v * t - g * t * t / 2, 1e-12);
  }
}

// A run that is started again knows nothing of the motion before.
TEST(MotionInPieces, MayBeStartedAgain) {
  const auto falling = ball(0.5);
  const ContactMechanismOf<ByHand<1, 1, 1>> mechanism(falling);
  std::array<double, 2> y{1, 0};
  IgnoreSteps none;
  ContactRun<2, 1, DormandPrince853, IgnoreSteps> run(mechanism, y, precise, {}, none);
  ASSERT_TRUE(run.start(0) && run.advance(2));
  EXPECT_EQ(y[0], 0.0);
  y = {1, 0};
  ASSERT_TRUE(run.start(0) && run.advance(0.4));
  EXPECT_NEAR(y[0], 1 - g * 0.08, 1e-13);
}

// The observer is told of an impact with which a motion begins.
TEST(Impacts, AtTheStartAreTold) {
  std::array<double, 2> y{0, -3};
  const Motion motion = move(ball(0.5), y, 0.1);
  ASSERT_EQ(motion.events.size(), 1U);
  EXPECT_EQ(motion.events[0].kind, ContactEventKind::impact);
  EXPECT_EQ(motion.events[0].state[1], 1.5);
}

/// Two balls over one floor, which know nothing of each other.
ByHand<2, 2, 2> two_balls(double e, double other) {
  return {{ContactRule{.tangents = 0, .restitution = e}, ContactRule{.tangents = 0, .restitution = other}},
          [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << -g, -g;
            r.gap = {y[0], y[1]};
            r.J.setIdentity();
            r.w << y[2], y[3];
            r.drift.setZero();
          }};
}

// What bounces to rest takes nothing from another ball that is near its floor then: each has its own end, sqrt(h) later.
TEST(Accumulations, LeaveOtherContactsTheirOwnEnd) {
  constexpr double end = 1.354570922957192713352433;  // of e = 0.5 from 1 m
  for (const double higher : {1e-5, 1e-4}) {
    std::array<double, 4> y{1, 1 + higher, 0, 0};
    const Motion motion = move(two_balls(0.5, 0.5), y, 1.5);
    const auto ends = motion.all(ContactEventKind::accumulation);
    ASSERT_EQ(ends.size(), 2U);
    // Below 1e-10 m one ball strikes with the other: a bounce of that height lasts so long.
    const double last = std::sqrt(8e-10 / g);
    EXPECT_NEAR(ends[0].time, end, last);
    EXPECT_NEAR(ends[1].time, end * std::sqrt(1 + higher), last);
  }
}

// Thirty-two balls on a floor, the most there may be, land at one time.
TEST(ManyBalls, LandTogether) {
  ByHand<32, 32, 32> balls{{}, [](double, const auto& y, auto& r) {
                             r.M.setIdentity();
                             r.F.setConstant(-g);
                             r.J.setIdentity();
                             r.drift.setZero();
                             for (std::size_t i = 0; i < 32; ++i) {
                               r.gap[i] = y[i];
                               r.w(static_cast<Eigen::Index>(i)) = y[32 + i];
                             }
                           }};
  balls.rules.fill({.tangents = 0, .restitution = 0});
  std::array<double, 64> y{};
  for (std::size_t i = 0; i < 32; ++i) y[i] = 1;
  const ContactResult result = integrate_contacts(balls, y, 0, 1, precise);
  EXPECT_TRUE(result) << describe(result.status);
  for (const double each : y) EXPECT_NEAR(each, 0, 1e-15);
}

TEST(ContactStatus, RefusesNumbersOfTangentsThatCannotBe) {
  for (const int tangents : {200, -1, 3}) {
    auto system = ball(0.5);
    system.rules[0].tangents = tangents;
    std::array<double, 2> y{1, 0};
    EXPECT_EQ(integrate_contacts(system, y, 0, 1, precise).status, ContactStatus::invalid_rule);
    MoreauJean scheme(system);
    EXPECT_FALSE(scheme.step(0, 1e-3, y));
  }
}

/// A mechanism of that many balls, each with a floor of its own, that is never moved.
class OnlyCounted final : public ContactMechanism {
 public:
  explicit OnlyCounted(int count) : ContactMechanism({count, count, count, 0}) {}
  [[nodiscard]] ContactRule rule(int) const override { return {.tangents = 0}; }
  [[nodiscard]] Evaluation read(double, std::span<const double>, ContactReading&) const override { return Evaluation::singular; }
  void coordinate_rates(double, std::span<const double>, std::span<double>) const override {}
};

TEST(ContactStatus, SaysThatThereIsNoRoomOrNoStart) {
  EXPECT_THROW(OnlyCounted(33), std::length_error);
  const OnlyCounted three(3);
  std::array<double, 6> y{};
  IgnoreSteps none;
  ContactRun<6, 2, DormandPrince853, IgnoreSteps> narrow(three, y, precise, {}, none);
  EXPECT_FALSE(narrow.start(0));
  EXPECT_EQ(narrow.result().status, ContactStatus::no_room);
  std::array<double, 5> shorter{};
  ContactRun<5, 3, DormandPrince853, IgnoreSteps> low(three, shorter, precise, {}, none);
  EXPECT_FALSE(low.start(0));
  EXPECT_EQ(low.result().status, ContactStatus::no_room);
  ContactRun<6, 3, DormandPrince853, IgnoreSteps> idle(three, y, precise, {}, none);
  EXPECT_FALSE(idle.advance(1));
  EXPECT_EQ(idle.result().status, ContactStatus::not_started);
}

/// A particle whose x is held by x^2 + apart = 0, over a floor.
struct HeldParticle {
  static constexpr std::size_t nq = 2, nv = 2, contacts = 1;
  static constexpr int constraints = 1;
  double apart;
  [[nodiscard]] ContactRule rule(int) const { return {.tangents = 0}; }
  [[nodiscard]] Evaluation read(double, const std::array<double, 4>& y, ContactReading& r) const {
    r.M.setIdentity();
    r.F << 0, -g;
    r.gap[0] = y[1] + 2;
    r.J << 0, 1;
    r.w << y[3];
    r.drift.setZero();
    r.A << 2 * y[0], 0;
    r.value << y[0] * y[0] + apart;
    r.rate << 2 * y[0] * y[2];
    r.gamma << 2 * y[2] * y[2];
    return Evaluation::ok;
  }
  void coordinate_rates(double, const std::array<double, 4>& y, std::array<double, 2>& rates) const { rates = {y[2], y[3]}; }
};

TEST(ContactStatus, SaysThatLoopsCannotBeClosed) {
  std::array<double, 4> y{0.7, 0, 0, 0};
  const ContactResult result = integrate_contacts(HeldParticle{1}, y, 0, 0.1, precise);
  EXPECT_EQ(result.status, ContactStatus::open_loops) << describe(result.status);
  std::array<double, 4> closed{0.7, 0, 0, 0};
  EXPECT_TRUE(integrate_contacts(HeldParticle{-0.25}, closed, 0, 0.1, precise));
  EXPECT_NEAR(closed[0], 0.5, 1e-15);
}

}  // namespace
}  // namespace contact_runs_test
