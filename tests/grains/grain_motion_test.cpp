// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/contacts/box_of_discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "tests/grains/disc_pile.hpp"

namespace {
std::size_t allocations = 0;
}  // namespace

// An optimiser that looks into these takes them for a mismatch of new and free.
#define NOT_INLINED __attribute__((noinline))
NOT_INLINED void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
NOT_INLINED void operator delete(void* memory) noexcept { std::free(memory); }
NOT_INLINED void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace grain_motion_test {
namespace {

using namespace torsor::runtime;
using disc_pile::expect_lawful;
using disc_pile::pile;

TEST(GrainMotion, IsTheSameOnAnyNumberOfThreads) {
  Grains<2> one = box_of_discs(700, 100);
  one.gravity = {0, -100};  // so that many touch soon
  {
    GrainMotion<2> motion(one, {.tolerance = 1e-2, .sweeps = 24});
    for (int k = 0; k < 17; ++k) (void)motion.step(1e-3);
  }
  const Grains<2> start = one;
  GrainMotion<2> on_one(one, {.tolerance = 1e-4, .sweeps = 12});
  for (int k = 0; k < 3; ++k) (void)on_one.step(1e-3);
  EXPECT_GT(on_one.contacts().all().size(), 200U);
  for (const unsigned threads : {2U, 3U, 4U}) {
    Grains<2> many = start;
    GrainMotion<2> on_many(many, {.tolerance = 1e-4, .sweeps = 12, .threads = threads});
    for (int k = 0; k < 3; ++k) (void)on_many.step(1e-3);
    for (std::size_t i = 0; i < one.count(); ++i) {
      ASSERT_EQ(one.x[i], many.x[i]) << i << ' ' << threads;
      ASSERT_EQ(one.v[i], many.v[i]) << i << ' ' << threads;
    }
  }
}

TEST(GrainMotion, LosesEnergyAndKeepsGrainsApart) {
  Grains<2> grains = box_of_discs(200, 10);
  GrainMotion<2> motion(grains, {.tolerance = 1e-4});
  for (int k = 0; k < 150; ++k) (void)motion.step(1e-3);
  double before = grains.energy(), deepest = 0;
  std::size_t grown = 0;
  for (int k = 0; k < 100; ++k) {
    const GrainStep step = motion.step(1e-3);
    deepest = std::max(deepest, step.deepest);
    // Putting overlaps back lifts grains by some of them: weight times depth.
    if (grains.energy() > before + 9.81 * 40 * deepest) ++grown;
    before = grains.energy();
    expect_lawful(motion, grains.count());
  }
  EXPECT_EQ(grown, 0U);
  EXPECT_LT(deepest, 0.002);  // a fifth of a radius, while they fall on each other
}

TEST(GrainMotion, AllocatesNothingAfterItsFirstStep) {
  for (const unsigned threads : {1U, 3U}) {
    Grains<2> grains = box_of_discs(200, 10);
    GrainMotion<2> motion(grains, {.tolerance = 1e-3, .sweeps = 50, .threads = threads});
    (void)motion.step(1e-3);
    const std::size_t allocated = allocations;
    std::size_t most = 0;
    // Threads on a busy machine wait for each other: few steps suffice.
    const int steps = threads == 1 ? 250 : 10;
    for (int k = 0; k < steps; ++k) most = std::max(most, motion.step(1e-3).contacts);
    EXPECT_GT(most, threads == 1 ? 300U : 0U);
    EXPECT_EQ(allocations, allocated) << threads;
  }
}

// A heap falls asleep and stands still to the last bit; the floor carries its weight meanwhile. What falls on it, a
// push, a wall that moves and another gravity wake it.
TEST(GrainMotion, LetsAHeapSleepAndWakesIt) {
  const auto settled = [](Grains<2>& grains, GrainMotion<2>& motion) {
    for (int k = 0; k < 40; ++k) (void)motion.step(0.01);
    const std::vector<Eigen::Vector2d> places(grains.x.begin(), grains.x.begin() + 3);
    const GrainStep step = motion.step(0.01);
    EXPECT_EQ(step.asleep, 3U);
    EXPECT_EQ(step.sweeps, 0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(places[i], grains.x[i]);
    EXPECT_NEAR(expect_lawful(motion, 3), 3 * 0.01, 1e-9);
  };
  {
    Grains<2> grains = pile(2, 0.5);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    settled(grains, motion);
    grains.v[2] = {0.1, 0};
    EXPECT_EQ(motion.step(0.01).asleep, 0U);
    EXPECT_GT(grains.kinetic_energy(), 1e-6);
  }
  {
    Grains<2> grains = pile(2, 0.5);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    settled(grains, motion);
    grains.gravity = {1, -1};
    EXPECT_EQ(motion.step(0.01).asleep, 0U);
    EXPECT_GT(grains.kinetic_energy(), 1e-6);
  }
  {
    Grains<2> grains = pile(2, 0.5);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    settled(grains, motion);
    grains.walls[0].velocity = {1, 0};  // a belt
    EXPECT_EQ(motion.step(0.01).asleep, 0U);
    EXPECT_GT(grains.kinetic_energy(), 1e-6);
    for (int k = 0; k < 40; ++k) EXPECT_EQ(motion.step(0.01).asleep, 0U) << k;
  }
  {
    Grains<2> grains = pile(2, 0.5);
    grains.add({0.6, 30}, 0.5, 1);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    settled(grains, motion);
    bool woken = false;
    for (int k = 0; k < 1200 && !woken; ++k) {
      const auto before = grains.x;
      woken = motion.step(0.01).asleep == 0;
      if (!woken) {
        ASSERT_EQ(before[0], grains.x[0]);
      }
    }
    EXPECT_TRUE(woken);
    // Only the one that falls is near them then.
    EXPECT_LT(grains.x[3](1), 4);
    EXPECT_GT(grains.kinetic_energy(), 1);
  }
}

// What is written to while it sleeps wakes, and so does all that it bore: here the top of a heap falls when the discs
// below are taken away, by their places, by a velocity that takes them out of reach, or by their size.
TEST(GrainMotion, WakesAHeapWhoseGrainsAreMovedByHand) {
  for (const int how : {0, 1, 2}) {
    Grains<2> grains = pile(2, 0.5);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    for (int k = 0; k < 40; ++k) (void)motion.step(0.01);
    ASSERT_EQ(motion.step(0.01).asleep, 3U);
    for (const std::size_t lower : {0U, 1U}) {
      if (how == 0) grains.x[lower](0) += lower == 0 ? -30 : 30;
      if (how == 1) grains.v[lower] = {lower == 0 ? -1000 : 1000, 0};
      if (how == 2) grains.radius[lower] = 0.4;
    }
    EXPECT_EQ(motion.step(0.01).asleep, 0U) << how;
    for (int k = 0; k < 10; ++k) (void)motion.step(0.01);
    EXPECT_LT(grains.v[2](1), -0.01) << how;
  }
}

// A ball on a slope of 2e-5 rolls off, slow as it is: 2/3 of the slope times g.
TEST(GrainMotion, LetsNothingSleepThatGainsSpeed) {
  Grains<2> grains;
  constexpr double slope = 2e-5, h = 1e-3;
  grains.walls.push_back({.normal = {std::sin(slope), std::cos(slope)}});
  grains.add(0.01 * grains.walls[0].normal, 0.01, 1);
  GrainMotion<2> motion(grains);
  for (int k = 0; k < 1000; ++k) (void)motion.step(h);
  const double expected = 2.0 / 3 * slope * 9.81 * 1000 * h;
  // Residuals of 1e-6 of m h g in each of 1000 steps.
  EXPECT_NEAR(grains.v[0](0), expected, 1e-6 * 9.81 * 1000 * h);
}

// The impulses account for the velocities, however coarse the sweeps: momentum is exact.
TEST(GrainSolver, GivesEachGrainTheMomentumOfItsImpulses) {
  for (const double tolerance : {0.3, 0.1, 1e-3}) {
    Grains<2> grains = box_of_discs(200, 10);
    grains.gravity = {0, -100};
    GrainMotion<2> motion(grains, {.tolerance = tolerance, .sweeps = 500, .rest = 0});
    constexpr double h = 1e-3;
    for (int k = 0; k < 60; ++k) {
      std::vector<Eigen::Vector2d> change;
      for (const auto& v : grains.v) change.push_back(-v - h * grains.gravity);
      const GrainStep step = motion.step(h);
      double largest = 0;
      for (const auto& c : motion.contacts().all()) {
        largest = std::max(largest, c.P.norm());
        change[c.a] -= grains.inverse_mass[c.a] * c.P;
        if (c.b < grains.count()) change[c.b] += grains.inverse_mass[c.b] * c.P;
      }
      // Rounding: m = 0.3 kg.
      for (std::size_t i = 0; i < grains.count(); ++i) {
        ASSERT_NEAR((change[i] + grains.v[i]).norm(), 0, 1e-13 * (1 + largest / 0.19))
            << "grain " << i << ", step " << k << ", tolerance " << tolerance << ", sweeps " << step.sweeps;
      }
    }
  }
}

// The grid finds the pairs that trying all finds.
TEST(NeighbourGrid, FindsEveryPairOnce) {
  const Grains<2> grains = box_of_discs(300, 10);
  NeighbourGrid<2> grid;
  constexpr double width = 0.03;
  grid.sort(grains.x, width);
  std::set<std::pair<std::size_t, std::size_t>> found, all;
  for (std::size_t i = 0; i < grains.count(); ++i) {
    grid.visit_later(i, [&](std::size_t j) {
      if ((grains.x[i] - grains.x[j]).norm() < width) {
        EXPECT_TRUE(found.insert({i, j}).second);
      }
    });
    for (std::size_t j = i + 1; j < grains.count(); ++j) {
      if ((grains.x[i] - grains.x[j]).norm() < width) all.insert({i, j});
    }
  }
  EXPECT_EQ(found, all);
}

// Spheres thrown at each other keep momentum, linear and angular; with e = 1 and no friction the energy as well.
TEST(Spheres, KeepMomentumInTheirCollisions) {
  Grains<3> grains;
  grains.gravity.setZero();
  grains.friction = 0.4;
  grains.restitution = 0.5;
  grains.add({0, 0, 0}, 0.1, 1, {1, 0, 0});
  grains.add({0.3, 0.08, 0.03}, 0.1, 2, {-1, 0, 0.1});
  grains.w[0] = {3, -2, 20};
  const auto momentum = [&] {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      sum.head<3>() += grains.v[i] / grains.inverse_mass[i];
      sum.tail<3>() +=
          grains.x[i].cross(grains.v[i]) / grains.inverse_mass[i] + grains.w[i] / grains.inverse_inertia[i];
    }
    return sum;
  };
  const auto before = momentum();
  const double energy = grains.energy();
  GrainMotion<3> motion(grains, {.tolerance = 1e-14});
  std::size_t struck = 0;
  for (int k = 0; k < 200; ++k) struck += motion.step(1e-3).contacts > 0 ? 1 : 0;
  EXPECT_GT(struck, 0U);
  EXPECT_LT(grains.energy(), energy);
  // Linear momentum to rounding; the impulses act at points an overlap of 2 v h apart.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(momentum()(i), before(i), 1e-14);
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(momentum()(i), before(i), 4 * 2e-3);
}

// A ball that loses nothing leaves the floor as fast as it came, less what gravity does within a step.
TEST(Spheres, BounceAsFastAsTheyCame) {
  constexpr double h = 1e-3, R = 0.1;
  for (const double height : {0.5, 0.5005, 0.501, 0.5015, 0.502, 0.5025}) {  // they arrive at other parts of a step
    Grains<3> grains;
    grains.walls.push_back({.restitution = 1});
    grains.add({0, 0, R + height}, R, 1);
    GrainMotion<3> motion(grains);
    double fastest_up = 0;
    for (int k = 0; k < 500; ++k) {
      (void)motion.step(h);
      fastest_up = std::max(fastest_up, grains.v[0](2));
    }
    EXPECT_NEAR(fastest_up, std::sqrt(2 * 9.81 * height), 2 * 9.81 * h) << height;
  }
}

// Beside contacts that restitution keeps open a sphere rests in a groove as it must: N = m g/(2 cos 45 deg).
TEST(Spheres, RestInAGrooveBesideOpenContacts) {
  Grains<3> grains;
  grains.friction = grains.restitution = 0.5;
  const double half = std::sqrt(0.5), R = 0.1, gap = 5e-11;
  for (const double side : {-1.0, 1.0}) {
    grains.walls.push_back({.normal = {side * half * 0.6, side * half * 0.8, half}, .restitution = 0.5});
  }
  grains.add({0, 0, (R + gap) / half}, R, 1);
  GrainMotion<3> motion(grains, {.tolerance = 1e-10});
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(motion.step(1e-3).status, GrainStatus::ok);
    EXPECT_TRUE(grains.v[0].isZero(0));
    for (const auto& c : motion.contacts().all()) EXPECT_TRUE(c.P.allFinite());
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& c : motion.contacts().all()) sum += c.P;
  EXPECT_NEAR((sum - Eigen::Vector3d(0, 0, 9.81e-3)).norm(), 0, 1e-11);
}

}  // namespace
}  // namespace grain_motion_test
