// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "runtime/grains/grain_motion.hpp"

/// Discs of radii from 8 to 12 mm in columns, a little apart, in a box of three walls.
inline torsor::runtime::Grains<2> box_of_discs(int count, int columns) {
  torsor::runtime::Grains<2> grains;
  unsigned long long state = 1;
  for (int i = 0; i < count; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    const double R = 0.008 + 0.004 * static_cast<double>(state >> 40) / static_cast<double>(1 << 24);
    grains.add({0.0125 + 0.025 * (i % columns), 0.0125 + 0.025 * (i / columns)}, R, 3000 * R * R);
  }
  torsor::runtime::GrainWall<2> left, right, floor;
  left.normal = {1, 0};
  right.normal = {-1, 0};
  right.point = {0.025 * columns, 0};
  grains.walls = {floor, left, right};
  return grains;
}
