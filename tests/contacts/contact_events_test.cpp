// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/contacts/told_motion.hpp"

namespace contact_events_test {
namespace {

using namespace told_motion;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// References: closed forms in 50 digits. Times of the integration carry its tolerance, 1e-13 a step.

TEST(BouncingBall, ComesToRestWhereItsImpactsAccumulateAndStaysThere) {
  struct Case {
    double e, end;
  };
  for (const Case& exact : {Case{0.5, 1.354570922957192713352433}, Case{0.8, 4.0637127688715781400573}}) {
    std::array<double, 2> y{1, 0};
    const Motion motion = move(ball(exact.e), y, exact.end + 1);
    const auto ends = motion.all(ContactEventKind::accumulation);
    ASSERT_EQ(ends.size(), 1U);
    // Each impact is dealt with at a rounded time, which the later ones feel (docs/events.md).
    const auto n = static_cast<double>(motion.result.impacts);
    EXPECT_NEAR(ends[0].time, exact.end, n * epsilon * exact.end * (1 + exact.e) / (1 - exact.e));
    EXPECT_EQ(y[0], 0.0);
    EXPECT_EQ(y[1], 0.0);
  }
}

TEST(BouncingBall, WithDragAccumulatesEarlier) {
  std::array<double, 2> y{1, 0};
  const Motion motion = move(ball(0.8, 0.1), y, 4);
  const auto impacts = motion.all(ContactEventKind::impact);
  ASSERT_GT(impacts.size(), 20U);
  EXPECT_NEAR(impacts[0].time, 0.4590853109923368917627545793, 1e-13);
  EXPECT_NEAR(impacts[0].state[1], 3.373545375232410740912704379, 1e-12);
  EXPECT_NEAR(impacts[1].time, 1.128094684638110524350218712, 1e-12);
  EXPECT_NEAR(impacts[9].time, 3.186537824528873767418592347, 2e-12);
  EXPECT_NEAR(motion.all(ContactEventKind::accumulation).at(0).time, 3.588227348104632062187405506, 3e-12);
  EXPECT_EQ(y[0], 0.0);
}

TEST(BallOnShakenTable, LiftsOffBouncesAndRestsAgain) {
  constexpr double A = 0.04, w = 20;
  std::array<double, 2> y{0, A * w};
  const Motion motion = move(ball_on_table(0.3, A, w), y, 0.8);
  const auto lifts = motion.all(ContactEventKind::opens);
  const auto impacts = motion.all(ContactEventKind::impact);
  const auto rests = motion.all(ContactEventKind::accumulation);
  ASSERT_EQ(lifts.size(), 3U);
  ASSERT_EQ(rests.size(), 2U);
  constexpr double lift = 0.03300051570501920010183122455;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(lifts[k].time, lift + static_cast<double>(k) * std::numbers::pi / 10, 1e-13);
  }
  EXPECT_NEAR(impacts[0].time, 0.2286739579632882016356392919, 1e-12);
  EXPECT_NEAR(impacts[1].time, 0.2561903614410956058568327638, 1e-12);
  EXPECT_NEAR(impacts[2].time, 0.264855282167928282728563843, 1e-12);
  // The impacts are located to 1e-13 s, which their extrapolation enlarges some times.
  EXPECT_NEAR(rests[0].time, 0.2686838337689845734461093288, 1e-12);
  EXPECT_NEAR(rests[1].time, 0.5828430991279638974, 1e-12);
}

TEST(SphereOnSlope, ChoosesRollingOrSlidingAfterItsBounces) {
  struct Case {
    double slope, f, speed, spin, end, x, vx, w;
    ContactRegime then;
  };
  const Case cases[] = {{0.3, 0.2, 0, 0, 1.306613992284163238097264902, 1.911256113659457832682412021,
                         2.705673936592228639673357219, 54.11347873184457279346714438, ContactRegime::sticks},
                        {0.3, 0.05, 0, 0, 1.306613992284163238097264902, 2.099689996875986864282429438,
                         3.175673931441843874778644569, 30.61347898936381103820277691, ContactRegime::slides},
                        {0.7, 0.2, 0, 0, 1.460291543501561009206403984, 5.476345574736281772343821444,
                         7.254714883884514811443588196, 98.69999264139146374613334467, ContactRegime::slides},
                        {0, 0.2, 3, -100, 1.277101713628201856851101409, 2.343493084736808495156899527, 5.0 / 7,
                         100.0 / 7, ContactRegime::sticks},
                        {0, 0.05, 3, -100, 1.277101713628201856851101409, 3.456305140884605570553304228,
                         2.373581609465989366214534759, -68.67908047326834946072673793, ContactRegime::slides}};
  for (const Case& c : cases) {
    std::array<double, 6> y{0, 0.55, 0, c.speed, 0, c.spin};
    const Motion motion = move(sphere_on_slope(c.slope, c.f, 0.6, 0.05), y, c.end);
    const auto rests = motion.all(ContactEventKind::accumulation);
    ASSERT_EQ(rests.size(), 1U) << c.slope << ' ' << c.f;
    // The gap is a difference of lengths of 0.05 m: 1e-17 m over the speeds that count, above 1e-3 m/s, ten times.
    EXPECT_NEAR(rests[0].time, c.end, 1e-13);
    EXPECT_EQ(rests[0].regime, c.then);
    EXPECT_NEAR(y[0], c.x, 2e-12);
    EXPECT_NEAR(y[1], 0.05, 1e-16);
    EXPECT_NEAR(y[3], c.vx, 2e-12);
    EXPECT_NEAR(y[5], c.w, 4e-11);  // 50 times a velocity
  }
  // The last one rolls in the end.
  std::array<double, 6> y{0, 0.55, 0, 3, 0, -100};
  const Motion motion = move(sphere_on_slope(0, 0.05, 0.6, 0.05), y, 5);
  const auto rolls = motion.all(ContactEventKind::slip_ends);
  ASSERT_EQ(rolls.size(), 1U);
  EXPECT_NEAR(rolls[0].time, 4.659967962720256298237949614, 1e-12);
  EXPECT_NEAR(rolls[0].state[0], 8.679226216480475981442906426, 4e-12);
  EXPECT_NEAR(y[3], 5.0 / 7, 1e-13);
}

TEST(BilliardBall, SlidesOnAParabolaAndThenRolls) {
  constexpr double R = 0.028575;
  {
    std::array<double, 9> y{0, 0, R, 2, 0, 0, 0, 52.4934383202099737532808399, -69.99125109361329833770778653};
    const Motion motion = move(billiard_ball(0.17, R, 0.2, 0), y, 0.1);
    const auto rolls = motion.all(ContactEventKind::slip_ends);
    ASSERT_EQ(rolls.size(), 1U);
    EXPECT_EQ(rolls[0].regime, ContactRegime::sticks);
    EXPECT_NEAR(rolls[0].time, 0.07281199941750400465996796272, 1e-13);
    EXPECT_NEAR(rolls[0].state[0], 0.1404231417337577232727953567, 1e-13);
    EXPECT_NEAR(y[3], 13.0 / 7, 1e-13);
    EXPECT_NEAR(y[7], 64.99187601549806274215723035, 1e-11);
  }
  // A cue strikes it downwards; the table answers with friction in the impact.
  std::array<double, 9> y{
      0, 0, R, 3, 0, -4, -125.9842519685039370078740157, 41.99475065616797900262467192, -94.48818897637795275590551181};
  const Motion motion = move(billiard_ball(0.17, R, 0.2, 0), y, 0.2);
  EXPECT_EQ(motion.result.impacts, 1);
  const auto rolls = motion.all(ContactEventKind::slip_ends);
  ASSERT_EQ(rolls.size(), 1U);
  EXPECT_NEAR(rolls[0].time, 0.1783780922527481784365278160192, 1e-13);
  EXPECT_NEAR(rolls[0].state[0], 0.4573563812667707285749781835, 1e-13);
  EXPECT_NEAR(rolls[0].state[1], 0.155555790982947362016939748, 1e-13);
  EXPECT_NEAR(y[3], 17.4 / 7, 1e-13);
  EXPECT_NEAR(y[4], 7.2 / 7, 1e-13);
  EXPECT_NEAR(y[6], -35.9955005624296962879640045, 1e-11);
  EXPECT_NEAR(y[8], -94.48818897637795275590551181, 1e-12);
}

TEST(BilliardBall, WithBackspinStopsDead) {
  constexpr double R = 0.05;
  for (const double f : {0.1, 0.4}) {
    std::array<double, 9> y{0, 0, R, 2, 0, 0, 0, -2.5 * 2 / R, 0};
    (void)move(billiard_ball(1, R, f, 0), y, 8);
    for (std::size_t i = 3; i < 9; ++i) EXPECT_NEAR(y[i], 0, i < 6 ? 1e-12 : 2e-11);
  }
}

// Coulomb's disc, no pyramid: the path is straight.
TEST(BlockOnPlane, StopsOnTheStraightLineOfItsVelocity) {
  const double angle = std::numbers::pi / 8;
  std::array<double, 6> y{0, 0, 0, 2 * std::cos(angle), 2 * std::sin(angle), 0};
  const Motion motion = move(block_on_plane(0.3), y, 1);
  const auto stops = motion.all(ContactEventKind::slip_ends);
  ASSERT_EQ(stops.size(), 1U);
  EXPECT_NEAR(stops[0].time, 0.6795786612300373768263677, 1e-14);
  EXPECT_NEAR(y[0], 0.6278488158418530452790915, 1e-14);
  EXPECT_NEAR(y[1], 0.2600634946415832631521984, 1e-14);
  EXPECT_NEAR(y[3], 0, 1e-15);
}

TEST(StopOfACoordinate, IsStruckAndRestedOn) {
  {
    std::array<double, 2> y{-1.2, 0};
    const Motion motion = move(pendulum_with_stop(0.5, -1, 0.7), y, 6);
    const auto impacts = motion.all(ContactEventKind::impact);
    ASSERT_EQ(impacts.size(), 4U);
    const double times[] = {0.6971413385770064766051931169, 2.145588146822795423597068745,
                            3.687384473922172617730741587, 5.33344195389605189450535675};
    const double speeds[] = {3.179419871840895614951865849, 2.225593910288626930466306094,
                             1.557915737202038851326414266, 1.090541016041427195928489986};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(impacts[i].time, times[i], 2e-13 * (1 + 20.0 * static_cast<double>(i)));
      EXPECT_NEAR(impacts[i].state[1], -0.7 * speeds[i], 1e-12);
    }
  }
  std::array<double, 2> y{1.3, 0};
  const Motion motion = move(pendulum_with_stop(0.5, 1, 0.5), y, 2);
  EXPECT_NEAR(motion.all(ContactEventKind::impact).at(0).time, 0.4243615164439495662266328136, 1e-12);
  // The gap is a difference of angles of 0.5, known to 1e-16; over the speeds that count, above 1e-3 rad/s, 1e-13 s.
  EXPECT_NEAR(motion.all(ContactEventKind::accumulation).at(0).time, 1.693707666148115357169, 1e-12);
  EXPECT_NEAR(y[0], 0.5, 1e-15);
  EXPECT_EQ(y[1], 0.0);
}

