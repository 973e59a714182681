// SPDX-License-Identifier: GPL-3.0-or-later
// Events in every method: the same facts for each. What events are, see events_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace event_methods_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 4>;  // (q1, q2, v1, v2)
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double g = 9.81;

/// The motion below as two unit masses, for the method that asks for their Lagrangian.
struct UnitMasses : mechanisms::Contract<2, 0> {
  struct Precomputed {
    std::array<double, 2> a, k;
  };
  static Precomputed precompute(const Parameters&) noexcept { return {}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<double, 4>& mass) noexcept {
    mass = {1.0, 0.0, 0.0, 1.0};
  }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(i);
      h[i] = p.k[k] * s.q[i] - p.a[k];
    }
  }
};

// q' = v, v_i' = a_i - k_i q_i: free fall, an oscillator, a clock and a sliding ball are all of this kind.
struct Motion {
  using Mechanism = UnitMasses;
  static constexpr bool second_order = true, accelerations_depend_on_velocities = false;
  std::array<double, 2> a{}, k{};

  UnitMasses::Precomputed precomputed() const noexcept { return {a, k}; }

  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[2], y[3], a[0] - k[0] * y[0], a[1] - k[1] * y[1]};
    return Evaluation::ok;
  }
  Evaluation jacobian(double, const State&, JacobianMatrix<double, 4>& J) const noexcept {
    J = {0, 0, -k[0], 0, 0, 0, 0, -k[1], 1, 0, 0, 0, 0, 1, 0, 0};
    return Evaluation::ok;
  }
  Evaluation jets(double t, const State& y, std::span<State> c) const noexcept {
    c[0] = y;
    if (c.size() < 2) return Evaluation::ok;
    (*this)(t, y, c[1]);
    for (std::size_t n = 2; n < c.size(); ++n) {
      const State& b = c[n - 1];
      c[n] = {b[2], b[3], -k[0] * b[0], -k[1] * b[1]};
      for (double& value : c[n]) value /= static_cast<double>(n);
    }
    return Evaluation::ok;
  }
};

// Guards of one type, so that each method is compiled once.
using AnyGuard = Guard<std::function<double(double, const State&)>, std::function<bool(double, State&)>>;
constexpr std::size_t most = 8;
AnyGuard any(Response response, Crossing crossing, std::function<double(double, const State&)> function,
             std::function<void(double, State&)> reset = {}) {
  return {std::move(function), crossing, response, [response, reset](double t, State& y) {
            if (reset) reset(t, y);
            return response != Response::stop;
          }};
}
AnyGuard barrier_of(std::function<double(double, const State&)> function, std::function<void(double, State&)> reset) {
  return any(Response::barrier, Crossing::falling, std::move(function), std::move(reset));
}

struct Seen {
  std::size_t guard;
  double time;
  bool grazing;
  State state;
};

template <class Method>
class EventsIn : public ::testing::Test {
 public:
  using Watched = EventResult<double, most>;

  // The others of the eight guards stay at one.
  static Watched run(Motion& motion, State& y, double end, const Method& method, std::vector<AnyGuard> guards,
                     std::vector<Seen>& seen, double start = 0.0) {
    std::array<AnyGuard, most> all;
    for (std::size_t i = 0; i < most; ++i) {
      all[i] = i < guards.size() ? guards[i] : any(Response::note, Crossing::either, [](double, const State&) {
        return 1.0;
      });
    }
    return integrate_with_events(motion, y, start, end, method, EventArray(all), [&](const Event<double, 4>& event) {
      seen.push_back({event.guard, event.time, event.grazing, event.state});
    });
  }
};

// A method with steps of about `step`: its tolerance where it has one, its order where it has none.
template <class Method>
Method with_step(double step) {
  Method method;
  if constexpr (requires { method.relative_tolerance; }) {
    method.relative_tolerance = method.absolute_tolerance = 1e-12;
    method.largest_step = step;
  } else {
    method.step = step;
  }
  return method;
}

// Every method for right-hand sides; the one for constraints: events_on_constraints_test.cpp, those of SUNDIALS:
// sundials_test.cpp.
using GaussByNewton = GaussCollocation<3, StageSolver::newton>;
using Methods = ::testing::Types<DormandPrince54, DormandPrince853, Taylor, RungeKutta4, Midpoint, StoermerVerlet,
                                 GaussCollocation<1>, GaussCollocation<3>, GaussByNewton, VariationalIntegrator<1>,
                                 VariationalIntegrator<2>, RadauIia5>;
