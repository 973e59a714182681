// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/falling_plate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::falling_plate_test {
namespace {

using namespace torsor::runtime;
using Plate = falling_plate::Mechanism<double>;
using State = StateVector<Plate>;

// The values of the scene.
constexpr double M = 1.0, edge = 0.6, height = 0.9, g = 9.81, rounding = 1.1e-16;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

/// A symmetric plate: a rectangle of the same edge and height.
Plate::Parameters rectangle() {
  return {.b = height / 2.0, .A = M * height * height / 12.0, .B = M * edge * edge / 12.0, .F = 0.0};
}

Plate::Reactions plane_forces(const Plate::Precomputed& plate, const Plate::State& s, const Plate::Accelerations& a) {
  Plate::Reactions reactions{};
  Plate::reactions(plate, s, a, {}, {}, reactions);
  return reactions;
}

/// Runs until the plate lies nearly flat; calls `look(state, accelerations)` at every step.
template <class Motion, class Look>
void fall(const Motion& motion, const Look& look) {
  State y = motion.initial();
  const auto result = integrate(motion, y, 0.0, 5.0, precise, [&](double t, const State& now) {
    const auto s = unpack<Plate>(t, now);
    Plate::Accelerations a{};
    Plate::Multipliers none{};
    EXPECT_EQ(motion.accelerations(s, a, none), Evaluation::ok);
    if (s.q.beta > 0.02) look(s, a);
    return s.q.beta > 0.02;
  });
  EXPECT_EQ(result.status, IntegrationStatus::stopped_by_observer) << describe(result);
}

// Question 1, by integrals over the triangle in the test itself: A = ∫y² dm, B = ∫x² dm, F = -∫xy dm about G, 2000 x
// 2000 cells; and z, normal to the plate, has the sum. Sums of the middles of cells are right to 1/2000.
TEST(FallingPlate, HasTheInertiaOfATriangle) {
  const auto p = Plate::default_parameters();
  constexpr int cells = 2000;
  double mass = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells - i; ++j) {
      const double u = edge * (i + 0.5) / cells, v = height * (j + 0.5) / cells, dm = j == cells - i - 1 ? 0.5 : 1.0;
      mass += dm;
      x += dm * u;
      y += dm * v;
      xx += dm * u * u;
      yy += dm * v * v;
      xy += dm * u * v;
    }
  }
  EXPECT_NEAR(p.b, y / mass, 1e-3 * p.b);
  EXPECT_NEAR(p.A, M * (yy / mass - y * y / mass / mass), 1e-3 * p.A);
  EXPECT_NEAR(p.B, M * (xx / mass - x * x / mass / mass), 1e-3 * p.B);
  EXPECT_NEAR(p.F, -M * (xy / mass - x * y / mass / mass), 1e-3 * p.F);
}

// Question 2: G falls along a vertical. Question 3: the moment of momentum at G has no vertical part, since it has none
// at the start and the plane only gives vertical forces: alpha' (B + A cos²(beta)) + F beta' sin(beta) = 0.
TEST(FallingPlate, FallsWithItsCentreOnAVerticalAndTurnsAsTheRelationSays) {
  const auto p = Plate::default_parameters();
  const auto motion = equations_of_motion<Plate>();
  double turned = 0.0;
  fall(motion, [&](const Plate::State& s, const Plate::Accelerations&) {
    EXPECT_EQ(s.q.x, 0.0);
    EXPECT_EQ(s.q.y, 0.0);
    const double relation =
        s.v.alpha * (p.B + p.A * std::pow(std::cos(s.q.beta), 2)) + p.F * s.v.beta * std::sin(s.q.beta);
    EXPECT_NEAR(relation, 0.0, 1e-11);  // 1e-13 (1 + |y|) a step, some hundred steps
    turned = std::fmax(turned, std::abs(s.q.alpha));
  });
  EXPECT_GT(turned, 0.1);
}

