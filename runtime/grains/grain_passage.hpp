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

  /// In the time until the next look, from where the grains are: whether two pass each other deeper than half the
  /// smallest radius, or a centre passes a segment. Also true where grains move apart or together by more than four of
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
    return (time * fastest > least && past_a_segment(grains, time)) ||
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

  [[nodiscard]] static bool past_a_segment(const Grains<dim>& grains, double time) noexcept {
    if constexpr (dim == 2) {
      const auto cross = [](const Vector& a, const Vector& b) { return a(0) * b(1) - a(1) * b(0); };
      for (const GrainWall<dim>& wall : grains.walls) {
        if (wall.shape != GrainWall<dim>::Shape::segment) continue;
        const Vector along = wall.end - wall.point;
        for (std::size_t i = 0; i < grains.count(); ++i) {
          const Vector from = grains.x[i] - wall.point, to = from + time * grains.v[i];
          const double before = cross(along, from), after = cross(along, to);
          if (!((before > 0 && after < 0) || (before < 0 && after > 0))) continue;
          const Vector on_line = from + before / (before - after) * (to - from);
          const double place = on_line.dot(along);
          if (place >= 0 && place <= along.squaredNorm()) return true;
        }
      }
    }
    return false;
  }

  NeighbourGrid<dim> grid_;
};

}  // namespace torsor::runtime
