// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace torsor::runtime {

/// Pairs of points that are near each other, by a uniform grid of cells. Cells are found by a table of twice as many
/// places as there are points, so that the memory does not depend on the room. Suits grains of similar size.
template <int dim>
class NeighbourGrid {
 public:
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Cell = std::array<std::int32_t, static_cast<std::size_t>(dim)>;

  /// Sorts the points into cells of a width.
  void sort(const std::vector<Vector>& points, double width) {
    const std::size_t count = points.size();
    places_ = std::bit_ceil(2 * count + 1);
    cells_.resize(count);
    order_.resize(count);
    first_.assign(places_ + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < dim; ++k) {
        const double place = std::floor(points[i](static_cast<Eigen::Index>(k)) / width);
        cells_[i][k] = std::isfinite(place) ? static_cast<std::int32_t>(std::clamp(place, -2e9, 2e9)) : 0;
      }
      ++first_[place_of(cells_[i]) + 1];
    }
    for (std::size_t p = 0; p < places_; ++p) first_[p + 1] += first_[p];
    // Backwards, so that the points of a place keep their order.
    ends_.assign(first_.begin() + 1, first_.end());
    for (std::size_t i = count; i-- > 0;) order_[--ends_[place_of(cells_[i])]] = static_cast<std::uint32_t>(i);
  }

  /// Calls visit(j) for each point j > i in the cells around that of point i, those of a cell in ascending order.
  template <class Visit>
  void visit_later(std::size_t i, const Visit& visit) const {
    Cell offset;
    offset.fill(-1);
    for (bool more = true; more;) {
      Cell cell = cells_[i];
      for (std::size_t k = 0; k < dim; ++k) cell[k] += offset[k];
      const std::size_t place = place_of(cell);
      for (std::uint32_t p = first_[place]; p < first_[place + 1]; ++p) {
        const std::uint32_t j = order_[p];
        if (j > i && cells_[j] == cell) visit(j);
      }
      more = false;
      for (std::size_t k = 0; k < dim && !more; ++k) {
        more = ++offset[k] <= 1;
        if (!more) offset[k] = -1;
      }
    }
  }

 private:
  [[nodiscard]] std::size_t place_of(const Cell& cell) const noexcept {
    std::uint64_t hash = 0;
    for (const std::int32_t k : cell) hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(hash >> 20) & (places_ - 1);
  }

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> order_, first_, ends_;
  std::size_t places_ = 1;
};

}  // namespace torsor::runtime
