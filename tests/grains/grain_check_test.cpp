// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/grains/grain_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "torsor/runtime/grains/grain_motion.hpp"

namespace grain_check_test {
namespace {

using namespace torsor::runtime;

template <int dim>
Grains<dim> two() {
  using Vector = typename Grains<dim>::Vector;
  Grains<dim> grains;
  grains.walls.emplace_back();
  grains.add(0.1 * Vector::Unit(dim - 1), 0.1, 1);
  grains.add(0.3 * Vector::Unit(dim - 1), 0.1, 1);
  return grains;
}

// Each change of two grains on a floor is refused: nothing moves, and the message names object, quantity and remedy.
template <int dim>
void refuses(const std::function<void(Grains<dim>&)>& change, const std::string& message) {
  Grains<dim> grains = two<dim>();
  GrainMotion<dim> motion(grains);
  ASSERT_EQ(motion.step(1e-3).status, GrainStatus::ok);
  change(grains);
  const auto x = grains.x[1];
  const GrainStep step = motion.step(1e-3);
  EXPECT_EQ(step.status, GrainStatus::invalid) << message;
  EXPECT_FALSE(step.converged);
  EXPECT_EQ(describe(step.fault), message);
  EXPECT_TRUE(std::isnan(x(0)) || grains.x[1] == x) << message;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <int dim>
void refuses_what_is_no_number() {
  using G = Grains<dim>;
  refuses<dim>([](G& g) { g.x[1](0) = nan; }, "grain 1: the sum of its coordinates is nan; give a finite place");
  refuses<dim>([](G& g) { g.v[0](1) = nan; }, "grain 0: the sum of its velocities is nan; give finite ones");
  refuses<dim>([](G& g) { g.w[0](0) = nan; }, "grain 0: its angular velocity is nan; give a finite one");
  refuses<dim>([](G& g) { g.radius[1] = nan; }, "grain 1: radius is nan; give a length above 0");
  refuses<dim>([](G& g) { g.inverse_mass[1] = nan; },
               "grain 1: the inverse of its mass is nan; give a finite mass above 0");
  refuses<dim>([](G& g) { g.inverse_inertia[1] = nan; },
               "grain 1: the inverse of its inertia is nan; give a finite inertia above 0");
  refuses<dim>([](G& g) { g.gravity(0) = nan; }, "grains: gravity is nan; give finite components");
  refuses<dim>([](G& g) { g.friction = nan; }, "grains: friction is nan; give a finite number of at least 0");
  refuses<dim>([](G& g) { g.restitution = nan; }, "grains: restitution is nan; give a number from 0 to 1");
  refuses<dim>([](G& g) { g.walls[0].point(0) = nan; },
               "wall 0: the sum of point, velocity and spin is nan; give finite numbers");
  refuses<dim>([](G& g) { g.walls[0].normal(0) = nan; }, "wall 0: the length of normal is nan; give a unit vector");
  refuses<dim>([](G& g) { g.walls[0].friction = nan; }, "wall 0: friction is nan; give a finite number of at least 0");
  refuses<dim>([](G& g) { g.walls[0].restitution = nan; }, "wall 0: restitution is nan; give a number from 0 to 1");
}

TEST(GrainCheck, RefusesWhatIsNoNumberInThePlane) { refuses_what_is_no_number<2>(); }
TEST(GrainCheck, RefusesWhatIsNoNumberInSpace) { refuses_what_is_no_number<3>(); }

TEST(GrainCheck, RefusesWhatCannotBe) {
  using G = Grains<2>;
  using Shape = GrainWall<2>::Shape;
  refuses<2>([](G& g) { g.radius[0] = 0; }, "grain 0: radius is 0; give a length above 0");
  refuses<2>(
      [](G& g) {
        g.add({1, 1}, 0.1, -2);
      },
      "grain 2: the inverse of its mass is -0.5; give a finite mass above 0");
  refuses<2>([](G& g) { g.friction = -0.1; }, "grains: friction is -0.1; give a finite number of at least 0");
  refuses<2>([](G& g) { g.restitution = 1.1; }, "grains: restitution is 1.1; give a number from 0 to 1");
  refuses<2>([](G& g) { g.x.emplace_back(1, 1); },
             "grains: the length of one of the lists is 2; make all as long as that of places: `add` does");
  refuses<2>([](G& g) { g.walls[0].normal = {0, 2}; }, "wall 0: the length of normal is 2; give a unit vector");
  refuses<2>([](G& g) { g.walls[0].shape = Shape::segment; },
             "wall 0: the segment's length is 0; give an end apart from the point");
  refuses<2>([](G& g) { g.walls.push_back({.shape = Shape::drum, .radius = 0.1}); },
             "wall 1: the drum's radius is 0.1; give one above that of every grain");
}

TEST(GrainCheck, RefusesUnusableOptionsAndSteps) {
  Grains<2> grains = two<2>();
  const auto said = [&grains](const GrainOptions& options, double h) {
    const GrainStep step = GrainMotion<2>(grains, options).step(h);
    EXPECT_EQ(step.status, GrainStatus::invalid);
    return describe(step.fault);
  };
  EXPECT_EQ(said({}, 0), "step: h is 0; give a finite time above 0");
  EXPECT_EQ(said({}, nan), "step: h is nan; give a finite time above 0");
  EXPECT_EQ(said({.tolerance = 0}, 1e-3), "options: tolerance is 0; give a number above 0");
  EXPECT_EQ(said({.tolerance = nan}, 1e-3), "options: tolerance is nan; give a number above 0");
  EXPECT_EQ(said({.sweeps = 0}, 1e-3), "options: sweeps is 0; allow one at least");
  EXPECT_EQ(said({.projections = -1}, 1e-3), "options: projections is -1; give 0 or more");
  EXPECT_EQ(said({.rest = nan}, 1e-3), "options: rest is nan; give 0 or more");
}

// Sizes so far apart that numbers overflow end in a status, not in rest.
TEST(GrainCheck, TellsOfNumbersThatOverflow) {
  Grains<2> plane = two<2>();
  plane.v[0] = {0, -1e308};
  plane.walls[0].velocity = {1e308, 0};
  const GrainStep in_plane = GrainMotion<2>(plane).step(1e-3);
  EXPECT_EQ(in_plane.status, GrainStatus::not_finite);
  Grains<3> space = two<3>();
  space.v[0] = {0, 0, -1e308};
  space.walls[0].velocity = {1e308, 0, 0};
  const GrainStep in_space = GrainMotion<3>(space).step(1e-3);
  EXPECT_EQ(in_space.status, GrainStatus::not_finite);
}

// What stands is not held by impulses that overflow, and what comes first is not forgotten for what comes last.
template <int dim>
void tells_of_what_overflows_at_rest() {
  for (const bool first : {true, false}) {
    Grains<dim> heavy = two<dim>();
    heavy.x[1] *= 4;  // apart
    heavy.inverse_mass[first ? 0 : 1] = 1e-300;
    heavy.inverse_inertia[first ? 0 : 1] = 1e-300;
    if (!first) std::swap(heavy.x[0], heavy.x[1]);
    EXPECT_EQ(GrainMotion<dim>(heavy).step(1e-3).status, GrainStatus::not_finite) << first;
  }
}
TEST(GrainCheck, TellsOfWhatOverflowsAtRestInThePlane) { tells_of_what_overflows_at_rest<2>(); }
TEST(GrainCheck, TellsOfWhatOverflowsAtRestInSpace) { tells_of_what_overflows_at_rest<3>(); }

TEST(GrainCheck, MovesWithAnyFiniteFrictionOfAWall) {
  Grains<3> grains = two<3>();
  grains.walls[0].friction = 1e200;
  GrainMotion<3> motion(grains);
  for (int k = 0; k < 3; ++k) ASSERT_EQ(motion.step(1e-3).status, GrainStatus::ok);
  EXPECT_TRUE(grains.x[0].allFinite());
}

// What is no number is not brought into bounds, in the plane as little as in space.
TEST(GrainRow, KeepsWhatIsNoNumber) {
  Grains<2> plane = two<2>();
  const GrainContact<2> in_plane{
      .a = 0, .b = 1, .n = {0, -1}, .friction = 0.5, .normal_weight = 1, .tangent_weight = 1};
  const GrainRow<2> row(plane, in_plane);
  EXPECT_TRUE(std::isnan(row.bounded(nan, 0)(0)));
  EXPECT_TRUE(std::isnan(row.bounded(1, nan)(1)));
  EXPECT_TRUE(std::isnan(row.bounded<GrainLaw::cone>(nan, 0)(0)));
  EXPECT_TRUE(std::isnan(row.bounded<GrainLaw::cone>(1, nan)(0)));
  Grains<3> space = two<3>();
  GrainContact<3> in_space;
  in_space.b = 1;
  in_space.n = {0, 0, -1};
  in_space.friction = 0.5;
  in_space.normal_weight = in_space.tangent_weight = 1;
  const GrainRow<3> other(space, in_space);
  EXPECT_FALSE(other.bounded({0, 0, nan}).allFinite());
  EXPECT_FALSE(other.bounded({nan, 0, 1}).allFinite());
  EXPECT_FALSE(other.bounded<GrainLaw::cone>({nan, 0, 1}).allFinite());
}

}  // namespace
}  // namespace grain_check_test
