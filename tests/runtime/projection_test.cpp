// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/long_tests.hpp"
#include "torsor/runtime/constraints/projection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "generated/andrews_squeezer.hpp"
#include "generated/model_making_press.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace projection_test {
namespace {

using namespace torsor::runtime;
using Pendulum = mechanisms::CartesianPendulum<double>;
using Squeezer = andrews_squeezer::Mechanism<double>;
using Press = model_making_press::Mechanism<double>;
using ThreeCranks = mechanisms::CrankLoop<mechanisms::ThreeEqualCranks>;
using ThreeCranksSmallSwing = mechanisms::CrankLoop<mechanisms::ThreeEqualCranksSmallSwing>;
using FourBar = mechanisms::CrankLoop<mechanisms::FourBar>;

/// The largest violations of the constraints, in their own units.
template <class M>
std::array<double, 2> violation(const StateVector<M>& y, double t = 0.0) {
  typename M::Constraints c{};
  M::constraints(M::precompute(M::default_parameters()), unpack<M>(t, y), c);
  std::array<double, 2> largest{};
  for (const double f : c.value) largest[0] = std::max(largest[0], std::abs(f));
  for (const double rate : c.rate) largest[1] = std::max(largest[1], std::abs(rate));
  return largest;
}

TEST(Projection, MovesAPointOfACircleAlongItsRadiusAndKeepsItsTangentialVelocity) {
  // M is the unit matrix: the least change is the orthogonal one.
  StateVector<Pendulum> y{0.6 * 1.1, -0.8 * 1.1, 3 * 0.8 + 0.5 * 0.6, 3 * 0.6 - 0.5 * 0.8};
  const auto result = project_on_constraints<Pendulum>(Pendulum::precompute({}), 0.0, y);
  EXPECT_EQ(result.evaluation, Evaluation::ok);
  EXPECT_EQ(result.rank, 1);
  const StateVector<Pendulum> expected{0.6, -0.8, 2.4, 1.8};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], expected[i], 4e-16 * 3);
}

TEST(Projection, TellsTheRankOfAStateThatNeedsNoChange) {
  StateVector<Pendulum> y{0.6, -0.8, 0.0, 0.0};
  const auto before = y;
  const auto result = project_on_constraints<Pendulum>(Pendulum::precompute({}), 0.0, y);
  EXPECT_EQ(result.evaluation, Evaluation::ok);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(y, before);
  EXPECT_EQ(result.rank, 1);
  // Of one constraint, of what it usually is: coordinates were looked at up to half a length farther, in both directions.
  EXPECT_GT(result.least_share, 1 / (1.5 * std::sqrt(2.0)));
  EXPECT_LE(result.least_share, 1.0);
}

TEST(Projection, LeavesAMechanismWithoutConstraintsAsItIs) {
  using Oscillator = mechanisms::Oscillator<double>;
  const auto motion = projected(equations_of_motion<Oscillator>());
  auto y = motion.initial();
  ASSERT_TRUE(integrate(motion, y, 0, 1, DormandPrince853{}));
  EXPECT_NEAR(y[0], std::cos(1.0), 1e-9 * 10);  // some ten steps at the usual tolerance
}

TEST(Projection, IsTheLeastChangeInTheMetricOfTheMasses) {
  // δ = M⁻¹ Aᵀ μ for some μ: M δv is normal to every velocity that the constraints admit, here one.
  const auto precomputed = Squeezer::precompute(Squeezer::default_parameters());
  StateVector<Squeezer> y = pack<Squeezer>(Squeezer::initial_state());
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (std::size_t i = 7; i < 14; ++i) y[i] = any(random);
  StateVector<Squeezer> admissible = y;
  ASSERT_EQ(project_on_constraints<Squeezer>(precomputed, 0.0, admissible).evaluation, Evaluation::ok);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(admissible[i], y[i], 1e-15);
  std::array<double, 49> mass{};
  Squeezer::mass_matrix(precomputed, unpack<Squeezer>(0.0, y), mass);
  double product = 0.0, size = 0.0;
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = 0; j < 7; ++j) {
      const double term = (admissible[7 + i] - y[7 + i]) * mass[j * 7 + i] * admissible[7 + j];
      product += term;
      size += std::abs(term);
    }
  }
  EXPECT_NEAR(product, 0.0, 1e-13 * size);  // the mechanism's own conditioning, some hundred, times roundings
  EXPECT_GT(size, 0.0);
}

