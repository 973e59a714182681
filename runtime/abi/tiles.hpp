// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "torsor/runtime/batch/simd_pack.hpp"

namespace torsor::runtime::abi {

/// A few numbers in pieces of registers: loads and stores with a mask wait for earlier stores, three times as long as a
/// kernel takes.
template <std::size_t count>
TORSOR_SIMD_INLINED void copy_numbers(const char* from, char* to) noexcept {
  constexpr std::size_t piece = count >= 4 ? 4 : count >= 2 ? 2 : count;
  std::memcpy(to, from, piece * sizeof(double));
  if constexpr (count > piece) copy_numbers<count - piece>(from + piece * sizeof(double), to + piece * sizeof(double));
}

/// `lanes` rows of `lanes` numbers each, a row in a register: states one after the other become packs, and packs
/// states.
template <std::size_t lanes>
class Tile {
 public:
  static constexpr bool in_registers = detail::fits_register(static_cast<int>(lanes * sizeof(double)));

  /// Row i at address(i), all of it, with rows and columns exchanged. Halves of rows are loaded side by side, so that
  /// two steps of shuffles are enough for eight lanes, and one for less.
  template <class Address>
  TORSOR_SIMD_INLINED void load_transposed(const Address& address) noexcept {
    constexpr auto order = std::make_integer_sequence<int, lanes>{};
    if constexpr (lanes == 2) {
      Row a, b;
      std::memcpy(&a, address(0), sizeof(Row));
      std::memcpy(&b, address(1), sizeof(Row));
      rows_ = {even(a, b, order), odd(a, b, order)};
    } else {
      constexpr std::size_t half = lanes / 2;
      std::array<Row, lanes> pairs;  // [side][quarter][even, odd]: two rows each, 2 apart
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t q = 0; q < lanes; q += 4) {
          const auto two_of = [&](std::size_t i) {
            return joined(address(i) + side * half * sizeof(double), address(i + 2) + side * half * sizeof(double));
          };
          const Row a = two_of(q), b = two_of(q + 1);
          pairs[side * half + q / 2] = even(a, b, order);
          pairs[side * half + q / 2 + 1] = odd(a, b, order);
        }
      }
      if constexpr (lanes == 4) {
        rows_ = pairs;
      } else {
        for (std::size_t side = 0; side < 2; ++side) {
          for (std::size_t i = 0; i < 2; ++i) {
            const Row &a = pairs[side * half + i], &b = pairs[side * half + 2 + i];
            rows_[side * half + i] = low_pairs(a, b, order);
            rows_[side * half + 2 + i] = high_pairs(a, b, order);
          }
        }
      }
    }
  }

  /// The first `count` rows, one after the other.
  template <std::size_t count>
  TORSOR_SIMD_INLINED void store_first(double* to) const noexcept {
    for_rows<count>([&](auto row) { std::memcpy(to + row() * lanes, &rows_[row()], sizeof(Row)); });
  }
  /// Rows `step` bytes from each other: all of the first `whole`, `count` numbers of the others.
  template <std::size_t whole, std::size_t rows, std::size_t count>
  TORSOR_SIMD_INLINED void store_rows(char* to, std::ptrdiff_t step) const noexcept {
    for_rows<rows>([&](auto row) {
      char* const into = to + static_cast<std::ptrdiff_t>(row()) * step;
      if constexpr (row() < whole || count == lanes) {
        std::memcpy(into, &rows_[row()], sizeof(Row));
      } else {
        const Row whole_row = rows_[row()];
        copy_numbers<count>(reinterpret_cast<const char*>(&whole_row), into);
      }
    });
  }

 private:
  using Row = typename detail::LaneStorage<double, static_cast<int>(lanes), in_registers>::Numbers;
  static_assert(!in_registers || lanes == 1 || lanes == 2 || lanes == 4 || lanes == 8);

  /// Half a row from each address.
  TORSOR_SIMD_INLINED static Row joined(const char* first, const char* second) noexcept {
#if defined(__AVX512F__)
    if constexpr (lanes == 8) {
      // With a mask, because g++ 12 warns of its own form without.
      return (Row)_mm512_maskz_insertf64x4(
          0xff, _mm512_castpd256_pd512(_mm256_loadu_pd(reinterpret_cast<const double*>(first))),
          _mm256_loadu_pd(reinterpret_cast<const double*>(second)), 1);
    }
#endif
#if defined(__AVX__)
    if constexpr (lanes == 4) {
      return (Row)_mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(reinterpret_cast<const double*>(first))),
                                       _mm_loadu_pd(reinterpret_cast<const double*>(second)), 1);
    }
