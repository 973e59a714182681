// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/dynamics/motion/point_motion.hpp"

namespace torsor {

/// Motion of one link relative to another, joint by joint between the two: nothing that moves both together enters, so
/// that the power of a mutual action shows by itself that it depends on no frame of reference.
///
/// All vectors are in the axes that the point P is seen along.
class RelativeMotion {
 public:
  /// Link `a` relative to link `b` (0 is the ground), reduced at P.
  RelativeMotion(const Model& model, int a, int b, const SeenPoint& point);

  /// {Ω(a/b); V(P ∈ a/b)}, laws of time included.
  const Twist& twist() const { return twist_; }
  /// Q_i = F · ∂V(P ∈ a/b)/∂q̇_i + M_P · ∂Ω(a/b)/∂q̇_i, every coordinate of the model: generalised forces of the wrench
  /// {F; M_P} on a with the opposite on b.
  std::vector<Value> generalised_forces(const Wrench& wrench_at_point) const;

 private:
  const Model& model_;
  std::vector<int> joints_;      ///< between the two links
  std::vector<Twist> per_rate_;  ///< of a relative to b for a unit rate of each, at P
  Twist twist_;
};

}  // namespace torsor
