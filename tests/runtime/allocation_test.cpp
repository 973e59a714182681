// SPDX-License-Identifier: GPL-3.0-or-later

// Eigen allocates by malloc, past operator new: its own guard asserts on each attempt, which is counted here.
namespace {
long eigen_complaints = 0;
}
#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition) ((condition) ? (void)0 : (void)++eigen_complaints)

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <span>
#include <vector>

#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/linear_solve.hpp"
#include "torsor/runtime/numerics/operational_inertia.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "torsor/runtime/records/trajectory.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace {
long allocations = 0;
}

// Not inlined: g++ 12 would see free() meet operator new and warn, which is the purpose here.
#define NOT_INLINED __attribute__((noinline))
NOT_INLINED void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
NOT_INLINED void* operator new[](std::size_t size) { return operator new(size); }
NOT_INLINED void operator delete(void* memory) noexcept { std::free(memory); }
NOT_INLINED void operator delete[](void* memory) noexcept { std::free(memory); }
NOT_INLINED void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
NOT_INLINED void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace torsor::runtime;
using CartesianPendulum = mechanisms::CartesianPendulum<double>;

template <class Action>
long allocations_during(Action&& action) {
  const long before = allocations;
  eigen_complaints = 0;
  Eigen::internal::set_is_malloc_allowed(false);
  action();
  Eigen::internal::set_is_malloc_allowed(true);
  return allocations - before + eigen_complaints;
}

TEST(Allocations, AreCounted) {
  EXPECT_GT(allocations_during([] { std::vector<int>(3).swap(*std::make_unique<std::vector<int>>()); }), 0);
  EXPECT_GT(allocations_during([] { Eigen::MatrixXd::Zero(40, 40).eval(); }), 0);
}

template <class Method>
void expect_none(const Method& method, double end, std::int64_t steps) {
  const auto motion = equations_of_motion<mechanisms::Pendulum<double>>();
  auto y = motion.initial();
  Result<double> result;
  double last = 0.0;
  EXPECT_EQ(allocations_during([&] {
              result =
                  integrate(motion, y, 0.0, end, method, [&](double t, const std::array<double, 2>&) { last = t; });
            }),
            0);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(last, end);
  EXPECT_GE(result.statistics.accepted, steps);
}

