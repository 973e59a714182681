// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/double_pendulum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"

namespace torsor::double_pendulum_test {
namespace {

using namespace torsor::runtime;
using Pendulum = double_pendulum::Mechanism<double>;
using State = StateVector<Pendulum>;

struct Truth {
  double time;
  State y;               // theta_1, theta_2 and their rates
  double amplification;  // largest column norm of dy(t)/dy(0)
};

// Independent truth: 50-digit extrapolation of equations written by hand, confirmed in binary128 by another program.
constexpr std::array<Truth, 3> truth{{
    {1.0,
     {-0.083860420405000849725678156866, -1.31309645061392503987080693396, -4.64791767807525574632648678289,
      -4.39024103608530359320551716559},
     8.5},
    {2.0,
     {-2.92203223590754080983208427967, 0.117385172202614548573850887057, 0.910779554993410739453434226877,
      4.42695187390119794989340053402},
     16.6},
    {5.0,
     {8.19107845941450269991188172755, 0.015016920586249178599657753851, 2.56127521585709553161009827343,
      5.93171293702213475240314242024},
     2.6e3},
}};

// The tolerance that leaves truncation below the roundings that 5 s cost; the method accepts 9e-16 at the least.
constexpr DormandPrince54 tight{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14};

TEST(DoublePendulum, MeetsItsIndependentReferenceWithin1em13TimesTheAmplification) {
  const auto motion = equations_of_motion<Pendulum>();
  State y = motion.initial();
  double t = 0.0;
  for (const Truth& at : truth) {
    const auto result = integrate(motion, y, t, at.time, tight);
    ASSERT_TRUE(result) << describe(result);
    t = at.time;
    double worst = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) worst = std::fmax(worst, std::abs(y[i] - at.y[i]));
    EXPECT_LE(worst, 1e-13 * at.amplification) << "at t = " << t;
  }
}

// Both hold more than 20 digits, so both round to the same doubles.
TEST(DoublePendulum, HasACommittedReferenceThatAgreesWithTheIndependentOne) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/double_pendulum.reference.csv");
  ASSERT_EQ(reference.rows(), truth.size());
  for (std::size_t row = 0; row < truth.size(); ++row) {
    EXPECT_EQ(reference.times[row], truth[row].time);
    EXPECT_EQ(reference.state<4>(row), truth[row].y);
  }
}

// E = -2 g cos(theta_1) - g cos(theta_2) at the start, to 50 digits in the independent reference.
constexpr double start_energy = 16.0240198015703533754089510373;

double energy(double t, const State& y) {
  Pendulum::FirstIntegrals integrals{};
  Pendulum::first_integrals(Pendulum::precompute({}), unpack<Pendulum>(t, y), integrals);
  return integrals.energy;
}

// Each of some 5000 steps moves the state by at most 1e-14 (1 + |y|), |y| < 10, and the energy by that times its
// gradient, which is below 50: 3e-8 if every step erred the same way at the limit, 4e-10 if they err at random.
TEST(DoublePendulum, KeepsItsEnergy) {
  const auto motion = equations_of_motion<Pendulum>();
  State y = motion.initial();
  EXPECT_NEAR(energy(0.0, y), start_energy, 4 * 16 * 2.2e-16);  // four roundings of numbers up to 16
  double worst = 0.0;
  const auto result = integrate(motion, y, 0.0, 20.0, tight, [&](double t, const State& state) {
    worst = std::fmax(worst, std::abs(energy(t, state) - start_energy));
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(worst, 4e-10);
}

// det(K - w^2 M) = 0 at rest has the roots w^2 = (2 -+ sqrt 2) g for unit masses and lengths.
TEST(DoublePendulum, HasTheKnownSmallOscillations) {
  Pendulum::Linearisation linear{};
  ASSERT_EQ(Pendulum::linearisation(Pendulum::precompute({}), {}, {}, {}, {}, linear), torsor::Status::ok);
  for (const double frequency : {2.3971993978640862263467331852, 5.78735129803609402671716504514}) {
    std::array<double, 4> a{};
    for (std::size_t i = 0; i < 4; ++i) a[i] = linear.K[i] - frequency * frequency * linear.M[i];
    // Products of two numbers up to 60, each with a few roundings: 8 * 60^2 * 1.1e-16.
    EXPECT_NEAR(a[0] * a[3] - a[1] * a[2], 0.0, 3e-12);
  }
}

// Point masses of 1 kg at (0, −1 m, 0) of their links. Sums of a few terms up to 30: 1e-13 is some ten roundings.
TEST(DoublePendulum, HasARegressorWhoseTablesLeadFromInertialParametersToForces) {
  std::array<double, Pendulum::inertial_parameter_count> pi{};
  for (std::size_t link = 0; link < 2; ++link) {
    pi[10 * link] = 1;       // m
    pi[10 * link + 2] = -1;  // h_y
    pi[10 * link + 4] = 1;   // J_xx
    pi[10 * link + 9] = 1;   // J_zz
  }
  std::array<double, Pendulum::base_parameter_count> base{};
  for (std::size_t b = 0; b < base.size(); ++b) base[b] = pi[static_cast<std::size_t>(Pendulum::base_parameters[b])];
  for (std::size_t k = 0; k < Pendulum::regrouping_count; ++k) {
    const double part = Pendulum::regrouping_factors[k] * pi[static_cast<std::size_t>(Pendulum::regrouped_from[k])];
    base[static_cast<std::size_t>(Pendulum::regrouped_to[k])] += part;
  }
  auto state = Pendulum::initial_state();
  state.v = {1.3, -0.7};
  const Pendulum::Accelerations a{2.0, -3.0};
  const auto precomputed = Pendulum::precompute(Pendulum::default_parameters());
  Pendulum::Regressor regressor;
  Pendulum::regressor(precomputed, state, a, regressor);
  Pendulum::GeneralizedForces forces;
  Pendulum::inverse_dynamics(precomputed, state, a, {}, forces);
  for (int i = 0; i < 2; ++i) {
    double sum = 0;
    for (std::size_t b = 0; b < base.size(); ++b) sum += regressor.Y[2 * b + static_cast<std::size_t>(i)] * base[b];
    EXPECT_NEAR(sum, forces[i], 1e-13) << i;
  }
}

// Rates of 1e120 make accelerations of about 1e240: their product overflows, and they are finite.
TEST(DoublePendulum, TellsLargeResultsFromThoseThatAreNotFinite) {
  const auto precomputed = Pendulum::precompute(Pendulum::default_parameters());
  const auto status_at = [&](double rate, Pendulum::Accelerations& a) {
    Pendulum::State state{};
    state.q = {0.4, -1.1};
    state.v = {rate, rate / 2};
    Pendulum::Multipliers lambda;
    return Pendulum::forward_dynamics(precomputed, state, {}, a, lambda);
  };
  Pendulum::Accelerations a{};
  EXPECT_EQ(status_at(1e120, a), torsor::Status::ok);
  EXPECT_GT(std::abs(a.theta_1), 1e200);
  EXPECT_GT(std::abs(a.theta_2), 1e200);
  for (const double rate : {1e160, HUGE_VAL, std::nan("")}) EXPECT_EQ(status_at(rate, a), torsor::Status::not_finite);
}

}  // namespace
}  // namespace torsor::double_pendulum_test
