// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/helicopter_on_a_circle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "generated/helicopter_on_a_circle_pitching_blades.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::helicopter_on_a_circle_test {
namespace {

using namespace torsor::runtime;
using Eigen::Vector3d;
using Rigid = helicopter_on_a_circle::Mechanism<double>;
using Pitching = helicopter_on_a_circle_pitching_blades::Mechanism<double>;

constexpr double m = 30, s = 0.5, l = 5, w = 0.4, R = 100, pi = std::numbers::pi;

/// A motion of the rotor: psi = omega t, phi = phi_0 + rate t + second t²/2; the pitch of blade i is alpha, and if
/// `swing` is not 0 changes with a rate and an acceleration of its own.
struct Flight {
  double theta, omega, alpha, swing, phi_0, rate, second;
  double pitch(int i) const { return alpha + swing * 0.1 * i; }
  double pitch_rate(int i) const { return swing * (3 - 2 * i); }
  double pitch_second(int i) const { return swing * (40 * i - 90); }
};
struct Screw {
  Vector3d resultant = Vector3d::Zero(), moment = Vector3d::Zero();
};
/// Axes of the turning frame at t = 0 are the ground's; those of the tilted cell: z leans by theta towards the centre.
struct Cell {
  Vector3d x, y, z;
  explicit Cell(double theta)
      : x(std::cos(theta), 0, std::sin(theta)), y(0, 1, 0), z(-std::sin(theta), 0, std::cos(theta)) {}
};

/// Place at time t of the point of blade i given by u along its span from A and v along its chord, in the ground.
Vector3d place(const Flight& f, int i, double u, double v, double t) {
  const double psi = f.omega * t, phi = f.phi_0 + f.rate * t + f.second * t * t / 2;
  const double pitch = f.pitch(i) + f.pitch_rate(i) * t + f.pitch_second(i) * t * t / 2, angle = phi + i * pi / 2;
  const Cell cell(f.theta);
  const Vector3d span = std::cos(angle) * cell.x + std::sin(angle) * cell.y, ahead = cell.z.cross(span);
  const Vector3d r = R * Vector3d::UnitX() + u * span + v * (std::cos(pitch) * ahead + std::sin(pitch) * cell.z);
  return {r[0] * std::cos(psi) - r[1] * std::sin(psi), r[0] * std::sin(psi) + r[1] * std::cos(psi), r[2]};
}

/// Momentum and dynamic screws in A and T at t = 0, blade by blade and point by point: two points of Gauss along each
/// edge are exact, velocities and accelerations being affine over a plate. Derivatives by central differences of order
/// four and step h = 5e-4: relative errors (30 h)^4/30 and (30 h)^4/90, below 2e-9, and 1e-16 * 100/h² = 4e-8 m/s² of
/// rounding.
struct Sums {
  Screw momentum, dynamic;
  std::array<double, 4> about_span{};  ///< moment of each blade's dynamic screw about its span
  double kinetic = 0;
};
Sums sums(const Flight& f) {
  constexpr double h = 5e-4;
  const double node = 1 / std::sqrt(3.0);
  Sums sums;
  const Cell cell(f.theta);
  for (int i = 0; i < 4; ++i) {
    const Vector3d span = std::cos(f.phi_0 + i * pi / 2) * cell.x + std::sin(f.phi_0 + i * pi / 2) * cell.y;
    for (const double a : {-node, node}) {
      for (const double b : {-node, node}) {
        const auto P = [&](double t) { return place(f, i, s + l / 2 + a * l / 2, b * w / 2, t); };
        const Vector3d here = P(0), V = (8 * (P(h) - P(-h)) - (P(2 * h) - P(-2 * h))) / (12 * h);
        const Vector3d gamma = (16 * (P(h) + P(-h)) - (P(2 * h) + P(-2 * h)) - 30 * here) / (12 * h * h);
        const Vector3d arm = here - R * Vector3d::UnitX();
        sums.momentum.resultant += m / 4 * V;
        sums.momentum.moment += m / 4 * arm.cross(V);
        sums.dynamic.resultant += m / 4 * gamma;
        sums.dynamic.moment += m / 4 * arm.cross(gamma);
        sums.about_span[static_cast<std::size_t>(i)] += m / 4 * arm.cross(gamma).dot(span);
        sums.kinetic += m / 8 * V.squaredNorm();
      }
    }
  }
  return sums;
}

double moment_across(double alpha) {
  return m * (2 * (s * s + s * l + l * l / 3) + w * w * (1 + std::pow(std::sin(alpha), 2)) / 6);
}
double moment_along(double alpha) {
  return m * (4 * (s * s + s * l + l * l / 3) + w * w * std::pow(std::cos(alpha), 2) / 3);
}

constexpr std::array<Flight, 3> flights{
    {{0.3, 0.2, 0.2, 0, 0, 30, 0}, {-0.5, 0.6, 0.4, 0, 1.1, 25, 0}, {1.0, -0.3, -0.2, 0, 2.0, 10, 0}}};

template <class Rotor>
typename Rotor::Parameters parameters(const Flight& f) {
  auto result = Rotor::default_parameters();
  result.theta = f.theta;
  result.omega = f.omega;
  result.alpha = f.alpha;
  return result;
}

// Questions 1 and 2: {4 m R omega y1; A omega sin(theta) x + C (omega cos(theta) + phi') z} in A, and
// T = 2 m R² omega² + (A omega² sin²(theta) + C (omega cos(theta) + phi')²)/2.
TEST(HelicopterOnACircle, HasTheMomentumScrewAndTheEnergyOfItsRotor) {
  for (const Flight& f : flights) {
    const auto expected = sums(f);
    const Cell cell(f.theta);
    const double A = moment_across(f.alpha), C = moment_along(f.alpha);
    const double across = f.omega * std::sin(f.theta), along = f.omega * std::cos(f.theta) + f.rate;
    const Vector3d sigma = A * across * cell.x + C * along * cell.z;
    EXPECT_LE((sigma - expected.momentum.moment).norm(), 1e-7 * sigma.norm());
    EXPECT_LE((expected.momentum.resultant - 4 * m * R * f.omega * cell.y).norm(), 1e-7 * 4 * m * R);
    Rigid::State state{};
    state.q.phi = f.phi_0;
    state.v.phi = f.rate;
    const auto precomputed = Rigid::precompute(parameters<Rigid>(f));
    Rigid::Energy energy{};
    Rigid::energy(precomputed, state, {}, energy);
    const double T = 2 * m * std::pow(R * f.omega, 2) + (A * across * across + C * along * along) / 2;
    EXPECT_NEAR(energy.kinetic, T, 1e-13 * T);
    EXPECT_NEAR(energy.kinetic, expected.kinetic, 1e-7 * T);
    Rigid::Kinematics at{};
    Rigid::kinematics(precomputed, state, at);
    EXPECT_NEAR(at.A_velocity[1], R * f.omega, 1e-13 * R);
  }
}

// Question 3: {-4 m R omega² x1; -omega sin(theta) (C (omega cos(theta) + phi') - A omega cos(theta)) y1}: the cell
// must hold the rotor up against the gyroscopic moment, and the motor has nothing to do.
TEST(HelicopterOnACircle, HasTheDynamicScrewOfItsRotorAsReactions) {
  for (const Flight& f : flights) {
    const auto expected = sums(f).dynamic;
    const double A = moment_across(f.alpha), C = moment_along(f.alpha), cosine = std::cos(f.theta);
    const double moment = -f.omega * std::sin(f.theta) * (C * (f.omega * cosine + f.rate) - A * f.omega * cosine);
    Rigid::State state{};
    state.q.phi = f.phi_0;
    state.v.phi = f.rate;
    const auto precomputed = Rigid::precompute(parameters<Rigid>(f));
    Rigid::Reactions cell{};
    Rigid::reactions(precomputed, state, {}, {}, {}, cell);
    EXPECT_NEAR(cell.X, -4 * m * R * f.omega * f.omega, 1e-10);
    EXPECT_NEAR(cell.M_y, moment, 1e-12 * std::abs(moment));
    // What cancels among the blades is of some 30 * 30² * 3² N m: 1e-13 of it.
    for (const double none : {cell.Y, cell.Z, cell.M_x, cell.M_z}) EXPECT_NEAR(none, 0.0, 1e-7);
    EXPECT_LE((Vector3d(cell.X, cell.Y, cell.Z) - expected.resultant).norm(), 1e-3);
    EXPECT_LE((cell.M_y * Vector3d::UnitY() - expected.moment).norm(), 1e-2);
    Rigid::Accelerations a{};
    Rigid::Multipliers none{};
    ASSERT_EQ(Rigid::forward_dynamics(precomputed, state, {}, a, none), torsor::Status::ok);
    EXPECT_NEAR(a.phi, 0.0, 1e-9);
  }
}

// Question 4: the dynamic screw is the sum of the blades', here at any pitch and any accelerations: the reactions
// against the sum over the plates. Without links the motor's torque is the moment about z, and the actuators' that
// about the spans. Pieces of m l² phi'² = 7e5 N m are summed: errors of 4e-9 of them, and of m l times 4e-8 m/s².
TEST(HelicopterOnACircle, HasTheDynamicScrewOfBladesWhosePitchChanges) {
  for (Flight f : flights) {
    for (int i = 0; i < 3; ++i) {
      f.swing = 0.5 + 0.5 * i;
      f.phi_0 = 0.7 * i + 0.2;
      f.second = 15.0 * i - 10;
      const auto expected = sums(f);
      Pitching::State state{};
      Pitching::Accelerations a{};
      state.q.phi = f.phi_0;
      state.v.phi = f.rate;
      a.phi = f.second;
      for (int blade = 0; blade < 4; ++blade) {
        state.q[blade + 1] = f.pitch(blade);
        state.v[blade + 1] = f.pitch_rate(blade);
        a[blade + 1] = f.pitch_second(blade);
      }
      auto without_links = parameters<Pitching>(f);
      without_links.k = without_links.c = 0.0;
      const auto precomputed = Pitching::precompute(without_links);
      Pitching::Reactions cell{};
      Pitching::reactions(precomputed, state, a, {}, {}, cell);
      Pitching::GeneralizedForces torque{};
      Pitching::inverse_dynamics(precomputed, state, a, {}, torque);
      const Cell axes(f.theta);
      constexpr double tolerance = 1e-2;
      EXPECT_LE((Vector3d(cell.X, cell.Y, cell.Z) - expected.dynamic.resultant).norm(), tolerance);
      EXPECT_NEAR(cell.M_x, expected.dynamic.moment.dot(axes.x), tolerance);
      EXPECT_NEAR(cell.M_y, expected.dynamic.moment.dot(axes.y), tolerance);
      EXPECT_NEAR(cell.M_z, expected.dynamic.moment.dot(axes.z), tolerance);
      EXPECT_NEAR(torque.phi, expected.dynamic.moment.dot(axes.z), tolerance);
      for (int blade = 0; blade < 4; ++blade) {
        EXPECT_NEAR(torque[blade + 1], expected.about_span[static_cast<std::size_t>(blade)], tolerance);
      }
      // None of them is within the tolerance of nothing.
      EXPECT_GT(std::abs(cell.M_x), 1.0);
      EXPECT_GT(std::abs(torque[1]), 1.0);
    }
  }
}

TEST(HelicopterOnACircle, MeetsItsCommittedReferences) {
  constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
  const auto compare = [&]<class Rotor>(const Rotor*, const std::string& name) {
    const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/" + name + ".reference.csv");
    const auto motion = equations_of_motion<Rotor>();
    for (std::size_t row = 0; row < reference.rows(); ++row) {
      const auto end = examples::state_at(motion, motion.initial(), 0.0, reference.times[row], precise);
      using Vector = StateVector<Rotor>;
      EXPECT_LE(examples::largest_difference(end, reference.template state<std::tuple_size_v<Vector>>(row)), 1e-10)
          << name;
    }
  };
  compare(static_cast<const Rigid*>(nullptr), "helicopter_on_a_circle");
  compare(static_cast<const Pitching*>(nullptr), "helicopter_on_a_circle_pitching_blades");
}

// What carries the rotor round has the power of the cell's wrench in the cell's motion, {omega z0; R omega y1} in A.
template <class Rotor>
examples::EnergyBalance balance_over_a_second() {
  const auto law = [](const typename Rotor::State& state) {
    return typename Rotor::Inputs{500 * std::cos(8 * state.time)};
  };
  const auto p = Rotor::default_parameters();
  const auto motion = equations_of_motion<Rotor>(p, law);
  return examples::energy_balance<Rotor>(motion, 1.0, 1e-12, [&](const auto& state, const auto& a, const auto& none) {
    typename Rotor::Reactions cell{};
    Rotor::reactions(motion.precomputed(), state, a, none, law(state), cell);
    return p.omega * (R * cell.Y + std::sin(p.theta) * cell.M_x + std::cos(p.theta) * cell.M_z);
  });
}

TEST(HelicopterOnACircle, ObeysTheEnergyTheorem) {
  const auto balance = balance_over_a_second<Rigid>();
  examples::expect_kept(balance, 100.0);
  EXPECT_GT(balance.work, 100.0);
}

TEST(HelicopterOnACircle, ObeysTheEnergyTheoremWithSwingingBlades) {
  const auto balance = balance_over_a_second<Pitching>();
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1.0);  // of 2 MJ
  EXPECT_GT(balance.work, 100.0);
}

}  // namespace
}  // namespace torsor::helicopter_on_a_circle_test
