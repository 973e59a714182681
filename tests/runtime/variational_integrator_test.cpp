// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/long_tests.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "generated/arm7.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/elastic_wing.hpp"
#include "generated/kapitza_pendulum.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace variational_integrator_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 4>;
using DoublePendulum = double_pendulum::Mechanism<double>;

/// A unit mass in polar coordinates r, θ, on a spring from the pole (rest length 1), with a drag proportional to its
/// velocity: T = ½ (r'² + r² θ'²), whose mass matrix varies.
struct PolarMass : mechanisms::Contract<2, 0> {
  struct Parameters {
    double stiffness, drag;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {0.0, 0.0}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {0.0, {{1.0, 0.0}}, {{0.0, 2.0}}}; }
  static void mass_matrix(const Precomputed&, const State& s, std::array<double, 4>& mass) noexcept {
    mass = {1.0, 0.0, 0.0, s.q[0] * s.q[0]};
  }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    const double r = s.q[0];
    h[0] = -r * s.v[1] * s.v[1] + p.parameters.stiffness * (r - 1.0) + p.parameters.drag * s.v[0];
    h[1] = 2.0 * r * s.v[0] * s.v[1] + p.parameters.drag * r * r * s.v[1];
  }
  static mechanisms::Status forward_dynamics(const Precomputed& p, const State& s, const Inputs&, Accelerations& a,
                                             Multipliers&) noexcept {
    GeneralizedForces h{};
    bias(p, s, h);
    a[0] = -h[0];
    a[1] = -h[1] / (s.q[0] * s.q[0]);
    return s.q[0] == 0.0 ? mechanisms::Status::singular : mechanisms::Status::ok;
  }
};

/// A mass that grows with time: d/dt (M v) has (∂M/∂t) v, which the forces lack.
struct GrowingMass : PolarMass {
  static void mass_matrix(const Precomputed& p, const State& s, std::array<double, 4>& mass) noexcept {
    PolarMass::mass_matrix(p, s, mass);
    for (double& entry : mass) entry *= 1.0 + s.time;
  }
};

/// The same headers without the kernel of derivatives.
struct WithoutDerivatives : DoublePendulum {
  static void inverse_dynamics_derivatives() = delete;
};

/// A mass on a line with a drag c v², even in v, from `since` on: x' = v0/(1 + c v0 t).
struct EvenDrag : mechanisms::Contract<1, 0> {
  struct Parameters {
    double drag = 1.0, since = 0.0;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {0.0, {{0.0}}, {{1.0}}}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 1>& mass) noexcept { mass = {1.0}; }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    h[0] = s.time >= p.parameters.since ? p.parameters.drag * s.v[0] * s.v[0] : 0.0;
  }
  static mechanisms::Status forward_dynamics(const Precomputed& p, const State& s, const Inputs&, Accelerations& a,
                                             Multipliers&) noexcept {
    GeneralizedForces h{};
    bias(p, s, h);
    a[0] = -h[0];
    return mechanisms::Status::ok;
  }
};

/// PolarMass with a force across the velocity, which does no work: even in v too.
struct AcrossTheVelocity : PolarMass {
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    PolarMass::bias(p, s, h);
    h[0] -= 1e-4 * s.v[0] * s.v[1];
    h[1] += 1e-4 * s.v[0] * s.v[0];
  }
};

// From (1, 0) with speed 2 along y: a straight line, whose speed falls as e^(-c t); at t, in r, θ, r', θ'.
State along_the_line(double drag, double t) {
  const double gone = drag > 0.0 ? 2.0 * (1.0 - std::exp(-drag * t)) / drag : 2.0 * t;
  const double speed = 2.0 * std::exp(-drag * t), r = std::hypot(1.0, gone);
  return {r, std::atan(gone), speed * gone / r, speed / (r * r)};
}

template <class Method>
double error_on_the_line(const Method& method, double drag) {
  const auto motion = equations_of_motion<PolarMass>({0.0, drag});
  State y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, method);
  EXPECT_TRUE(result) << describe(result);
  const State exact = along_the_line(drag, 1.0);
  double error = 0.0;
  for (std::size_t i = 0; i < 4; ++i) error = std::max(error, std::abs(y[i] - exact[i]));
  return error;
}

