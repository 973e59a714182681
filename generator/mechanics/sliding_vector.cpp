// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/sliding_vector.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// Length, area or volume of the region.
Value measure(const std::vector<Vector>& edges) {
  if (edges.empty() || edges.size() > 3) {
    throw SceneError(
        fmt::format("a density acts along a segment, over a parallelogram or in a parallelepiped: give 1, 2 "
                    "or 3 edges instead of {}",
                    edges.size()));
  }
  Value square;
  if (edges.size() == 1) {
    square = dot(edges[0], edges[0]);
  } else {
    const Vector normal = cross(edges[0], edges[1]);
    if (edges.size() == 2) {
      square = dot(normal, normal);
    } else {
      const Value volume = dot(normal, edges[2]);
      square = volume * volume;
    }
  }
  if (identically_zero(square)) {
    throw SceneError(fmt::format("the {} edge{} of a density's region span no {}: give independent edges", edges.size(),
                                 edges.size() == 1 ? "" : "s",
                                 std::array<const char*, 3>{"length", "area", "volume"}[edges.size() - 1]));
  }
  return square.program()->sqrt(square);
}

void check(const DensityTerm& term, std::size_t edges) {
  for (std::size_t d = 0; d < 3; ++d) {
    if (term.powers[d] < 0) {
      throw SceneError(fmt::format("a density has the power {} along edge {}: only polynomials are integrated",
                                   term.powers[d], d + 1));
    }
    if (d >= edges && term.powers[d] != 0) {
      throw SceneError(
          fmt::format("a density depends on edge {} of a region that has {}: give that edge or drop the "
                      "power",
                      d + 1, edges));
    }
  }
}

}  // namespace

Vector moment_at(const SlidingVector& sliding, const Vector& oa) { return cross(sliding.point - oa, sliding.vector); }

Value moment_about(const Vector& resultant, const Vector& moment, const NamedAxis& axis) {
  const Vector &ab = axis.ab, &direction = axis.direction;
  if (identically_zero(direction)) {
    throw SceneError(fmt::format("the direction of axis '{}' is the null vector: give a direction", axis.name));
  }
  const Vector at_b = moment + cross(resultant, ab);
  const Value square = dot(direction, direction);
  const Value norm = square.program()->sqrt(square);
  const Value along = dot(at_b, direction);
  return along / norm;
}

DensityIntegral integrate_density(const DensityRegion& region, const std::vector<DensityTerm>& density) {
  const Value size = measure(region.edges);
  DensityIntegral integral;
  for (const DensityTerm& term : density) {
    check(term, region.edges.size());
    Number mean(1);
    for (const int power : term.powers) mean = mean * Number::rational(1, power + 1);
    Vector arm = region.corner;  // to the mean place of the monomial
    for (std::size_t d = 0; d < region.edges.size(); ++d) {
      const int power = term.powers[d];
      for (int i = 0; i < 3; ++i) arm[i] += Number::rational(power + 1, power + 2) * region.edges[d][i];
    }
    const Vector total = (mean * size) * term.coefficient;
    integral.resultant += total;
    integral.moment += cross(arm, total);
  }
  return integral;
}

}  // namespace torsor
