// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/runtime/grains/grain_motion.hpp"

/// Discs of radii from 8 to 12 mm, each somewhere across a cell of 25 mm, in a box of three walls. Columns in which one
/// stands exactly on the other would stay up.
inline torsor::runtime::Grains<2> box_of_discs(int count, int columns) {
  torsor::runtime::Grains<2> grains;
  unsigned long long state = 1;
  const auto random = [&state] {  // from 0 to 1
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 40) / static_cast<double>(1 << 24);
  };
  for (int i = 0; i < count; ++i) {
    const double R = 0.008 + 0.004 * random(), aside = (0.0125 - R) * (2 * random() - 1);
    grains.add({0.0125 + 0.025 * (i % columns) + aside, 0.0125 + 0.025 * (i / columns)}, R, 3000 * R * R);
  }
  torsor::runtime::GrainWall<2> left, right, floor;
  left.normal = {1, 0};
  right.normal = {-1, 0};
  right.point = {0.025 * columns, 0};
  grains.walls = {floor, left, right};
  return grains;
}