TEST(LagrangianForces, AreTheDerivativesOfTheLagrangianAndTheDrag) {
  // ∂L/∂r = r θ'² - k (r - 1), less the drag c r'; ∂L/∂θ = 0, less c r² θ'.
  const PolarMass::State state{0.0, {{1.5, 0.3}}, {{-0.7, 2.5}}};
  std::array<double, 2> F;
  lagrangian_forces<PolarMass>({{4.0, 0.25}}, state, F);
  EXPECT_NEAR(F[0], 1.5 * 2.5 * 2.5 - 4.0 * 0.5 + 0.25 * 0.7, 1e-13);
  EXPECT_NEAR(F[1], -0.25 * 1.5 * 1.5 * 2.5, 1e-13);
}

TEST(LagrangianForces, AreAlikeFromTheKernelOfDerivativesAndFromTheBias) {
  // By hand: T = θ1'² + ½ θ2'² + cos(θ1 - θ2) θ1' θ2', U = g (2 cos θ1 + cos θ2).
  const DoublePendulum::State state{0.0, {0.8, -1.1}, {1.7, -2.3}};
  const double turn = -std::sin(0.8 + 1.1) * 1.7 * -2.3;
  const std::array<double, 2> by_hand{turn - 2 * 9.81 * std::sin(0.8), -turn - 9.81 * std::sin(-1.1)};
  std::array<double, 2> by_kernel, by_bias;
  lagrangian_forces<DoublePendulum>({}, state, by_kernel);
  lagrangian_forces<WithoutDerivatives>({}, state, by_bias);
  static_assert(HasInverseDynamicsDerivatives<DoublePendulum> && !HasInverseDynamicsDerivatives<WithoutDerivatives>);
  for (std::size_t i = 0; i < 2; ++i) {  // some thirty operations on terms of 20
    EXPECT_NEAR(by_kernel[i], by_hand[i], 30 * 20 * 1.1e-16);
    EXPECT_NEAR(by_bias[i], by_hand[i], 100 * 20 * 1.1e-16);
  }
}

// Steps where the next term changes the order seen by less than 0.2; an order wrong by one or two would be off by more.
template <int stages>
void expect_order(double drag, double step) {
  const double coarse = error_on_the_line(VariationalIntegrator<stages>{.step = step}, drag);
  const double fine = error_on_the_line(VariationalIntegrator<stages>{.step = step / 2}, drag);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0 * stages, 0.25) << stages << " stages, drag " << drag;
}
TEST(VariationalIntegrator, HasTwiceTheOrderOfItsStagesOnAStraightLineInPolarCoordinates) {
  for (const double drag : {0.0, 0.5}) {
    expect_order<1>(drag, 1.0 / 64);
    expect_order<2>(drag, 1.0 / 32);
    expect_order<3>(drag, 1.0 / 16);
  }
}

// A pendulum whose support is shaken at 100 rad/s: forces that depend on time, each stage having a time of its own.
TEST(VariationalIntegrator, HasTwiceTheOrderOfItsStagesWhereForcesDependOnTime) {
  const auto motion = equations_of_motion<kapitza_pendulum::Mechanism<double>>();
  auto truth = motion.initial();
  ASSERT_TRUE(
      integrate(motion, truth, 0, 0.5, DormandPrince853{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14}));
  const auto error = [&](double step) {
    auto y = motion.initial();
    EXPECT_TRUE(integrate(motion, y, 0, 0.5, VariationalIntegrator<2>{.step = step}));
    return std::abs(y[0] - truth[0]);
  };
  EXPECT_NEAR(std::log2(error(1.0 / 1600) / error(1.0 / 3200)), 4.0, 0.25);
}

template <class M>
void expect_no_even_forces(const char* name) {
  const auto precomputed = M::precompute(M::default_parameters());
  for (const double speed : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (int place = 0; place < 30; ++place) {
      auto state = M::initial_state(M::default_parameters());
      for (int i = 0; i < M::velocity_count; ++i) {
        state.q[i] += static_cast<ScalarOf<M>>(std::sin(1.0 + 7.0 * i + 3.0 * place) * place);
        state.v[i] = static_cast<ScalarOf<M>>(speed * std::cos(2.0 + 5.0 * i + 11.0 * place));
      }
      EXPECT_FALSE(has_forces_even_in_velocities<M>(precomputed, state)) << name << ' ' << speed << ' ' << place;
    }
  }
}
// Scenes of gravity, springs and dampers: Christoffel's terms are all that is even in v, beside any weight.
TEST(EvenForces, AreNoneWhereNoActionIsEven) {
  expect_no_even_forces<arm7::Mechanism<double>>("arm7");
  expect_no_even_forces<arm7::Mechanism<float>>("arm7 in float");
  expect_no_even_forces<double_pendulum::Mechanism<double>>("double pendulum");
  expect_no_even_forces<elastic_wing::Mechanism<double>>("elastic wing");
  expect_no_even_forces<kapitza_pendulum::Mechanism<double>>("Kapitza's pendulum");
}