TEST(Projection, RemovesTheDriftOfTheCartesianPendulum) {
  // Without it, Runge-Kutta at h = 0.01 leaves the circle by 3.6e-5 at t = 10 and is lost before t = 1000.
  const auto drifting = unprojected_motion<Pendulum>();
  auto y = drifting.initial();
  ASSERT_TRUE(integrate(drifting, y, 0, 10, RungeKutta4{.step = 0.01}));
  EXPECT_NEAR((y[0] * y[0] + y[1] * y[1] - 1) / 2, -3.588e-5, 1e-8);
  EXPECT_NEAR(y[0] * y[2] + y[1] * y[3], -7.202e-6, 1e-9);

  const auto motion = projected(equations_of_motion<Pendulum>());
  y = motion.initial();
  double worst = 0.0;
  const double end = torsor::wanted(100.0, 10000.0);
  ASSERT_TRUE(integrate(motion, y, 0, end, RungeKutta4{.step = 0.01}, [&](double, const StateVector<Pendulum>& state) {
    const auto v = violation<Pendulum>(state);
    worst = std::max({worst, v[0], v[1]});
  }));
  EXPECT_LT(worst, 1e-14);  // roundings of numbers up to 4.5
}

TEST(Projection, KeepsTheOrderOfEveryMethodOnBenchmarkA01) {
  // Closed form at t = 10, IFToMM A01.
  const std::array<double, 4> exact{-0.275087462576116860054391449254, -0.961419205099125064265135068597,
                                    4.17559810095172883646051950627, -1.19474905456047527164747276163};
  const auto motion = projected(equations_of_motion<Pendulum>());
  const auto error = [&](const auto& method) {
    auto y = motion.initial();
    EXPECT_TRUE(integrate(motion, y, 0, 10, method));
    double largest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(y[i] - exact[i]));
    return largest;
  };
  // The motion amplifies by at most ten, over 10 s at speeds up to 5.
  EXPECT_LT(error(DormandPrince54{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11}), 1e-11 * 10 * 5 * 10);
  EXPECT_LT(error(DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}), 1e-13 * 10 * 5 * 10);
  const double coarse = error(RungeKutta4{.step = 0.0025}), fine = error(RungeKutta4{.step = 0.00125});
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

TEST(Projection, GivesDenseStepsThatJoin) {
  const auto motion = projected(equations_of_motion<Pendulum>());
  auto y = motion.initial();
  std::array<double, 4> last = y;
  const auto see = [&](const auto& step) requires requires { step.start; }
  {
    const auto start = step(step.start), middle = step((step.start + step.end) / 2);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(start[i], last[i], 2e-15);  // roundings of numbers up to 4.5
    last = step(step.end);
    EXPECT_NEAR(violation<Pendulum>(last)[0], 0.0, 1e-15);
    EXPECT_NEAR(violation<Pendulum>(middle)[0], 0.0, 1e-7);  // the interpolant's own error, at a tolerance of 1e-9
  };
  ASSERT_TRUE(integrate(motion, y, 0, 3, DormandPrince54{}, see));
}

/// At t = 0.03, to 24 digits from two derivations.
constexpr std::array<double, 14> squeezer_at_003{
    15.8107711951537070971193873,   -15.7563710584118394697277528, 0.0408222401196458048582823196,
    -0.534730116342079593770185031, 0.524409965879954069371655800, 0.534730116342079593770185031,
    1.04808074104193787306851547,   1139.92030225910606419809685,  -1424.37929517754007319602644,
    11.0329119106185937453273113,   19.2933741050320408316275568,  0.573569914829502453817687862,
    -19.2933741050320408316275568,  0.323179149249130874990748391};

TEST(Projection, BringsAndrewsSqueezerToItsReference) {
  const auto motion = projected(equations_of_motion<Squeezer>());
  auto y = motion.initial();
  double worst = 0.0;
  const auto result =
      integrate(motion, y, 0, 0.03, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13},
                [&](double, const auto& s) { worst = std::max(worst, violation<Squeezer>(s)[0]); });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(worst, 1e-13 * 0.035);  // of the longest bar
  // Some 300 steps at 1e-13, of angles to 16: 1e-12 of them. An error of phase of 1e-12 rad moves the rates, which
  // change by some hundred rad/s in a radian of β, by 1e-10.
  for (std::size_t i = 0; i < 14; ++i) {
    const double size = std::abs(squeezer_at_003[i]);
    EXPECT_NEAR(y[i], squeezer_at_003[i], i < 7 ? 1e-12 * std::max(1.0, size) : 1e-10 + 1e-12 * size) << i;
  }
}

