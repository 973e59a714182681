// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

#include "tests/runtime/linear_systems.hpp"

namespace modes_test {
namespace {

using namespace torsor::runtime;
using namespace linear_systems;
using Eigen::MatrixXd;

// A symmetric eigenproblem of a few rows keeps each ω² to some ten roundings of the largest one.
constexpr double rounding = 1e-14;

TEST(NaturalModes, OfTwoEqualMassesBetweenThreeSpringsAreTheTextbookOnes) {
  const NaturalModes modes = natural_modes(chain(2, 2.0, 50.0));  // k/m = 25
  EXPECT_NEAR(modes.angular_frequency(0), 5.0, 5 * rounding * 10);
  EXPECT_NEAR(modes.angular_frequency(1), 5.0 * std::sqrt(3.0), 5 * rounding * 10);
  // Mass-normalised: both masses move by 1/sqrt(2 m) = 1/2, together and against each other.
  EXPECT_NEAR(modes.shapes(0, 0), 0.5, rounding);
  EXPECT_NEAR(modes.shapes(1, 0), 0.5, rounding);
  EXPECT_NEAR(std::abs(modes.shapes(0, 1)), 0.5, rounding);
  EXPECT_NEAR(modes.shapes(0, 1) + modes.shapes(1, 1), 0.0, rounding);
}

TEST(NaturalModes, OfAVibrationAbsorberAreThePublishedOnes) {
  const NaturalModes modes = natural_modes(absorber());
  EXPECT_NEAR(modes.angular_frequency(0), 8.543089535574103800624004, 200 * rounding);
  EXPECT_NEAR(modes.angular_frequency(1), 11.7053671957424831326229, 200 * rounding);
}

TEST(NaturalModes, DiagonaliseMassAndStiffness) {
  for (int seed = 1; seed <= 20; ++seed) {
    const LinearSystem system = random_system(6, seed);
    const NaturalModes modes = natural_modes(system);
    const MatrixXd& Q = modes.shapes;
    const MatrixXd squares = modes.squared_frequencies.asDiagonal();
    const double size = squares.cwiseAbs().maxCoeff();
    EXPECT_LE((Q.transpose() * system.M * Q - MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 100 * rounding);
    EXPECT_LE((Q.transpose() * system.K * Q - squares).cwiseAbs().maxCoeff(), 100 * rounding * size);
  }
}

// The course prints that Q is a rotation and QᵀDQ, D = M⁻¹K, diagonal. With unequal masses neither holds.
TEST(NaturalModes, DiagonaliseDByTheInverseOfQAndNotByItsTranspose) {
  LinearSystem system = chain(2, 1.0, 10.0);
  system.M(1, 1) = 4.0;
  const MatrixXd Q = natural_modes(system).shapes;
  const MatrixXd D = inverse(system.M) * system.K;
  const MatrixXd by_inverse = inverse(Q) * D * Q, by_transpose = Q.transpose() * D * Q;
  EXPECT_LE(std::abs(by_inverse(0, 1)) + std::abs(by_inverse(1, 0)), 100 * rounding * 20);
  EXPECT_GT(std::abs(by_transpose(0, 1)), 0.1);
  EXPECT_GT((Q.transpose() * Q - MatrixXd::Identity(2, 2)).cwiseAbs().maxCoeff(), 0.1);
}

TEST(NaturalModes, TellFreeMotionsAndThoseThatRunAway) {
  MatrixXd K(2, 2);
  K << 3, -3, -3, 3;  // two masses tied to each other only: k (1/m1 + 1/m2) = 3 (1 + 1/2)
  const NaturalModes free = natural_modes(undamped(Eigen::Vector2d(1, 2).asDiagonal(), K));
  EXPECT_NEAR(free.squared_frequencies(0), 0.0, 5 * rounding);
  EXPECT_NEAR(free.squared_frequencies(1), 4.5, 5 * rounding * 5);
  K << -4, 0, 0, 9;
  const NaturalModes falling = natural_modes(undamped(MatrixXd::Identity(2, 2), K));
  EXPECT_EQ(falling.squared_frequencies(0), -4.0);
  EXPECT_TRUE(std::isnan(falling.angular_frequency(0)));
}

// Three masses in a row that nothing holds: one free motion, whatever rounding leaves of its frequency.
TEST(NaturalModes, OfAFreeChainHaveAFrequencyOfZero) {
  for (int k = 1; k < 20; ++k) {
    const double a = 7.3 * k, b = 2.1;
    MatrixXd M = MatrixXd::Zero(3, 3), K(3, 3);
    M.diagonal() << 1, 3.0 * k, 0.7;
    K << a, -a, 0, -a, a + b, -b, 0, -b, b;
    const NaturalModes modes = natural_modes(undamped(M, K));
    EXPECT_EQ(modes.squared_frequencies(0), 0.0) << k;
    EXPECT_EQ(modes.angular_frequency(0), 0.0) << k;
    EXPECT_GT(modes.angular_frequency(1), 0.1) << k;
  }
}

TEST(NaturalModes, DoNotMindTheUnitsOfACoordinate) {
  const LinearSystem metres = absorber();
  LinearSystem mixed = metres;  // the second coordinate in nanometres: x2 = 1e-9 y2
  const Eigen::Vector2d unit(1, 1e-9);
  mixed.M = unit.asDiagonal() * metres.M * unit.asDiagonal();
  mixed.K = unit.asDiagonal() * metres.K * unit.asDiagonal();
  const NaturalModes expected = natural_modes(metres), modes = natural_modes(mixed);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(modes.angular_frequency(k), expected.angular_frequency(k), 200 * rounding);
    EXPECT_NEAR(modes.shapes(1, k) * 1e-9, expected.shapes(1, k), 100 * rounding);
  }
}

TEST(NaturalModes, RefuseWhatHasNone) {
  LinearSystem system = chain(2, 1.0, 1.0);
  system.K(0, 1) = 0.5;
  EXPECT_THROW((void)natural_modes(system), std::invalid_argument);
  system = chain(2, 1.0, 1.0);
  system.M(1, 1) = 0.0;
  EXPECT_THROW((void)natural_modes(system), std::invalid_argument);
  for (const bool above : {true, false}) {  // a decomposition looks at one half only
    system = chain(2, 1.0, 1.0);
    (above ? system.M(0, 1) : system.M(1, 0)) += 0.25;
    EXPECT_THROW((void)natural_modes(system), std::invalid_argument);
  }
  system = chain(2, 1.0, 1.0);
  system.C.resize(1, 1);
  EXPECT_THROW((void)natural_modes(system), std::invalid_argument);
}

TEST(DampedModes, OfOneMassAreTheRootsOfItsTrinomial) {
  for (const double damping : {0.0, 1.0, 6.0, 25.0}) {
    LinearSystem system = chain(1, 2.0, 9.0);  // 2 x'' + c x' + 18 x
    system.C(0, 0) = damping;
    const std::complex<double> root = std::sqrt(std::complex<double>(damping * damping - 4 * 2 * 18));
    const std::complex<double> slow = damping > 12 ? (-damping + root) / 4.0 : (-damping - root) / 4.0;
    const auto modes = damped_modes(system);
    ASSERT_EQ(modes.size(), 2U);
    EXPECT_NEAR(modes[0].eigenvalue.real(), slow.real(), 20 * rounding);
    EXPECT_NEAR(std::abs(modes[0].eigenvalue.imag()), std::abs(slow.imag()), 20 * rounding);
    if (damping < 12) {
      EXPECT_GT(modes[0].eigenvalue.imag(), 0.0);
      EXPECT_NEAR(modes[0].damping_ratio(), damping / (2 * std::sqrt(18.0 * 2.0)), 10 * rounding);
    }
  }
}

// x'' − 2Ω y' + (a − Ω²) x = 0, y'' + 2Ω x' + (b − Ω²) y = 0: μ⁴ − (a + b + 2Ω²) μ² + (a − Ω²)(b − Ω²) = 0 for λ = iμ.
TEST(DampedModes, OfAGyroscopicSystemArePurelyImaginary) {
  const double a = 3.0, b = 8.0, turn = 1.2, square = turn * turn;
  const LinearSystem system = rotating_mass(a, b, turn);
  const double half = 0.5 * (a + b + 2 * square);
  const double root = std::sqrt(half * half - (a - square) * (b - square));
  const auto modes = damped_modes(system);
  ASSERT_EQ(modes.size(), 4U);
  EXPECT_NEAR(modes[0].angular_frequency(), std::sqrt(half - root), 50 * rounding);
  EXPECT_NEAR(modes[2].angular_frequency(), std::sqrt(half + root), 50 * rounding);
  for (const DampedMode& mode : modes) EXPECT_NEAR(mode.eigenvalue.real(), 0.0, 50 * rounding);
}

// Sum and product of the roots are -tr(M⁻¹C) and det K / det M; each mode solves its equation.
TEST(DampedModes, KeepTheInvariantsOfAnySystem) {
  for (int seed = 1; seed <= 20; ++seed) {
    LinearSystem system = random_system(4, seed);
    system.C = random_matrix(4, seed + 100);
    system.K += 0.5 * random_matrix(4, seed + 200);
    std::complex<double> sum = 0.0, product = 1.0;
    for (const DampedMode& mode : damped_modes(system)) {
      sum += mode.eigenvalue;
      product *= mode.eigenvalue;
      const std::complex<double> s = mode.eigenvalue;
      const Eigen::VectorXcd rest =
          s * s * (system.M * mode.shape) + s * (system.C * mode.shape) + system.K * mode.shape;
      EXPECT_LE(rest.norm(), 1e-12 * (std::norm(s) * system.M.norm() + system.K.norm()) * mode.shape.norm());
      EXPECT_LE(mode.residual, 1e-13);
    }
    const double trace = (inverse(system.M) * system.C).trace();
    EXPECT_NEAR(sum.real(), -trace, 1e-12 * (1 + std::abs(trace)));
    const double expected = determinant(system.K) / determinant(system.M);
    EXPECT_NEAR(product.real(), expected, 1e-11 * (1 + std::abs(expected)));
  }
}

TEST(NaturalModes, OfSoftDirectionsAreNotFreeBesideStiffOnes) {
  const LinearSystem system{Eigen::MatrixXd::Identity(3, 3), Eigen::MatrixXd::Zero(3, 3),
                            Eigen::Vector3d(4.0, 10.0, 1e16).asDiagonal(), Eigen::VectorXd::Zero(3)};
  const NaturalModes modes = natural_modes(system);
  EXPECT_NEAR(modes.angular_frequency(0), 2.0, 4 * rounding);
  EXPECT_NEAR(modes.angular_frequency(1), std::sqrt(10.0), 8 * rounding);
}

TEST(ProportionalDamping, IsRecognisedWithItsTwoFactors) {
  LinearSystem system = random_system(5, 7);
  system.C = 0.3 * system.M + 0.02 * system.K;
  const ProportionalDamping found = proportional_damping(system);
  EXPECT_NEAR(found.alpha, 0.3, 1e-12);
  EXPECT_NEAR(found.beta, 0.02, 1e-12);
  EXPECT_LE(found.residual, 1e-12);
  const NaturalModes modes = natural_modes(system);
  const ModalDamping damping = modal_damping(modes, system.C);
  EXPECT_LE(damping.coupling, 1e-12);
  for (int k = 0; k < 5; ++k) {  // ζ = α / 2ω + β ω / 2
    const double omega = modes.angular_frequency(k);
    EXPECT_NEAR(damping.ratios(k), 0.15 / omega + 0.01 * omega, 1e-12);
  }
}

TEST(ProportionalDamping, IsDeniedWithWhatRemains) {
  LinearSystem system = chain(3, 1.0, 1.0);
  system.C(0, 0) = 1.0;  // a damper on the first mass only: off K and M, and it couples the modes
  EXPECT_GT(proportional_damping(system).residual, 0.3);
  EXPECT_GT(modal_damping(natural_modes(system), system.C).coupling, 0.3);
  // C = K M⁻¹ K leaves modes uncoupled (Caughey) without being proportional.
  system.C = system.K * inverse(system.M) * system.K;
  EXPECT_GT(proportional_damping(system).residual, 0.05);
  EXPECT_LE(modal_damping(natural_modes(system), system.C).coupling, 1e-13);
}

TEST(ProportionalDamping, OfASingleMassIsItsMassTerm) {
  LinearSystem system = chain(1, 2.0, 3.0);
  system.C(0, 0) = 4.0;
  const ProportionalDamping found = proportional_damping(system);
  EXPECT_NEAR(found.alpha, 2.0, rounding * 2);
  EXPECT_EQ(found.beta, 0.0);
}

}  // namespace
}  // namespace modes_test