TEST(CeilingThatIsTouched, ChangesNothing) {
  const auto ceiling = [] {
    ByHand<1, 1, 1> system = ball(0.5);
    system.fill = [](double, const auto& y, auto& r) {
      r.M(0, 0) = 1;
      r.F(0) = -g;
      r.gap[0] = 1 - y[0];
      r.J(0, 0) = -1;
      r.w(0) = -y[1];
      r.drift(0) = 0;
    };
    return system;
  }();
  for (const double more : {0.0, 1e-12, -1e-12}) {
    std::array<double, 2> y{0, std::sqrt(2 * g * (1 + more))};
    const double end = 2 * y[1] / g;
    const double start = y[1];
    const Motion motion = move(ceiling, y, end);
    EXPECT_EQ(motion.result.impacts, more > 0 ? 1 : 0) << more;
    // With the impact the ball comes back earlier by less than 1e-6 s.
    EXPECT_NEAR(y[1], -start, more > 0 ? 1e-4 : 1e-12);
  }
}

TEST(DryFrictionInAJoint, StopsAPendulumOnTheOtherSideOfEachSwingUntilItSticks) {
  std::array<double, 2> y{1.2, 0};
  const Motion motion = move(pendulum_with_friction(0.8), y, 8);
  const auto stops = motion.all(ContactEventKind::slip_ends);
  const double angles[] = {-0.9984129319914847396366295931, 0.8104792491785228282263478722,
                           -0.6320936863686394136562183744, 0.4603816394130270607147866895,
                           -0.2931642675851050298344113048, 0.1286644327636413372928815843,
                           0.03467601445216764910840615463};
  const double times[] = {1.0875709299092279561, 2.1469441724169098462, 3.185761569627182085, 4.2097626420632228934,
                          5.2235619628431204317, 6.2311020356208227858, 7.2359502073581145387};
  ASSERT_EQ(stops.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(stops[i].state[0], angles[i], 1e-12);
    // Where a swing turns, the time is known as well as the velocity over the acceleration, some 1e-14 a swing.
    EXPECT_NEAR(stops[i].time, times[i], 4e-12);
    EXPECT_EQ(stops[i].regime, i == 6 ? ContactRegime::sticks : ContactRegime::slides);
  }
  EXPECT_EQ(y[1], 0.0);
}