class Names {
 public:
  template <class Method>
  static std::string GetName(int i) {
    constexpr const char* names[] = {"DormandPrince54",   "DormandPrince853",  "Taylor",
                                     "RungeKutta4",       "Midpoint",          "StoermerVerlet",
                                     "GaussOrder2",       "GaussOrder6",       "GaussByNewton",
                                     "VariationalOrder2", "VariationalOrder4", "RadauIia5"};
    return names[i];
  }
};
TYPED_TEST_SUITE(EventsIn, Methods, Names);

const auto height = [](double, const State& y) { return y[0]; };

// Every method is exact for free fall, but for rounding.
TYPED_TEST(EventsIn, ComeToRestAtTheTimeOfTheClosedForm) {
  struct Ball {
    double e, end, tenth;
  };
  for (const Ball& ball : {Ball{0.5, 1.354570922957192713352433, 1.352807158734592202006922},
                           Ball{0.9, 8.578949178728887184565411, 5.430218002585345622119992}}) {
    State y{1.0, 0.0, 0.0, 0.0};
    std::vector<Seen> seen;
    Motion fall{{-g, 0}, {}};
    const auto result = this->run(fall, y, 100, with_step<TypeParam>(0.05),
                                  {barrier_of(height, [&](double, State& s) { s[2] *= -ball.e; })}, seen);
    ASSERT_EQ(result.status, EventStatus::accumulation) << describe(result.status);
    // As in events_test.cpp: each time is rounded, and the ball reflected up to a rounding of the time early.
    const double rounding = epsilon * ball.end, n = static_cast<double>(result.fired[0]);
    EXPECT_NEAR(result.accumulation_time, ball.end, n * rounding * (1 + ball.e) / (1 - ball.e));
    ASSERT_GT(seen.size(), 10U);
    EXPECT_NEAR(seen[9].time, ball.tenth, 10 * 10 * rounding);
    EXPECT_LT(n, 36.0 / -std::log(ball.e) + 40);
    EXPECT_NEAR(y[0], 0.0, 1e-14);
  }
}

TYPED_TEST(EventsIn, TellATouchFromAnImpact) {
  for (const double excess : {0.0, 1e-12, -1e-12}) {
    const double v0 = std::sqrt(2 * g * (1 + excess));
    State y{0.0, 0.0, v0, 0.0};
    std::vector<Seen> seen;
    Motion fall{{-g, 0}, {}};
    const auto result =
        this->run(fall, y, 10, with_step<TypeParam>(0.03),
                  {barrier_of([](double, const State& s) { return 1.0 - s[0]; },
                              [](double, State& s) { s[2] *= -0.5; }),
                   any(Response::stop, Crossing::falling, height)},
                  seen);
    ASSERT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
    EXPECT_EQ(result.fired[0], excess > 0 ? 1 : 0) << excess;
    EXPECT_EQ(result.grazed[0], excess == 0.0 ? 1 : 0) << excess;
    ASSERT_FALSE(seen.empty());
    if (excess == 0.0) {
      // Known to the square root of a rounding of the height, over g.
      EXPECT_NEAR(seen[0].time, 0.451523640985730904450811, std::sqrt(2 * 4 * epsilon / g));
    }
    if (excess > 0) {
      const double v = std::sqrt(v0 * v0 - 2 * g);  // known to a rounding of the height: 2 g ε/v
      EXPECT_NEAR(seen[0].state[2], v, 16 * g * epsilon / v);
    } else {
      EXPECT_NEAR(result.time, 2 * v0 / g, 8 * epsilon);
      EXPECT_NEAR(y[2], -v0, 32 * epsilon * v0);
    }
  }
}