// M of the double pendulum depends on q0 - q1, of which rounding leaves fewer digits the further both have turned.
TEST(EvenForces, AreNoneOfRodsThatHaveTurnedOften) {
  using Rods = double_pendulum::Mechanism<double>;
  const auto precomputed = Rods::precompute(Rods::default_parameters());
  for (const double turns : {1e3, 1e4, 1e5, 1e6}) {
    for (int place = 0; place < 50; ++place) {
      const double away = 2 * std::numbers::pi * turns;
      Rods::State state{};
      state.q[0] = away + 0.1 * place;
      state.q[1] = 0.3 - away;
      state.v[0] = 3;
      state.v[1] = -2 * place;
      EXPECT_FALSE(has_forces_even_in_velocities<Rods>(precomputed, state)) << turns << ' ' << place;
    }
  }
}

/// A bead of 1 kg on an arc of radius l, by its place q across: M = l²/(l² - q²), bias = ½ M'(q) v².
struct BeadOnAnArc : mechanisms::Contract<1, 0> {
  struct Parameters {
    double radius = 1.0;
  };
  struct Precomputed {
    double square = 1.0;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p.radius * p.radius}; }
  static void mass_matrix(const Precomputed& p, const State& s, std::array<double, 1>& mass) noexcept {
    mass = {p.square / (p.square - s.q[0] * s.q[0])};
  }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    const double rest = p.square - s.q[0] * s.q[0];
    h[0] = p.square * s.q[0] * s.v[0] * s.v[0] / (rest * rest);
  }
};

/// A crank with a heavy slide: M = 2 + cos q, whatever it has turned by.
struct Crank : mechanisms::Contract<1, 0> {
  struct Parameters {};
  struct Precomputed {};
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters&) noexcept { return {}; }
  static void mass_matrix(const Precomputed&, const State& s, std::array<double, 1>& mass) noexcept { mass = {2 + std::cos(s.q[0])}; }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    h[0] = -std::sin(s.q[0]) * s.v[0] * s.v[0] / 2;
  }
};

TEST(EvenForces, AreNoneHoweverSmallALengthOrLargeAnAngleIs) {
  for (const double radius : {1.0, 1e-3, 1e-5, 1e-6, 1e-7}) {
    for (int place = 0; place < 200; ++place) {
      const BeadOnAnArc::State state{0.0, {{0.9 * radius * std::sin(3.0 * place)}}, {{radius * (1 + place)}}};
      EXPECT_FALSE(has_forces_even_in_velocities<BeadOnAnArc>({radius * radius}, state)) << radius << ' ' << place;
    }
  }
  for (const double turned : {1.0, 1e3, 1e6, 1e7, 1e9}) {
    for (int place = 0; place < 200; ++place) {
      const Crank::State state{0.0, {{turned + 0.1 * place}}, {{3.0}}};
      EXPECT_FALSE(has_forces_even_in_velocities<Crank>({}, state)) << turned << ' ' << place;
    }
  }
}

template <class M>
Result<double> short_run(const typename M::Parameters& parameters, double end) {
  const auto motion = equations_of_motion<M>(parameters);
  auto y = motion.initial();
  return integrate(motion, y, 0, end, VariationalIntegrator<2>{.step = 1e-3});
}
TEST(VariationalIntegrator, RefusesForcesThatAreEvenInTheVelocities) {
  const auto drag = short_run<EvenDrag>({}, 0.5);
  EXPECT_EQ(drag.status, IntegrationStatus::unsuitable_model);
  EXPECT_EQ(drag.statistics.accepted, 0);
  EXPECT_EQ(short_run<EvenDrag>({.drag = 1e-6}, 0.5).status, IntegrationStatus::unsuitable_model);
  EXPECT_EQ(short_run<EvenDrag>({.drag = 0.0}, 0.5).status, IntegrationStatus::reached_end);
  EXPECT_EQ(short_run<AcrossTheVelocity>({1.0, 0.1}, 0.5).status, IntegrationStatus::unsuitable_model);
  // Switched on after 100 steps: seen before the step after 128.
  const auto later = short_run<EvenDrag>({.since = 0.0995}, 0.5);
  EXPECT_EQ(later.status, IntegrationStatus::unsuitable_model);
  EXPECT_EQ(later.statistics.accepted, 128);
}

