// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "tests/dynamics/constrained_motion.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/long_tests.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/loops.hpp"
#include "tests/scenes/rolling.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::reduction_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;
using State = ConstrainedMotion::State;

/// An entry of a matrix of the kernel, stored by columns.
Value entry(const Kernel& kernel, const std::string& name, std::size_t rows, std::size_t i, std::size_t j) {
  const std::string target = "result." + name + "[" + std::to_string(j * rows + i) + "]";
  for (const Assignment& assignment : kernel.assignments) {
    if (assignment.target.to_string() == target) return assignment.value;
  }
  ADD_FAILURE() << "no entry " << target;
  return {};
}

/// State matrices of the kernel `linearisation` against central differences of the forward dynamics along the
/// constraints, about the state given once its dependent parts are made to satisfy them. Step 1e-18 in 60 digits: the
/// truncation is some 1e-36, the rounding 1e-42 times what differences amplify.
/// False, without a comparison, when Newton's method finds no state that satisfies the constraints.
bool expect_the_flow(const Scene& scene, State state) {
  const WorkingDigits precision(60);
  const Equations equations(scene);
  const Kernel kernel = make_kernel("linearisation", equations);
  const ConstrainedMotion motion(equations);
  const std::size_t n = motion.freedoms();
  IndependentFreedoms freedoms;
  if (equations.constraints().empty()) {
    for (std::size_t i = 0; i < n; ++i) freedoms.coordinates.push_back(i), freedoms.velocities.push_back(i);
  } else {
    freedoms = independent_freedoms(equations);
  }
  state.q.resize(motion.positions().size(), Real(0));
  state.v.resize(n, Real(0));
  state.u.resize(equations.model().inputs().size(), Real(0));
  motion.satisfy(state, freedoms);
  Evaluator<Real> here = motion.at(state);
  for (const auto& [j, freedom] : freedoms.pivots) {
    for (const Value& residual : {equations.constraints()[j].value, equations.constraints()[j].rate}) {
      if (!(abs(here(residual)) < power_of_ten(-50))) return false;
    }
  }
  const std::vector<Real> a = here(equations.forward().accelerations), lambda = here(equations.forward().multipliers);
  Evaluator<Real> linear = motion.at(state, a, lambda);

  const std::size_t k = freedoms.coordinates.size(), p = freedoms.velocities.size();
  const auto flow = [&](const State& at) {
    const std::vector<Real> rates = motion.rates_of_deviation(state, at);
    Evaluator<Real> there = motion.at(at);
    const std::vector<Real> accelerations = there(equations.forward().accelerations);
    std::vector<Real> f;
    for (const std::size_t i : freedoms.coordinates) f.push_back(rates[i]);
    for (const std::size_t i : freedoms.velocities) f.push_back(accelerations[i]);
    return f;
  };
  const Real h = power_of_ten(-18);
  const auto compare = [&](const std::string& matrix, std::size_t column, const auto& move) {
    std::vector<std::vector<Real>> sides;
    for (const Real& step : {h, -h}) {
      State moved = state;
      move(moved, step);
      motion.satisfy(moved, freedoms);
      sides.push_back(flow(moved));
    }
    for (std::size_t i = 0; i < k + p; ++i) {
      const Real difference = (sides[0][i] - sides[1][i]) / (h + h);
      const Real found = linear(entry(kernel, matrix, k + p, i, column));
      EXPECT_LT(relative_difference(found, difference), 1e-28)
          << scene.name() << ": " << matrix << "(" << i << ", " << column << ") = " << found.to_string(12) << ", flow "
          << difference.to_string(12);
    }
  };
  for (std::size_t j = 0; j < k; ++j) {
    compare("A", j, [&](State& s, const Real& step) { motion.displace(s, freedoms.coordinates[j], step); });
  }
  for (std::size_t j = 0; j < p; ++j) {
    compare("A", k + j, [&](State& s, const Real& step) { s.v[freedoms.velocities[j]] += step; });
  }
  for (std::size_t j = 0; j < state.u.size(); ++j) {
    compare("B", j, [&](State& s, const Real& step) { s.u[j] += step; });
  }
  for (std::size_t i = 0; i < p; ++i) {
    EXPECT_LT(relative_difference(linear(entry(kernel, freedoms.pivots.empty() ? "F" : "F_r", p, i, 0)), Real(0)), 1e-40)
        << "F of the motion itself";
  }
  return true;
}

/// Four bars with a spring, a damper and a motor.
Scene four_bar() {
  FourBar bars("four_bar");
  bars.close();
  bars.scene.spring("spring", bars.c, quantity("3", "N m"), quantity("1", "1"));
  bars.scene.damper("damper", bars.b, quantity("0.2", "N m s"));
  bars.scene.motor("u", bars.a);
  return bars.scene;
}

TEST(ReducedLinearisation, IsTheDerivativeOfTheFlowOfALoop) {
  EXPECT_TRUE(expect_the_flow(
      four_bar(), {{rational(1, 1), rational(-3, 10), rational(17, 10)}, {rational(3, 2)}, {rational(2, 5)}}));
}

/// A torque acts on the disc, about its axis and across.
Scene rolling_disc() {
  RollingDisc it;
  it.scene.torque("wind", it.disc, {quantity("0.1", "N m"), 0, quantity("0.3", "N m")}, it.disc);
  return it.scene;
}