// A billiard ball slides, (x, R φ) with friction, then rolls: u = x' - R φ' vanishes.
TYPED_TEST(EventsIn, EndTheSlidingOfABilliardBall) {
  constexpr double mu = 0.2, v0 = 2.0;
  Motion ball{{-mu * g, 2.5 * mu * g}, {}};
  State y{0.0, 0.0, v0, 0.0};
  std::vector<Seen> seen;
  const auto slides = any(
      Response::reset, Crossing::falling, [](double, const State& s) { return s[2] - s[3]; },
      [&](double, State& s) {
        ball.a = {0.0, 0.0};
        s[3] = s[2];
      });
  const auto result = this->run(ball, y, 2, with_step<TypeParam>(0.05), {slides}, seen);
  ASSERT_TRUE(result) << describe(result.status);
  ASSERT_EQ(seen.size(), 1U);
  const double t = 0.2912479976700160186398719, x = 0.4992822817200274605254946;
  EXPECT_NEAR(seen[0].time, t, 16 * epsilon);  // u falls by 7/2 μ g: 2 roundings of v0 move t by 0.6 ε each
  EXPECT_NEAR(seen[0].state[0], x, 32 * epsilon);
  EXPECT_NEAR(y[2], 1.428571428571428571428571, 16 * epsilon * v0);
  EXPECT_NEAR(y[3] / 0.05, 28.57142857142857142857143, 16 * epsilon * v0 / 0.05);
  EXPECT_NEAR(y[0], x + 10.0 / 7.0 * (2 - t), 64 * epsilon);
}

// Eight guards, four of which cross at one time.
TYPED_TEST(EventsIn, AreManyAtOnceInTheirOrder) {
  State y{0.0, 0.0, 1.0, -1.0};
  std::vector<AnyGuard> guards;
  for (std::size_t i = 0; i < most; ++i) {
    const double root = i % 2 == 0 ? 1.0 : 3.0 - 0.25 * static_cast<double>(i);
    guards.push_back(any(Response::note, Crossing::either, [root, i](double, const State& s) {
      return i % 4 < 2 ? s[0] - root : s[1] + root;
    }));
  }
  std::vector<Seen> seen;
  Motion clock;
  const auto result = this->run(clock, y, 4, with_step<TypeParam>(0.7), guards, seen);
  ASSERT_TRUE(result) << describe(result.status);
  std::vector<std::size_t> order;
  for (const Seen& event : seen) order.push_back(event.guard);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 2, 4, 6, 7, 5, 3, 1}));
}

// x = cos t falls through zero at π/2: where it does for the method, and near that to the method's own error.
TYPED_TEST(EventsIn, AreLocatedAsWellAsTheMethodIs) {
  Motion oscillator{{}, {1.0, 1.0}};
  const auto error = [&](double step) {
    State y{1.0, 0.0, 0.0, 0.0};
    std::vector<Seen> seen;
    const auto result = this->run(oscillator, y, 3, with_step<TypeParam>(step),
                                  {any(Response::stop, Crossing::falling, height)}, seen);
    EXPECT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
    // The state given is beyond zero by no more than a few roundings of the time make of it (slope 1).
    EXPECT_LE(y[0], 0.0);
    EXPECT_GE(y[0], -8 * epsilon * result.time);
    return std::abs(result.time - std::numbers::pi / 2);
  };
  if constexpr (requires { TypeParam::relative_tolerance; TypeParam{}.relative_tolerance; }) {
    EXPECT_LT(error(0.5), 1e-12 * 10);  // tolerance × steps
  } else {
    // h halved: the error falls as the order of the method says, unless it is rounding.
    double order = std::is_same_v<TypeParam, Midpoint> ? 2.0 : 4.0;
    if constexpr (requires { TypeParam::order; }) order = TypeParam::order;
    const double coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse, 0.27 * std::pow(0.1, order) + 16 * epsilon);  // phase of order 2: t h²/6 at most, t = π/2
    EXPECT_LT(fine, coarse / std::pow(2.0, order - 0.5) + 16 * epsilon);
  }
}

// Products of five linear factors, two pairs of which are as near as 1e-5, within two steps of the clock y = t.
TYPED_TEST(EventsIn, LoseNoRootInsideAStep) {
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> place(0.1, 9.9), exponent(-5.0, -1.0);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> roots;
    while (roots.size() < 5) {
      const double root = place(random), pair = root + std::pow(10.0, exponent(random));
      roots.push_back(root);
      if (roots.size() < 5) roots.push_back(pair);
    }
    std::sort(roots.begin(), roots.end());
    State y{0.0, 0.0, 1.0, 0.0};
    std::vector<Seen> seen;
    auto method = with_step<TypeParam>(7.0);
    if constexpr (requires { method.first_step; }) method.first_step = 7.0;
    Motion clock;
    const auto result = this->run(clock, y, 10.5, method,
                                  {any(Response::note, Crossing::either, [&](double, const State& s) {
                                    double value = 1.0;
                                    for (const double root : roots) value *= s[0] - root;
                                    return value;
                                  })},
                                  seen);
    ASSERT_TRUE(result) << describe(result.status);
    ASSERT_EQ(seen.size(), roots.size()) << trial;
    // The terms of an interpolant are as large as what the step changes, 7.
    for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(seen[i].time, roots[i], 8 * epsilon * 7) << trial;
  }
}

