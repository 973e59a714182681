// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace torsor::runtime {

/// 64 bits that tell one sequence of values from another (FNV-1a): a change of any value changes them but for one in
/// 2^64. They guard against accidents, not against intent. The same on every machine.
class Digest {
 public:
  Digest& add(std::uint64_t value) noexcept {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ ((value >> (8 * byte)) & 0xffU)) * 0x100000001b3U;
    }
    return *this;
  }
  Digest& add(double value) noexcept { return add(std::bit_cast<std::uint64_t>(value)); }
  Digest& add(std::span<const double> values) noexcept {
    for (const double value : values) add(value);
    return *this;
  }
  /// With its length, so that two texts in a row are told from others.
  Digest& add(std::string_view text) noexcept {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char letter : text) value_ = (value_ ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    return *this;
  }

  [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace torsor::runtime
