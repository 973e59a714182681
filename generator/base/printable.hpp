// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace torsor {

/// A character of a text.
struct Character {
  std::size_t size = 1;   ///< bytes
  char32_t code = 0;
  bool is_valid = false;  ///< UTF-8: shortest form, no surrogate, at most U+10FFFF
};

/// The character at the beginning of a text that is not empty; a byte that begins none stands for itself.
Character first_character(std::string_view text);

/// Whether a reader sees the character as what it is: no control character, no format character that turns the direction
/// of text or takes no room (U+061C, U+200B to U+200F, U+2028 to U+202E, U+2060 to U+206F, U+FEFF, U+FFF9 to U+FFFB, tags),
/// no code that stands for no character.
bool is_visible(const Character& character);

/// The text as valid UTF-8 that a terminal, an editor or a picture shows as it is: what is not visible, and bytes that are
/// no UTF-8, become U+FFFD; a tabulator, a new line and a carriage return become a blank.
std::string printable(std::string_view text);

}  // namespace torsor
