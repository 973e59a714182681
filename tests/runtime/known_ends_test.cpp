// SPDX-License-Identifier: GPL-3.0-or-later
// Motions whose ends are known to 30 digits (extrapolation of order 32 with 72 digits, two step sizes agreeing to
// 1e-34), as plain right-hand sides and by a generated header; and what Runge-Kutta 4 is known to lose over long runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace known_ends_test {
namespace {

using namespace torsor::runtime;
constexpr double g = 9.81;

template <class Method>
Method of_tolerance(double tolerance, Method method = {}) {
  method.relative_tolerance = tolerance;
  method.absolute_tolerance = tolerance;
  return method;
}

template <std::size_t size>
double largest_difference(const std::array<double, size>& a, const std::array<double, size>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

template <class System, std::size_t size, class Method>
double error_at_end(const System& system, std::array<double, size> y, double time, const Method& method,
                    const std::array<double, size>& end) {
  const auto result = integrate(system, y, 0.0, time, method);
  EXPECT_TRUE(result) << describe(result);
  return largest_difference(y, end);
}

using State = std::array<double, 4>;
const State mild{0.75, 0.5, 0.0, 0.0};
const State end_of_mild{2.875846664665684478653768910960e-02, -3.14591990168469073955176124159e-01,
                        1.816638635026446881379475521071e+00, 1.166381986603743572564266177165e+00};

// κ = 15: a rounding of the state at the start moves the end by 15 × 1.1e-16 = 1.7e-15. What is best is a matter of luck:
// of sixteen tolerances several are.
TEST(DoublePendulumFromSmallAngles, IsKnownToRoundingByTaylorsMethod) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  double smallest = 1.0;
  for (int i = 0; i < 16; ++i) {
    const auto method = of_tolerance(std::pow(10.0, -13.5 - 0.1 * i), Taylor{.compensated = true});
    smallest = std::min(smallest, error_at_end(motion, mild, 10, method, end_of_mild));
  }
  EXPECT_LE(smallest, 2e-15);
}

TEST(DoublePendulumFromSmallAngles, IsKnownToATenThousandthOfABillionthByTheOthers) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  EXPECT_LE(error_at_end(motion, mild, 10, of_tolerance<DormandPrince853>(1e-13), end_of_mild), 100 * 1e-13 * 15);
  EXPECT_LE(error_at_end(motion, mild, 10, of_tolerance<DormandPrince54>(1e-11), end_of_mild), 100 * 1e-11 * 15);
}

// κ = 2.9e8: the start's roundings alone move the end by 3e-8.
TEST(DoublePendulumThatTurnsOver, IsKnownAsFarAsItsAmplificationAllows) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  const State end{-7.53128874294912389398266804858e-01, 1.627933082053701835561177617174e+00,
                  -4.08736885134418806501939800498e+00, -8.86970257838753173566782985360e+00};
  EXPECT_LE(error_at_end(motion, State{2.0, 2.5, 0, 0}, 10, of_tolerance(1e-15, Taylor{.compensated = true}), end),
            3e-6);
  EXPECT_LE(error_at_end(motion, State{2.0, 2.5, 0, 0}, 10, of_tolerance<DormandPrince853>(1e-14), end), 3e-4);
}

// At rest with both rods horizontal, κ = 9.4e5: at every tolerance the end is right or a status says that it is not.
const State end_of_horizontal_rods{0.7487609755149033159515944895772, -25.8324619988856107490477082164,
                                   4.078003969273397255604108576893, 2.779889455355823245354899486589};

// A refusal is right only outside of 1e-4 to 1e-11: above, steps as long as the motion's own periods may not converge,
// and below, roundings of the stages may hide the error that is asked for.
template <class Method>
void expect_right_or_failed(const Method& method, double tolerance) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  State y{1.5707963267948966, 1.5707963267948966, 0.0, 0.0};
  const auto result = integrate(motion, y, 0, 20, method);
  if (!result) {
    EXPECT_TRUE(tolerance > 2e-4 || tolerance < 5e-12) << tolerance << ": " << describe(result);
    return;
  }
  EXPECT_LE(largest_difference(y, end_of_horizontal_rods), 100 * tolerance * 9.4e5) << tolerance;
  double_pendulum::Mechanism<double>::Energy e{};
  double_pendulum::Mechanism<double>::energy(motion.precomputed(), unpack<double_pendulum::Mechanism<double>>(0.0, y),
                                             {}, e);
  EXPECT_LE(std::abs(e.kinetic - e.force_function), 1e4 * tolerance * 3 * g) << tolerance;
}

TEST(HorizontalRods, MisleadNeitherImplicitMethodsNorCompensatedOnes) {
  for (int digits = 3; digits <= 15; ++digits) {
    const double tolerance = std::pow(10.0, -digits);
    expect_right_or_failed(of_tolerance(tolerance, Taylor{.compensated = true}), tolerance);
    expect_right_or_failed(of_tolerance(tolerance, DormandPrince853{.compensated = true}), tolerance);
    expect_right_or_failed(of_tolerance(tolerance, DormandPrince54{.compensated = true}), tolerance);
    if (digits <= 13) expect_right_or_failed(of_tolerance<RadauIia5>(tolerance), tolerance);
  }
}

