// SPDX-License-Identifier: GPL-3.0-or-later
// Values "by hand" are printed by clock_escapement_by_hand.py: two equations of motion, written without a generator, in
// RK4 steps of fixed length from event to event. Halving its steps moves what stands here in the last digits only.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "generated/clock_escapement.hpp"
#include "tests/long_tests.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::clock_escapement_test {
namespace {

using namespace torsor::runtime;
using Clock = MechanismWithContacts<clock_escapement::Mechanism<double>>;

// The values of the scene.
constexpr double R = 0.03, r_pin = 0.0016, r_pallet = 0.005, clear = 0.0046, r_drum = 0.0015, l = 0.25, m_bob = 0.2,
                 g = 9.81;
constexpr int pins = 10;

constexpr DormandPrince853 method(double tolerance) {
  return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
}

struct Seen {
  ContactEventKind kind;
  double time;
  int contact;
  double psi, theta, lost;
};
/// All events until a time.
std::vector<Seen> events(const Clock& clock, Clock::State& y, double end, double tolerance) {
  std::vector<Seen> seen;
  const auto result = integrate_contacts(clock, y, 0, end, method(tolerance), {}, [&](const ContactEvent& event) {
    seen.push_back({event.kind, event.time, event.contact, event.state[0], event.state[1], event.energy_lost});
    return true;
  });
  EXPECT_TRUE(result) << describe(result.status) << " at " << result.time;
  EXPECT_LE(result.worst_residual, 1e-13);
  return seen;
}

TEST(ClockEscapement, GoesAsTheMotionByHandDoes) {
  using enum ContactEventKind;
  // Contacts in order: entry1, exit1, entry2 ... exit10. Steps of 1e-4 by hand.
  struct Expected {
    ContactEventKind kind;
    double time;
    int contact;
    double lost;
  };
  constexpr std::array expected{Expected{impact, 0.01701740006308, 3, 5.974174921476e-5},
                                Expected{opens, 0.3411240636094, 3, 0},
                                Expected{impact, 0.3647163625907, 16, 2.664154490419e-4},
                                Expected{slip_ends, 0.4999752499099, 16, 0},
                                Expected{opens, 0.8415626188102, 16, 0},
                                Expected{impact, 0.8643680849436, 1, 2.600893466637e-4},
                                Expected{slip_ends, 1.000191895778, 1, 0},
                                Expected{opens, 1.343271664600, 1, 0},
                                Expected{impact, 1.366872249323, 14, 2.648570630033e-4},
                                Expected{slip_ends, 1.500117076390, 14, 0},
                                Expected{opens, 1.843544791368, 14, 0},
                                Expected{impact, 1.866359946226, 19, 2.585445977897e-4},
                                Expected{slip_ends, 2.000290882801, 19, 0},
                                Expected{opens, 2.345154686177, 19, 0},
                                Expected{impact, 2.368763166917, 12, 2.634730034942e-4},
                                Expected{slip_ends, 2.500174622607, 12, 0},
                                Expected{opens, 2.845275365809, 12, 0},
                                Expected{impact, 2.868099584269, 17, 2.571772532828e-4},
                                Expected{slip_ends, 3.000313690117, 17, 0}};
  const Clock clock;
  Clock::State y = clock.initial();
  const std::vector<Seen> seen = events(clock, y, 3.2, 1e-12);
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].kind, expected[i].kind) << i;
    EXPECT_EQ(seen[i].contact, expected[i].contact) << i;
    EXPECT_NEAR(seen[i].time, expected[i].time, 1e-10) << i;  // by hand with steps of 2e-4: up to 2e-11 elsewhere
    if (expected[i].kind == impact) {
      EXPECT_NEAR(seen[i].lost, expected[i].lost, 1e-13) << i;  // of 0.6 rad/s, to 1e-10 as well
    }
  }
}

/// The limit of a sequence whose differences fall by one factor, of its last three members (Aitken).
double limit(const std::vector<double>& sequence) {
  const double a = sequence.at(sequence.size() - 3), b = sequence.at(sequence.size() - 2), c = sequence.back();
  return c - (c - b) * (c - b) / (c - 2 * b + a);
}

