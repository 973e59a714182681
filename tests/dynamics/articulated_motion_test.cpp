// SPDX-License-Identifier: GPL-3.0-or-later
// The articulated-body recursion against the factorised mass matrix: two derivations to the same accelerations.
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/scenes/trees.hpp"

namespace torsor::articulated_motion_test {
namespace {

using namespace testing_mechanisms;

/// A tree with two branches, a skew axis, prismatic and driven joints, springs, a damper, a motor, given wrenches.
Scene branching_tree() {
  BranchingTree tree("branching_tree");
  Scene& s = tree.scene;
  const PointHandle p = s.point("P", tree.tip, {quantity("0.3", "m"), 0, 0});
  const PointHandle q = s.point("Q", s.ground(), {0, quantity("1", "m"), 0});
  s.spring("spring", {.a = p, .b = q, .stiffness = quantity("40", "N/m"), .rest = quantity("0.2", "m")});
  s.damper("damper", tree.c, quantity("0.3", "N m s"));
  s.motor("u", tree.b);
  s.force("force", {.body = tree.branch, .point = p, .components = {0, quantity("3", "N"), 0}, .axes = s.ground()});
  return s;
}

TEST(ArticulatedBody, GivesTheAccelerationsOfTheFactorisedMassMatrix) {
  const Scene scene = branching_tree();
  const WorkingDigits precision(60);
  ModelOptions factorisation, recursion;
  factorisation.forward = ForwardMethod::factorisation;
  recursion.forward = ForwardMethod::articulated_body;
  const Equations one(scene, factorisation), other(scene, recursion);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomState state(scene, seed);
    Evaluator<Real> first(one.program(), state.in_real()), second(other.program(), state.in_real());
    const std::vector<Real> x = first(one.forward().accelerations), y = second(other.forward().accelerations);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      // 60 digits less what a condition of M below 1e5 and a few hundred operations cost.
      EXPECT_LT(abs(x[i] - y[i]).to_double(), 1e-50 * (1 + abs(x[i]).to_double())) << "seed " << seed << ", i = " << i;
    }
  }
}

TEST(ArticulatedBody, IsTakenForLongChainsAndTheFactorisationForShortOnes) {
  const auto chosen_is_recursion = [](int n) {
    Scene s("chain");
    FrameHandle parent = s.ground();
    for (int i = 0; i < n; ++i) {
      const std::string name = "q" + std::to_string(i);
      parent = s.revolute(name, parent, i % 2 == 0 ? axis::x : axis::y, s.coordinate(name, "rad"),
                          {.origin = {0, 0, quantity("0.25", "m")}});
      s.body(name, parent, generic_body("1"));
    }
    ModelOptions recursion;
    recursion.forward = ForwardMethod::articulated_body;
    const Equations cheapest(s), recursive(s, recursion);
    const auto cost = [](const Equations& e) { return count(e.program(), e.forward().accelerations).total(); };
    return cost(cheapest) == cost(recursive);
  };
  EXPECT_FALSE(chosen_is_recursion(3));
  EXPECT_TRUE(chosen_is_recursion(24));
}

TEST(ArticulatedBody, IsRefusedWhereItDoesNotFit) {
  Scene s("pendulum");
  const Expression a = s.coordinate("a", "rad");
  const FrameHandle first = s.revolute("first", s.ground(), axis::z, a);
  const FrameHandle second = s.revolute("second", first, axis::z, 2 * a);
  s.body("bob", second, Inertia::point(quantity("1", "kg")).at({quantity("1", "m"), 0, 0}));
  ModelOptions recursion;
  recursion.forward = ForwardMethod::articulated_body;
  const Equations equations(s, recursion);
  EXPECT_THROW(equations.forward(), UsageError);
}

}  // namespace
}  // namespace torsor::articulated_motion_test
