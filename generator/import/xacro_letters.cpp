// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_letters.hpp"

#include <algorithm>

namespace torsor::xacro {
namespace {

/// Bytes 10xxxxxx go on with what the one before them began.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::size_t end_of_letter(const std::string& text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t most = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : first >= 0xC0U ? 2 : 1;
  std::size_t end = at + 1;
  while (end < text.size() && end < at + most && goes_on(text[end])) ++end;
  return end;
}

}  // namespace

std::vector<std::string> letters(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_letter(text, at);
    all.push_back(text.substr(at, end - at));
    at = end;
  }
  return all;
}

std::size_t letter_count(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at = end_of_letter(text, at)) ++count;
  return count;
}

std::string part_of_letters(const std::string& text, std::size_t begin, std::size_t count) {
  std::size_t from = 0;
  for (; begin > 0 && from < text.size(); --begin) from = end_of_letter(text, from);
  std::size_t to = from;
  for (; count > 0 && to < text.size(); --count) to = end_of_letter(text, to);
  return text.substr(from, to - from);
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
}

}  // namespace torsor::xacro