// x = cos(t - 1) passes c = cos 1e-3 twice within a step, about its top; that the motion keeps its height is all that
// the methods here have in common (their phases are wrong by up to 2π h²/12).
TYPED_TEST(EventsIn, SeeAPairOfCrossingsInsideAStep) {
  State y{1.0, 0.0, 0.0, 0.0};
  std::vector<Seen> seen;
  // By the explicit midpoint rule it grows by h³/8 a second, which must be little beside the 5e-7 of 1 - c.
  const double step = std::is_same_v<TypeParam, Midpoint> ? 0.002 : 0.01;
  Motion oscillator{{}, {1.0, 1.0}};
  const auto result = this->run(oscillator, y, 9, with_step<TypeParam>(step),
                                {any(Response::note, Crossing::either,
                                     [](double, const State& s) { return s[0] - std::cos(1e-3); })},
                                seen, 1.0);
  ASSERT_TRUE(result) << describe(result.status);
  ASSERT_EQ(seen.size(), 3U);  // from t = 1, where the cosine is at its top: once down, then up and down about 1 + 2π
  EXPECT_NEAR(seen[0].time, 1.0 + 1e-3, 1e-5);
  EXPECT_NEAR((seen[1].time + seen[2].time) / 2, 1.0 + 2 * std::numbers::pi, 6 * step * step);
  EXPECT_NEAR(seen[2].time - seen[1].time, 2e-3, 2e-4);
}

// The steps themselves: states inside them, to the order that each interpolant has.
template <class Method>
double worst_inside(double step) {
  const Motion oscillator{{}, {1.0, 4.0}};
  State y{1.0, 0.0, 0.0, 2.0};
  double worst = 0.0, seam = 0.0;
  State last = y;
  const auto result = integrate(oscillator, y, 0, 2, Method{.step = step}, [&](const auto& inside) requires requires {
    inside.start;
  } {
    const State first = inside(inside.start);
    for (std::size_t i = 0; i < 4; ++i) seam = std::max(seam, std::abs(first[i] - last[i]));
    for (const double part : {0.25, 0.5, 0.8}) {
      const double t = inside.start + part * (inside.end - inside.start);
      const State at = inside(t);
      worst = std::max({worst, std::abs(at[0] - std::cos(t)), std::abs(at[1] - std::sin(2 * t)),
                        std::abs(at[2] + std::sin(t)), std::abs(at[3] - 2 * std::cos(2 * t))});
    }
    last = inside(inside.end);
  });
  EXPECT_TRUE(result) << describe(result);
  EXPECT_LE(seam, 4 * epsilon * 2);
  return worst;
}

TEST(GaussSteps, AreOfTheirOrderInside) {
  // Local error h^(stages + 2) for three stages and more; two stages are of order 4 at the ends and inside.
  EXPECT_GT(worst_inside<GaussCollocation<2>>(0.1) / worst_inside<GaussCollocation<2>>(0.05), 12.0);
  EXPECT_GT(worst_inside<GaussCollocation<3>>(0.1) / worst_inside<GaussCollocation<3>>(0.05), 24.0);
  EXPECT_GT(worst_inside<GaussCollocation<5>>(0.2) / worst_inside<GaussCollocation<5>>(0.1), 96.0);
  EXPECT_GT(worst_inside<GaussCollocation<1>>(0.1) / worst_inside<GaussCollocation<1>>(0.05), 3.6);
  EXPECT_LT(worst_inside<GaussCollocation<6>>(0.05), 1e-11);
}

TEST(StoermerVerletSteps, AreOfTheMethodsOrderInside) {
  EXPECT_GT(worst_inside<StoermerVerlet>(0.02) / worst_inside<StoermerVerlet>(0.01), 3.6);
}

/// Steps y + h f, exact for the clock, with an interpolant that sags between them.
struct Sagging {
  static constexpr bool coarse_inside = true;
  double step = 1.0;

