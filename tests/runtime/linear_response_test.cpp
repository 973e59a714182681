// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/linear_response.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/numerics/matrix_exponential.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "tests/runtime/linear_systems.hpp"

namespace linear_response_test {
namespace {

using namespace torsor::runtime;
using namespace linear_systems;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd one(double value) { return VectorXd::Constant(1, value); }

LinearSystem oscillator(double c, double k) {
  LinearSystem system = undamped(MatrixXd::Identity(1, 1), MatrixXd::Constant(1, 1, k));
  system.C(0, 0) = c;
  return system;
}

// The exponential errs by some ‖A‖ t roundings, A t of the size of 10 to 20 here.
constexpr double tolerance = 1e-13;

TEST(MatrixExponential, OfARotationAndOfANilpotentMatrixIsExact) {
  MatrixXd turn(2, 2);
  turn << 0, -1, 1, 0;
  const MatrixXd turned = matrix_exponential(20.0 * turn);
  EXPECT_NEAR(turned(0, 0), std::cos(20.0), tolerance);
  EXPECT_NEAR(turned(1, 0), std::sin(20.0), tolerance);
  MatrixXd shift = MatrixXd::Zero(3, 3);
  shift(0, 1) = shift(1, 2) = 1.0;
  EXPECT_NEAR(matrix_exponential(3.0 * shift)(0, 2), 4.5, tolerance);
  EXPECT_LE((matrix_exponential(MatrixXd::Zero(2, 2)) - MatrixXd::Identity(2, 2)).norm(), 1e-15);
  EXPECT_THROW((void)matrix_exponential(MatrixXd::Zero(2, 3)), std::invalid_argument);
}

TEST(LinearResponse, OfADampedMassReleasedIsTheTextbookOne) {
  for (const double t : {0.0, 0.3, 2.0, 10.0}) {
    // ζ = 0.2, ω0 = 2
    const double decay = 0.4, omega = std::sqrt(4.0 - decay * decay);
    const auto under = LinearResponse(oscillator(0.8, 4.0), one(1), one(0)).at(t);
    EXPECT_NEAR(under.x(0), std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)),
                tolerance);
    EXPECT_NEAR(under.v(0), -4.0 / omega * std::exp(-decay * t) * std::sin(omega * t), 2 * tolerance);
    // Critical damping: a double root, one eigenvector.
    const auto critical = LinearResponse(oscillator(4.0, 4.0), one(1), one(0)).at(t);
    EXPECT_NEAR(critical.x(0), std::exp(-2.0 * t) * (1.0 + 2.0 * t), tolerance);
    // Over: roots -1 and -4.
    const auto over = LinearResponse(oscillator(5.0, 4.0), one(0), one(3)).at(t);
    EXPECT_NEAR(over.x(0), std::exp(-t) - std::exp(-4.0 * t), tolerance);
  }
}

TEST(LinearResponse, ToAStepOvershootsByTheTextbookAmount) {
  const double zeta = 0.1, omega = std::sqrt(1.0 - zeta * zeta);
  const LinearResponse response(oscillator(2 * zeta, 1.0), one(0), one(0), {.constant = one(3)});
  const double peak = std::numbers::pi / omega;
  EXPECT_NEAR(response.at(peak).x(0), 3.0 * (1.0 + std::exp(-zeta * peak)), 3 * tolerance);
  EXPECT_NEAR(response.at(peak).v(0), 0.0, 3 * tolerance);
}

TEST(LinearResponse, GrowsWithTimeAtResonance) {
  const LinearResponse response(oscillator(0, 1), one(0), one(0), {.cosine = one(1), .angular_frequency = 1.0});
  for (const double t : {0.5, 3.0, 12.0}) EXPECT_NEAR(response.at(t).x(0), 0.5 * t * std::sin(t), 10 * tolerance);
}

