// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/mechanism.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/batch/motion_ensemble.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/numerics/linear_solve.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace mechanism_test {
namespace {

using namespace torsor::runtime;
using Oscillator = mechanisms::Oscillator<double>;
using CartesianPendulum = mechanisms::CartesianPendulum<double>;
using Turn = mechanisms::TurnByCosineAndSine<double>;

static_assert(HasForwardDynamics<Oscillator> && HasForwardDynamics<mechanisms::Oscillator<float>>);
static_assert(HasDynamicsMatrices<CartesianPendulum> && !HasDynamicsMatrices<Oscillator>);
static_assert(HasCoordinateRates<Turn> && !HasCoordinateRates<Oscillator>);
static_assert(!MechanismModel<int>);
static_assert(std::is_same_v<ScalarOf<mechanisms::Oscillator<float>>, float>);

TEST(StateVector, PutsCoordinatesBeforeVelocities) {
  CartesianPendulum::State state{3.0, {{1.0, 2.0}}, {{4.0, 5.0}}};
  const StateVector<CartesianPendulum> y = pack<CartesianPendulum>(state);
  EXPECT_EQ(y, (std::array{1.0, 2.0, 4.0, 5.0}));
  const auto back = unpack<CartesianPendulum>(3.0, y);
  EXPECT_EQ(back.time, 3.0);
  EXPECT_EQ(pack<CartesianPendulum>(back), y);
}

TEST(EquationsOfMotion, UseParametersAndInputLaw) {
  // 2 x'' = -8 x + F with F = 6 + t at x = 0.5, t = 1: x'' = 1.5.
  const auto motion = equations_of_motion<Oscillator>(
      Oscillator::Parameters{2.0, 8.0}, [](const Oscillator::State& s) { return Oscillator::Inputs{{6.0 + s.time}}; });
  std::array<double, 2> dydt{};
  EXPECT_EQ(motion(1.0, {0.5, 0.25}, dydt), Evaluation::ok);
  EXPECT_EQ(dydt, (std::array{0.25, 1.5}));
}

TEST(EquationsOfMotion, LeaveAMechanismToItselfByDefault) {
  const auto motion = equations_of_motion<Oscillator>();
  EXPECT_EQ(motion.initial(), (std::array{1.0, 0.0}));
  EXPECT_EQ(motion.initial_time(), 0.0);
  std::array<double, 2> dydt{};
  EXPECT_EQ(motion(0.0, {0.5, 0.25}, dydt), Evaluation::ok);
  EXPECT_EQ(dydt, (std::array{0.25, -0.5}));
}

/// Starts where its spring of stiffness k carries its weight m g, as generated headers start by formulas.
struct StartsAtEquilibrium : Oscillator {
  static State initial_state(const Parameters& p) noexcept { return {2.0, {{-p.mass * 9.81 / p.stiffness}}, {}}; }
  static State initial_state() noexcept { return initial_state(default_parameters()); }
};
TEST(EquationsOfMotion, StartWhereTheirParametersSay) {
  const Oscillator::Parameters parameters{2.0, 8.0};
  const auto motion = equations_of_motion<StartsAtEquilibrium>(parameters);
  EXPECT_EQ(motion.initial(), (std::array{-2.0 * 9.81 / 8.0, 0.0}));
  EXPECT_EQ(motion.initial_time(), 2.0);
  EXPECT_EQ((Member<StartsAtEquilibrium>{.parameters = parameters}.state.q[0]), -2.0 * 9.81 / 8.0);
  EXPECT_EQ(Member<StartsAtEquilibrium>{}.state.q[0], -9.81);
}

TEST(EquationsOfMotion, PassOnTheStatusOfTheKernel) {
  const auto motion = equations_of_motion<CartesianPendulum>();
  std::array<double, 4> dydt{};
  EXPECT_EQ(motion(0.0, {0.0, 0.0, 1.0, 0.0}, dydt), Evaluation::singular);
}

TEST(EquationsOfMotion, UseTheMapOfAMechanismWhoseRatesAreNotItsVelocities) {
  const auto motion = equations_of_motion<Turn>();
  auto y = motion.initial();
  ASSERT_TRUE(integrate(motion, y, 0, 3, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12}));
  // ω = 2 for 3 s; 3 s × tolerance × (1 + ω) on a motion that amplifies nothing.
  EXPECT_NEAR(y[0], std::cos(6.0), 1e-11);
  EXPECT_NEAR(y[1], std::sin(6.0), 1e-11);
  EXPECT_EQ(y[2], 2.0);
}

struct PendulumA01 {
  double time;
  std::array<double, 4> y;
};

