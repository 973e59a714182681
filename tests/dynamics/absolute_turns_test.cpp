// SPDX-License-Identifier: GPL-3.0-or-later
// Gravity turned into links by their absolute angles at once, against the same joint by joint.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "tests/dynamics/random_mechanism.hpp"
#include "tests/long_tests.hpp"
#include "tests/scenes/bodies.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/random_state.hpp"

namespace torsor::absolute_turns_test {
namespace {

using namespace testing_mechanisms;

/// A tree of turns and a few slides. Most joints turn about the axis of the one before; many of their angles are counted from
/// where its coordinate is, or from where the one before that is, as absolute angles are.
Scene random_tree(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&random](unsigned n) { return random() % n; };
  Scene s("tree");
  struct Joint {
    FrameHandle frame;
    Expression q, angle;
    std::size_t axis = 0, parent = 0;
  };
  std::vector<Joint> joints{{s.ground(), {}, {}, 3, 0}};
  const std::size_t count = 2 + below(5);
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t parent = below(4) > 0 ? k - 1 : below(static_cast<unsigned>(k));
    const Joint& before = joints[parent];
    const bool same = before.axis < 3 && below(4) > 0;
    const std::size_t axis = same ? before.axis : below(3);
    const std::string name = std::to_string(k);
    Placement place{.origin = {quantity("0.1", "m"), quantity(below(2) == 0 ? "0" : "-0.4", "m"), quantity("0.2", "m")}};
    const std::size_t turned_about = below(2) == 0 ? axis : below(3);
    if (below(3) == 0) place.rotation = Rotation::about(static_cast<int>(turned_about), static_cast<int>(below(24)));
    Joint joint{.frame = before.frame, .q = {}, .angle = {}, .axis = axis, .parent = parent};
    const Triple direction = std::array<Triple, 3>{axis::x, axis::y, axis::z}[axis];
    if (below(6) == 0) {
      joint.axis = 3;
      joint.frame = s.prismatic("slide" + name, before.frame, direction, s.coordinate("x" + name, "m"), place);
    } else {
      joint.q = s.coordinate("q" + name, "rad");
      joint.angle = joint.q;
      if (same && below(4) > 0) joint.angle = joint.q - before.q;
      const Joint& first = joints[before.parent];
      if (same && first.axis == axis && below(5) == 0) joint.angle = joint.q - before.angle - first.q;
      joint.frame = s.revolute("turn" + name, before.frame, direction, joint.angle, place);
    }
    if (k == count || below(4) > 0) s.body("body" + name, joint.frame, generic_body());
    joints.push_back(joint);
  }
  for (std::size_t k = 1; k < joints.size(); ++k) {  // no end without matter
    const bool carries = std::any_of(joints.begin() + 1, joints.end(), [k](const Joint& joint) { return joint.parent == k; });
    if (!carries) s.body("tip" + std::to_string(k), joints[k].frame, generic_body("0.7"));
  }
  s.gravity({quantity("1", "m/s^2"), quantity("2", "m/s^2"), quantity("-9.81", "m/s^2")});
  return s;
}

TEST(AbsoluteTurns, GiveTheForcesOfTurnsJointByJoint) {
  const WorkingDigits precision(60);
  int at_once = 0;
  for (unsigned seed = 1; seed <= wanted(60U, 1000U); ++seed) {
    const Scene scene = random_tree(seed);
    const Equations equations(scene);
    at_once += equations.model().without_lines().has_absolute_turns() ? 1 : 0;
    const RandomState state(scene, seed);
    Evaluator<Real> here(equations.program(), state.in_real());
    const std::vector<Real> one = here(equations.inverse_dynamics()), other = here(equations.inverse_dynamics_of_motion());
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_LT((abs(one[i] - other[i]) / (Real(1) + abs(other[i]))).to_double(), 1e-50) << "seed " << seed << ", force " << i;
  }
  EXPECT_GE(at_once, 20);
}

}  // namespace
}  // namespace torsor::absolute_turns_test
