// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace torsor::runtime {

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
