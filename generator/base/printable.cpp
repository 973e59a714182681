// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/printable.hpp"

#include <algorithm>
#include <array>

namespace torsor {
namespace {

struct CodeRange {
  char32_t first, last;
};

/// Controls, format characters, codes that stand for no character.
constexpr std::array<CodeRange, 11> invisible{{{0x0, 0x1F},
                                               {0x7F, 0x9F},
                                               {0xAD, 0xAD},
                                               {0x61C, 0x61C},
                                               {0x180E, 0x180E},
                                               {0x200B, 0x200F},
                                               {0x2028, 0x202E},
                                               {0x2060, 0x206F},
                                               {0xFEFF, 0xFEFF},
                                               {0xFFF9, 0xFFFB},
                                               {0xE0000, 0xE0FFF}}};

unsigned byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Bytes of a character by its first byte; 0 where none begins so.
std::size_t size_by_first_byte(unsigned first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 0;
}

}  // namespace

Character first_character(std::string_view text) {
  const unsigned first = byte_at(text, 0);
  const Character alone{1, static_cast<char32_t>(first), false};
  const std::size_t size = size_by_first_byte(first);
  if (size == 0 || size > text.size()) return alone;
  if (size == 1) return {1, static_cast<char32_t>(first), true};
  char32_t code = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_at(text, i) & 0xC0U) != 0x80U) return alone;
    code = (code << 6U) | (byte_at(text, i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least.at(size) || is_surrogate || code > 0x10FFFF) return alone;
  return {size, code, true};
}

bool is_visible(const Character& character) {
  if (!character.is_valid || (character.code & 0xFFFEU) == 0xFFFEU) return false;
  return std::none_of(invisible.begin(), invisible.end(), [&](const CodeRange& range) {
    return range.first <= character.code && character.code <= range.last;
  });
}

std::string printable(std::string_view text) {
  constexpr const char* replacement = "\xEF\xBF\xBD";  // U+FFFD
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.code == '\t' || character.code == '\n' || character.code == '\r') {
      result += ' ';
    } else if (is_visible(character)) {
      result += text.substr(0, character.size);
    } else {
      result += replacement;
    }
    text.remove_prefix(character.size);
  }
  return result;
}

}  // namespace torsor
