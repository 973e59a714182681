// SPDX-License-Identifier: GPL-3.0-or-later
// Frames against derivatives of their own poses, and J M⁻¹ Jᵀ against Gauss's elimination of numbers.
#include "torsor/generator/kernels/kernel_frames.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::kernel_frames_test {
namespace {

using namespace testing_mechanisms;
using testing_mechanisms::Block;  // and not that of a schedule

/// A random mechanism with a tool on each frame from one on.
Scene with_tools(const RandomMechanismOptions& options, unsigned seed, bool on_the_last_alone = false) {
  Scene scene = random_mechanism(seed, options);
  const std::size_t frames = scene.content().frames.size();
  for (std::size_t k = on_the_last_alone ? frames - 1 : 1; k < frames; ++k) {
    scene.point("tool" + std::to_string(k), FrameHandle{static_cast<int>(k)}, {metres("0.3"), metres("-0.2"), metres("0.5")});
  }
  return scene;
}

std::map<std::string, Value> results_of(const Kernel& kernel) {
  std::map<std::string, Value> all;
  for (const Assignment& assignment : kernel.assignments) all[assignment.target.to_string()] = assignment.value;
  return all;
}

class FramesOfRandomMechanisms : public ::testing::TestWithParam<unsigned> {
 protected:
  /// Numbers are of order one to 1e4: 50 digits leave 1e-44.
  static void expect_derivatives_of_poses(const Scene& scene) {
    const WorkingDigits precision(50);
    const Equations equations(scene);
    const Model& model = equations.model();
    Program& program = equations.program();
    const std::map<std::string, Value> results = results_of(make_frames(equations));
    const RandomState state(scene, 5);
    Evaluator<Real> at(program, state.in_real());
    const auto entry = [&](const std::string& member, int i) { return results.at("result." + member + "[" + std::to_string(i) + "]"); };
    const auto expect_equal = [&](const Value& a, const Value& b, const std::string& what) {
      EXPECT_LE(abs(at(program.bind(a)) - at(program.bind(b))).to_double(), 1e-44) << scene.name() << ": " << what;
    };
    Substitution steady(program, [&program](const SymbolPointer& symbol) -> std::optional<Value> {
      if (symbol->kind != SymbolKind::acceleration) return std::nullopt;
      return program.number(Number(), symbol->unit);
    });
    const auto n = static_cast<std::size_t>(model.unknown_count());
    for (const PointContent& point : scene.content().points) {
      const std::string& p = point.name;
      Vector linear, angular;
      Matrix turn;
      for (int i = 0; i < 3; ++i) {
        linear[i] = entry(p + "_twist", i);
        angular[i] = entry(p + "_twist", i + 3);
        for (int j = 0; j < 3; ++j) turn(i, j) = entry(p + "_rotation", 3 * j + i);
      }
      for (int i = 0; i < 3; ++i) {
        if (!p.starts_with("moving")) expect_equal(time_derivative(entry(p + "_position", i)), linear[i], p + " velocity");
        for (int j = 0; j < 3; ++j) {
          const Vector column(turn(0, j), turn(1, j), turn(2, j));
          expect_equal(time_derivative(turn(i, j)), bound(program, cross(angular, column))[i], p + " angular velocity");
        }
      }
      for (int i = 0; i < 6; ++i) {
        const Value drift = entry(p + "_drift", i);
        expect_equal(steady(program.bind(time_derivative(entry(p + "_twist", i)))), drift, p + " drift");
        for (std::size_t j = 0; j < n; ++j) {
          Derivation by = partial_derivation(program, model.coordinates()[j].v);
          expect_equal(by(entry(p + "_twist", i)), entry(p + "_jacobian", static_cast<int>(6 * j) + i), p + " Jacobian");
        }
      }
    }
  }

  /// [M −B; A 0] [x; λ] = [J_sᵀ; 0] by elimination with exchange of rows, then J_r x.
  static void expect_answers_to_impulses(const Scene& scene) {
    const WorkingDigits precision(50);
    const Equations equations(scene);
    if (!equations.massless().empty()) return;
    const auto n = static_cast<std::size_t>(equations.model().unknown_count());
    const std::map<std::string, Value> frames = results_of(make_frames(equations));
    const std::map<std::string, Value> inertia = results_of(make_operational_inertia(equations));
    const RandomState state(scene, 6);
    Evaluator<Real> at(equations.program(), state.in_real());
    const std::vector<ConstraintRow>& kept = equations.constraints();
    if (!kept.empty() && equations.redundancy().redundant()) return;
    const std::size_t size = n + kept.size();
    for (const PointContent& point : scene.content().points) {
      const auto column = [&](std::size_t r, std::size_t j) {
        return at(frames.at("result." + point.name + "_jacobian[" + std::to_string(6 * j + r) + "]"));
      };
      for (std::size_t s = 0; s < 6; ++s) {
        std::vector<std::vector<Real>> rows(size, std::vector<Real>(size + 1, Real(0)));
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t j = 0; j < n; ++j) rows[i][j] = at(equations.mass()[i][j]);
          for (std::size_t k = 0; k < kept.size(); ++k) {
            rows[i][n + k] = -at(kept[k].column[i]);
            rows[n + k][i] = at(kept[k].jacobian[i]);
          }
          rows[i][size] = column(s, i);
        }
        for (std::size_t k = 0; k < size; ++k) {
          std::size_t best = k;
          for (std::size_t i = k + 1; i < size; ++i) {
            if (abs(rows[best][k]) < abs(rows[i][k])) best = i;
          }
          std::swap(rows[k], rows[best]);
          for (std::size_t i = 0; i < size; ++i) {
            if (i == k) continue;
            const Real factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j <= size; ++j) rows[i][j] = rows[i][j] - factor * rows[k][j];
          }
        }
        for (std::size_t r = 0; r < 6; ++r) {
          Real expected(0);
          for (std::size_t i = 0; i < n; ++i) expected = expected + column(r, i) * (rows[i][size] / rows[i][i]);
          const Real found = at(inertia.at("result." + point.name + "_inverse_inertia[" + std::to_string(6 * s + r) + "]"));
          // Fifty digits, of which an ill-conditioned state may take fifteen.
          EXPECT_LE(abs(found - expected).to_double(), 1e-35 * (1 + abs(expected).to_double())) << scene.name() << " " << r << s;
        }
      }
    }
  }
};