TEST(ReducedLinearisation, IsTheDerivativeOfTheFlowOfARollingDiscByQuaternion) {
  State state;
  // Leaning and turning: (8, 5, 3, 1)/sqrt(99).
  const Real norm = sqrt(Real(99));
  state.q = {Real(0), Real(0), rational(2, 5), Real(8) / norm, Real(5) / norm, Real(3) / norm, Real(1) / norm};
  state.v = {Real(0), Real(0), Real(0), rational(1, 3), rational(-2, 5), rational(7, 2)};
  EXPECT_TRUE(expect_the_flow(rolling_disc(), state));
}

TEST(Linearisation, AlongAnAttitudeIsTheDerivativeOfTheFlow) {
  Scene scene("top");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle top = scene.spherical("top", scene.ground(), e);
  scene.body("top", top,
             Inertia::general({.mass = kilograms("2"), .xx = moment("0.3"), .yy = moment("0.4"),
                               .zz = moment("0.2")})
                 .at({metres("0.1"), metres("0.2"), metres("0.7")}));
  scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
  State state;
  const Real norm = sqrt(Real(30));
  state.q = {Real(4) / norm, Real(-3) / norm, Real(1) / norm, Real(2) / norm};
  state.v = {rational(3, 2), rational(-7, 5), rational(9, 4)};
  EXPECT_TRUE(expect_the_flow(scene, state));
}

/// A pendulum on a block that slides in a plane.
struct HangingBob : SlidingPoint {
  Expression q = scene.coordinate("q", "rad");
  State state{{rational(2, 3), Real(0), rational(-5, 4)}, {rational(1, 2), rational(1, 7), rational(3, 2)}, {}};

  HangingBob() : SlidingPoint("hanging_bob", "3") {
    const FrameHandle arm = scene.revolute("arm", point, axis::z, q);
    scene.body("bob", arm, Inertia::point(kilograms("2")).at({metres("1.5"), metres("0.2"), 0}));
    scene.gravity({0, quantity("-9.81", "m/s^2"), 0});
  }
};

// A law of time and a nonholonomic law drag it along.
TEST(ReducedLinearisation, FollowsLawsOfTime) {
  HangingBob it;
  const Expression metre = metres("1"), speed = quantity("1", "m/s"), t = it.scene.time();
  it.scene.holonomic("curve", it.y - metre * sin(it.x / metre) * cos(quantity("2", "1/s") * t));
  it.scene.nonholonomic(
      "law", rate(it.x) - speed * cos(it.q) - quantity("3", "m/s^2") * t * sin(it.y / metre) - rate(it.q) * metre / 5);
  it.state.time = rational(3, 5);
  EXPECT_TRUE(expect_the_flow(it.scene, it.state));
}

TEST(ReducedLinearisation, TakesTheMultipliersOutWhereFrictionWorksWithThem) {
  HangingBob it;
  const ConstraintHandle floor = it.scene.holonomic("floor", it.y - metres("0.3") * sin(it.x / metres("2")));
  it.scene.sliding_friction("friction", floor,
                            {.coefficient = Expression(1) / 5,
                             .body = it.point,
                             .point = it.place,
                             .direction = {rate(it.x), quantity("0.1", "m/s") * it.q + rate(it.y), 0},
                             .axes = it.scene.ground()});
  EXPECT_TRUE(expect_the_flow(it.scene, it.state));
}

TEST(ReducedLinearisation, IsTheDerivativeOfTheFlowOfRandomMechanisms) {
  const unsigned seeds = wanted(8U, 30U);
  unsigned constrained = 0;
  for (unsigned seed = 700; seed < 700 + seeds; ++seed) {
    const Scene scene = random_mechanism(seed);
    if (scene.content().constraints.empty()) continue;
    const Equations equations(scene);
    try {
      if (equations.redundancy().redundant()) continue;
      independent_freedoms(equations);
    } catch (const SceneError&) {
      continue;  // a start that no constraint was made for
    }
    State state;
    for (std::size_t i = 0; i < equations.model().positions().size(); ++i) {
      state.q.push_back(rational(static_cast<long>((i + 1) * 37 % 19) - 9, 17));
      state.v.push_back(rational(static_cast<long>((i + 2) * 41 % 23) - 11, 13));
    }
    for (std::size_t i = 0; i < equations.model().inputs().size(); ++i) state.u.push_back(rational(3, 4));
    SCOPED_TRACE("seed " + std::to_string(seed));
    constrained += expect_the_flow(scene, state) ? 1U : 0U;
  }
  EXPECT_GE(constrained, seeds / 3);
}

TEST(IndependentFreedoms, AreThoseTheSceneWants) {
  Scene scene = four_bar();
  const auto chosen = [](const Scene& s) { return independent_freedoms(Equations(s)).coordinates; };
  const auto coordinate = [](const Scene& s, std::size_t i) { return Expression(s.content().coordinates[i].q); };
  for (std::size_t i = 0; i < 3; ++i) {
    Scene wanting = scene;
    wanting.independent({coordinate(scene, i)});
    EXPECT_EQ(chosen(wanting), std::vector<std::size_t>{i});
  }
  scene.independent({coordinate(scene, 0), coordinate(scene, 1)});
  EXPECT_EQ(
      error_of<SceneError>([&] { chosen(scene); }),
      "coordinate 'b' cannot be independent beside those named before it: the constraints determine it, or nearly, "
      "at the initial configuration; leave it out of independent(...)");
  Scene driven("driven");
  const Expression q = driven.coordinate("q", "rad");
  driven.drive(q, driven.time() * quantity("1", "rad/s"));
  EXPECT_EQ(error_of<SceneError>([&] { driven.independent({q}); }),
            "coordinate 'q' is driven and cannot be independent: name an unknown one");
}

}  // namespace
}  // namespace torsor::reduction_test
