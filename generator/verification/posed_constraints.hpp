// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/geometry/real_vector.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// Where a link is: its axes in those of the ground as columns, its origin from the ground's.
struct Pose {
  RealRotation rotation;
  RealVector origin;
};
/// By link; the ground is the first.
using Poses = std::vector<Pose>;

/// The same poses but for one link, moved by h along (0, 1, 2) or about (3, 4, 5) one of its own axes.
Poses displaced(Poses poses, int link, std::size_t direction, const Real& h);

/// A holonomic condition f as a function of the poses of the bodies, wherever they are: no chain of joints ties them.
struct PosedConstraint {
  std::function<Real(const Poses&)> value;
  std::function<Real(const Poses&)> length;  ///< what f is made of, for a scale: a distance, or 1
  Real operator()(const Poses& poses) const { return value(poses); }
  Real size(const Poses& poses) const { return abs(length(poses)) + abs(value(poses)); }
};

/// The geometry of a scene's constraints in numbers, apart from the formulas that the equations use.
class PosedScene {
 public:
  explicit PosedScene(const Model& model);

  Poses at(Evaluator<Real>& here) const;

  /// Distances of points along directions, contacts with planes, and the conditions of joints that close loops, with
  /// points and parameters as they are there. Nothing for formulas of coordinates, non-holonomic conditions, and points
  /// of contact in a plane that they were not found for.
  std::optional<PosedConstraint> constraint(const ConstraintLaw& law, Evaluator<Real>& here) const;

 private:
  const Model* model_;
  std::vector<Vector> origins_;
  std::vector<Matrix> rotations_;
};

}  // namespace torsor
