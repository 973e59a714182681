// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace stabilised_quaternion_test {
namespace {

using namespace torsor::runtime;
using mechanisms::Contract;
using mechanisms::Nothing;
using mechanisms::Values;
using Vector3 = std::array<double, 3>;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A free body: centre of mass x, y, z and attitude by a quaternion (w, x, y, z); velocities of the centre along the
/// ground's axes, angular ones along the body's. `Hold` gives masses, gravity and the constraints
///   0 = g,   0 = A v,   A v' + γ = 0.
template <class Hold>
struct HeldFreely : Contract<6, 3, 7> {
  static constexpr int parameter_count = 0, quaternion_count = 1;
  static constexpr int quaternions[] = {3};
  static State initial_state() noexcept { return Hold::start(); }
  static void coordinate_rates(const Precomputed&, const State& s, std::array<double, 7>& rates) noexcept {
    const double w = s.q[3], x = s.q[4], y = s.q[5], z = s.q[6], a = s.v[3], b = s.v[4], c = s.v[5];
    rates = {s.v[0],
             s.v[1],
             s.v[2],
             (-x * a - y * b - z * c) / 2,
             (w * a + y * c - z * b) / 2,
             (w * b + z * a - x * c) / 2,
             (w * c + x * b - y * a) / 2};
  }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 36>& mass) noexcept {
    mass = {};
    for (std::size_t i = 0; i < 3; ++i) {
      mass[7 * i] = Hold::mass;
      mass[7 * (3 + i)] = Hold::inertia[i];
    }
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    const Vector3 w{s.v[3], s.v[4], s.v[5]};
    const Vector3 turning = cross(w, {Hold::inertia[0] * w[0], Hold::inertia[1] * w[1], Hold::inertia[2] * w[2]});
    for (std::size_t i = 0; i < 3; ++i) {
      h[static_cast<int>(i)] = -Hold::mass * Hold::gravity[i];
      h[static_cast<int>(3 + i)] = turning[i];
    }
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    Hold::constraints(s, c);
    for (std::size_t j = 0; j < 3; ++j) {
      c.rate[j] = 0;
      for (int k = 0; k < 6; ++k) c.rate[j] += c.jacobian[static_cast<std::size_t>(k) * 3 + j] * s.v[k];
    }
  }
  /// Columns of the rotation: the body's axes as the ground sees them.
  static std::array<Vector3, 3> axes(const State& s) noexcept {
    const double w = s.q[3], x = s.q[4], y = s.q[5], z = s.q[6];
    return {{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
             {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
             {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}};
  }
};

/// The fast heavy top of Terze, Müller & Zlatar (2016), its point (0, -1, 0) in the body held at the origin.
struct Pivot {
  static constexpr double mass = 15;
  static constexpr Vector3 inertia{0.234375, 0.46875, 0.234375}, gravity{0, 0, -9.81};
  using Body = HeldFreely<Pivot>;
  static Body::State start() noexcept {
    // v = ω × (0, 1, 0)
    return {0, {{0, 1, 0, 1, 0, 0, 0}}, {{4.61538, 0, 0, 0, 150, -4.61538}}};
  }
  template <class State, class Constraints>
  static void constraints(const State& s, Constraints& c) noexcept {
    const auto axes = HeldFreely<Pivot>::axes(s);
    // d/dt (x - R e_y) = v - R (ω × e_y), ω × e_y = (-ω_z, 0, ω_x).
    const Vector3 w{s.v[3], s.v[4], s.v[5]}, centripetal = cross(w, cross(w, {0, 1, 0}));
    c.jacobian = {};
    for (std::size_t i = 0; i < 3; ++i) {
      c.value[i] = s.q[static_cast<int>(i)] - axes[1][i];
      c.jacobian[i * 3 + i] = 1;
      c.jacobian[3 * 3 + i] = -axes[2][i];
      c.jacobian[5 * 3 + i] = axes[0][i];
      c.gamma[i] = 0;
      for (std::size_t k = 0; k < 3; ++k) c.gamma[i] -= axes[k][i] * centripetal[k];
    }
  }
};

/// A homogeneous ball of radius 1/2 that rolls without slipping on a plane inclined by 0.3 rad, z across it.
struct Rolling {
  static constexpr double mass = 2, radius = 0.5, slope = 0.3, g = 9.81;
  static constexpr double moment = 0.4 * mass * radius * radius;
  static constexpr Vector3 inertia{moment, moment, moment};
  static const Vector3 gravity;
  using Body = HeldFreely<Rolling>;
  static Body::State start() noexcept {
    // At the attitude (cos, 0, 0, sin) of half a right angle the body's x is the ground's y: ω = (-v_y, v_x, 0)/r.
    const double half = std::sqrt(0.5);
    return {0, {{0, 0, radius, half, 0, 0, half}}, {{0, 1, 0, 0, 1 / radius, 3}}};
  }
  template <class State, class Constraints>
  static void constraints(const State& s, Constraints& c) noexcept {
    const auto axes = HeldFreely<Rolling>::axes(s);
    c = {};
    c.value[2] = s.q[2] - radius;
    c.jacobian[2 * 3 + 2] = 1;
    // Of the contact: v_x - r ω_y and v_y + r ω_x. The rotation's own change adds ω × ω = 0: γ vanishes.
    c.jacobian[0 * 3 + 0] = c.jacobian[1 * 3 + 1] = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      c.jacobian[(3 + k) * 3 + 0] = -radius * axes[k][1];
      c.jacobian[(3 + k) * 3 + 1] = radius * axes[k][0];
    }
  }
};
const Vector3 Rolling::gravity{g * std::sin(slope), 0, -g* std::cos(slope)};

struct Worst {
  double norm = 0, value = 0, rate = 0;
};
template <class Body>
Worst run(double end, const StabilisedRadauIia5& method, StateVector<Body>& y, Statistics& statistics) {
  const auto motion = constrained_motion<Body>();
  y = motion.initial();
  Worst worst;
  const auto result = integrate(motion, y, 0, end, method, [&](double t, const StateVector<Body>& at) {
    typename Body::Constraints constraints{};
    Body::constraints({}, unpack<Body>(t, at), constraints);
    worst.norm = std::max(worst.norm, std::abs(at[3] * at[3] + at[4] * at[4] + at[5] * at[5] + at[6] * at[6] - 1));
    for (const double value : constraints.value) worst.value = std::max(worst.value, std::abs(value));
    for (const double rate : constraints.rate) worst.rate = std::max(worst.rate, std::abs(rate));
  });
  EXPECT_TRUE(result) << describe(result);
  statistics = result.statistics;
  return worst;
}

TEST(StabilisedRadauIia5, HoldsAHeavyTopByItsPointWithAQuaternion) {
  using Body = HeldFreely<Pivot>;
  // After 0.2 s, 30 rad of spin: centre, attitude and the angular velocities across the figure's axis, by an
  // independent integration to 27 digits. The first five digits of the attitude are those that Exudyn's
  // TestModels/heavyTop.py publishes for these data.
  const std::array<double, 7> truth{0.605550561377119770136150239,  0.598957681794919157684825780,
                                    -0.523983027430003184780596595, -0.708279152974312562108796855,
                                    0.438781088126581897370189638,  0.545728396145417673414642772,
                                    0.0893997528240050104623756681};
  const double across_x = -2.69159091214340862135129869, across_z = 4.91726098989399441714576226;
  constexpr std::size_t omega_x = 7 + 3, spin = 7 + 4, omega_z = 7 + 5;  // behind the coordinates and the velocity
  StateVector<Body> y;
  Statistics statistics;
  double errors[2];
  std::int64_t steps[2];
  for (int i = 0; i < 2; ++i) {
    const double tolerance = i == 0 ? 1e-8 : 1e-12;
    const Worst worst =
        run<Body>(0.2, {.relative_tolerance = tolerance, .absolute_tolerance = tolerance}, y, statistics);
    // Norm and length of four squares, twice; rates of 5 m/s from terms of 150 rad/s at most.
    EXPECT_LT(worst.norm, 8 * 1.1e-16);
    EXPECT_LT(worst.value, 20 * 1.1e-16);
    EXPECT_LT(worst.rate, 20 * 150 * 1.1e-16);
    errors[i] = 0;
    for (std::size_t k = 0; k < 7; ++k) errors[i] = std::max(errors[i], std::abs(y[k] - truth[k]));
    steps[i] = statistics.accepted;
    // Angles add the errors of steps of rates of up to 150 rad/s over 0.2 s.
    const double of_angles = tolerance * 150 * 0.2 * static_cast<double>(steps[i]);
    EXPECT_LT(errors[i], of_angles);
    // Rates of 6 rad/s that turn by these angles.
    EXPECT_NEAR(y[omega_x], across_x, 6 * of_angles);
    EXPECT_NEAR(y[omega_z], across_z, 6 * of_angles);
    // The figure's axis keeps its spin: each step errs by the tolerance relative to it, and nothing magnifies that.
    EXPECT_NEAR(y[spin], 150, tolerance * 150 * static_cast<double>(steps[i]));
  }
  // Order five at least: four decades of tolerance; one order less would change the slope by 1.
  const double slope =
      std::log(errors[0] / errors[1]) / std::log(static_cast<double>(steps[1]) / static_cast<double>(steps[0]));
  EXPECT_GT(slope, 4.4);
}

TEST(StabilisedRadauIia5, RollsABallWithAQuaternion) {
  using Body = HeldFreely<Rolling>;
  StateVector<Body> y;
  Statistics statistics;
  const double end = 2;
  const Worst worst = run<Body>(end, {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9}, y, statistics);
  // Five sevenths of the slope's pull, and no other force in the plane: a parabola. The spin about z stays 3 rad/s.
  const double pull = 5.0 / 7 * Rolling::g * std::sin(Rolling::slope);
  const double bound = 1e-9 * 30 * static_cast<double>(statistics.accepted);  // 30: the largest coordinate's size
  EXPECT_NEAR(y[0], pull * end * end / 2, bound);
  EXPECT_NEAR(y[1], 1 * end, bound);
  EXPECT_NEAR(y[7], pull * end, bound);
  EXPECT_NEAR(y[8], 1.0, bound);
  const auto axes = Body::axes(unpack<Body>(end, y));
  const auto along = [&](std::size_t i) { return axes[0][i] * y[10] + axes[1][i] * y[11] + axes[2][i] * y[12]; };
  EXPECT_NEAR(along(0), -1 / Rolling::radius, bound);
  EXPECT_NEAR(along(1), pull * end / Rolling::radius, bound);
  EXPECT_NEAR(along(2), 3.0, bound);
  // Rates of 4 m/s from terms of 8 rad/s.
  EXPECT_LT(worst.norm, 8 * 1.1e-16);
  EXPECT_LT(worst.value, 2 * 1.1e-16);
  EXPECT_LT(worst.rate, 20 * 8 * 1.1e-16);
}

}  // namespace
}  // namespace stabilised_quaternion_test