TEST_P(FramesOfRandomMechanisms, HaveTwistsJacobiansAndDriftsOfTheirPoses) {
  expect_derivatives_of_poses(with_tools({.actions = false, .constraints = false}, GetParam()));
  expect_derivatives_of_poses(with_tools({.actions = false, .constraints = false, .joints = true}, GetParam()));
}
// The twist is that of the link where the point is. It changes also because the point goes on to another place there.
TEST_P(FramesOfRandomMechanisms, HaveDriftsOfPointsThatMoveInTheirFrames) {
  Scene scene = random_mechanism(GetParam(), {.actions = false, .constraints = false});
  int moving = 0;
  const std::vector<CoordinateContent> coordinates = scene.content().coordinates;
  for (const CoordinateContent& c : coordinates) {
    if (c.attitude || c.released) continue;
    const Expression q(c.q), angle = c.q->unit == units::metre ? q / metres("1") : q;
    for (std::size_t k = 1; k < scene.content().frames.size(); k += 2) {
      scene.point("moving" + std::to_string(moving++), FrameHandle{static_cast<int>(k)},
                  {metres("0.3") * angle, metres("0.2") * angle * angle, metres("0.5")});
    }
  }
  ASSERT_GT(moving, 0);
  expect_derivatives_of_poses(scene);
}
TEST_P(FramesOfRandomMechanisms, AnswerToImpulses) {
  expect_answers_to_impulses(with_tools({.actions = false, .constraints = false, .most_bodies = 3}, GetParam(), true));
  expect_answers_to_impulses(with_tools({.actions = false, .joints = true, .most_bodies = 3}, GetParam(), true));
}
INSTANTIATE_TEST_SUITE_P(Seeds, FramesOfRandomMechanisms, ::testing::Range(1U, 7U));

/// A bar that turns: the drift of its tip is the centripetal acceleration, J M⁻¹ Jᵀ that of one degree of freedom.
TEST(Frames, AreThoseOfATurningBar) {
  Scene scene("bar");
  const Expression q = scene.coordinate("q", "rad");
  const FrameHandle bar = scene.revolute("bar", scene.ground(), axis::z, q);
  scene.body("bar", bar, Inertia::general({.mass = kilograms("3"), .zz = Expression::quantity("2", "kg m^2")}));
  scene.point("tip", bar, {metres("2"), 0, 0});
  const Equations equations(scene);
  NamedState state(equations, {{"q", Real(0)}, {equations.model().coordinates()[0].v->name, Real(3)}});
  const std::map<std::string, Value> frames = results_of(make_frames(equations));
  const std::map<std::string, Value> inertia = results_of(make_operational_inertia(equations));
  const auto entry = [&](const std::map<std::string, Value>& all, const std::string& member, int i) {
    return state.in_double(all.at("result.tip_" + member + "[" + std::to_string(i) + "]"));
  };
  const std::vector<double> twist = {0, 6, 0, 0, 0, 3}, drift = {-18, 0, 0, 0, 0, 0}, jacobian = {0, 2, 0, 0, 0, 1};
  for (int i = 0; i < 6; ++i) {
    const auto row = static_cast<std::size_t>(i);
    EXPECT_EQ(entry(frames, "twist", i), twist[row]);
    EXPECT_EQ(entry(frames, "drift", i), drift[row]);
    EXPECT_EQ(entry(frames, "jacobian", i), jacobian[row]);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(entry(inertia, "inverse_inertia", 6 * j + i), jacobian[row] * jacobian[static_cast<std::size_t>(j)] / 2);
    }
  }
  EXPECT_EQ(entry(frames, "position", 0), 2);
  EXPECT_EQ(entry(frames, "rotation", 0), 1);
}

TEST(Frames, AreAbsentWithoutPoints) {
  Scene scene = pendulum();
  EXPECT_EQ(why_absent("frames", Equations(scene)), "the scene has no named point (point, or --points)");
  EXPECT_EQ(why_absent("operational_inertia", Equations(scene)), "the scene has no named point (point, or --points)");
}

TEST(Frames, HaveNoOperationalInertiaWhereFrictionFollowsAReaction) {
  using namespace literals;
  testing_mechanisms::Block it;
  it.name_the_normal_force();
  EXPECT_EQ(why_absent("operational_inertia", Equations(it.scene)), "");
  it.slide(0.25_r, {rate(it.x), 0, 0});
  EXPECT_EQ(why_absent("operational_inertia", Equations(it.scene)),
            "friction in proportion to a reaction: what an impulse changes is then not symmetric");
  EXPECT_EQ(why_absent("frames", Equations(it.scene)), "");
}

}  // namespace
}  // namespace torsor::kernel_frames_test
