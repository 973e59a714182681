// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "runtime/batch/simd_pack.hpp"

namespace torsor::runtime::abi {

/// `lanes` rows of `lanes` numbers each, a row in a register: states one after the other become packs, and packs
/// states.
template <std::size_t lanes>
class Tile {
 public:
  static constexpr bool in_registers = detail::fits_register(static_cast<int>(lanes * sizeof(double)));

  /// A whole row.
  TORSOR_SIMD_INLINED void load(std::size_t row, const char* from) noexcept {
    std::memcpy(&rows_[row], from, sizeof(Row));
  }
  /// The first `count` numbers of a row; the rest is zero. No others are read. In pieces: loads with a mask wait for
  /// earlier stores, three times as long as a kernel takes.
  TORSOR_SIMD_INLINED void load_part(std::size_t row, const char* from, std::size_t count) noexcept {
    rows_[row] = Row{};
    char* to = reinterpret_cast<char*>(&rows_[row]);
    if constexpr (lanes > 4) copy_piece<4>(from, to, count);
    if constexpr (lanes > 2) copy_piece<2>(from, to, count);
    copy_piece<1>(from, to, count);
  }

  /// The first `count` numbers of a row.
  TORSOR_SIMD_INLINED void store(std::size_t row, char* to, std::size_t count) const noexcept {
    if (count == lanes) {
      std::memcpy(to, &rows_[row], sizeof(Row));
      return;
    }
    const char* from = reinterpret_cast<const char*>(&rows_[row]);
    if constexpr (lanes > 4) copy_piece<4>(from, to, count);
    if constexpr (lanes > 2) copy_piece<2>(from, to, count);
    copy_piece<1>(from, to, count);
  }

  /// Whole rows of packs.
  TORSOR_SIMD_INLINED void load_pack(std::size_t row, const double* from) noexcept {
    std::memcpy(&rows_[row], from, sizeof(Row));
  }
  TORSOR_SIMD_INLINED void store_pack(std::size_t row, double* to) const noexcept {
    std::memcpy(to, &rows_[row], sizeof(Row));
  }

  TORSOR_SIMD_INLINED void transpose() noexcept {
    exchange<1>();
    if constexpr (lanes > 2) exchange<2>();
    if constexpr (lanes > 4) exchange<4>();
  }

 private:
  using Row = typename detail::LaneStorage<double, static_cast<int>(lanes), in_registers>::Numbers;

  template <std::size_t piece>
  TORSOR_SIMD_INLINED static void copy_piece(const char*& from, char*& to, std::size_t count) noexcept {
    if ((count & piece) == 0) return;
    std::memcpy(to, from, piece * sizeof(double));
    from += piece * sizeof(double);
    to += piece * sizeof(double);
  }

  // Blocks of step x step numbers beside the diagonal change places.
  template <int step>
  TORSOR_SIMD_INLINED void exchange() noexcept {
    for (std::size_t i = 0; i < lanes; ++i) {
      if ((i & std::size_t{step}) == 0)
        exchange<step>(rows_[i], rows_[i + step], std::make_integer_sequence<int, lanes>{});
    }
  }
  template <int step, int... lane>
  TORSOR_SIMD_INLINED static void exchange(Row& first, Row& second, std::integer_sequence<int, lane...>) noexcept {
    constexpr int size = static_cast<int>(lanes);
    const Row a = first, b = second;
    first = __builtin_shufflevector(a, b, ((lane & step) != 0 ? size + lane - step : lane)...);
    second = __builtin_shufflevector(a, b, ((lane & step) != 0 ? size + lane : lane + step)...);
  }

  std::array<Row, lanes> rows_;
};

/// Columns of `rows` numbers without gaps, `step` bytes from one of the `lanes` states to the next, to packs. With
/// `beyond`, up to lanes - 1 numbers behind each column may be read.
template <std::size_t rows, std::size_t lanes>
TORSOR_SIMD_INLINED void columns_to_packs(const char* from, std::ptrdiff_t step, bool beyond, double* to) noexcept {
  for (std::size_t k = 0; k < rows; k += lanes) {
    const std::size_t count = std::min(lanes, rows - k);
    Tile<lanes> tile;
    const char* column = from + k * sizeof(double);
    if (beyond || count == lanes) {
      for (std::size_t lane = 0; lane < lanes; ++lane, column += step) tile.load(lane, column);
    } else {
      for (std::size_t lane = 0; lane < lanes; ++lane, column += step) tile.load_part(lane, column, count);
    }
    tile.transpose();
    for (std::size_t i = 0; i < count; ++i) tile.store_pack(i, to + (k + i) * lanes);
  }
}

/// The other way: number k of a state is entry `entry(k)` of the packs.
template <std::size_t lanes, class Entry>
TORSOR_SIMD_INLINED void packs_to_states(const double* from, std::size_t count_of_state, const Entry& entry, char* to,
                                         std::ptrdiff_t step, std::size_t states) noexcept {
  for (std::size_t k = 0; k < count_of_state; k += lanes) {
    const std::size_t count = std::min(lanes, count_of_state - k);
    Tile<lanes> tile;
    for (std::size_t i = 0; i < lanes; ++i)
      tile.load_pack(i, from + entry(std::min(k + i, count_of_state - 1)) * lanes);
    tile.transpose();
    for (std::size_t lane = 0; lane < states; ++lane) {
      tile.store(lane, to + static_cast<std::ptrdiff_t>(lane) * step + k * sizeof(double), count);
    }
  }
}

}  // namespace torsor::runtime::abi
