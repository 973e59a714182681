// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// A vector bound to a line: a force and its line of action. Every point of the line stands for the same sliding
/// vector.
struct SlidingVector {
  Vector point;   ///< OP, P any point of the line [m]
  Vector vector;  ///< V
};

/// Moment at A, AP ∧ V; `oa` as the point is given.
Vector moment_at(const SlidingVector& sliding, const Vector& oa);

/// Screw of a finite set of sliding vectors at A: {Σ V, Σ AP ∧ V}.
template <class Kind>
Screw<Kind> screw_of(const std::vector<SlidingVector>& set, const Vector& oa) {
  Vector resultant, moment;
  for (const SlidingVector& sliding : set) {
    resultant += sliding.vector;
    moment += moment_at(sliding, oa);
  }
  return {resultant, moment};
}

/// A line of space about which moments are taken, seen from a point A.
struct NamedAxis {
  std::string name;  ///< for messages
  Vector ab;         ///< to any point B of the axis [m]
  Vector direction;  ///< of any length
};

/// Moment about the axis, M_B·u with u its unit direction: any point B of the axis gives the same. `moment` is that at
/// A. Throws SceneError naming the axis when the direction is null.
Value moment_about(const Vector& resultant, const Vector& moment, const NamedAxis& axis);

template <class Kind>
Value moment_about(const Screw<Kind>& screw, const NamedAxis& axis) {
  return moment_about(resultant_of(screw), moment_of(screw), axis);
}

/// A term c s1^i s2^j s3^k of a density of sliding vectors, per unit of length, area or volume; s1, s2, s3 go from 0 to
/// 1 along the edges of the region.
struct DensityTerm {
  Vector coefficient;
  std::array<int, 3> powers{0, 0, 0};
};

/// Where a density acts: the points corner + Σ s_d edge_d of a segment (one edge), a parallelogram (two) or a
/// parallelepiped (three).
struct DensityRegion {
  Vector corner;              ///< from the reduction point A [m]
  std::vector<Vector> edges;  ///< [m]
};

/// {∫ F(P) dv, ∫ AP ∧ F(P) dv} of a polynomial density.
struct DensityIntegral {
  Vector resultant;
  Vector moment;
};

/// Exact integral of a sum of density terms over a region: the measure of the region times the mean of every monomial,
/// Π 1/(power + 1), with one power more along edge d for the arm. Throws SceneError when there are not one to three
/// edges, when they are dependent (a flat region has no measure), for a negative power or one along an edge that does
/// not exist.
DensityIntegral integrate_density(const DensityRegion& region, const std::vector<DensityTerm>& density);

/// The same as a screw at A.
template <class Kind>
Screw<Kind> screw_of_density(const DensityRegion& region, const std::vector<DensityTerm>& density) {
  const DensityIntegral integral = integrate_density(region, density);
  return {integral.resultant, integral.moment};
}

}  // namespace torsor