TEST(LinearResponse, OfAFreeMassUnderAConstantForceIsAFall) {
  LinearSystem system = undamped(MatrixXd::Constant(1, 1, 2.0), MatrixXd::Zero(1, 1));
  system.F(0) = 6.0;  // the force that the linearisation left, 4 N more from outside
  const auto end = LinearResponse(system, one(1), one(-2), {.constant = one(4)}).at(3.0);
  EXPECT_NEAR(end.x(0), 1.0 - 6.0 + 0.5 * 5.0 * 9.0, 20 * tolerance);
  EXPECT_NEAR(end.v(0), -2.0 + 15.0, 20 * tolerance);
}

// Each mode of the undamped chain under F cos ωt: ε = (p / (ω_i² − ω²)) (cos ωt − cos ω_i t), p = q_iᵀ F.
TEST(LinearResponse, IsTheSuperpositionOfTheModes) {
  const LinearSystem system = chain(4, 1.5, 7.0);
  const VectorXd force = Eigen::Vector4d(1, 0, -2, 0.5);
  const double omega = 1.3;
  const NaturalModes modes = natural_modes(system);
  const LinearResponse response(system, VectorXd::Zero(4), VectorXd::Zero(4),
                                {.cosine = force, .angular_frequency = omega});
  for (const double t : {0.4, 2.0, 5.0}) {
    VectorXd sum = VectorXd::Zero(4);
    for (int k = 0; k < 4; ++k) {
      const double own = modes.angular_frequency(k);
      const double load = modes.shapes.col(k).dot(force) / (own * own - omega * omega);
      sum += modes.shapes.col(k) * load * (std::cos(omega * t) - std::cos(own * t));
    }
    EXPECT_LE((response.at(t).x - sum).norm(), 20 * tolerance);
  }
}

// Damping, gyroscopic terms and a stiffness that is not symmetric, against an integration whose tolerance is 1e-13.
TEST(LinearResponse, AgreesWithAnIntegrationOfAnyLinearSystem) {
  LinearSystem system = random_system(2, 3);
  system.C = random_matrix(2, 11) + MatrixXd::Identity(2, 2);
  system.K(0, 1) += 0.4;
  const Eigen::Vector2d constant(0.3, -1), cosine(1, 2), sine(-0.5, 0.25), x0(0.1, 0.2), v0(-1, 1);
  const double omega = 2.2;
  const MatrixXd inverse = linear_systems::inverse(system.M);
  const auto motion = [&](double t, const std::array<double, 4>& y, std::array<double, 4>& dydt) {
    const Eigen::Vector2d x(y[0], y[1]), v(y[2], y[3]);
    const Eigen::Vector2d a =
        inverse * (constant + cosine * std::cos(omega * t) + sine * std::sin(omega * t) - system.C * v - system.K * x);
    dydt = {v(0), v(1), a(0), a(1)};
    return Evaluation::ok;
  };
  std::array<double, 4> y{x0(0), x0(1), v0(0), v0(1)};
  const auto result =
      integrate(motion, y, 0.0, 3.0, DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
  ASSERT_TRUE(result) << describe(result);
  const auto end =
      LinearResponse(system, x0, v0, {.constant = constant, .cosine = cosine, .sine = sine, .angular_frequency = omega})
          .at(3.0);
  const double size = 1.0 + std::abs(y[0]) + std::abs(y[1]) + std::abs(y[2]) + std::abs(y[3]);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(end.x(i), y[static_cast<std::size_t>(i)], 1e-11 * size);  // 1e-13 a step, some hundred steps
    EXPECT_NEAR(end.v(i), y[static_cast<std::size_t>(i) + 2], 1e-11 * size);
  }
}

TEST(LinearResponse, RefusesVectorsOfAnotherSize) {
  EXPECT_THROW(LinearResponse(chain(2, 1, 1), one(0), VectorXd::Zero(2)), std::invalid_argument);
  EXPECT_THROW(LinearResponse(chain(2, 1, 1), VectorXd::Zero(2), VectorXd::Zero(2), {.sine = one(1)}),
               std::invalid_argument);
}

}  // namespace
}  // namespace linear_response_test
