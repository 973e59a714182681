// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

namespace torsor::runtime {

/// A matrix of fixed size, stored column by column, or a column: for methods that go through the entries themselves, and
/// are compiled for each mechanism. An expression library would take most of that time.
template <class Scalar, std::size_t rows, std::size_t columns = 1>
struct SmallMatrix {
  std::array<Scalar, rows * columns> entries;

  [[nodiscard]] Scalar& operator()(int i, int j) noexcept { return entries[place(i, j)]; }
  [[nodiscard]] const Scalar& operator()(int i, int j) const noexcept { return entries[place(i, j)]; }
  [[nodiscard]] Scalar& operator()(int i) noexcept requires(columns == 1) { return entries[place(i, 0)]; }
  [[nodiscard]] const Scalar& operator()(int i) const noexcept requires(columns == 1) { return entries[place(i, 0)]; }

  [[nodiscard]] SmallMatrix operator-() const noexcept {
    SmallMatrix result = *this;
    for (Scalar& entry : result.entries) entry = -entry;
    return result;
  }

 private:
  [[nodiscard]] static constexpr std::size_t place(int i, int j) noexcept {
    return static_cast<std::size_t>(j) * rows + static_cast<std::size_t>(i);
  }
};

}  // namespace torsor::runtime