TEST(Allocations, AreNoneInAHundredThousandStepsOfEachMethod) {
  expect_none(Midpoint{.step = 1e-3}, 100.0, 100'000);
  expect_none(RungeKutta4{.step = 1e-3}, 100.0, 100'000);
  expect_none(DormandPrince54{.largest_step = 1e-3}, 100.0, 100'000);
  expect_none(DormandPrince853{.largest_step = 1e-3, .compensated = true}, 100.0, 100'000);
  expect_none(StoermerVerlet{.step = 1e-3}, 100.0, 100'000);
}

TEST(Allocations, AreNoneInTheImplicitMethods) {
  expect_none(GaussCollocation<3>{.step = 1e-2}, 10.0, 1'000);
  expect_none(GaussCollocation<3, StageSolver::newton>{.step = 1e-2}, 10.0, 1'000);
  expect_none(RadauIia5{.largest_step = 1e-2}, 10.0, 1'000);
  expect_none(VariationalIntegrator<2>{.step = 1e-2}, 10.0, 1'000);
}

/// x'' = -x with its Taylor coefficients.
struct Oscillating {
  using State = std::array<double, 2>;
  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -y[0]};
    return Evaluation::ok;
  }
  Evaluation jets(double, const State& y, std::span<State> c) const noexcept {
    c[0] = y;
    for (std::size_t k = 1; k < c.size(); ++k) {
      c[k] = {c[k - 1][1] / static_cast<double>(k), -c[k - 1][0] / static_cast<double>(k)};
    }
    return Evaluation::ok;
  }
};

TEST(Allocations, AreNoneInTaylorsMethod) {
  std::array<double, 2> y{1.0, 0.0};
  const auto stop = [](double, const std::array<double, 2>& at) { return at[0]; };
  Result<double> result;
  EXPECT_EQ(allocations_during([&] { result = integrate(Oscillating{}, y, 0, 1000, Taylor{.largest_step = 0.1}); }), 0);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_GE(result.statistics.accepted, 10'000);
  EXPECT_EQ(allocations_during([&] {
              const auto events = integrate_with_events(Oscillating{}, y, 0, 20, Taylor{}, Events(note(stop)));
              EXPECT_GE(events.fired[0], 6);
            }),
            0);
}

TEST(Allocations, AreNoneOnConstraints) {
  const auto motion = equations_of_motion<CartesianPendulum>();
  const auto expect = [](const auto& run) {
    bool done = false;
    EXPECT_EQ(allocations_during([&] { done = run(); }), 0);
    EXPECT_TRUE(done);
  };
  auto y = motion.initial();
  expect([&] { return static_cast<bool>(integrate(motion, y, 0, 10, StabilisedRadauIia5{.largest_step = 1e-2})); });
  y = motion.initial();
  expect([&] { return static_cast<bool>(integrate(projected(motion), y, 0, 10, DormandPrince853{})); });
  y = motion.initial();
  expect([&] { return static_cast<bool>(integrate(projected(motion), y, 0, 10, RungeKutta4{.step = 1e-2})); });
  y = motion.initial();
  expect([&] { return static_cast<bool>(integrate_partitioned<1>(motion, y, 0, 10, DormandPrince853{})); });
  y = motion.initial();
  const Events lowest(note([](double, const std::array<double, 4>& s) { return s[0]; }));
  expect([&] {
    const auto result = integrate_with_events(motion, y, 0, 10, StabilisedRadauIia5{}, lowest);
    return static_cast<bool>(result) && result.fired[0] > 5;
  });
}

TEST(Allocations, AreNoneWhileRecordingThroughTheInterpolantAndComparing) {
  const auto motion = equations_of_motion<CartesianPendulum>();
  auto y = motion.initial();
  std::vector<Sample<double, 4>> storage(1001);
  Trajectory<double, 4> trajectory(storage, {"x", "y", "x'", "y'"});
  EquallySpaced observer(0.0, 0.01, trajectory);
  Reference<double> reference{"", {"x", "y", "x'", "y'"}, {0.0, 10.0}, std::vector<double>(8)};
  ReferenceErrors<double, 4> errors(reference);
  EXPECT_EQ(allocations_during([&] {
              EXPECT_TRUE(integrate(motion, y, 0, 10, DormandPrince54{}, observer));
              y = motion.initial();
              EXPECT_TRUE(integrate_through(motion, y, 0.0, reference.times, DormandPrince54{}, errors));
            }),
            0);
  EXPECT_EQ(trajectory.samples().size(), 1001U);
  EXPECT_EQ(errors.compared(), 2U);
}

TEST(Allocations, AreNoneInEvents) {
  const auto motion = equations_of_motion<mechanisms::Pendulum<double>>();
  const auto angle = [](double, const std::array<double, 2>& y) { return y[0] + 1; };
  const auto reverse = [](double, std::array<double, 2>& y) { y[1] *= -1; };
  const Events events(barrier(angle, reverse), note([](double t, const auto&) { return std::sin(t); }));
  const auto count = [&](const auto& method) {
    auto y = motion.initial();
    return allocations_during([&] {
      const auto result = integrate_with_events(motion, y, 0, 20, method, events);
      EXPECT_TRUE(result) << describe(result.status);
      EXPECT_GT(result.fired[0], 5);
      EXPECT_EQ(result.fired[1], 6);
    });
  };
  EXPECT_EQ(count(DormandPrince54{}), 0);
  EXPECT_EQ(count(RungeKutta4{.step = 0.01}), 0);
  EXPECT_EQ(count(GaussCollocation<3>{.step = 0.05}), 0);
  EXPECT_EQ(count(RadauIia5{}), 0);
  EXPECT_EQ(count(StoermerVerlet{.step = 0.01}), 0);
  EXPECT_EQ(count(VariationalIntegrator<2>{.step = 0.05}), 0);
}

// Large enough for Eigen's blocked kernels, which take their workspace from the heap when sizes are not fixed.
TEST(Allocations, AreNoneInTheLinearSolves) {
  constexpr std::size_t nv = 24, m = 10;
  std::array<double, nv * nv> mass{};
  std::array<double, m * nv> jacobian{};
  std::array<double, nv> r{}, a{};
  std::array<double, m> gamma{}, lambda{};
  for (std::size_t i = 0; i < nv; ++i) {
    mass[i * nv + i] = 2.0;
    jacobian[i * m + i % m] = 1.0;
    r[i] = 1.0;
  }
  const ConstrainedDynamics<double, nv, m> equations{.mass = mass, .jacobian = jacobian, .r = r, .gamma = gamma};
  EXPECT_EQ(allocations_during([&] {
              for (int i = 0; i < 100; ++i) {
                EXPECT_EQ(solve_dynamics(mass, r, a), Evaluation::ok);
                EXPECT_EQ(solve_constrained_dynamics(equations, a, lambda), Evaluation::ok);
              }
            }),
            0);
}

TEST(Allocations, AreNoneInOperationalInertias) {
  std::array<double, 36> inverse{};
  for (std::size_t i = 0; i < 36; ++i) inverse[i] = i % 7 == 0 ? 2.0 : 0.25;
  EXPECT_EQ(allocations_during([&] {
              EXPECT_EQ(operational_inertia(inverse).evaluation, Evaluation::ok);
              EXPECT_EQ(operational_inertia(inverse, translation_rows).evaluation, Evaluation::ok);
            }),
            0);
}

}  // namespace