#endif
    Row row;
    std::memcpy(&row, first, sizeof(Row) / 2);
    std::memcpy(reinterpret_cast<char*>(&row) + sizeof(Row) / 2, second, sizeof(Row) / 2);
    return row;
  }

  // a0 b0 a2 b2 ..., a1 b1 a3 b3 ...
  template <int... lane>
  TORSOR_SIMD_INLINED static Row even(const Row& a, const Row& b, std::integer_sequence<int, lane...>) noexcept {
    return __builtin_shufflevector(a, b, (lane % 2 * static_cast<int>(lanes) + lane / 2 * 2)...);
  }
  template <int... lane>
  TORSOR_SIMD_INLINED static Row odd(const Row& a, const Row& b, std::integer_sequence<int, lane...>) noexcept {
    return __builtin_shufflevector(a, b, (lane % 2 * static_cast<int>(lanes) + lane / 2 * 2 + 1)...);
  }
  // a0 a1 a4 a5 b0 b1 b4 b5, a2 a3 a6 a7 b2 b3 b6 b7
  template <int... lane>
  TORSOR_SIMD_INLINED static Row low_pairs(const Row& a, const Row& b, std::integer_sequence<int, lane...>) noexcept {
    return __builtin_shufflevector(a, b, (lane / 2 * 4 + lane % 2)...);
  }
  template <int... lane>
  TORSOR_SIMD_INLINED static Row high_pairs(const Row& a, const Row& b, std::integer_sequence<int, lane...>) noexcept {
    return __builtin_shufflevector(a, b, (lane / 2 * 4 + lane % 2 + 2)...);
  }

  // Each with its number known when this is compiled: rows then stay in registers.
  template <std::size_t count, class Work>
  TORSOR_SIMD_INLINED static void for_rows(const Work& work) noexcept {
    [&]<std::size_t... row>(std::index_sequence<row...>) { (work(std::integral_constant<std::size_t, row>{}), ...); }
    (std::make_index_sequence<count>{});
  }

  std::array<Row, lanes> rows_;
};

/// Columns of `rows` numbers without gaps, `step` bytes from one of the `lanes` states to the next, to packs. With
/// `beyond`, up to lanes - 1 numbers behind each column may be read.
template <std::size_t rows, std::size_t lanes>
TORSOR_SIMD_INLINED void columns_to_packs(const char* from, std::ptrdiff_t step, bool beyond, double* to) noexcept {
  constexpr std::size_t whole = rows / lanes * lanes, rest = rows - whole;
  const auto column = [=](std::size_t k) {
    return [at = from + k * sizeof(double), step](std::size_t lane) {
      return at + static_cast<std::ptrdiff_t>(lane) * step;
    };
  };
  for (std::size_t k = 0; k < whole; k += lanes) {
    Tile<lanes> tile;
    tile.load_transposed(column(k));
    tile.template store_first<lanes>(to + k * lanes);
  }
  if constexpr (rest > 0) {
    if (beyond) {
      Tile<lanes> tile;
      tile.load_transposed(column(whole));
      tile.template store_first<rest>(to + whole * lanes);
    } else {
      alignas(64) std::array<double, lanes * lanes> square{};
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        copy_numbers<rest>(column(whole)(lane), reinterpret_cast<char*>(square.data() + lane * lanes));
      }
      Tile<lanes> tile;
      tile.load_transposed(
          [&](std::size_t lane) { return reinterpret_cast<const char*>(square.data() + lane * lanes); });
      tile.template store_first<rest>(to + whole * lanes);
    }
  }
}

/// The other way, of all lanes: number k of a state, of `numbers`, is entry `entry(k)` of the packs. Nothing else is
/// written in the end.
template <std::size_t numbers, std::size_t lanes, class Entry>
TORSOR_SIMD_INLINED void packs_to_states(const double* from, const Entry& entry, char* to,
                                         std::ptrdiff_t step) noexcept {
  constexpr std::size_t whole = numbers / lanes * lanes, rest = numbers - whole;
  // The last numbers of all states go first: where states follow each other without gaps, registers are stored over the
  // beginning of later states, which are written afterwards.
  if constexpr (rest > 0) {
    Tile<lanes> tile;
    tile.load_transposed([&](std::size_t i) {
      return reinterpret_cast<const char*>(from + entry(i < rest ? whole + i : numbers - 1) * lanes);
    });
    char* const into = to + whole * sizeof(double);
    if (step == static_cast<std::ptrdiff_t>(numbers * sizeof(double))) {
      constexpr std::size_t over = (lanes - rest + numbers - 1) / numbers;  // states that a register reaches into
      tile.template store_rows<lanes - std::min(lanes, over), lanes, rest>(into, step);
    } else {
      tile.template store_rows<0, lanes, rest>(into, step);
    }
  }
  for (std::size_t k = 0; k < whole; k += lanes) {
    Tile<lanes> tile;
    tile.load_transposed([&](std::size_t i) { return reinterpret_cast<const char*>(from + entry(k + i) * lanes); });
    tile.template store_rows<lanes, lanes, lanes>(to + k * sizeof(double), step);
  }
}

}  // namespace torsor::runtime::abi
