// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the motion through articulated bodies against those that solve with the factorisation of M.
#include "torsor/generator/dynamics/derivatives/articulated_derivatives.hpp"

#include <gtest/gtest.h>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/long_tests.hpp"
#include "tests/scenes/trees.hpp"

namespace torsor::articulated_derivatives_test {
namespace {

using namespace testing_mechanisms;

constexpr int digits = 60;

ModelOptions by(ForwardMethod method) { return {.forward = method}; }

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
  BranchingTree tree("forking_tree");
  Scene& s = tree.scene;
  const Expression e = s.coordinate("e", "rad"), f = s.coordinate("f", "m"), g = s.coordinate("g", "rad");
  const FrameHandle left =
      s.spherical("left", tree.branch, s.attitude("ball"), {.origin = {metres("0.4"), metres("0.1"), 0}});
  const FrameHandle finger = s.revolute("finger", left, axis::x, e, {.origin = {0, metres("0.2"), 0}});
  const FrameHandle right = s.prismatic("right", tree.branch, -axis::z, f, {.origin = {0, metres("0.1"), 0}});
  const FrameHandle hand = s.revolute("hand", right, axis::y, g, {.rotation = Rotation::about(2, 3)});
  tree.add_bodies({left, finger, right, hand});
  s.spring("spring", tree.c - 2 * g, quantity("40", "N m"));
  s.damper("damper", tree.c, quantity("0.3", "N m s"));
  s.motor("u", tree.b);
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
  const int seeds = wanted(60, 120);
  for (unsigned seed = 1; seed <= static_cast<unsigned>(seeds); ++seed) {
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
  EXPECT_GE(compared, seeds / 6);
  EXPECT_GE(turning, seeds / 30);
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
