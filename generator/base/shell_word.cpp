// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/shell_word.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/printable.hpp"

namespace torsor {
namespace {

bool stands_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-_./=,+@%").find(c) != std::string_view::npos;
}

bool all_visible(std::string_view word) {
  while (!word.empty()) {
    const Character character = first_character(word);
    if (!is_visible(character)) return false;
    word.remove_prefix(character.size);
  }
  return true;
}

/// Two question marks begin a trigraph in C: they never stand side by side.
std::string in_single_quotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      if (c == '?' && text.back() == '?') text += "''";
      text += c;
    }
  }
  return text + "'";
}

/// Bytes of what is not visible as three octal digits, which no following character can lengthen.
std::string with_escapes(std::string_view word) {
  std::string text = "$'";
  while (!word.empty()) {
    const Character character = first_character(word);
    const std::string_view bytes = word.substr(0, character.size);
    if (!is_visible(character) || bytes == "?") {
      for (const char byte : bytes) text += fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
    } else {
      if (bytes == "'" || bytes == "\\") text += '\\';
      text += bytes;
    }
    word.remove_prefix(character.size);
  }
  return text + "'";
}

}  // namespace

std::string shell_word(std::string_view word) {
  if (!all_visible(word)) return with_escapes(word);
  if (!word.empty() && std::all_of(word.begin(), word.end(), stands_bare)) return std::string(word);
  return in_single_quotes(word);
}

}  // namespace torsor
