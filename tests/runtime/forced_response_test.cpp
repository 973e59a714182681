// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/forced_response.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/small_motions/fourier_series.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "tests/runtime/linear_systems.hpp"

namespace forced_response_test {
namespace {

using namespace torsor::runtime;
using namespace linear_systems;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double rounding = 1e-14;

LinearSystem oscillator(double zeta) {
  LinearSystem system = undamped(MatrixXd::Identity(1, 1), MatrixXd::Identity(1, 1));
  system.C(0, 0) = 2 * zeta;
  return system;
}

TEST(FrequencyResponse, OfOneMassIsTheTextbookFunction) {
  for (const double zeta : {0.01, 0.3, 2.0}) {
    const FrequencyResponse response(oscillator(zeta), VectorXcd::Constant(1, 1.0));
    for (const double r : {0.0, 0.5, 1.0, 3.0}) {
      const Complex expected = 1.0 / Complex(1 - r * r, 2 * zeta * r);
      const auto amplitude = response(r);
      ASSERT_TRUE(amplitude);
      EXPECT_LE(std::abs((*amplitude)(0) - expected), 10 * rounding * std::abs(expected) / std::min(1.0, zeta));
    }
  }
}

TEST(FrequencyResponse, HasNoSteadyMotionAtAnUndampedResonance) {
  const auto curve = resonance_curve(oscillator(0.0), VectorXcd::Constant(1, 1.0), {0.5, 1.0, 2.0});
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_TRUE(curve[0].amplitude && curve[2].amplitude);
  EXPECT_FALSE(curve[1].amplitude);
  EXPECT_NEAR((*curve[2].amplitude)(0).real(), -1.0 / 3.0, rounding);
}

TEST(FrequencyResponse, LeavesTheTunedMassOfThePublishedAbsorberStill) {
  const FrequencyResponse response(absorber(), Eigen::Vector2cd(1, 0));
  const auto amplitude = response(10.0);
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(std::abs((*amplitude)(0)), 0.0, rounding);
  EXPECT_NEAR((*amplitude)(1).real(), -0.1, rounding);
}

// Den Hartog: at the two fixed points the amplitude does not depend on the damping; with the tuning 1/(1+mu) both have
// the height sqrt(1 + 2/mu), at r² = (1 ± sqrt(mu/(2+mu)))/(1+mu).
TEST(FrequencyResponse, PassesThroughDenHartogsFixedPointsWhateverTheDamping) {
  const double mu = 0.1, tuning = 1.0 / (1.0 + mu), height = 4.582575694955840006588047;
  for (const double zeta : {0.05, 0.1678520331536355446376009, 0.6}) {
    LinearSystem system = undamped(Eigen::Vector2d(1, mu).asDiagonal(), MatrixXd::Zero(2, 2));
    const double k = mu * tuning * tuning, c = 2 * zeta * mu;  // m1 = k1 = 1; zeta refers to 2 m2 sqrt(k1/m1)
    system.K << 1 + k, -k, -k, k;
    system.C << c, -c, -c, c;
    const FrequencyResponse response(system, Eigen::Vector2cd(1, 0));
    for (const double sign : {-1.0, 1.0}) {
      const double r = std::sqrt((1.0 + sign * std::sqrt(mu / (2.0 + mu))) / (1.0 + mu));
      EXPECT_NEAR(std::abs((*response(r))(0)), height, 1e-12 * height);
    }
  }
}

TEST(ResonancePeaks, OfOneMassAreWhereTheTextbookHasThem) {
  const double zeta = 0.2;
  const auto peaks = resonance_peaks(oscillator(zeta), VectorXcd::Constant(1, 1.0), {.from = 0.1, .to = 3.0, .samples = 100});
  ASSERT_EQ(peaks.size(), 1U);
  // A maximum is known to the square root of rounding.
  EXPECT_NEAR(peaks[0].angular_frequency, std::sqrt(1 - 2 * zeta * zeta), 1e-7);
  EXPECT_NEAR(peaks[0].amplitude, 1 / (2 * zeta * std::sqrt(1 - zeta * zeta)), 1e-12);
  EXPECT_TRUE(resonance_peaks(oscillator(0.8), VectorXcd::Constant(1, 1.0), {.from = 0.01, .to = 3.0}).empty());
}

TEST(Antiresonances, OfTheAbsorberIsItsOwnFrequency) {
  const std::vector<double> still = antiresonances(absorber(), Eigen::Vector2d(1, 0), 0);
  ASSERT_EQ(still.size(), 1U);
  EXPECT_NEAR(still[0], 10.0, 100 * rounding);
  EXPECT_TRUE(antiresonances(absorber(), Eigen::Vector2d(1, 0), 1).empty());  // X2 = k2 F / det never vanishes
  EXPECT_THROW((void)antiresonances(absorber(), Eigen::Vector2d(1, 0), 2), std::invalid_argument);
}

// A mass that is driven stands still at the frequencies of what remains when it is held.
TEST(Antiresonances, OfADrivenMassAreTheFrequenciesOfTheOthersWithItHeld) {
  for (int seed = 1; seed <= 10; ++seed) {
    const LinearSystem system = random_system(5, seed);
    const NaturalModes held =
        natural_modes(undamped(system.M.bottomRightCorner(4, 4), system.K.bottomRightCorner(4, 4)));
    const std::vector<double> still = antiresonances(system, VectorXd::Unit(5, 0), 0);
    ASSERT_EQ(still.size(), 4U);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(still[static_cast<std::size_t>(k)], held.angular_frequency(k), 1e-11 * held.angular_frequency(3));
    }
  }
}

TEST(FourierSeries, OfATrigonometricPolynomialIsExact) {
  const double omega = 2.0;
  // 1 + 3 cos 2ωt − 4 sin 5ωt: c0 = 1, c2 = 3/2, c5 = 2 i.
  const FourierSeries series = fourier_series(
      [omega](double t) {
        return VectorXd::Constant(1, 1 + 3 * std::cos(2 * omega * t) - 4 * std::sin(5 * omega * t));
      },
      omega, 6, 32);
  ASSERT_EQ(series.coefficients.size(), 7U);
  const std::array<Complex, 7> expected{1, 0, 1.5, 0, 0, Complex(0, 2), 0};
  for (std::size_t n = 0; n < 7; ++n) EXPECT_LE(std::abs(series.coefficients[n](0) - expected[n]), 2 * rounding) << n;
  EXPECT_NEAR(series(0.37)(0), 1 + 3 * std::cos(1.48) - 4 * std::sin(3.7), 10 * rounding);
}

// The coefficients of exp(cos ωt) are Bessel functions I_n(1); Abramowitz & Stegun, table 9.8: I_0, I_1, I_2.
TEST(FourierSeries, OfASmoothFunctionConvergesToItsCoefficients) {
  const FourierSeries series =
      fourier_series([](double t) { return VectorXd::Constant(1, std::exp(std::cos(3 * t))); }, 3.0, 8, 64);
  EXPECT_NEAR(series.coefficients[0](0).real(), 1.26606587775200833560, 2 * rounding);
  EXPECT_NEAR(series.coefficients[1](0).real(), 0.56515910399248502721, 2 * rounding);
  EXPECT_NEAR(series.coefficients[2](0).real(), 0.13574766976703828118, 2 * rounding);
}

// The course prints e^{i n ω_i t} with the mode's own frequency: at that frequency nothing is steady. The exponent is
// the forcing's. Integrated from the start that the series names, the motion comes back after a period of the forcing.
TEST(PeriodicResponse, HasThePeriodOfTheForcing) {
  const double omega = 1.7;
  const LinearSystem system = [] {
    LinearSystem result = absorber();
    result.C = 0.01 * result.K;
    return result;
  }();
  const auto force = [omega](double t) { return Eigen::Vector2d(std::exp(std::sin(omega * t)), std::cos(omega * t)); };
  const auto response = periodic_response(system, fourier_series(force, omega, 24, 128));
  ASSERT_TRUE(response);
  FourierSeries rate = *response;
  for (std::size_t n = 0; n < rate.coefficients.size(); ++n) {
    rate.coefficients[n] *= Complex(0, static_cast<double>(n) * omega);
  }
  const MatrixXd inverse = linear_systems::inverse(system.M);
  const auto motion = [&](double t, const std::array<double, 4>& y, std::array<double, 4>& dydt) {
    const Eigen::Vector2d x(y[0], y[1]), v(y[2], y[3]);
    const Eigen::Vector2d a = inverse * (force(t) - system.C * v - system.K * x);
    dydt = {v(0), v(1), a(0), a(1)};
    return Evaluation::ok;
  };
  const VectorXd x0 = (*response)(0.0), v0 = rate(0.0);
  std::array<double, 4> y{x0(0), x0(1), v0(0), v0(1)};
  for (const double t : {0.3, 0.5, 1.0}) {  // of a period
    std::array<double, 4> end = y;
    const double time = t * 2 * std::numbers::pi / omega;
    const auto result =
        integrate(motion, end, 0.0, time, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    ASSERT_TRUE(result) << describe(result);
    const VectorXd expected = (*response)(time);
    // Local errors of 1e-12 over some hundred steps; the series is truncated below 1e-20.
    EXPECT_NEAR(end[0], expected(0), 1e-10);
    EXPECT_NEAR(end[1], expected(1), 1e-10);
  }
  EXPECT_GT(((*response)(0.0) - (*response)(2 * std::numbers::pi / 8.5430895)).norm(), 1e-3);
}

// x'' + x' + x = 5 + sin t: x = 5 - cos t.
TEST(PeriodicResponse, CountsTheForceOfTheSystem) {
  const MatrixXd one = MatrixXd::Identity(1, 1);
  const LinearSystem system{one, one, one, VectorXd::Constant(1, 5.0)};
  const FourierSeries push = fourier_series([](double t) { return VectorXd::Constant(1, std::sin(t)); }, 1.0, 3);
  const auto response = periodic_response(system, push);
  ASSERT_TRUE(response);
  EXPECT_NEAR((*response)(0.0)(0), 4.0, 100 * rounding);
  EXPECT_NEAR((*response)(1.0)(0), 5.0 - std::cos(1.0), 100 * rounding);
  const auto still = periodic_response(system, {1.0, {}});
  ASSERT_TRUE(still);
  EXPECT_NEAR((*still)(0.3)(0), 5.0, 100 * rounding);
  EXPECT_FALSE(periodic_response({one, one, MatrixXd::Zero(1, 1), VectorXd::Constant(1, 5.0)}, push));
  EXPECT_THROW((void)periodic_response({one, one, one, VectorXd::Zero(2)}, push), std::invalid_argument);
}

// x'' + 4 x = sin t has x = 1/3 sin t: rounding of the samples is no force at the resonance 2.
TEST(PeriodicResponse, TakesNoRoundingForAForce) {
  for (const int samples : {16, 1024}) {
    const FourierSeries push =
        fourier_series([](double t) { return VectorXd::Constant(1, std::sin(t)); }, 1.0, 3, samples);
    for (const std::size_t n : {0U, 2U, 3U}) EXPECT_EQ(push.coefficients[n](0), Complex(0, 0)) << n;
    const auto response = periodic_response(undamped(MatrixXd::Identity(1, 1), MatrixXd::Constant(1, 1, 4.0)), push);
    ASSERT_TRUE(response);
    EXPECT_NEAR((*response)(1.0)(0), std::sin(1.0) / 3, 100 * rounding);
  }
  // A harmonic of 1e-12 of the largest is one.
  const FourierSeries small = fourier_series(
      [](double t) { return VectorXd::Constant(1, std::sin(t) + 2e-12 * std::cos(2 * t)); }, 1.0, 3);
  EXPECT_NEAR(small.coefficients[2](0).real(), 1e-12, 100 * rounding);
}

// The rest about which a system is linearised is known to rounding: what it leaves in F is no force.
TEST(PeriodicResponse, TakesWhatIsLeftOfABalanceForNoForce) {
  LinearSystem chain{Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Zero(2, 2), Eigen::Matrix2d::Zero(), Eigen::VectorXd::Zero(2)};
  chain.K << 1, -1, -1, 1;
  const FourierSeries pull{1.0, {Eigen::Vector2cd::Zero(), Eigen::Vector2cd(1.0, -1.0)}};
  chain.F = Eigen::Vector2d(1e-17, 0.0);
  EXPECT_TRUE(periodic_response(chain, pull));
  chain.F = Eigen::Vector2d(1e-3, 0.0);
  EXPECT_FALSE(periodic_response(chain, pull));
}

TEST(PeriodicResponse, DoesNotExistWhenAHarmonicMeetsAnUndampedMode) {
  const auto third = [](double t) { return VectorXd::Constant(1, std::cos(t) + std::cos(3 * t)); };
  const LinearSystem system = undamped(MatrixXd::Identity(1, 1), MatrixXd::Constant(1, 1, 9.0));
  FourierSeries series = fourier_series(third, 1.0, 3, 16);
  EXPECT_FALSE(periodic_response(system, series));
  series.coefficients[3].setZero();
  ASSERT_TRUE(periodic_response(system, series));
  EXPECT_NEAR((*periodic_response(system, series))(0.0)(0), 1.0 / 8.0, 10 * rounding);
}

// x'' + 2 ζ x' + x = f: the largest amplitude is at sqrt(1 - 2 ζ²), left or right of the highest of the samples. A
// maximum is flat: it is known to the root of rounding.
TEST(ResonancePeaks, AreFoundOnEitherSideOfTheHighestSample) {
  const double damping = 0.1;
  const LinearSystem system{Eigen::MatrixXd::Identity(1, 1), Eigen::MatrixXd::Constant(1, 1, 2 * damping),
                            Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXd::Zero(1)};
  for (const double shift : {-0.05, -0.02, 0.0, 0.02, 0.05}) {
    const auto peaks = resonance_peaks(system, Eigen::VectorXcd::Ones(1), {.from = 0.5 + shift, .to = 1.5 + shift, .samples = 11});
    ASSERT_EQ(peaks.size(), 1U);
    EXPECT_NEAR(peaks[0].angular_frequency, std::sqrt(1 - 2 * damping * damping), 1e-7) << shift;
  }
}

// A resonance 1e-5 rad/s wide at 1,000 rad/s, looked for in an interval of which 1e-9 is less than the spacing of doubles.
TEST(ResonancePeaks, AreFoundInANarrowIntervalFarFromZero) {
  const double omega = 1000.00005;
  const LinearSystem system{Eigen::MatrixXd::Identity(1, 1), Eigen::MatrixXd::Constant(1, 1, 1e-5),
                            Eigen::MatrixXd::Constant(1, 1, omega * omega), Eigen::VectorXd::Zero(1)};
  for (const double range : {1e-4, 1e-5}) {
    const auto peaks = resonance_peaks(
        system, Eigen::VectorXcd::Ones(1), {.from = omega - range / 2, .to = omega + 0.47 * range, .samples = 50});
    ASSERT_FALSE(peaks.empty());
    EXPECT_NEAR(peaks[0].angular_frequency, omega, 1e-6);
  }
}

// x'' + 4 x = cos, seen on a grid that has 2, and between its points.
TEST(ResonancePeaks, AreInfiniteWhereAnUndampedResonanceIsMet) {
  const LinearSystem system = undamped(MatrixXd::Identity(1, 1), MatrixXd::Constant(1, 1, 4.0));
  const auto peaks = resonance_peaks(system, Eigen::VectorXcd::Ones(1), {.from = 0.0, .to = 4.0, .samples = 1001});
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_EQ(peaks[0].angular_frequency, 2.0);
  EXPECT_TRUE(std::isinf(peaks[0].amplitude));
}

// Two oscillators that know nothing of each other: at the second one's own frequency the first stands still no more
// than elsewhere. Tied by a weak spring it does.
TEST(Antiresonances, AreNotFrequenciesOfWhatIsNotTied) {
  LinearSystem system{Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Zero(2, 2),
                      Eigen::Vector2d(1.0, 4.0).asDiagonal(), Eigen::VectorXd::Zero(2)};
  EXPECT_TRUE(antiresonances(system, Eigen::Vector2d(1.0, 0.0), 0).empty());
  system.K(0, 1) = system.K(1, 0) = -0.1;
  const auto tied = antiresonances(system, Eigen::Vector2d(1.0, 0.0), 0);
  ASSERT_EQ(tied.size(), 1U);
  EXPECT_NEAR(tied[0], 2.0, 1e-13);
}

}  // namespace
}  // namespace forced_response_test