TEST(Projection, KeepsClosedLoopsClosedOverManySteps) {
  const std::int64_t steps = torsor::wanted(5'000, 1'000'000);
  double worst = 0.0;
  const auto squeezer = projected(equations_of_motion<Squeezer>());
  auto y = squeezer.initial();
  ASSERT_TRUE(integrate(squeezer, y, 0, 5e-8 * static_cast<double>(steps), RungeKutta4{.step = 5e-8},
                        [&](double, const auto& s) { worst = std::max(worst, violation<Squeezer>(s)[0]); }));
  EXPECT_LT(worst, 1e-13 * 0.035);

  const auto bars = projected(constrained_motion<FourBar>());
  auto z = bars.initial();
  const double before = FourBar::energy(unpack<FourBar>(0.0, z));
  worst = 0.0;
  ASSERT_TRUE(integrate(bars, z, 0, 1e-3 * static_cast<double>(steps), RungeKutta4{.step = 1e-3},
                        [&](double, const auto& s) { worst = std::max(worst, violation<FourBar>(s)[0]); }));
  EXPECT_LT(worst, 1e-13);
  // Energy of 10 J drifts by h⁴ (rates to 10/s)⁵/100 a second and roundings of each step.
  const double t = 1e-3 * static_cast<double>(steps);
  EXPECT_NEAR(FourBar::energy(unpack<FourBar>(0.0, z)), before, 1e-9 * t);
}

// θ(10) and θ'(10) of the pendulum of length 1 from 2 rad at rest, by elliptic functions.
constexpr double swing[2]{0.015728632141428118626277592909, 5.27089879322982858518148735035};

TEST(Projection, TakesAParallelogramWithAnExtraBarThroughItsChangePoints) {
  const double near = change_point_tolerance<double>();
  const auto motion = projected(constrained_motion<ThreeCranks>({}, {}, near), near);
  const auto expect = [&](const auto& method, double tolerance) {
    auto y = motion.initial();
    const auto result = integrate(motion, y, 0, 10, method);
    ASSERT_TRUE(result) << describe(result);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(y[k], swing[0], tolerance);
      EXPECT_NEAR(y[4 + k], swing[1], tolerance);
    }
    EXPECT_NEAR(y[3], 0.0, 1e-14);
    EXPECT_LT(violation<ThreeCranks>(y)[0], 1e-14);
  };
  // Six passages at 4.5 m/s, of 2e-6 s each with some constraints let go; and the tolerance times 10 s and speeds of 5.
  expect(DormandPrince853{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9}, 1e-9 * 10 * 5);
  expect(RungeKutta4{.step = 2e-3}, 5e-8);  // h⁴ times 10 s times rates to the fifth power, 3^5
}

TEST(Projection, TakesTheRankOfRedundantLoops) {
  auto y = pack<ThreeCranksSmallSwing>(ThreeCranksSmallSwing::initial_state());
  y[1] += 1e-3;
  y[3] -= 2e-3;
  y[5] = 0.1;
  const auto result = project_on_constraints<ThreeCranksSmallSwing>(ThreeCranksSmallSwing::precompute({}), 0.0, y);
  EXPECT_EQ(result.evaluation, Evaluation::ok);
  EXPECT_EQ(result.rank, 3);  // of four
  const auto left = violation<ThreeCranksSmallSwing>(y);
  EXPECT_LT(left[0], 2e-15);
  EXPECT_LT(left[1], 2e-15);

  // A press whose frame holds it in four ways too many, with two attitudes by quaternions.
  const auto precomputed = Press::precompute(Press::default_parameters());
  auto press = pack<Press>(Press::initial_state());
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1e-3, 1e-3);
  for (double& component : press) component += any(random);
  const auto of_press = project_on_constraints<Press>(precomputed, 0.0, press);
  EXPECT_EQ(of_press.evaluation, Evaluation::ok);
  EXPECT_EQ(of_press.rank, Press::multiplier_count - Press::redundant_count);
  EXPECT_LT(of_press.position, 1e-14);
  EXPECT_LT(of_press.velocity, 1e-14);
}

