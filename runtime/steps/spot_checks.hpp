// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace torsor::runtime {

/// Numbers between 0 and 1 of which no two are equal nor near: parts of the multiples of the golden ratio.
template <class Scalar>
[[nodiscard]] Scalar spread(std::size_t i) noexcept {
  const Scalar multiple = static_cast<Scalar>(i + 1) * Scalar(0.6180339887498949);
  return multiple - std::floor(multiple);
}

/// Which steps of a run also look whether the model still has the structure that the method asks for: those after 1, 2,
/// 4, 8, ... steps and after every 64. What a check costs is then shared by 64 steps.
class SpotChecks {
 public:
  [[nodiscard]] bool due() noexcept {
    const std::uint64_t taken = taken_++;
    return taken > 0 && ((taken & (taken - 1)) == 0 || taken % 64 == 0);
  }

 private:
  std::uint64_t taken_ = 0;
};

}  // namespace torsor::runtime