  struct Step {
    double start, end;
    State y_start, y_end;
    State operator()(double t) const noexcept {
      const double part = (t - start) / (end - start);
      State y;
      for (std::size_t i = 0; i < 4; ++i) y[i] = y_start[i] + part * (y_end[i] - y_start[i]) - 0.4 * part * (1 - part);
      return y;
    }
  };
  struct Formula {
    using Step = Sagging::Step;
    template <class F>
    static bool step(F& f, double t, double h, const State& y, State& next) noexcept {
      if (!f(t, y, next)) return false;
      for (std::size_t i = 0; i < 4; ++i) next[i] = y[i] + h * next[i];
      return true;
    }
    template <class F>
    static bool refine(F&, double, double, const State&, const State&) noexcept {
      return true;
    }
    static Step interpolant(double t, double t_next, const State& y, const State& next) noexcept {
      return {t, t_next, y, next};
    }
  };
  template <class S>
  [[nodiscard]] auto start(S& system, State& y, double t) const noexcept {
    return FixedStepRun<Formula, S, double, 4>(system, y, t, step);
  }
};

TEST(EventsBySteps, AreThoseOfTheStepsAndNotOfTheInterpolant) {
  State y{0.0, 0.0, 1.0, 0.0};
  Motion clock;
  const auto half = stop_at([](double, const State& s) { return s[0] - 0.5; });
  const auto located = integrate_with_events(clock, y, 0, 3, Sagging{}, Events(half));
  EXPECT_EQ(located.status, EventStatus::stopped_at_event);
  EXPECT_NEAR(located.time, 0.5, epsilon);  // the interpolant has it at 0.6 or so
}

TEST(EventsBySteps, AreNotKeptWhereNoStepCrosses) {
  // The interpolant alone falls to -0.1.
  State y{0.0, 0.0, 1.0, 0.0};
  Motion clock;
  int told = 0;
  const auto result =
      integrate_with_events(clock, y, 0, 3, Sagging{}, Events(note([](double, const State& s) { return s[1] + 0.05; })),
                            [&](const auto&) { ++told; });
  EXPECT_EQ(result.status, EventStatus::guard_not_followed) << describe(result.status);
  EXPECT_EQ(told, 0);
}

// A wheel at 3 rad/s, its angle taken back into [-π, π] a dozen times: inside the steps it goes on evenly.
template <class Method>
void expect_no_jump_inside() {
  const auto wheel = angles_within_a_turn(Motion{}, std::array<std::size_t, 1>{0});
  State y{0.0, 0.0, 3.0, 0.0};
  double worst = 0.0;
  int jumps = 0;
  const auto result = integrate(wheel, y, 0, 25, with_step<Method>(0.4), [&](const auto& step) requires requires {
    step.start;
  } {
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const double t = step.start + part * (step.end - step.start), angle = step(t)[0];
      worst = std::max(worst, std::abs(std::remainder(angle - 3 * t, 2 * std::numbers::pi)));
      jumps += part == 1.0 && std::abs(angle) > std::numbers::pi ? 1 : 0;
    }
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LE(worst, 64 * epsilon * 75);  // some sixty steps round an angle that this test lets grow to 75
  EXPECT_EQ(jumps, 12);                 // 75 = 11.94 turns, taken back at 0.5, 1.5, ... 11.5 turns
  EXPECT_LE(std::abs(y[0]), std::numbers::pi);
}

TEST(AnglesWithinATurn, AreLedBackToWhereTheyCameFrom) {
  const auto wheel = angles_within_a_turn(Motion{}, std::array<std::size_t, 1>{0});
  for (const double before : {-20.0, -3.5, 3.0, 3.5, 10.0, 100.0}) {
    const State from{before, 5.0, 3.0, 7.0};
    State settled = from;
    ASSERT_EQ(wheel.project(0.0, settled), Evaluation::ok);
    EXPECT_LE(std::abs(settled[0]), std::numbers::pi);
    const State back = wheel.unwound(settled, from);
    EXPECT_NEAR(back[0], before, 16 * epsilon * std::abs(before));  // 2π is rounded once, up to 16 times over
    for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(back[i], from[i]);
  }
}

TEST(AnglesWithinATurn, DoNotJumpInsideSteps) {
  expect_no_jump_inside<DormandPrince54>();
  expect_no_jump_inside<DormandPrince853>();
  expect_no_jump_inside<Taylor>();
  expect_no_jump_inside<StoermerVerlet>();
  expect_no_jump_inside<GaussCollocation<3>>();
  expect_no_jump_inside<RadauIia5>();
}

}  // namespace
}  // namespace event_methods_test