/// The four-bar with a crank next to nothing in mass, which takes nearly all of every correction.
struct LightCrank : mechanisms::FourBar {
  static constexpr std::array<double, 2> mass{1e-6, 0.7};
};
TEST(Projection, ClosesTheLoopOfACrankWoundUp) {
  // An angle of 1e5 turns is known to 6e-11 rad: the other two must close the loop to roundings of its metre.
  const auto wind_up = [](auto mechanism, double turns) {
    using M = decltype(mechanism);
    auto y = pack<M>(M::initial_state());
    y[0] += 2 * std::numbers::pi * turns;
    y[3] = 7.0;
    const auto result = project_on_constraints<M>(M::precompute({}), 0.0, y);
    EXPECT_EQ(result.evaluation, Evaluation::ok) << turns;
    const auto left = violation<M>(y);
    EXPECT_LT(left[0], 8 * 1.1e-16) << turns;
    EXPECT_LT(left[1], 7 * 8 * 1.1e-16) << turns;
  };
  for (const double turns : {1e3, -1e4, 1e5, 1e7}) {
    wind_up(FourBar{}, turns);
    wind_up(mechanisms::CrankLoop<LightCrank>{}, turns);
  }
  // And so it stays while it moves.
  const auto bars = projected(constrained_motion<FourBar>());
  auto y = bars.initial();
  y[0] += 2e5 * std::numbers::pi;
  double worst = 0.0;
  ASSERT_TRUE(integrate(bars, y, 0, 2, RungeKutta4{.step = 1e-2}, [&](double t, const auto& s) {
    if (t > 0) worst = std::max(worst, violation<FourBar>(s)[0]);
  }));
  EXPECT_LT(worst, 1e-13);
}

/// A parallelogram whose base and coupler differ by a rounding: nothing at angles near zero is so small.
struct RoundedLengths : mechanisms::FourBar {
  static constexpr std::array<double, 2> crank{0.3, 0.3}, base{0, 0.3}, coupler{0, 0.1 + 0.2};
};
TEST(Projection, TakesTheRoundingOfLengthsForWhatItIsNearZeroAngles) {
  using M = mechanisms::CrankLoop<RoundedLengths>;
  for (double angle = 1e-14; angle < 1e-4; angle *= 7) {
    StateVector<M> y{angle, angle, angle / 3, 0, 0, 0};
    EXPECT_EQ(project_on_constraints<M>(M::precompute({}), 0.0, y).evaluation, Evaluation::ok) << angle;
    EXPECT_LT(violation<M>(y)[0], 2 * 1.1e-16) << angle;
  }
}

TEST(ConstrainedMotion, AgreesWithTheGeneratedForwardDynamics) {
  const Squeezer::State state = unpack<Squeezer>(0.03, squeezer_at_003);
  Squeezer::Accelerations by_kernel{}, by_factor{};
  Squeezer::Multipliers lambda_kernel{}, lambda_factor{};
  ASSERT_EQ(equations_of_motion<Squeezer>().accelerations(state, by_kernel, lambda_kernel), Evaluation::ok);
  const ConstrainedMotion<Squeezer> motion;
  ASSERT_EQ(motion.accelerations(state, by_factor, lambda_factor), Evaluation::ok);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(by_factor[i], by_kernel[i], 1e-12 * 51850);
  for (int j = 0; j < 6; ++j) EXPECT_NEAR(lambda_factor[j], lambda_kernel[j], 1e-11 * 200);
}

TEST(Baumgarte, BoundsTheDriftThatGrowsWithoutIt) {
  // Without it 3.6e-5 at t = 10 and a hundred times as much at t = 100.
  const ConstrainedMotion<Pendulum> motion({}, {.alpha = 20.0, .beta = 20.0});
  auto y = motion.initial();
  double worst[2]{};
  ASSERT_TRUE(integrate(motion, y, 0, 40, RungeKutta4{.step = 0.01}, [&](double t, const StateVector<Pendulum>& s) {
    double& half = worst[t < 20 ? 0 : 1];
    half = std::max(half, violation<Pendulum>(s)[0]);
  }));
  EXPECT_LT(worst[1], 3.6e-5 / 10);
  EXPECT_LT(worst[1], 2 * worst[0]);
  EXPECT_GT(worst[1], 1e-12);  // it damps, it does not project
}

