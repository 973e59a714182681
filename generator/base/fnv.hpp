// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace torsor {

/// 64 bits that tell one sequence of bytes from another (FNV-1a), the same on every machine. They guard against
/// accidents, not against intent.
class Fnv {
 public:
  Fnv& add(std::string_view text) noexcept {
    for (const char letter : text) value_ = (value_ ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    return *this;
  }
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace torsor
