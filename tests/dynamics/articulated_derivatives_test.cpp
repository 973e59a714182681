// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the motion through articulated bodies against those that solve with the factorisation of M.
#include "generator/dynamics/derivatives/articulated_derivatives.hpp"

#include <gtest/gtest.h>

#include "benchmarks/model_counts/models.hpp"
#include "generator/program/evaluation.hpp"
#include "generator/program/formula.hpp"
#include "generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::articulated_derivatives_test {
namespace {

constexpr int digits = 60;

Expression quantity(const char* value, const char* unit) { return Expression::quantity(value, unit); }

ModelOptions by(ForwardMethod method) {
  ModelOptions options;
  options.forward = method;
  return options;
}

/// Largest difference over 1 + size, at a random state in sixty digits, and whether an attitude moved.
struct Difference {
  double largest = 0;
  bool turning = false;
};

Difference difference(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(digits);
  const Equations one(scene, by(ForwardMethod::articulated_body)), other(scene, by(ForwardMethod::factorisation));
  EXPECT_TRUE(fits_articulated_derivatives(one));
  const ForwardDerivatives articulated = forward_derivatives(one), solved = forward_derivatives(other);
  const RandomState state(scene, seed);
  Evaluator<Real> first(one.program(), state.in_real()), second(other.program(), state.in_real());
  Difference found;
  for (const CoordinateContent& coordinate : one.model().coordinates()) {
    found.turning = found.turning || coordinate.attitude >= 0;
  }
  using Of = ForwardDerivatives::Of;
  for (const auto matrix : {&Of::by_position, &Of::by_velocity, &Of::by_force, &Of::by_input}) {
    const ValueMatrix &x = articulated.accelerations.*matrix, &y = solved.accelerations.*matrix;
    EXPECT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = 0; j < x[i].size(); ++j) {
        const Real a = first(x[i][j]), b = second(y[i][j]);
        found.largest = std::max(found.largest, abs(a - b).to_double() / (1 + abs(b).to_double()));
      }
    }
  }
  return found;
}

// Sixty digits less the condition of M, below 1e8 where the pivots of random mechanisms are, squared by two solves.
constexpr double bound = 1e-40;

/// A trunk with two branches, one of which forks: skew, negative and slanted axes, slides, a driven joint, an
/// attitude in the middle, springs, dampers, motors.
Scene forking_tree() {
  Scene s("forking_tree");
  const auto turn = [&s](const char* name) { return s.coordinate(name, "rad"); };
  const Expression a = turn("a"), b = s.coordinate("b", "m"), c = turn("c"), d = turn("d"), e = turn("e");
  const Expression f = s.coordinate("f", "m"), g = turn("g"), driven = turn("driven");
  s.drive(driven, pow(s.time() / quantity("1", "s"), 2));
  const FrameHandle trunk = s.revolute("trunk", s.ground(), axis::z, a, {.origin = {quantity("0.1", "m"), 0, 0}});
  const FrameHandle slide = s.prismatic("slide", trunk, {0, 1, 1}, b, {.rotation = Rotation::about(0, 2)});
  const FrameHandle rotor = s.revolute("rotor", slide, axis::x, driven);
  const FrameHandle tip = s.revolute("tip", rotor, {1, 2, 2}, c, {.origin = {0, 0, quantity("0.3", "m")}});
  const FrameHandle branch = s.revolute("branch", trunk, -axis::y, d, {.origin = {0, quantity("0.2", "m"), 0}});
  const FrameHandle left =
      s.spherical("left", branch, s.attitude("ball"), {.origin = {quantity("0.4", "m"), quantity("0.1", "m"), 0}});
  const FrameHandle finger = s.revolute("finger", left, axis::x, e, {.origin = {0, quantity("0.2", "m"), 0}});
  const FrameHandle right = s.prismatic("right", branch, -axis::z, f, {.origin = {0, quantity("0.1", "m"), 0}});
  const FrameHandle hand = s.revolute("hand", right, axis::y, g, {.rotation = Rotation::about(2, 3)});
  for (const FrameHandle& frame : {trunk, slide, rotor, tip, branch, left, finger, right, hand}) {
    const auto j = [](const char* value) { return quantity(value, "kg m^2"); };
    s.body("body" + std::to_string(frame.index), frame,
           Inertia::general({.mass = quantity("1.5", "kg"), .xx = j("0.3"), .yy = j("0.5"), .zz = j("0.4"),
                             .xy = j("0.1"), .xz = j("-0.02"), .yz = j("0.03")})
               .at({quantity("-0.1", "m"), quantity("0.2", "m"), quantity("0.05", "m")}));
  }
  s.gravity({0, 0, quantity("-9.81", "m/s^2")});
  s.spring("spring", c - 2 * g, quantity("40", "N m"));
  s.damper("damper", c, quantity("0.3", "N m s"));
  s.motor("u", b);
  s.motor("w", g);
  return s;
}

TEST(ArticulatedDerivatives, AreThoseOfSolvingOnAForkingTree) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) EXPECT_LT(difference(forking_tree(), seed).largest, bound);
}

TEST(ArticulatedDerivatives, AreThoseOfSolvingOnChainsOfBenchmarks) {
  for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    if (scene.name() == "chain32" || scene.name() == "chain16") continue;
    EXPECT_LT(difference(scene, 5).largest, bound) << scene.name();
  }
}

TEST(ArticulatedDerivatives, AreThoseOfSolvingOnRandomTrees) {
  int compared = 0, turning = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    testing_mechanisms::RandomMechanismOptions options;
    options.actions = options.released = options.constraints = false;
    options.motors = seed % 2 == 0;
    options.joints = seed % 3 != 0;
    const Scene scene = testing_mechanisms::random_mechanism(seed, options);
    if (!fits_articulated_derivatives(Equations(scene))) continue;
    const Difference found = difference(scene, seed);
    EXPECT_LT(found.largest, bound) << testing_mechanisms::call_of(seed, options);
    ++compared;
    turning += found.turning ? 1 : 0;
  }
  EXPECT_GE(compared, 20);
  EXPECT_GE(turning, 4);
}

TEST(ArticulatedDerivatives, AreTakenForLongChains) {
  for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    const auto total = [&scene](ForwardMethod method) {
      const Equations equations(scene, by(method));
      const ForwardDerivatives::Of of = forward_derivatives(equations).accelerations;
      std::vector<Value> all;
      for (const ValueMatrix* matrix : {&of.by_position, &of.by_velocity, &of.by_force}) {
        for (const auto& row : *matrix) all.insert(all.end(), row.begin(), row.end());
      }
      return count(equations.program(), all).total();
    };
    if (scene.name() != "panda" && scene.name() != "chain16") continue;
    const bool longer = scene.name() == "chain16";
    const int least = total(ForwardMethod::cheapest);
    EXPECT_EQ(least, total(longer ? ForwardMethod::articulated_body : ForwardMethod::factorisation));
    EXPECT_LE(least, longer ? 22'900 : 4'450);  // Pinocchio's, taped and optimised by CppAD: 30,394 and 7,059
  }
}

}  // namespace
}  // namespace torsor::articulated_derivatives_test