TEST(BlockOnABelt, SticksAndSlipsInTheCycleOfItsTwoCoefficients) {
  struct Case {
    double m, k, speed, N, f_static, f, sticks_until, stick, slip;
  };
  for (const Case& c : {Case{2, 50, 0.2, 19.62, 0.5, 0.35, 0.1962, 0.5886, 0.8670739255408371736850496412},
                        Case{1, 400, 0.05, 30, 0.25, 0.24, 0.01875, 0.03, 0.2850135859111926146467038762}}) {
    std::array<double, 2> y{0, 0};
    const Motion motion = move(block_on_belt(c.m, c.k, c.speed, c.N, c.f_static, c.f), y, 5);
    const auto slips = motion.all(ContactEventKind::slips), sticks = motion.all(ContactEventKind::slip_ends);
    ASSERT_GE(slips.size(), 3U);
    ASSERT_GE(sticks.size(), slips.size());
    for (std::size_t i = 0; i < slips.size(); ++i) {
      EXPECT_NEAR(slips[i].state[0], c.sticks_until, 1e-13);
      if (i > 0) {
        EXPECT_NEAR(slips[i].time - sticks[i].time, c.stick, 2e-12);
      }
      if (i + 1 < sticks.size()) {
        EXPECT_NEAR(sticks[i + 1].time - slips[i].time, c.slip, 2e-12);
      }
    }
  }
}

