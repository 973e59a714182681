// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string_view>

namespace torsor::runtime::abi {

/// What a size of a mechanism must be beside the number that it is compared with, and what is said where it is not: each \001
/// stands for a number. Which numbers that are, among all of a mechanism: the two that are compared from `first` on, those of
/// the text from `shown` on.
struct SizeCheck {
  enum Relation { at_least, at_most, below };
  Relation relation;
  std::size_t first, shown;
  const char* said;

  [[nodiscard]] constexpr bool broken(std::span<const double> numbers) const noexcept {
    const double size = numbers[first], bound = numbers[first + 1];
    if (relation == at_least) return size < bound;
    return relation == at_most ? size > bound : size >= bound;
  }

  /// As much as fits, with a zero behind it.
  template <std::size_t room>
  void say(std::array<char, room>& text, std::span<const double> numbers) const noexcept {
    std::size_t length = 0;
    const auto add = [&](std::string_view part) {
      for (const char c : part) {
        if (length + 1 < room) text[length++] = c;
      }
    };
    const std::string_view all(said);
    std::size_t from = 0;
    for (const double number : numbers.subspan(shown)) {
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
  static constexpr std::size_t numbers = 0;
  static constexpr std::array<SizeCheck, 0> sizes{};
};

}  // namespace torsor::runtime::abi
