// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "tests/dynamics/random_source.hpp"

namespace torsor::testing_mechanisms {

/// What a closed chain is made of: its bodies, and its coordinates apart from those of attitudes.
struct ClosedChain {
  std::vector<FrameHandle> frames;
  std::vector<Expression> coordinates;
};

/// A chain of several joints on `base` that closes back on it by another joint (a weld too), with all its initial
/// values: they satisfy the closure exactly, for where the chain ends is worked out in exact numbers and the closing
/// joint is put there. One of three kinds, told by the names of what is in it:
/// * `spatial…`: joints of any kind in any direction, with one freedom more than the closing joint takes, or more;
/// * `planar…`: parallel revolute joints, one of them perhaps a slider, closed by a joint that locks more than the
/// three
///   freedoms of the plane (four-bar linkages, slider-cranks): redundant;
/// * `hinged…`: a free body held twice by like joints on the same line or in the same direction: redundant.
ClosedChain add_closed_chain(Scene& scene, RandomSource& random, const FrameHandle& base);

}  // namespace torsor::testing_mechanisms
