// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/contacts/box_of_discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <set>
#include <utility>

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

/// A pyramid of discs of diameter and weight 1 on a floor, the base row touching (references: disc piles).
Grains<2> pile(int rows, double f) {
  Grains<2> grains;
  grains.gravity = {0, -1};
  grains.friction = f;
  GrainWall<2> floor;
  floor.friction = f;
  grains.walls.push_back(floor);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      grains.add({i + 0.5 * row, 0.5 + row * std::sqrt(3.0) / 2}, 0.5, 1);
    }
  }
  return grains;
}

// The laws of every contact, to rounding of the largest impulse; returns that of the floor on all.
double expect_lawful(const GrainMotion<2>& motion, std::size_t count) {
  double floor = 0;
  for (const GrainContact<2>& c : motion.contacts().all()) {
    const double N = c.P.dot(c.n), T = (c.P - N * c.n).norm();
    EXPECT_TRUE(std::isfinite(N));
    EXPECT_GE(N, -1e-15);
    EXPECT_LE(T, c.friction * N + 1e-15);
    if (c.b >= count) floor += N;
  }
  return floor;
}

// Three discs rest where f > tan 15°; with less they move. At rest the floor carries the weight, each outer disc 3/2.
TEST(PileOfDiscs, OfThreeRestsAboveTheTangentOfFifteenDegrees) {
  for (const double f : {0.25, 0.2680, 0.5}) {
    Grains<2> grains = pile(2, f);
    GrainMotion<2> motion(grains, {.tolerance = 1e-12, .sweeps = 100000});
    constexpr double h = 0.01;
    for (int k = 0; k < 20; ++k) {
      const GrainStep step = motion.step(h);
      ASSERT_TRUE(step.converged) << f << ' ' << step.residual;
      const double floor = expect_lawful(motion, grains.count());
      if (f > 0.26795) {
        EXPECT_NEAR(floor, 3 * h, 1e-11);
      }
    }
    if (f > 0.26795) {
      EXPECT_LT(grains.kinetic_energy(), 1e-18);
    } else {
      EXPECT_GT(grains.kinetic_energy(), 1e-6);
    }
  }
}

TEST(GrainMotion, IsTheSameOnAnyNumberOfThreads) {
  Grains<2> one = box_of_discs(700, 100), four = box_of_discs(700, 100);
  one.gravity = four.gravity = {0, -100};  // so that many touch soon
  GrainMotion<2> on_one(one, {.tolerance = 1e-2, .sweeps = 24}),
      on_four(four, {.tolerance = 1e-2, .sweeps = 24, .threads = 3});
  for (int k = 0; k < 20; ++k) {
    (void)on_one.step(1e-3);
    (void)on_four.step(1e-3);
  }
  EXPECT_GT(on_one.contacts().all().size(), 200U);
  for (std::size_t i = 0; i < one.count(); ++i) {
    ASSERT_EQ(one.x[i], four.x[i]) << i;
    ASSERT_EQ(one.v[i], four.v[i]) << i;
  }
}

TEST(GrainMotion, LosesEnergyKeepsGrainsApartAndAllocatesNothing) {
  Grains<2> grains = box_of_discs(200, 10);
  GrainMotion<2> motion(grains, {.tolerance = 1e-4});
  for (int k = 0; k < 150; ++k) (void)motion.step(1e-3);
  double before = grains.energy(), deepest = 0;
  const std::size_t allocated = allocations;
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
  // Vectors of contacts grow while contacts become more: by doubling, not in each step.
  EXPECT_LE(allocations - allocated, 24U);
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

}  // namespace
}  // namespace grain_motion_test
