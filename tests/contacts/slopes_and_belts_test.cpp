// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the references that contact_events_test.cpp has not: round bodies on slopes, balls with drag and on a table, belts,
// and balls of a billiard table (sphere_incline.md, bouncing_drag_table.md, stick_slip_belt.md, billiard_cue_masse.md).
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/contacts/told_motion.hpp"
#include "torsor/runtime/contacts/impact_laws.hpp"

namespace slopes_and_belts_test {
namespace {

using namespace told_motion;

/// A round body of mass 1 that is released on a slope, its moment of inertia R²/k.
ByHand<3, 3, 1> round_body(double slope, double f, double k) {
  constexpr double R = 0.05;
  ByHand<3, 3, 1> body = sphere_on_slope(slope, f, 0, R);
  body.fill = [fill = body.fill, k](double t, const auto& y, auto& r) {
    fill(t, y, r);
    r.M(2, 2) = R * R / k;
  };
  return body;
}

/// What the first contact does from the start on, at this time.
template <class S>
ContactRegime regime_at_start(const S& system, typename S::State y) {
  const ContactMechanismOf<S> mechanism(system);
  ContactOptions options;
  ContactAutomaton automaton(mechanism, options);
  EXPECT_TRUE(automaton.start(0, y));
  return automaton.motion().states[0].regime;
}

TEST(RoundBodies, RollUpToTheCriticalSlope) {
  struct Case {
    double k, f, slope;
  };
  for (const Case& c : {Case{2.5, 0.1, 0.3366748193867271813966986313}, Case{2.5, 0.3, 0.809783572570166846624145858},
                        Case{1.5, 0.1, 0.2449786631268641541720824812}, Case{1.5, 0.3, 0.6435011087932843868028092287},
                        Case{2, 0.1, 0.2914567944778670919956046214}, Case{2, 0.3, 0.7328151017865065916407920727},
                        Case{1, 0.1, 0.1973955598498807583700497652}, Case{1, 0.3, 0.5404195002705841554435783646}}) {
    const std::array<double, 6> y{0, 0.05, 0, 0, 0, 0};
    EXPECT_EQ(regime_at_start(round_body(c.slope * (1 - 1e-11), c.f, c.k), y), ContactRegime::sticks) << c.k << ' ' << c.f;
    EXPECT_EQ(regime_at_start(round_body(c.slope * (1 + 1e-11), c.f, c.k), y), ContactRegime::slides) << c.k << ' ' << c.f;
  }
}

TEST(RoundBodies, OnASlopeRollOrSlide) {
  std::array<double, 6> rolls{0, 0.05, 0, 0, 0, 0}, slides = rolls;
  (void)move(round_body(0.5, 0.2, 2.5), rolls, 1);
  EXPECT_NEAR(rolls[3], 3.359403238362308166200681889, 1e-12);
  EXPECT_NEAR(rolls[3], 0.05 * rolls[5], 1e-13);
  EXPECT_NEAR(rolls[5] * 0.4 * 0.05 / (g * std::cos(0.5)), 0.1560864256696544323586227045, 1e-13);  // friction over N
  (void)move(round_body(0.7, 0.2, 2.5), slides, 1);
  EXPECT_NEAR(slides[3], 4.819155140349582944214349486, 1e-12);
  EXPECT_NEAR(slides[5], 75.03101857260831461569986504, 1e-11);
  EXPECT_NEAR(slides[3] - 0.05 * slides[5], 1.067604211719167213429356235, 1e-12);
}

TEST(RoundBodies, AfterTheirBouncesGoOnAsTheyMust) {
  struct Case {
    double slope, f, speed, spin, end, slip, slip_later;
  };
  for (const Case& c : {Case{0.3, 0.05, 0, 0, 1.306613992284163238097264902, 1.644999981973653322868505723,
                             1.644999981973653322868505723 + 1.258979309641357097562260432},
                        Case{0.7, 0.2, 0, 0, 1.460291543501561009206403984, 2.319715251814941624136920962,
                             2.319715251814941624136920962 + 1.067604211719167213429356235},
                        Case{0, 0.05, 3, -100, 1.277101713628201856851101409, 5.807535633128784462250871655,
                             5.807535633128784462250871655 - 3.5 * 0.05 * g}}) {
    for (const bool later : {false, true}) {
      std::array<double, 6> y{0, 0.55, 0, c.speed, 0, c.spin};
      (void)move(sphere_on_slope(c.slope, c.f, 0.6, 0.05), y, c.end + (later ? 1 : 0));
      EXPECT_NEAR(y[3] - 0.05 * y[5], later ? c.slip_later : c.slip, 4e-12) << c.slope << ' ' << c.f;
    }
  }
  std::array<double, 6> y{0, 0.55, 0, 0, 0, 0};
  const Motion motion = move(sphere_on_slope(0.3, 0.2, 0.6, 0.05), y, 2.306613992284163238097264902);
  EXPECT_NEAR(y[0], 5.652306202875879769421196567, 4e-12);
  EXPECT_NEAR(y[3], 4.776426241840615233804211873, 4e-12);
  struct First {
    std::size_t number;
    double time, x, vx, w;
  };
  const auto impacts = motion.all(ContactEventKind::impact);
  for (const First& first : {First{0, 0.3266534980710408095243, 0.1546681248048116165177, 0.6764184841480571599183,
      13.52836968296114319837},
                             First{1, 0.7186376957562897809535, 0.6425355813319888297619, 1.48812066512572575182,
                                 29.76241330251451503641}}) {
    ASSERT_LT(first.number, impacts.size());
    const Told& told = impacts[first.number];
    EXPECT_NEAR(told.time, first.time, 1e-13);
    EXPECT_NEAR(told.state[0], first.x, 1e-12);
    EXPECT_NEAR(told.state[3], first.vx, 1e-12);
    EXPECT_NEAR(told.state[5], first.w, 2e-11);
  }
  EXPECT_NEAR(impacts[0].state[4], 1.836808739361828662292, 1e-12);
  ASSERT_LT(7U, impacts.size());
  EXPECT_NEAR(impacts[7].time, 1.279181370193358774081, 1e-13);
  EXPECT_NEAR(impacts[7].state[0], 1.837733636986928709017, 1e-12);
}

TEST(BouncingBalls, WithDragComeToRest) {
  struct Case {
    double c, e, first, second, tenth, end, speed;
  };
  for (const Case& c : {Case{0.1, 0.8, 0.4590853109923368917627545793, 1.128094684638110524350218712,
      3.186537824528873767418592347,
                             3.588227348104632062187405506, 3.373545375232410740912704379},
                        Case{1, 0.8, 0.5291844809148977286990096282, 0.9531324294627165051190800885,
                            2.041466821701074763333783248,
                             2.241966269103109169712344401, 2.329959432635523565375284047},
                        Case{1, 0.5, 0.5291844809148977286990096282, 0.8116915767020968530750992033,
                            1.074931190792526459818507877,
                             1.075952963227549974439194572, 1.456224645397202228359552529}}) {
    std::array<double, 2> y{1, 0};
    const Motion motion = move(ball(c.e, c.c), y, c.end + 0.1);
    const auto impacts = motion.all(ContactEventKind::impact), rests = motion.all(ContactEventKind::accumulation);
    ASSERT_GE(impacts.size(), 10U);
    ASSERT_EQ(rests.size(), 1U);
    EXPECT_NEAR(impacts[0].time, c.first, 1e-13);
    EXPECT_NEAR(impacts[0].state[1], c.speed, 1e-12);
    EXPECT_NEAR(impacts[1].time, c.second, 2e-13);
    EXPECT_NEAR(impacts[9].time, c.tenth, 1e-12);
    EXPECT_NEAR(rests[0].time, c.end, 1e-12);
    EXPECT_EQ(y[1], 0);
  }
}

TEST(BouncingBalls, OnATableThatShakesLiftOffAndLand) {
  std::array<double, 2> y{0, 0.04 * 20};
  const Motion motion = move(ball_on_table(0.3, 0.04, 20), y, 0.98);
  const auto impacts = motion.all(ContactEventKind::impact), lifts = motion.all(ContactEventKind::opens),
             rests = motion.all(ContactEventKind::accumulation);
  const std::array<double, 3> speeds{-1.176796926893544738046056836, -0.3475953610120644036538342837,
      -0.1023670694906422697942412209};
  ASSERT_GE(impacts.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {  // after them, e times as fast
    const double table = 0.04 * 20 * std::cos(20 * impacts[k].time);
    EXPECT_NEAR(impacts[k].state[1] - table, -0.3 * speeds[k], 2e-12);
  }
  ASSERT_EQ(lifts.size(), 4U);
  ASSERT_EQ(rests.size(), 3U);
  EXPECT_NEAR(lifts[1].time, 0.3471597810639985239480955629, 1e-13);
  EXPECT_NEAR(lifts[2].time, 0.661319046422977848, 1e-13);
  EXPECT_NEAR(lifts[3].time, 0.975478311781957171, 1e-13);
  EXPECT_NEAR(rests[2].time, 0.897002364486943221, 2e-12);
}

TEST(BouncingBalls, KeepStepWithATable) {
  constexpr double A = 0.01, w = 30, e = 0.8, phase = 1.180479127022815032847265512, launch = 1.027300797723862388977284386;
  constexpr double T = 0.2094395102393195492308428922;
  EXPECT_NEAR(std::cos(phase), 0.3804817769347638477693645875, 1e-15);
  for (const double late : {0.0, 1e-3}) {
    const double start = phase / w + late, end = start + 120.5 * T;
    // The state where a launch of the cycle has gone on for half of a period, or one that is late.
    std::array<double, 2> y{A * std::sin(w * start) + 1e-9, launch};
    std::vector<Told> events;
    const ContactResult result = integrate_contacts(ball_on_table(e, A, w), y, start, end, precise, {}, Log{events});
    ASSERT_TRUE(result) << describe(result.status);
    ASSERT_GE(events.size(), 100U);
    // Multipliers of modulus 0.8: what was off is gone, but for 1e-3 0.8^119.
    const Told& last = events.back();
    EXPECT_NEAR(std::remainder(w * last.time - phase, 2 * std::numbers::pi), 0, late == 0 ? 1e-10 : 1e-9);
    EXPECT_NEAR(last.state[1], launch, 1e-9);
    EXPECT_NEAR(events[events.size() - 1].time - events[events.size() - 2].time, T, 1e-10);
  }
}

TEST(Belts, CarryABlockThatSticksAndSlips) {
  struct Case {
    double m, k, speed, N, f_static, f, x, largest, smallest, stick, slip;
  };
  for (const Case& c : {Case{2, 50, 0.2, 19.62, 0.5, 0.35, 0.1962, 0.2085052977229773134882287092,
      0.06617470227702268651177129085, 0.5886,
                             0.8670739255408371736850496412},
                        Case{1, 400, 0.05, 30, 0.25, 0.24, 0.01875, 0.02061007662722763754493943851,
                            0.01538992337277236245506056149, 0.03,
                             0.2850135859111926146467038762}}) {
    const auto system = block_on_belt(c.m, c.k, c.speed, c.N, c.f_static, c.f);
    std::array<double, 2> y{};
    const Motion motion = move(system, y, 8 * (c.stick + c.slip));
    const auto slips = motion.all(ContactEventKind::slips), ends = motion.all(ContactEventKind::slip_ends);
    ASSERT_GE(slips.size(), 4U);
    for (std::size_t i = 0; i + 1 < slips.size(); ++i) {
      EXPECT_NEAR(slips[i].state[0], c.x, 1e-13);
      EXPECT_NEAR(ends[i + 1].time - slips[i].time, c.slip, 1e-12);
      EXPECT_NEAR(slips[i + 1].time - ends[i + 1].time, c.stick, 1e-12);
    }
    // The block turns round w t after its slip began, tan(w t) = v/(w d), and half of a period of the spring later.
    const double w = std::sqrt(c.k / c.m), d = (c.f_static - c.f) * c.N / c.k, turn = std::atan(c.speed / (w * d)) / w;
    for (const bool back : {false, true}) {
      std::array<double, 2> there{};
      (void)move(system, there, slips[2].time + turn + (back ? std::numbers::pi / w : 0));
      EXPECT_NEAR(there[0], back ? c.smallest : c.largest, 1e-12);
      EXPECT_NEAR(there[1], 0, 1e-11);
    }
  }
}

/// A block of 1 kg on a belt up a slope, x and the belt's velocity v + a t up it.
ByHand<1, 1, 1> on_conveyor(double slope, double f_static, double f, double v, double a = 0) {
  ByHand<1, 1, 1> block = block_on_belt(1, 0, v, g * std::cos(slope), f_static, f, -g * std::sin(slope));
  block.fill = [fill = block.fill, a](double t, const auto& y, auto& r) {
    fill(t, y, r);
    r.w(0) -= a * t;
    r.drift(0) = -a;
  };
  return block;
}

TEST(Belts, AsConveyorsTurnABlockRound) {
  std::array<double, 2> y{0, -2};
  const Motion motion = move(on_conveyor(0, 0.4, 0.3, 1.5), y, 5);
  const auto ends = motion.all(ContactEventKind::slip_ends);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(ends[0].time, 1.189262657152565409446143391, 1e-13);
  EXPECT_NEAR(ends[0].state[0], -0.2973156642881413523615358478, 1e-13);
  EXPECT_NEAR(y[0], 5.418790349983010533469249066, 1e-12);
}

TEST(Belts, UpASlopeCarryWhatTheyHold) {
  constexpr double slope = 0.35;
  std::array<double, 2> y{};
  const Motion motion = move(on_conveyor(slope, 0.45, 0.4, 0.8), y, 5);
  const auto ends = motion.all(ContactEventKind::slip_ends);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(ends[0].time, 2.482382576814150961646590396, 1e-12);
  EXPECT_NEAR(ends[0].state[0], 0.9929530307256603846586361582, 1e-12);
  EXPECT_NEAR(y[0], 3.007046969274339615341363842, 2e-12);
  std::array<double, 2> slides{}, carried{0, 0.8}, first{};
  (void)move(on_conveyor(slope, 0.45, 0.4, 0.8), first, 1);
  EXPECT_NEAR(first[1], 0.3222710340751371466671485332, 1e-13);
  (void)move(on_conveyor(slope, 0.45, 0.3, 0.8), slides, 1);
  EXPECT_NEAR(slides[1], -0.5992535972281415738872182093, 1e-13);
  (void)move(on_conveyor(slope, 0.45, 0.3, 0.8), carried, 1);
  EXPECT_NEAR(carried[0], 0.8, 1e-14);
  // It breaks loose where the belt speeds up, or brakes, by more.
  for (const double a : {0.7830333497267765069443319045, -7.510688332002731978044968778}) {
    EXPECT_EQ(regime_at_start(on_conveyor(slope, 0.45, 0.4, 0.8, a * (1 - 1e-10)), {0, 0.8}), ContactRegime::sticks);
    EXPECT_EQ(regime_at_start(on_conveyor(slope, 0.45, 0.4, 0.8, a * (1 + 1e-10)), {0, 0.8}), ContactRegime::slides);
  }
}

TEST(BilliardBalls, StruckDownwardsSlideAndThenRoll) {
  constexpr double m = 0.17, R = 0.028575;
  struct Case {
    double f_of_impact, f, vx, vy, slip_x, slip_y, tau, x, y, lost;
  };
  for (const Case& c : {Case{0.2, 0.2, 2.642229123600033648574532213, 0.715541752799932702850935574,
      0.5478019326001177700108627455,
                             -1.095603865200235540021725491, 0.1783780922527481365278160192, 0.4573563812667707285749781835,
                             0.155555790982947362016939748, 0.03643913053662291089046285732},
                        Case{0, 0.2, 3, 0, 1.8, -3.6, 0.5861252889907705626236366104, 1.607657935517542114624831846,
                             0.3014358629095391464921559711, 0.3934285714285714285714285714}}) {
    const double spin_x = -125.9842519685039370078740157, spin_y = 41.99475065616797900262467192,
        spin_z = -94.48818897637795275590551181;
    // Without friction the table takes the fall away alone.
    std::array<double, 9> y{0, 0, R, 3, 0, c.f_of_impact > 0 ? -4.0 : 0.0, spin_x, spin_y, spin_z};
    std::vector<Told> events;
    std::array<double, 9> begun = y;
    const auto system = billiard_ball(m, R, c.f, 0);
    (void)integrate_contacts(system, begun, 0, 0, precise);
    EXPECT_NEAR(begun[3], c.vx, 1e-13);
    EXPECT_NEAR(begun[4], c.vy, 1e-13);
    const double ux = begun[3] - R * begun[7], uy = begun[4] + R * begun[6];
    EXPECT_NEAR(ux, c.slip_x, 1e-13);
    EXPECT_NEAR(uy, c.slip_y, 1e-13);
    EXPECT_NEAR(m * (ux * ux + uy * uy) / 7, c.lost, 1e-13);
    const Motion motion = move(system, y, 0.7);
    const auto rolls = motion.all(ContactEventKind::slip_ends);
    ASSERT_EQ(rolls.size(), 1U);
    EXPECT_NEAR(rolls[0].time, c.tau, 1e-12);
    EXPECT_NEAR(rolls[0].state[0], c.x, 2e-12);
    EXPECT_NEAR(rolls[0].state[1], c.y, 2e-12);
    EXPECT_NEAR(y[3], 2.485714285714285714285714286, 1e-12);
    EXPECT_NEAR(y[4], 1.028571428571428571428571429, 1e-12);
    EXPECT_NEAR(y[6], -35.9955005624296962879640045, 1e-10);
    EXPECT_NEAR(y[7], 86.98912635920509936257967754, 1e-10);
    EXPECT_NEAR(y[8], spin_z, 1e-10);
  }
}

// Two balls in flight collide along (cos 30°, sin 30°, 0).
TEST(BilliardBalls, ThrowEachOther) {
  constexpr double m = 0.17, R = 0.028575;
  const Eigen::Vector3d n(std::sqrt(0.75), 0.5, 0), t(-0.5, std::sqrt(0.75), 0), z(0, 0, 1);
  Eigen::Matrix<double, 3, 12> J;  // of (V1, W1, V2, W2); the contact is at R n of the first ball, -R n of the second
  const std::array<Eigen::Vector3d, 3> axes{n, t, z};
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d& along = axes[static_cast<std::size_t>(k)];
    const Eigen::Vector3d arm = R * n.cross(along);
    J.row(k) << -along.transpose(), -arm.transpose(), along.transpose(), -arm.transpose();
  }
  Eigen::Matrix<double, 12, 1> inverse;
  inverse << Eigen::Vector3d::Constant(1 / m), Eigen::Vector3d::Constant(2.5 / (m * R * R)), Eigen::Vector3d::Constant(1 / m),
      Eigen::Vector3d::Constant(2.5 / (m * R * R));
  const auto strike = [&](const Eigen::Vector3d& spin, double& lost) {
    Eigen::Matrix<double, 12, 1> v = Eigen::Matrix<double, 12, 1>::Zero();
    v(0) = 2;
    v.segment<3>(3) = spin;
    ContactProblem problem;
    problem.count = 1;
    problem.laws[0] = coulomb(2, 0.06);
    problem.W = J * inverse.asDiagonal() * J.transpose();
    problem.q = J * v;
    const ImpactResult result = impact(problem, std::array{0.93});
    EXPECT_NEAR(result.P(0), 0.2841429349816743200031775723, 1e-15);
    lost = result.lost;
    return std::pair(Eigen::Matrix<double, 12, 1>(v + inverse.asDiagonal() * J.transpose() * result.P), result.P);
  };
  double lost = 0;
  const auto [rolling, P1] = strike({0, 2 / R, 0}, lost);
  EXPECT_NEAR(lost, 0.04533835034780091840038130868, 1e-14);
  const auto [spinning, P2] = strike({0, 0, 30}, lost);
  EXPECT_NEAR(std::hypot(P2(1), P2(2)), 0.003466785714285714285714285714, 1e-15);
  EXPECT_NEAR(spinning(0), 0.5423035714285714285714285714, 1e-14);
  EXPECT_NEAR(spinning(1), -0.8180537823105220631519183623, 1e-14);
  EXPECT_NEAR(spinning(5), 31.78415198100237470316210474, 1e-12);
  EXPECT_NEAR(spinning(6), 1.457696428571428571428571429, 1e-14);
  EXPECT_NEAR(spinning(7), 0.8180537823105220631519183623, 1e-14);
  EXPECT_NEAR(spinning(11), 1.784151981002374703162104737, 1e-12);
  const double thrown = std::atan2(spinning(7), spinning(6)) * 180 / std::numbers::pi - 30;
  EXPECT_NEAR(thrown, -0.6990226050045967093974737161, 1e-11);
  (void)rolling;
}

}  // namespace
}  // namespace slopes_and_belts_test
