// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>

namespace torsor {

/// Where a result of a function goes: an entry of an array, a member of a structure, or an entry of such a member.
struct Target {
  std::string result;                  ///< what the function calls it, e.g. "forces"
  std::string member{};                ///< of a structure, else empty
  std::optional<std::size_t> entry{};  ///< of an array, or of a vector that has a name for each entry

  /// One of its entries.
  Target operator[](std::size_t index) const { return {result, member, index}; }
  /// "result.A[7]"
  std::string to_string() const;
  friend bool operator==(const Target&, const Target&) = default;
  friend bool operator<(const Target& a, const Target& b) {
    return std::tie(a.result, a.member, a.entry) < std::tie(b.result, b.member, b.entry);
  }
};

}  // namespace torsor
