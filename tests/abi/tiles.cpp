// SPDX-License-Identifier: GPL-3.0-or-later
// Between arrays of states and packs: every layout, with every number of rows that takes another way through registers.
// Reading goes to the very end of an array, which the address sanitizer watches where it is on; of what is written,
// everything else must stay as it was.
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "torsor/runtime/abi/kernel_call.hpp"

namespace {

namespace abi = torsor::runtime::abi;
constexpr std::size_t lanes = torsor::runtime::native_lanes<double>;
constexpr std::size_t states = 3 * lanes + 1;
constexpr double untouched = -1.0;

/// Steps in numbers from one state, row and column to the next.
struct Layout {
  const char* name;
  std::size_t state, row, column;
};

/// What stands at (i, j) of a state.
constexpr double number(std::size_t state, std::size_t i, std::size_t j) {
  return static_cast<double>(10000 * state + 100 * i + j);
}

torsor_view view_of(std::vector<double>& numbers, const Layout& layout) {
  const auto bytes = [](std::size_t step) { return static_cast<std::ptrdiff_t>(step * sizeof(double)); };
  return {numbers.data(), bytes(layout.state), bytes(layout.row), bytes(layout.column)};
}

/// Just as long as it must be, so that nothing may be read or written behind it.
std::vector<double> array_of(const Layout& layout, std::size_t rows, std::size_t columns) {
  const std::size_t last = (states - 1) * layout.state + (rows - 1) * layout.row + (columns - 1) * layout.column;
  return std::vector<double>(last + 1, untouched);
}

[[noreturn]] void fail(const char* what, const Layout& layout, std::size_t rows, std::size_t columns) {
  std::fprintf(stderr, "%s: %s, %zu x %zu numbers, %zu lanes\n", what, layout.name, rows, columns, lanes);
  std::exit(1);
}

template <class Work>
void for_blocks(const Work& work) {
  for (std::size_t first = 0; first < states; first += lanes) {
    work(abi::StatesOfBlock{first, std::min(lanes, states - first)});
  }
}

template <std::size_t rows>
void read() {
  for (const Layout& layout :
       {Layout{"gapless", rows, 1, 1}, Layout{"gaps", rows + 3, 1, 1}, Layout{"gaps in rows", 3 * rows, 2, 1},
        Layout{"states together", 1, states, 1}, Layout{"one for all", 0, 1, 1}, Layout{"overlapping", 1, 1, 1}}) {
    std::vector<double> array = array_of(layout, rows, 1);
    const bool shared = layout.state == 0 || (layout.state == 1 && layout.row == 1);
    if (shared) {
      std::iota(array.begin(), array.end(), 1.0);
    } else {
      for (std::size_t s = 0; s < states; ++s)
        for (std::size_t i = 0; i < rows; ++i) array[s * layout.state + i * layout.row] = number(s, i, 0);
    }
    const torsor_view from = view_of(array, layout);
    for_blocks([&](abi::StatesOfBlock block) {
      alignas(64) double packs[rows * lanes];
      abi::read_columns<rows, lanes>(from, block, states, packs);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t s = block.first + std::min(lane, block.count - 1);
        for (std::size_t i = 0; i < rows; ++i) {
          if (packs[i * lanes + lane] != array[s * layout.state + i * layout.row])
            fail("read otherwise", layout, rows, 1);
        }
      }
    });
  }
}

template <std::size_t rows, std::size_t columns>
void write() {
  constexpr std::size_t size = rows * columns;
  for (const Layout& layout :
       {Layout{"by columns", size, 1, rows}, Layout{"by rows", size, columns, 1},
        Layout{"by columns, gaps", size + 1, 1, rows}, Layout{"by rows, gaps", size + 9, columns, 1},
        Layout{"gaps in states", 2 * size + 1, 2, 2 * rows}, Layout{"states together", 1, states, states * rows}}) {
    std::vector<double> array = array_of(layout, rows, columns), expected = array;
    const torsor_view to = view_of(array, layout);
    for_blocks([&](abi::StatesOfBlock block) {
      alignas(64) double packs[size * lanes];
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t s = block.first + std::min(lane, block.count - 1);
        for (std::size_t k = 0; k < size; ++k) packs[k * lanes + lane] = number(s, k % rows, k / rows);
      }
      abi::write_matrices_of<lanes, rows, columns>(packs, block, to);
      // Later states are not yet written: what a register held beyond must not be seen.
      for (std::size_t s = block.first; s < block.first + block.count; ++s) {
        for (std::size_t k = 0; k < size; ++k) {
          expected[s * layout.state + k % rows * layout.row + k / rows * layout.column] = number(s, k % rows, k / rows);
        }
      }
      if (array != expected) fail("written otherwise", layout, rows, columns);
    });
  }
}

template <std::size_t... n>
void of_sizes(std::index_sequence<n...>) {
  (read<n>(), ...);
  (write<n, 1>(), ...);
}

}  // namespace

int main() {
  of_sizes(std::index_sequence<1, 2, 3, 5, 7, 8, 9, 14, 17>{});
  write<1, 6>();
  write<2, 3>();
  write<7, 7>();
  std::printf("%zu lanes: all layouts\n", lanes);
}
