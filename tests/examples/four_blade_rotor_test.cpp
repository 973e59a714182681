// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/four_blade_rotor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::four_blade_rotor_test {
namespace {

using namespace torsor::runtime;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Rotor = four_blade_rotor::Mechanism<double>;
using State = StateVector<Rotor>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
constexpr double m = 30, s = 0.5, l = 5, w = 0.4, pi = std::numbers::pi;

/// ∫ (r² 1 - r rᵀ) dm over four rectangles, two points of Gauss along each edge: exact for squares.
Matrix3d inertia(double alpha) {
  Matrix3d J = Matrix3d::Zero();
  const double node = 1 / std::sqrt(3.0);
  for (int blade = 0; blade < 4; ++blade) {
    const Vector3d span(std::cos(blade * pi / 2), std::sin(blade * pi / 2), 0);
    const Vector3d chord = std::cos(alpha) * Vector3d::UnitZ().cross(span) + std::sin(alpha) * Vector3d::UnitZ();
    for (const double u : {-node, node}) {
      for (const double v : {-node, node}) {
        const Vector3d r = (s + l / 2 + u * l / 2) * span + v * w / 2 * chord;
        J += m / 4 * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
      }
    }
  }
  return J;
}

// diag(A, A, C): A = m (2 (s² + s l + l²/3) + w² (1 + sin²(alpha))/6), C = m (4 (s² + s l + l²/3) + w² cos²(alpha)/3).
// Roundings of numbers up to 2000.
TEST(FourBladeRotor, HasTheInertiaOperatorOfFourRectanglesAtAnyPitch) {
  for (const double alpha : {0.0, 0.2, -0.7, 1.1, pi / 2}) {
    std::array<double, 9> mass{};
    Rotor::mass_matrix(Rotor::precompute({alpha}), Rotor::initial_state(), mass);
    const Eigen::Map<const Matrix3d> found(mass.data());
    EXPECT_LE((found - inertia(alpha)).cwiseAbs().maxCoeff(), 1e-11);
    const double spans = s * s + s * l + l * l / 3, sine = std::sin(alpha), cosine = std::cos(alpha);
    EXPECT_NEAR(found(0, 0), m * (2 * spans + w * w * (1 + sine * sine) / 6), 1e-11);
    EXPECT_NEAR(found(2, 2), m * (4 * spans + w * w * cosine * cosine / 3), 1e-11);
    EXPECT_EQ(found(0, 1), 0.0);
  }
}

// Free motion of a body of revolution: Omega = L/A + (1 - C/A) omega_z z, L fixed in the ground and omega_z constant,
// so that R(t) = turn(L t/A) turn((1 - C/A) omega_z t z). 1e-13 a step of some hundred a second.
TEST(FourBladeRotor, PrecessesAboutItsMomentum) {
  const auto motion = equations_of_motion<Rotor>();
  const Matrix3d J = inertia(0.2);
  const auto start = Rotor::initial_state();
  const Vector3d omega(start.v.e_omega_x, start.v.e_omega_y, start.v.e_omega_z), L = J * omega;
  const double A = J(0, 0), C = J(2, 2);
  State y = motion.initial();
  for (int i = 1; i <= 10; ++i) {
    y = examples::state_at(motion, y, i - 1.0, i, precise);
    const Matrix3d expected = (Eigen::AngleAxisd(L.norm() / A * i, L.normalized()) *
                               Eigen::AngleAxisd((1 - C / A) * omega[2] * i, Vector3d::UnitZ()))
                                  .toRotationMatrix();
    const Matrix3d found = Eigen::Quaterniond(y[0], y[1], y[2], y[3]).toRotationMatrix();
    EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-10) << i;
    EXPECT_NEAR(y[6], omega[2], 1e-11);
    EXPECT_LE((found * J * Vector3d(y[4], y[5], y[6]) - L).norm(), 1e-10 * L.norm());
  }
}

TEST(FourBladeRotor, MeetsItsCommittedReference) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/four_blade_rotor.reference.csv");
  const auto motion = equations_of_motion<Rotor>();
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const State end = examples::state_at(motion, motion.initial(), 0.0, reference.times[row], precise);
    EXPECT_LE(examples::largest_difference(end, reference.state<7>(row)), 1e-10);
  }
}

TEST(FourBladeRotor, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Rotor>(equations_of_motion<Rotor>(), 5.0, 1e-13);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-4);  // of 16 kJ
}

}  // namespace
}  // namespace torsor::four_blade_rotor_test