// Each swing lets the wheel go on by one pin, and two starts tend to the cycle that was found by hand, one of them by
// default. A swing leaves 0.86 of what is left of the start: after 35 of them 2e-5 rad at most. Its square over 0.1 rad is
// the error of the limit.
TEST(ClockEscapement, FindsTheCycleOfTheMotionByHand) {
  for (const double start : {0.107, 0.1}) {
    if (start < 0.107 && !wanted(false, true)) continue;
    const Clock clock;
    Clock::State y = clock.initial();
    y[1] = start;
    std::vector<double> left, right, times, wheel, drops;
    for (const Seen& each : events(clock, y, 35, 1e-11)) {
      if (each.kind == ContactEventKind::impact) drops.push_back(each.lost);
      if (each.kind != ContactEventKind::slip_ends) continue;
      (each.theta < 0 ? left : right).push_back(each.theta);
      if (each.theta > 0) continue;
      times.push_back(each.time);
      wheel.push_back(each.psi);
    }
    ASSERT_GT(left.size(), 30U);
    EXPECT_NEAR(limit(left), -0.103051467, 1e-8);
    EXPECT_NEAR(limit(right), 0.103614730, 1e-8);
    std::vector<double> periods, losses;
    for (std::size_t i = 1; i < times.size(); ++i) {
      periods.push_back(times[i] - times[i - 1]);
      EXPECT_NEAR(wheel[i] - wheel[i - 1], 2 * std::numbers::pi / pins, 0.01) << i;  // half a pin is 0.3
    }
    for (std::size_t i = drops.size() % 2; i + 1 < drops.size(); i += 2) losses.push_back(drops[i] + drops[i + 1]);
    EXPECT_NEAR(limit(periods), 0.999722033, 5e-9);
    EXPECT_NEAR(limit(losses), 5.0204829e-4, 5e-11);
  }
}

// Too little weight: the swing fades until a pallet comes to stand on a pin. There it rests, as friction holds it.
TEST(ClockEscapement, StopsOnAPinWhereTheWeightIsTooSmall) {
  const double weight = 0.03, f = 0.1;
  const Clock clock({.weight = weight, .f = f});
  Clock::State y = clock.initial();
  const std::vector<Seen> seen = events(clock, y, 30, 1e-11);
  EXPECT_EQ(std::count_if(seen.begin(), seen.end(), [](const Seen& e) { return e.kind == ContactEventKind::impact; }),
            45);
  EXPECT_NEAR(y[0], 13.9651991, 1e-6);  // by hand, steps of 1e-3 and 5e-4: errors of 1e-8
  EXPECT_NEAR(y[1], -0.0669361759, 1e-8);
  EXPECT_NEAR(y[2], 0, 1e-20);
  EXPECT_NEAR(y[3], 0, 1e-20);
  // Equilibrium of wheel and pendulum: N and T on the pin at the exit.
  const double H = std::sqrt(2.0) * R, aside = (R + clear) / std::sqrt(2.0), above = aside - H;
  const double c = std::cos(y[1]), s = std::sin(y[1]);
  const double qx = aside * c + above * s, qz = above * c - aside * s;  // of the pallet, from the pivot
  double px = 0, pz = 0, least = 1;
  for (int i = 0; i < pins; ++i) {
    const double angle = y[0] + 2 * std::numbers::pi * i / pins;
    const double distance = std::hypot(R * std::sin(angle) - qx, R * std::cos(angle) - qz - H);
    if (distance > least) continue;
    least = distance;
    px = R * std::sin(angle);
    pz = R * std::cos(angle);
  }
  EXPECT_NEAR(least, r_pin + r_pallet, 1e-12);
  const double nx = (px - qx) / least, nz = (pz - qz - H) / least, tx = nz, tz = -nx;
  // The point of contact from both axes; moments about y are z F_x - x F_z.
  const double ax = px - r_pin * nx, az = pz - r_pin * nz, bx = ax, bz = az - H;
  const double a11 = az * nx - ax * nz, a12 = az * tx - ax * tz, a21 = -(bz * nx - bx * nz), a22 = -(bz * tx - bx * tz);
  const double b1 = -weight * g * r_drum, b2 = m_bob * g * l * s;
  const double N = (b1 * a22 - b2 * a12) / (a11 * a22 - a12 * a21), T = (a11 * b2 - a21 * b1) / (a11 * a22 - a12 * a21);
  EXPECT_GT(N, 0);
  EXPECT_LT(std::abs(T), f * N);
}

}  // namespace
}  // namespace torsor::clock_escapement_test
