// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdio>
#include <string_view>

namespace torsor::runtime::abi {

/// What a size of a mechanism must be beside the number that it is compared with, and what is said where it is not: each \001
/// stands for a number, the size first.
struct SizeCheck {
  enum Relation { at_least, at_most, below };
  int relation;
  const char* said;

  [[nodiscard]] constexpr bool broken(double size, double bound) const noexcept {
    if (relation == at_least) return size < bound;
    return relation == at_most ? size > bound : size >= bound;
  }

  /// As much as fits, with a zero behind it.
  template <std::size_t room>
  void say(std::array<char, room>& text, double size, double bound) const noexcept {
    std::size_t length = 0;
    const auto add = [&](std::string_view part) {
      for (const char c : part) {
        if (length + 1 < room) text[length++] = c;
      }
    };
    const std::string_view all(said);
    std::size_t from = 0;
    for (const double number : {size, bound}) {
      const std::size_t place = all.find('\001', from);
      if (place == std::string_view::npos) break;
      std::array<char, 32> digits;
      std::snprintf(digits.data(), digits.size(), "%.6g", number);
      add(all.substr(from, place - from));
      add(digits.data());
      from = place + 1;
    }
    add(all.substr(from));
    text[length] = '\0';
  }
};

/// Of a mechanism whose sizes no run-time parameter changes.
struct NoSizes {
  static constexpr std::array<SizeCheck, 0> sizes{};
};

}  // namespace torsor::runtime::abi