// Question 4: AB stays parallel to itself when alpha' = 0, thus F = 0: the plate's axes at G along and across the edge
// are principal. Then (A + M b² cos²(beta)) beta'² + 2 M g b sin(beta) is a first integral, and the motion is (A + M b²
// cos²) beta'' - M b² sin cos beta'² + M g b cos = 0.
TEST(FallingPlate, KeepsItsEdgeParallelWhenItIsSymmetric) {
  const auto p = rectangle();
  const auto motion = equations_of_motion<Plate>(p);
  const double start = Plate::initial_state(p).q.beta;
  const double conserved = 2.0 * M * g * p.b * std::sin(start);
  fall(motion, [&](const Plate::State& s, const Plate::Accelerations& a) {
    EXPECT_EQ(s.q.alpha, 0.0);
    const double sine = std::sin(s.q.beta), cosine = std::cos(s.q.beta);
    const double inertia = p.A + M * p.b * p.b * cosine * cosine;
    EXPECT_NEAR(inertia * s.v.beta * s.v.beta + 2.0 * M * g * p.b * sine, conserved, 1e-11);
    const double equation =
        inertia * a.beta - M * p.b * p.b * sine * cosine * s.v.beta * s.v.beta + M * g * p.b * cosine;
    EXPECT_NEAR(equation, 0.0, 30 * 10 * rounding);
    // N = M (g + z''), z = b sin(beta): it stays positive, the plate stays on the plane.
    const double N = M * (g + p.b * (cosine * a.beta - sine * s.v.beta * s.v.beta));
    const auto reactions = plane_forces(motion.precomputed(), s, a);
    EXPECT_NEAR(reactions.N, N, 30 * 30 * rounding);
    EXPECT_GT(reactions.N, 0.0);
    EXPECT_NEAR(reactions.moment, 0.0, 30 * 30 * rounding);  // N acts at H, under G
  });
}

// For any plate: N = M (g + z''), and the moments at G along the edge's direction x and along the horizontal normal e:
// dσ/dt by the change of σ over 2 h, σ = J Omega with Omega = beta' x + alpha' z_g. N acts at H + X x.
TEST(FallingPlate, IsHeldByTheForceAndTheMomentOfNewtonAndEuler) {
  const auto p = Plate::default_parameters();
  const auto motion = equations_of_motion<Plate>(p);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int i = 0; i < 30; ++i) {
    Plate::State s{};
    for (int j = 0; j < 4; ++j) {
      s.q[j] = uniform(random);
      s.v[j] = uniform(random);
    }
    Plate::Accelerations a{};
    Plate::Multipliers none{};
    ASSERT_EQ(motion.accelerations(s, a, none), Evaluation::ok);
    const auto reactions = plane_forces(motion.precomputed(), s, a);
    // σ along x, e and z_g, then turned with x and e by alpha.
    const auto momentum = [&](double t) {
      const double beta = s.q.beta + s.v.beta * t + a.beta * t * t / 2.0, beta_rate = s.v.beta + a.beta * t;
      const double alpha = s.v.alpha * t + a.alpha * t * t / 2.0, alpha_rate = s.v.alpha + a.alpha * t;
      const double sine = std::sin(beta), cosine = std::cos(beta);
      const double along_x = p.A * beta_rate + p.F * alpha_rate * sine;
      const double along_y = p.F * beta_rate + p.B * alpha_rate * sine;
      const double along_z = (p.A + p.B) * alpha_rate * cosine;
      const double along_e = along_y * cosine - along_z * sine;
      return std::array{along_x * std::cos(alpha) - along_e * std::sin(alpha),
                        along_x * std::sin(alpha) + along_e * std::cos(alpha)};
    };
    constexpr double h = 1e-5;
    const auto before = momentum(-h), after = momentum(h);
    const double sine = std::sin(s.q.beta), cosine = std::cos(s.q.beta);
    EXPECT_NEAR(reactions.N, M * (g + p.b * (cosine * a.beta - sine * s.v.beta * s.v.beta)), 50 * 30 * rounding);
    // At G: N has the moment -b cos(beta) N about x, and what is asked for about e. Differences: h² times 100, and
    // 1e-16/h.
    EXPECT_NEAR(-p.b * cosine * reactions.N, (after[0] - before[0]) / (2.0 * h), 2e-8);
    EXPECT_NEAR(reactions.moment, (after[1] - before[1]) / (2.0 * h), 2e-8);
  }
}

// The triangle: the plane pushes upwards all the time, within the edge (from -edge/3 to 2 edge/3 beside H).
TEST(FallingPlate, StaysOnThePlaneWithItsWholeEdge) {
  const auto motion = equations_of_motion<Plate>();
  int looks = 0;
  fall(motion, [&](const Plate::State& s, const Plate::Accelerations& a) {
    const auto reactions = plane_forces(motion.precomputed(), s, a);
    EXPECT_GT(reactions.N, 0.0);
    const double place = -reactions.moment / reactions.N;
    EXPECT_GT(place, -edge / 3.0);
    EXPECT_LT(place, 2.0 * edge / 3.0);
    ++looks;
  });
  EXPECT_GT(looks, 10);
}

TEST(FallingPlate, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Plate>(equations_of_motion<Plate>(), 0.5, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-8);
  EXPECT_GT(balance.exchanged, 0.1);
}

}  // namespace
}  // namespace torsor::falling_plate_test