// IFToMM benchmark A01, closed form to 50 digits.
constexpr PendulumA01 benchmark[] = {
    {5.0,
     {-0.94230543504375733549685750751, -0.334754338414000580788701093998, 0.85790425688594907305753993668,
      -2.41492865437048862260125201106}},
    {9.99,
     {-0.316436469913032291228337244164, -0.948613704575776519245975395739, 4.09245199149402074343170267263,
      -1.36515112024030470567957738906}},
    {10.0,
     {-0.275087462576116860054391449254, -0.961419205099125064265135068597, 4.17559810095172886648051950627,
      -1.19474905456047524767147276163}},
};

// The motion by the matrices M, h, A, γ and the solver of this library instead of the kernel.
struct MotionByMatrices {
  Evaluation operator()(double t, const std::array<double, 4>& y, std::array<double, 4>& dydt) const noexcept {
    const auto precomputed = CartesianPendulum::precompute({});
    const auto state = unpack<CartesianPendulum>(t, y);
    CartesianPendulum::Accelerations a{};
    CartesianPendulum::Multipliers lambda{};
    const auto evaluation = solve_dynamics<CartesianPendulum>(precomputed, state, {}, a, lambda);
    dydt = {y[2], y[3], a[0], a[1]};
    return evaluation;
  }
};

// Errors of 1e-13 × 10 s × (1 + 5 m/s) amplify with the motion (at most by 10, its period changes with the energy) and
// drift off the constraint, which a twice differentiated constraint lets grow as t²: × 100. Measured: 1e-11.
constexpr double a01_tolerance = 1e-13 * 10 * 6 * 100;

template <class System>
void expect_benchmark(const System& system) {
  std::array<double, 4> y{-1.0, 0.0, 0.0, 0.0};
  std::array<double, 3> times{};
  for (std::size_t i = 0; i < 3; ++i) times[i] = benchmark[i].time;
  std::size_t row = 0;
  const DormandPrince54 method{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
  const auto result = integrate_through(system, y, 0.0, times, method, [&](double, const std::array<double, 4>& state) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(state[i], benchmark[row].y[i], a01_tolerance);
    ++row;
  });
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(row, 3U);
}

TEST(EquationsOfMotion, MeetTheCartesianPendulumOfA01) { expect_benchmark(equations_of_motion<CartesianPendulum>()); }

TEST(SolveDynamics, MeetsTheCartesianPendulumOfA01) { expect_benchmark(MotionByMatrices{}); }

TEST(SolveDynamics, AgreesWithForwardDynamics) {
  const CartesianPendulum::State state{0.0, {{0.6, -0.8}}, {{1.6, 1.2}}};
  const auto precomputed = CartesianPendulum::precompute({});
  CartesianPendulum::Accelerations by_kernel{}, by_solver{};
  CartesianPendulum::Multipliers lambda_kernel{}, lambda_solver{};
  ASSERT_EQ(CartesianPendulum::forward_dynamics(precomputed, state, {}, by_kernel, lambda_kernel),
            mechanisms::Status::ok);
  ASSERT_EQ(solve_dynamics<CartesianPendulum>(precomputed, state, {}, by_solver, lambda_solver), Evaluation::ok);
  // A handful of roundings of numbers up to 12.
  EXPECT_NEAR(by_kernel[0], by_solver[0], 1e-14);
  EXPECT_NEAR(by_kernel[1], by_solver[1], 1e-14);
  EXPECT_NEAR(lambda_kernel[0], lambda_solver[0], 1e-14);
}

TEST(SolveDynamics, ReportsTheSingularPositionOfAMechanism) {
  const CartesianPendulum::State centre{0.0, {{0.0, 0.0}}, {{1.0, 0.0}}};
  CartesianPendulum::Accelerations a{};
  CartesianPendulum::Multipliers lambda{};
  EXPECT_EQ(solve_dynamics<CartesianPendulum>(CartesianPendulum::precompute({}), centre, {}, a, lambda),
            Evaluation::singular);
}

TEST(SolveDynamics, WorksWithoutMultipliers) {
  using Pendulum = mechanisms::Pendulum<float>;
  const Pendulum::State state{0.0F, {{0.5F}}, {{0.0F}}};
  Pendulum::Accelerations a{};
  Pendulum::Multipliers none{};
  ASSERT_EQ(solve_dynamics<Pendulum>(Pendulum::precompute({}), state, {{1.0F}}, a, none), Evaluation::ok);
  EXPECT_FLOAT_EQ(a[0], 1.0F - 9.81F * std::sin(0.5F));
}

}  // namespace
}  // namespace mechanism_test
