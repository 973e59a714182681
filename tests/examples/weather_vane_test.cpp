// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/weather_vane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::weather_vane_test {
namespace {

using namespace torsor::runtime;
using Vane = weather_vane::Mechanism<double>;
using State = StateVector<Vane>;
using Three = std::array<double, 3>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
constexpr double R = 0.3, m = 2, C = 0.4, c = 0.02, pi = std::numbers::pi;

struct Screw {
  Three resultant{}, moment{};
};

/// Sums over the plate cut into rings and sectors, each piece a mass point of the plane x, y1 at theta: an integral
/// that knows no catalogue. Gauss's rule of three points in the radius (times r, a polynomial) and the midpoint rule in
/// the angle, whose error for cos, sin and their products over a quarter of a turn is (pi/2)²/(24 n²) relative: 1e-7
/// here.
template <class Quantity>
Screw over_the_plate(const Quantity& quantity) {
  constexpr int n = 1000;
  constexpr std::array<double, 3> node{-0.774596669241483377, 0.0, 0.774596669241483377};
  constexpr std::array<double, 3> weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
  Screw sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const double r = R * (1 + node[k]) / 2;
    for (int i = 0; i < n; ++i) {
      const double angle = (i + 0.5) * pi / 2 / n;
      const double dm = m / (pi * R * R / 4) * r * (R / 2 * weight[k]) * (pi / 2 / n);
      const Screw piece = quantity(r * std::cos(angle), r * std::sin(angle));
      for (std::size_t j = 0; j < 3; ++j) {
        sum.resultant[j] += dm * piece.resultant[j];
        sum.moment[j] += dm * piece.moment[j];
      }
    }
  }
  return sum;
}

Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Place, velocity and acceleration of the plate's point (x, y) in the ground.
Three place(double x, double y, double theta) { return {x, y * std::cos(theta), y * std::sin(theta)}; }
Three velocity(double, double y, double theta, double rate) {
  return {0, -y * rate * std::sin(theta), y * rate * std::cos(theta)};
}
Three acceleration(double, double y, double theta, double rate, double second) {
  return {0, y * (-second * std::sin(theta) - rate * rate * std::cos(theta)),
          y * (second * std::cos(theta) - rate * rate * std::sin(theta))};
}

Vane::State some_state(int i) {
  Vane::State s{};
  s.q.theta = 0.7 * i - 2.0;
  s.v.theta = 1.5 - 0.4 * i;
  return s;
}

// {m V_G; sigma_O} = {m 4R/(3 pi) theta' z1; m R² theta' (x/4 - y1/(2 pi))}, T = m R² theta'²/8.
TEST(WeatherVane, HasTheMomentumScrewOfAQuarterDisk) {
  const auto precomputed = Vane::precompute(Vane::default_parameters());
  for (int i = 0; i < 8; ++i) {
    const auto s = some_state(i);
    const double theta = s.q.theta, rate = s.v.theta;
    Vane::Kinematics at{};
    Vane::kinematics(precomputed, s, at);
    const Screw momentum = over_the_plate([&](double x, double y) {
      const Three v = velocity(x, y, theta, rate);
      return Screw{v, cross(place(x, y, theta), v)};
    });
    const Three sigma{m * R * R / 4 * rate, -m * R * R / (2 * pi) * rate * std::cos(theta),
                      -m * R * R / (2 * pi) * rate * std::sin(theta)};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(m * at.vane_velocity[k], momentum.resultant[k], 1e-6);
      EXPECT_NEAR(sigma[k], momentum.moment[k], 1e-6);
    }
    EXPECT_NEAR(m * at.vane_velocity[2], m * 4 * R / (3 * pi) * rate * std::cos(theta), 1e-15);
    Vane::Energy energy{};
    Vane::energy(precomputed, s, {}, energy);
    EXPECT_NEAR(energy.kinetic, m * R * R * rate * rate / 8, 1e-15);
  }
}

// The hinge's reactions in the five released directions are the dynamic screw in O, at any acceleration:
// {m 4R/(3 pi) (theta'' z1 - theta'² y1); m R² (theta'' x/4 - (theta'' y1 + theta'² z1)/(2 pi))}.
TEST(WeatherVane, HasTheDynamicScrewOfAQuarterDiskAsItsHingesReactions) {
  const auto precomputed = Vane::precompute(Vane::default_parameters());
  for (int i = 0; i < 8; ++i) {
    const auto s = some_state(i);
    const double theta = s.q.theta, rate = s.v.theta, second = 0.9 - 0.5 * i;
    Vane::Reactions hinge{};
    Vane::reactions(precomputed, s, {second}, {}, {}, hinge);
    const Screw dynamic = over_the_plate([&](double x, double y) {
      const Three gamma = acceleration(x, y, theta, rate, second);
      return Screw{gamma, cross(place(x, y, theta), gamma)};
    });
    const Three force{hinge.X, hinge.Y, hinge.Z};
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(force[k], dynamic.resultant[k], 1e-6);
    EXPECT_NEAR(hinge.M_y, dynamic.moment[1], 1e-6);
    EXPECT_NEAR(hinge.M_z, dynamic.moment[2], 1e-6);
    EXPECT_NEAR(m * R * R / 4 * second, dynamic.moment[0], 1e-6);
    const double cosine = std::cos(theta), sine = std::sin(theta), arm = m * R * R / (2 * pi);
    EXPECT_NEAR(hinge.M_y, -arm * (second * cosine - rate * rate * sine), 1e-14);
    EXPECT_NEAR(hinge.M_z, -arm * (second * sine + rate * rate * cosine), 1e-14);
    EXPECT_NEAR(hinge.Y, -m * 4 * R / (3 * pi) * (second * sine + rate * rate * cosine), 1e-14);
    EXPECT_NEAR(hinge.Z, m * 4 * R / (3 * pi) * (second * cosine - rate * rate * sine), 1e-14);
    EXPECT_NEAR(hinge.X, 0.0, 1e-15);
  }
}

// m R²/4 theta'' = -C sin(theta) - c theta'.
TEST(WeatherVane, TurnsIntoTheWindLikeADampedPendulum) {
  const auto motion = equations_of_motion<Vane>();
  for (int i = 0; i < 8; ++i) {
    const auto s = some_state(i);
    Vane::Accelerations a{};
    Vane::Multipliers none{};
    ASSERT_EQ(motion.accelerations(s, a, none), Evaluation::ok);
    EXPECT_NEAR(m * R * R / 4 * a.theta, -C * std::sin(s.q.theta) - c * s.v.theta, 1e-15);
  }
  const State end = examples::state_at(motion, motion.initial(), 0.0, 100.0, precise);
  // Turned into the wind: it decays as exp(-c t/(2 J)), J = 0.045 kg m², 0.22 1/s.
  EXPECT_NEAR(std::remainder(end[0], 2 * pi), 0.0, 1e-8);
}

TEST(WeatherVane, MeetsItsCommittedReference) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/weather_vane.reference.csv");
  const auto motion = equations_of_motion<Vane>();
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const double time = reference.times[row];
    const State end = examples::state_at(motion, motion.initial(), 0.0, time, precise);
    // A hundred steps of 1e-13.
    const double allowed = 1e-11 * std::fmax(1.0, growth.until(time));
    EXPECT_LE(examples::largest_difference(end, reference.state<2>(row)), allowed);
  }
}

TEST(WeatherVane, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Vane>(equations_of_motion<Vane>(), 10.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-8);
  EXPECT_GT(balance.work, 0.1);
}

}  // namespace
}  // namespace torsor::weather_vane_test
