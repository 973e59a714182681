// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Axis i of a frame with that place, in the axes of a link; bound.
Vector frame_axis(const Model& model, const FramePlace& at, int i, int axes);

/// Wrench of frame a on frame b for a unit multiplier of one locked direction of a joint that closes a loop, in the
/// axes of a's link: its resultant and its moment at the origin of b. For every virtual displacement its work is that
/// of f:
/// * offset: δ(AB · a_i) is that of the force a_i;
/// * alignment: δ(a_i · b_j) = δθ · (b_j ∧ a_i), δθ the turn of b in a;
/// * screw, f = p (sin φ a_y · b_y − cos φ a_z · b_y) with φ = AB · a_x / p: the force
///   (cos φ a_y · b_y + sin φ a_z · b_y) a_x and the couple p b_y ∧ (sin φ a_y − cos φ a_z), which are a_x and −p a_x
///   where the loop is closed.
struct ClosureWrench {
  SeenPoint point;  ///< the origin of b
  Wrench at_point;
};
ClosureWrench closure_wrench(const Model& model, const JointClosure& law, const std::string& user);

}  // namespace torsor
