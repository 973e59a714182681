// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/grains/grains.hpp"
#include "torsor/runtime/grains/neighbour_grid.hpp"

namespace torsor::runtime {

/// Whether grains leave each other behind unseen: contacts are looked for once a step, and between two looks grains
/// move along straight lines. Only where they move by more than the smallest radius is anything asked.
template <int dim>
class GrainPassage {
 public:
  using Vector = Eigen::Matrix<double, dim, 1>;

  /// In the time until the next look, from where the grains are: whether two pass each other, or one a segment, deeper
  /// than half the smallest radius. Also true where grains move apart or together by more than four of
  /// the largest diameters, because then it would take all pairs to tell.
  [[nodiscard]] bool happens(const Grains<dim>& grains, double time) {
    const std::size_t count = grains.count();
    if (count == 0) return false;
    double least = INFINITY, widest = 0, fastest = 0;
    Vector low = grains.v[0], high = grains.v[0];
    for (std::size_t i = 0; i < count; ++i) {
      least = std::min(least, grains.radius[i]);
      widest = std::max(widest, grains.radius[i]);
      fastest = std::max(fastest, grains.v[i].norm());
      low = low.cwiseMin(grains.v[i]);
      high = high.cwiseMax(grains.v[i]);
    }
    const double apart = time * (high - low).norm();  // no two move further beside each other
    return (time * fastest > least && past_a_segment(grains, time, least)) ||
           (apart > least && (apart > 8 * widest || past_each_other(grains, time, {least, 2 * widest + apart})));
  }

 private:
  struct Lengths {
    double least, reach;
  };

  [[nodiscard]] bool past_each_other(const Grains<dim>& grains, double time, const Lengths& lengths) {
    grid_.sort(grains.x, lengths.reach);
    bool past = false;
    for (std::size_t i = 0; i < grains.count() && !past; ++i) {
      grid_.visit_later(i, [&](std::uint32_t j) {
        const Vector from = grains.x[i] - grains.x[j], way = time * (grains.v[i] - grains.v[j]);
        const double square = way.squaredNorm(), to_nearest = -from.dot(way);
        if (!(to_nearest > 0 && to_nearest < square)) return;  // apart from the start on, or nearest at the end
        const double sum = grains.radius[i] + grains.radius[j] - lengths.least / 2;
        past = past || from.squaredNorm() - to_nearest * to_nearest / square < sum * sum;
      });
    }
    return past;
  }

  [[nodiscard]] static bool past_a_segment(const Grains<dim>& grains, double time, double least) noexcept {
    for (const GrainWall<dim>& wall : grains.walls) {
      if (wall.shape != GrainWall<dim>::Shape::segment) continue;
      const Vector along = wall.end - wall.point;
      for (std::size_t i = 0; i < grains.count(); ++i) {
        const Vector from = grains.x[i] - wall.point, way = time * grains.v[i];
        // The distance from a segment has one least value along a straight way.
        if (!(away(along, from).dot(way) < 0 && away(along, from + way).dot(way) > 0)) continue;
        if (distance_on_the_way(along, from, way) < grains.radius[i] - least / 2) return true;
      }
    }
    return false;
  }

  /// From the nearest point of a segment that begins at the origin.
  [[nodiscard]] static Vector away(const Vector& along, const Vector& place) noexcept {
    return place - std::clamp(along.dot(place) / along.squaredNorm(), 0.0, 1.0) * along;
  }

  /// The least distance from that segment of a way that is nearest to it between its ends: between the lines, or at an
  /// end of the segment.
  [[nodiscard]] static double distance_on_the_way(const Vector& along, const Vector& from, const Vector& way) noexcept {
    const auto nearest = [&](const Vector& point) {
      const double part = std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
      return Vector(from + part * way - point).norm();
    };
    double distance = std::min(nearest(Vector::Zero()), nearest(along));
    const double both = way.dot(along), square = along.squaredNorm(), sine = way.squaredNorm() * square - both * both;
    if (sine > 0) {
      const double part = (way.squaredNorm() * along.dot(from) - both * way.dot(from)) / sine;
      if (part > 0 && part < 1) distance = std::min(distance, nearest(part * along));
    }
    return distance;
  }

  NeighbourGrid<dim> grid_;
};

}  // namespace torsor::runtime