TEST(BlockOnABelt, IsCarriedAlongOrLeftBehindByItsState) {
  {
    std::array<double, 2> y{0, -2};
    const Motion motion = move(block_on_belt(1, 0, 1.5, g, 0.4, 0.3), y, 5);
    EXPECT_NEAR(motion.all(ContactEventKind::slip_ends).at(0).time, 1.189262657152565409446143391, 1e-13);
    EXPECT_NEAR(y[0], 5.418790349983010533469249066, 1e-12);
  }
  const double slope = 0.35, N = g * std::cos(slope), down = -g * std::sin(slope);
  {
    std::array<double, 2> y{0, 0};
    const Motion motion = move(block_on_belt(1, 0, 0.8, N, 0.45, 0.4, down), y, 5);
    EXPECT_NEAR(motion.all(ContactEventKind::slip_ends).at(0).time, 2.482382576814150961646590396, 1e-12);
    EXPECT_NEAR(y[0], 3.007046969274339615341363842, 1e-12);
  }
  // f = 0.3 < tan 0.35 < f_s: laid on at rest it slides down for ever, laid on with the belt it sticks for ever.
  std::array<double, 2> still{0, 0}, moving{0, 0.8};
  EXPECT_EQ(move(block_on_belt(1, 0, 0.8, N, 0.45, 0.3, down), still, 2).result.events, 0);
  EXPECT_NEAR(still[1], -2 * 0.5992535972281415738872182093, 1e-12);
  const Motion stays = move(block_on_belt(1, 0, 0.8, N, 0.45, 0.3, down), moving, 2);
  EXPECT_EQ(stays.result.events, 0);
  EXPECT_GT(stays.result.ambiguous, 0);  // it could have begun to slide: rest persists
  EXPECT_NEAR(moving[0], 1.6, 1e-13);
}

