// SPDX-License-Identifier: GPL-3.0-or-later
// What derivatives of accelerations are made of, against the recursions of inverse dynamics, mass matrix and bias.
#include <gtest/gtest.h>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/recursions/inertia_derivatives.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::inertia_slopes_test {
namespace {

using namespace testing_mechanisms;

Scene flying_arm() {
  Scene s("flying_arm");
  const Expression x = s.coordinate("x", "m"), y = s.coordinate("y", "m"), a = s.coordinate("a", "rad");
  const FrameHandle slide = s.prismatic("slide", s.ground(), {3, 0, 4}, x);
  const FrameHandle trunk = s.spherical("trunk", slide, s.attitude("ball"), {.origin = {0, quantity("0.3", "m"), 0}});
  const FrameHandle arm = s.revolute("arm", trunk, {1, 2, 2}, a, {.origin = {quantity("0.2", "m"), 0, 0}});
  const FrameHandle hand = s.prismatic("hand", arm, -axis::y, y, {.origin = {0, 0, quantity("0.5", "m")}});
  for (const FrameHandle& frame : {slide, trunk, arm, hand}) {
    s.body("body" + std::to_string(frame.index), frame, generic_body("1.2"));
  }
  s.gravity({0, quantity("1", "m/s^2"), quantity("-9.81", "m/s^2")});
  return s;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all{flying_arm()};
  for (Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    if (scene.name() == "panda" || scene.name() == "chain8") all.push_back(std::move(scene));
  }
  return all;
}

// Sixty digits, less those that some thousand operations on numbers below 1e6 lose.
constexpr int digits = 60;
constexpr double bound = 1e-48;

TEST(InertiaSlopes, HaveTheBiasOfInverseDynamicsAtRest) {
  const WorkingDigits precision(digits);
  for (const Scene& scene : scenes()) {
    const Equations equations(scene);
    ASSERT_TRUE(all_joints_are_free(equations.model()));
    const InertiaSlopes slopes = inertia_slopes(equations.model());
    const RandomState state(scene, 3);
    Evaluator<Real> at(equations.program(), state.in_real());
    for (std::size_t i = 0; i < slopes.bias.size(); ++i) {
      // Without springs and motors the bias is that of inertia and gravity.
      const Real direct = at(equations.bias()[i]) + at(equations.actions().passive[i]), found = at(slopes.bias[i]);
      EXPECT_LE(abs(found - direct).to_double(), bound * (1 + abs(direct).to_double())) << scene.name() << " " << i;
    }
  }
}

TEST(InertiaSlopes, LackColumnsOfTheMassMatrix) {
  const WorkingDigits precision(digits);
  for (const Scene& scene : scenes()) {
    const Equations equations(scene);
    const InertiaSlopes slopes = inertia_slopes(equations.model());
    const ForceDerivatives whole = inertia_derivatives(equations.model());
    const RandomState state(scene, 4);
    Evaluator<Real> at(equations.program(), state.in_real());
    double left_out = 0;
    for (std::size_t j = 0; j < slopes.own.size(); ++j) {
      const Real own = at(slopes.own[j]);
      left_out += abs(own).to_double();
      for (std::size_t i = 0; i < slopes.own.size(); ++i) {
        const Real sum = at(slopes.forces.by_position[i][j]) + own * at(equations.mass()[i][j]);
        const Real direct = at(whole.by_position[i][j]);
        EXPECT_LE(abs(sum - direct).to_double(), bound * (1 + abs(direct).to_double())) << scene.name();
      }
    }
    EXPECT_GT(left_out, 0.1) << scene.name();
  }
}

TEST(Linearisation, LeavesWhatInverseDynamicsAsksForWithLessWork) {
  const WorkingDigits precision(digits);
  for (const Scene& scene : scenes()) {
    const Equations equations(scene);
    const Linearisation linear = linearisation(equations);
    const RandomState state(scene, 5);
    Evaluator<Real> at(equations.program(), state.in_real());
    std::vector<Value> alone = equations.inverse_dynamics(), shared = linear.F;
    for (std::size_t i = 0; i < linear.F.size(); ++i) {
      const Real direct = at(equations.inverse_dynamics()[i]), found = at(linear.F[i]);
      EXPECT_LE(abs(found + direct).to_double(), bound * (1 + abs(direct).to_double())) << scene.name() << " " << i;
    }
    for (const ValueMatrix* matrix : {&linear.M, &linear.C, &linear.K}) {
      for (const auto& row : *matrix) {
        alone.insert(alone.end(), row.begin(), row.end());
        shared.insert(shared.end(), row.begin(), row.end());
      }
    }
    const int cost = count(equations.program(), shared).total(), before = count(equations.program(), alone).total();
    EXPECT_LE(cost, before) << scene.name();
    if (scene.name() != "flying_arm") {
      EXPECT_LT(cost, before) << scene.name();  // whose skew axes keep all inertia
    }
  }
}

}  // namespace
}  // namespace torsor::inertia_slopes_test