TEST(VariationalIntegrator, MeetsTheReferenceOfTheDoublePendulum) {
  // Extrapolation in 50 digits at t = 1. Order 8 with h = 1/200 leaves less than roundings, which the flow amplifies
  // by 8.5.
  const State truth{-0.083860420405000849725678156866, -1.31309645061392503987080693396,
                    -4.64791767807525574632648678289, -4.39024103608529360320551716559};
  const auto motion = equations_of_motion<DoublePendulum>();
  State y = motion.initial();
  const auto result = integrate(motion, y, 0, 1, VariationalIntegrator<4>{.step = 0.005});
  ASSERT_TRUE(result) << describe(result);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], truth[i], 8.5 * 10 * 1.1e-16 * 5) << i;
}

TEST(VariationalIntegrator, KeepsTheMomentumOfACyclicCoordinate) {
  // Nothing depends on θ: r² θ' = 2 whatever the error of the step, here 1e-3 in r. Roundings of p and of r² θ' alone.
  const auto motion = equations_of_motion<PolarMass>({50.0, 0.0});
  State y = motion.initial();
  double worst = 0.0;
  const auto watch = [&](double, const State& at) { worst = std::max(worst, std::abs(at[0] * at[0] * at[3] - 2.0)); };
  ASSERT_TRUE(integrate(motion, y, 0, 100, VariationalIntegrator<1>{.step = 0.02}, watch));
  EXPECT_LT(worst, 8 * 2.2e-16);
}

TEST(VariationalIntegrator, KeepsTheEnergyOfAChaoticMotionWithoutDrift) {
  // The double pendulum from (2.0, 2.5). The energy's error is that of a step, h⁶ at order 6: half the step, a 64th of
  // the error over the first 20 s. It walks nowhere: in the last 20 s of three times (long: 500 times) as long it is no
  // larger than twice that, where the least drift, linear in time, would make it three times as large in 60 s already.
  // Classical Runge-Kutta of the same step loses 0.24 J in 10⁵ steps.
  const bool long_run = torsor::wanted(false, true);
  const auto motion = equations_of_motion<DoublePendulum>();
  const auto energy = [&](const State& y) {
    DoublePendulum::Energy e{};
    DoublePendulum::energy(motion.precomputed(), unpack<DoublePendulum>(0.0, y), {}, e);
    return e.kinetic - e.force_function;
  };
  const double start = energy(motion.initial());
  // Largest errors in the first and in the last 20 s.
  const auto errors = [&](double step, double end) {
    State y = motion.initial();
    std::array<double, 2> worst{};
    const auto watch = [&](double t, const State& at) {
      const double error = std::abs(energy(at) - start);
      if (t <= 20.0) worst[0] = std::max(worst[0], error);
      if (t >= end - 20.0) worst[1] = std::max(worst[1], error);
    };
    EXPECT_TRUE(integrate(motion, y, 0, end, VariationalIntegrator<3>{.step = step}, watch));
    return worst;
  };
  const auto coarse = errors(0.01, long_run ? 10'000.0 : 60.0);
  EXPECT_NEAR(std::log2(coarse[0] / errors(0.005, 20.0)[0]), 6.0, 0.25);
  EXPECT_LT(coarse[1], 2.0 * coarse[0]);
}

TEST(VariationalIntegrator, ReportsWhatItCannotSolve) {
  const auto motion = equations_of_motion<DoublePendulum>();
  State y = motion.initial();
  auto result = integrate(motion, y, 0, 1, VariationalIntegrator<1>{.step = 1.0});
  EXPECT_EQ(result.status, IntegrationStatus::no_convergence);
  EXPECT_EQ(y, motion.initial());
  const auto growing = equations_of_motion<GrowingMass>();
  y = growing.initial();
  EXPECT_EQ(integrate(growing, y, 0, 1, VariationalIntegrator<1>{.step = 0.01}).status, IntegrationStatus::unsuitable_model);
  EXPECT_EQ(y, growing.initial());
  // At the pole the mass matrix of polar coordinates is singular.
  const auto polar = equations_of_motion<PolarMass>();
  State pole{0.0, 0.0, 0.0, 1.0};
  result = integrate(polar, pole, 0, 1, VariationalIntegrator<1>{.step = 0.01});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::singular);
}

}  // namespace
}  // namespace variational_integrator_test