/// Equal balls on threads of 1 m, side by side at rest: q = angles. Newton's cradle.
ByHand<3, 3, 2> cradle() {
  constexpr double apart = 0.1;
  return {{ContactRule{.tangents = 0, .restitution = 1}, ContactRule{.tangents = 0, .restitution = 1}},
          [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.J.setZero();
            for (int i = 0; i < 3; ++i) r.F(i) = -g * std::sin(y[static_cast<std::size_t>(i)]);
            for (int c = 0; c < 2; ++c) {
              const auto k = static_cast<std::size_t>(c);
              const Eigen::Vector2d a(std::cos(y[k]), std::sin(y[k])), b(std::cos(y[k + 1]), std::sin(y[k + 1]));
              const Eigen::Vector2d line(apart + b.y() - a.y(), a.x() - b.x()), n = line.normalized();
              const Eigen::Vector2d u = y[4 + k] * b - y[3 + k] * a;
              const auto turned = [](const Eigen::Vector2d& e) { return Eigen::Vector2d(-e.y(), e.x()); };
              r.gap[k] = line.norm() - apart;
              r.J(c, c) = -n.dot(a);
              r.J(c, c + 1) = n.dot(b);
              r.w(c) = n.dot(u);
              r.drift(c) = n.dot(y[4 + k] * y[4 + k] * turned(b) - y[3 + k] * y[3 + k] * turned(a)) +
                           (u.squaredNorm() - r.w(c) * r.w(c)) / line.norm();
            }
          }};
}

// The two that hang at rest touch without a force, and swing together without one: they must neither part nor strike
// for ever. Also where they begin a little within each other.
TEST(NewtonsCradle, SwingsWithTwoBallsThatTouchWithoutAForce) {
  const double bottom = std::sqrt(2 * g * (1 - std::cos(0.3)));
  for (const double within : {0.0, 1e-12}) {
    std::array<double, 6> y{-0.3, within, 0, 0, 0, 0};
    const Motion motion = move(cradle(), y, 3);
    const auto impacts = motion.all(ContactEventKind::impact);
    ASSERT_EQ(motion.events.size(), impacts.size());  // none opens
    ASSERT_EQ(impacts.size(), 3U);
    // Newton's law for all contacts at once (sheet of multiple impacts): v (-1/3, 2/3, 2/3).
    EXPECT_NEAR(impacts[0].state[3], -bottom / 3, 1e-11);
    EXPECT_NEAR(impacts[0].state[4], 2 * bottom / 3, 1e-11);
    EXPECT_NEAR(impacts[0].state[5], 2 * bottom / 3, 1e-11);
  }
}

// Painlevé: M^-1 = [[1, 0.9], [0.9, 1]], f = 1.5, pressed by 1.
ByHand<3, 3, 1> pressed_down_by_its_slip() {
  ByHand<3, 3, 1> system = sphere_on_slope(0, 1.5, 0, 1);
  system.fill = [](double, const auto& y, auto& r) {
    r.M.setIdentity();
    r.M(0, 0) = r.M(1, 1) = 1 / (1 - 0.81);
    r.M(0, 1) = r.M(1, 0) = -0.9 / (1 - 0.81);
    r.F << 0, 0, 0;
    r.F -= r.M.col(0);
    r.gap[0] = y[0];
    r.J << 1, 0, 0, 0, 1, 0;
    r.w << y[3], y[4];
    r.drift.setZero();
  };
  return system;
}