// The same by the structure-preserving ones, which have a step in place of a tolerance. With 50 ms the variational
// integrator of order 6 is off by the motion's size, 8; two halvings later by 8 / 2^12, and after one more by 2^6 times
// less, doubled for the terms of higher order. Störmer-Verlet needs a constant mass matrix, and must say so.
TEST(HorizontalRods, MisleadNoMethodOfFixedStep) {
  const State start{1.5707963267948966, 1.5707963267948966, 0.0, 0.0};
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  const double coarse =
      error_at_end(motion, start, 20, VariationalIntegrator<3>{.step = 0.0125}, end_of_horizontal_rods);
  const double fine =
      error_at_end(motion, start, 20, VariationalIntegrator<3>{.step = 0.00625}, end_of_horizontal_rods);
  EXPECT_LE(coarse, 8.0 / 4096);
  EXPECT_LE(fine, coarse / 32);
  State y = start;
  EXPECT_EQ(integrate(motion, y, 0.0, 20.0, StoermerVerlet{.step = 0.01}).status, IntegrationStatus::unsuitable_model);
}

// Heavy symmetric top in Euler's angles, I1 = 5/16 and I3 = 1/8 about the point, m g l = 4.905: p_φ and p_ψ are
// constant, the rest by Lagrange's equations. y = (φ, θ, ψ, rates).
constexpr auto top = [](double, const std::array<double, 6>& y, std::array<double, 6>& rate) noexcept {
  constexpr double I1 = 5.0 / 16.0, I3 = 1.0 / 8.0, moment = 4.905;
  const double s = std::sin(y[1]), c = std::cos(y[1]), phi = y[3], theta = y[4], psi = y[5];
  const double spin = psi + phi * c;  // constant
  const double turning = (I3 * spin * theta - 2 * I1 * phi * theta * c) / (I1 * s);
  rate = {phi,
          theta,
          psi,
          turning,
          (I1 * phi * phi * s * c - I3 * spin * phi * s + moment * s) / I1,
          phi * theta * s - turning * c};
  return Evaluation::ok;
};

// κ = 61: an angle of 451 rad is rounded to 5.7e-14.
TEST(HeavyTopInEulersAngles, IsKnownToTheRoundingOfItsAngles) {
  const std::array<double, 6> end{3.793810884914525621687350693649e+01, 7.357482475581846787198325020808e-01,
                                  4.512030912771534084738916309643e+02, 2.903961860301357099111870416440e+00,
                                  6.919473781420158643078299803087e-01, 2.184720949524797180285342147738e+01};
  double smallest = 1.0;
  for (const double tolerance : {1e-12, 1e-13, 1e-14}) {
    smallest = std::min(smallest, error_at_end(top, {0, 0.5, 0, 0, 0, 24}, 20,
                                               of_tolerance(tolerance, DormandPrince853{.compensated = true}), end));
  }
  EXPECT_LE(smallest, 61 * 5.7e-14);
}

// Thin hoop of 0.5 m rolling without slipping, I1 = m r²/2, I3 = m r²: y = (contact x and y, heading, lean, roll, and
// the angular velocities about the horizontal diameter, the other one, the axis).
constexpr auto hoop = [](double, const std::array<double, 8>& y, std::array<double, 8>& rate) noexcept {
  constexpr double r = 0.5, I1 = r * r / 2, I3 = r * r, rolling = r * r;
  const double s = std::sin(y[3]), c = std::cos(y[3]), w1 = y[5], w2 = y[6], w3 = y[7];
  const double heading = w2 / s, roll = w3 - heading * c;
  rate = {-r * roll * std::cos(y[2]),
          -r * roll * std::sin(y[2]),
          heading,
          w1,
          roll,
          (I1 * w2 * heading * c - (I3 + rolling) * w3 * w2 - g * r * c) / (I1 + rolling),
          (I3 * w3 * w1 - I1 * w1 * heading * c) / I1,
          rolling * w1 * w2 / (I3 + rolling)};
  return Evaluation::ok;
};

// κ = 187, the roll 125 rad.
TEST(RollingHoop, IsKnownToTheRoundingOfItsAngles) {
  const std::array<double, 8> end{1.517245501846176454418182552180e+00, 2.430335916513561688873236431743e-01,
                                  1.289240563714880452852238863805e+01, 1.198036500879284288077977611736e+00,
                                  -1.24822830259631902901322118097e+02, 4.940484549289880164914979029665e-02,
                                  5.239549401600928046307087132991e-01, -6.00050263180823492805499046475e+00};
  double smallest = 1.0;
  for (const double tolerance : {1e-12, 1e-13, 1e-14}) {
    smallest = std::min(smallest, error_at_end(hoop, {0, 0, 0, 1.2, 0, 0, 0.5, -6}, 20,
                                               of_tolerance(tolerance, DormandPrince853{.compensated = true}), end));
  }
  EXPECT_LE(smallest, 187 * 1.5e-14);
}