// f'' + 2 α f' + β² f = 0, f'' being A a + γ, at states off the circle in position and in velocity.
TEST(Baumgarte, GivesTheResidualTheEquationOfADampedOscillator) {
  const StateVector<Pendulum> off{0.5, -0.9, 1.3, 0.4};
  const auto s = unpack<Pendulum>(0.0, off);
  Pendulum::Constraints c{};
  Pendulum::constraints({}, s, c);
  for (const auto& [alpha, beta] : {std::array{3.0, 7.0}, std::array{11.0, 2.0}}) {
    const ConstrainedMotion<Pendulum> motion({}, {.alpha = alpha, .beta = beta});
    Pendulum::Accelerations a{};
    Pendulum::Multipliers lambda{};
    ASSERT_EQ(motion.accelerations(s, a, lambda), Evaluation::ok);
    const double second = c.jacobian[0] * a[0] + c.jacobian[1] * a[1] + c.gamma[0];
    // Terms to 40, each rounded a few times.
    EXPECT_NEAR(second + 2 * alpha * c.rate[0] + beta * beta * c.value[0], 0.0, 40 * 16 * 1.1e-16);
  }
}

/// A point on a line that two guides push, at 1 m/s and at 2 m/s; they are at one place at t = 0 only.
struct PushedTwice : mechanisms::Contract<1, 2> {
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 1>& mass) noexcept { mass = {1.0}; }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept { h = {}; }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c.value = {s.q[0] - s.time, s.q[0] - 2 * s.time};
    c.jacobian = {1, 1};
    c.rate = {s.v[0] - 1, s.v[0] - 2};
    c.gamma = {0, 0};
  }
};
TEST(Projection, RefusesConstraintsThatAskForTwoVelocities) {
  for (const double v : {0.0, 1.0, 1.5, 2.0}) {
    StateVector<PushedTwice> y{0.0, v};
    EXPECT_EQ(project_on_constraints<PushedTwice>({}, 0.0, y).evaluation, Evaluation::singular) << v;
    EXPECT_EQ(y[1], v);
  }
}

TEST(Projection, ReportsStatesFromWhichNoneIsReached) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto project = [](StateVector<Pendulum> y) {
    const StateVector<Pendulum> before = y;
    const auto result = project_on_constraints<Pendulum>(Pendulum::precompute({}), 0.0, y);
    EXPECT_TRUE(result.evaluation == Evaluation::ok || y == before || before[0] != before[0] || before[3] != before[3]);
    return result.evaluation;
  };
  EXPECT_EQ(project({0.0, 0.0, 1.0, 0.0}), Evaluation::singular);  // the centre: no gradient
  EXPECT_EQ(project({nan, 0.0, 1.0, 0.0}), Evaluation::not_finite);
  EXPECT_EQ(project({1.0, 0.0, 1.0, nan}), Evaluation::not_finite);
  EXPECT_EQ(project({infinity, 0.0, 1.0, 0.0}), Evaluation::not_finite);
  EXPECT_EQ(project({1e-160, 1e-160, 0.0, 0.0}), Evaluation::not_finite);  // the way to the circle overflows
  EXPECT_EQ(project({1e6, 1e6, 0.0, 0.0}), Evaluation::ok);
}

struct Leaving {
  [[nodiscard]] Evaluation operator()(double, const std::array<double, 1>&,
                                      std::array<double, 1>& dydt) const noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  }
  [[nodiscard]] Evaluation project(double t, std::array<double, 1>&) const noexcept {
    return t > 0.5 ? Evaluation::singular : Evaluation::ok;
  }
};

TEST(Projection, ThatFailsEndsTheIntegrationAtTheLastGoodState) {
  std::array<double, 1> y{0.0};
  const auto fixed = integrate(Leaving{}, y, 0, 1, RungeKutta4{.step = 0.125});
  EXPECT_EQ(fixed.status, IntegrationStatus::model_failure);
  EXPECT_EQ(fixed.evaluation, Evaluation::singular);
  EXPECT_EQ(fixed.time, 0.5);
  EXPECT_EQ(y[0], 0.5);
  y[0] = 0.0;
  const auto adaptive = integrate(Leaving{}, y, 0, 1, DormandPrince54{});
  EXPECT_EQ(adaptive.status, IntegrationStatus::model_failure);
  EXPECT_NEAR(adaptive.time, 0.5, 1e-12);  // creeps up to it
}

}  // namespace
}  // namespace projection_test
