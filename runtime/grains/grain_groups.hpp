// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace torsor::runtime {

/// Groups of grains as trees, the least grain on top (union and find).
class GrainGroups {
 public:
  /// Each grain alone.
  void reset(std::size_t count) {
    above_.resize(count);
    for (std::size_t i = 0; i < count; ++i) above_[i] = static_cast<std::uint32_t>(i);
  }
  void join(std::uint32_t a, std::uint32_t b) noexcept {
    const std::uint32_t p = root(a), q = root(b);
    above_[std::max(p, q)] = std::min(p, q);
  }
  [[nodiscard]] std::uint32_t root(std::uint32_t i) noexcept {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace torsor::runtime