// Five masses on rods, absolute angles: Σ_j m_ij cos(θ_i - θ_j) θ_j″ = -Σ_j m_ij sin(θ_i - θ_j) θ_j′² - m_ii g sin θ_i,
// m_ij the number of masses below both; solved by Cholesky's factors.
constexpr auto chain = [](double, const std::array<double, 10>& y, std::array<double, 10>& rate) noexcept {
  constexpr std::size_t n = 5;
  double M[n][n]{}, x[n]{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double below = static_cast<double>(n - std::max(i, j));
      M[i][j] = below * std::cos(y[i] - y[j]);
      x[i] -= below * std::sin(y[i] - y[j]) * y[n + j] * y[n + j];
    }
    x[i] -= static_cast<double>(n - i) * g * std::sin(y[i]);
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < j; ++k) M[j][j] -= M[j][k] * M[j][k];
    M[j][j] = std::sqrt(M[j][j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) M[i][j] -= M[i][k] * M[j][k];
      M[i][j] /= M[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= M[i][k] * x[k];
    x[i] /= M[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= M[k][i] * x[k];
    x[i] /= M[i][i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    rate[i] = y[n + i];
    rate[n + i] = x[i];
  }
  return Evaluation::ok;
};

TEST(FiveMassesOnRods, AreKnownToTheirAmplification) {  // κ = 8.8
  const std::array<double, 10> end{2.428906088052164758836717588356e-01, 3.601413974362733462716781134075e-01,
                                   4.672577635391160225256600968515e-01, 1.085497749276475491991736326539e+00,
                                   8.670185194143396414809006530577e-01, -2.02868529492405861057274532047e+00,
                                   -6.49147349123702533727340555823e-01, -3.74802981914805006700822089735e+00,
                                   -1.71091819211506005839701626303e+00, 4.796834959088740828264621142749e-01};
  EXPECT_LE(
      error_at_end(chain, {1.0, 1.2, 1.4, 1.6, 1.8, 0, 0, 0, 0, 0}, 5, of_tolerance<DormandPrince853>(1e-13), end),
      100 * 1e-13 * 8.8);
}

// Pendulum of 1 m from 2 rad, a million steps: what plain codes lose, four digits of it. The loss falls with h^5 a
// step.
TEST(RungeKutta4, LosesTheEnergyThatOthersFound) {
  const auto pendulum = [](double, const std::array<double, 2>& y, std::array<double, 2>& rate) noexcept {
    rate = {y[1], -g * std::sin(y[0])};
    return Evaluation::ok;
  };
  for (const auto& [step, loss] : {std::pair{0.01, -9.707e-06}, std::pair{0.005, -1.517e-07}}) {
    std::array<double, 2> y{2.0, 0.0};
    ASSERT_TRUE(integrate(pendulum, y, 0.0, 1e6 * step, RungeKutta4{.step = step}));
    const double change = y[1] * y[1] / 2 / g - std::cos(y[0]) + std::cos(2.0);
    EXPECT_NEAR(change, loss, 1e-3 * std::abs(loss) + 1e-10)
        << step;  // the figures' last digit; roundings of 1e6 steps
  }
}

// In Cartesian coordinates with the tension from the twice differentiated constraint and nothing that holds it.
TEST(RungeKutta4, LeavesTheCircleAsOthersFound) {
  const auto cartesian = [](double, const std::array<double, 4>& y, std::array<double, 4>& rate) noexcept {
    const double tension = (y[2] * y[2] + y[3] * y[3] - g * y[1]) / (y[0] * y[0] + y[1] * y[1]);
    rate = {y[2], y[3], -tension * y[0], -g - tension * y[1]};
    return Evaluation::ok;
  };
  struct Found {
    double step, time, position, velocity, energy;
  };
  for (const Found& found :
       {Found{0.01, 1, -3.485e-07, -8.153e-07, 6.233e-06}, Found{0.01, 10, -3.588e-05, -7.202e-06, 4.745e-04},
        Found{0.01, 100, -3.598e-03, -7.211e-05, 4.845e-02}, Found{0.001, 10, -3.592e-09, -7.206e-10, 4.767e-08},
        Found{0.001, 100, -3.595e-07, -7.191e-09, 4.830e-06}}) {
    std::array<double, 4> y{-1.0, 0.0, 0.0, 0.0};
    ASSERT_TRUE(integrate(cartesian, y, 0.0, found.time, RungeKutta4{.step = found.step}));
    const auto expect = [&](double value, double printed) {
      EXPECT_NEAR(value, printed, 1e-3 * std::abs(printed)) << found.step << ", " << found.time;
    };
    expect((y[0] * y[0] + y[1] * y[1] - 1) / 2, found.position);
    expect(y[0] * y[2] + y[1] * y[3], found.velocity);
    expect((y[2] * y[2] + y[3] * y[3]) / 2 + g * y[1], found.energy);
  }
}

}  // namespace
}  // namespace known_ends_test
