// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "torsor/runtime/grains/grain_motion.hpp"

namespace disc_pile {

using namespace torsor::runtime;

/// A pyramid of discs of diameter and weight 1 on a floor, the base row touching (references: disc piles).
inline Grains<2> pile(int rows, double f) {
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
inline double expect_lawful(const GrainMotion<2>& motion, std::size_t count) {
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

}  // namespace disc_pile