// Painlevé's rod of half-length 1 and mass 1 slides on its foot with f = 2, leans after it and turns upwards: N grows as
// the rod comes to 1 + 3 cos² θ = 3 f sin θ cos θ, tan θ = 3 - sqrt 5, where its equations are singular.
TEST(ContactStatus, SaysThatARodJamsWhereItsEquationsBecomeSingular) {
  const ByHand<3, 3, 1> rod{{ContactRule{.tangents = 1, .friction = 2}}, [](double, const auto& y, auto& r) {
                              const double c = std::cos(y[2]), s = std::sin(y[2]), turning = y[5];
                              r.M.setIdentity();
                              r.M(2, 2) = 1.0 / 3;
                              r.F << 0, -g, 0;
                              r.gap[0] = y[1] - s;
                              r.J << 0, 1, -c, 1, 0, s;
                              r.w << y[4] - c * turning, y[3] + s * turning;
                              r.drift << s * turning * turning, c * turning * turning;
                            }};
  for (const double turning : {2.0, 3.5}) {
    for (const bool impact : {false, true}) {
      const double start = 0.5;
      std::array<double, 6> y{0, std::sin(start), start, -10 - std::sin(start) * turning, std::cos(start) * turning, turning};
      const auto result = integrate_contacts(rod, y, 0, 2, precise, {.impact_without_collision = impact});
      EXPECT_EQ(result.status, ContactStatus::jams);
      EXPECT_EQ(result.contact, 0);
      EXPECT_EQ(result.events, 0);
      EXPECT_LT(result.integration.statistics.accepted, 1000);
      // W_NN - f W_NT d over W_NN is 1e-8 there, and falls with θ at a rate above 1.5.
      const double left = std::atan(3 - std::sqrt(5.0)) - y[2];
      EXPECT_GT(left, 0);
      EXPECT_LT(left, 1e-8);
    }
  }
}

// The slip 1 ends at p = 5/3, where w_N = -7/12; then it sticks, with dw_N/dp = 0.19.
TEST(ContactStatus, IsThatOfAMotionWhereImpactsWithoutCollisionAreAskedFor) {
  const auto system = pressed_down_by_its_slip();
  std::array<double, 6> y{0, 0, 0, 0, 1, 0};
  int impacts = 0;
  const auto result = integrate_contacts(system, y, 0, 1, precise, {.impact_without_collision = true}, [&](const ContactEvent& event) {
    EXPECT_EQ(event.kind, ContactEventKind::impact);
    EXPECT_NEAR(event.impulses(0), 5.0 / 3 + 7 / (12 * 0.19), 1e-14);
    EXPECT_NEAR(event.energy_lost, 0.5 / (1 - 0.81), 1e-14);  // all that there was: M_yy/2
    ++impacts;
  });
  EXPECT_TRUE(result) << describe(result.status);
  EXPECT_EQ(impacts, 1);
  for (const double each : y) EXPECT_NEAR(each, 0, 1e-14);
}

TEST(ContactStatus, SaysWhatIsWrongAndWhere) {
  const auto system = pressed_down_by_its_slip();  // it slips to the positive side
  std::array<double, 6> y{0, 0, 0, 0, 1, 0};
  const Motion none = move(system, y, 1, false);
  EXPECT_EQ(none.result.status, ContactStatus::no_solution);
  EXPECT_EQ(none.result.verdict, ContactVerdict::none);
  EXPECT_EQ(none.result.contact, 0);
  std::array<double, 2> below{-0.1, 0}, above{1, 0};
  EXPECT_EQ(move(ball(0.5), below, 1, false).result.status, ContactStatus::penetrates);
  EXPECT_EQ(move(ball(1.5), above, 1, false).result.status, ContactStatus::invalid_rule);
}

}  // namespace
}  // namespace contact_events_test
