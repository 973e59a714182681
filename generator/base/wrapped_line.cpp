// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/wrapped_line.hpp"

#include <string_view>

namespace torsor {
namespace {

/// Whether the blank at this place has a binary operator after it.
bool stands_before_operator(std::string_view text, std::size_t blank) {
  const std::string_view after = text.substr(blank + 1);
  return after.starts_with("&& ") ||
         (after.size() > 2 && after[1] == ' ' && std::string_view("+-*/").find(after[0]) != std::string_view::npos);
}

}  // namespace

std::string wrapped(const std::string& line, std::size_t indentation) {
  constexpr std::size_t columns = 120;
  std::string result;
  std::string rest = line;
  std::size_t room = columns - indentation;
  while (rest.size() > room) {
    std::size_t cut = std::string::npos;
    int template_arguments = 0;  // never broken, nor is a text in quotes
    bool in_quotes = rest.front() == '"';
    for (std::size_t at = 1; at < rest.size() && (at <= room || cut == std::string::npos); ++at) {
      if (rest[at] == '"' && rest[at - 1] != '\\') in_quotes = !in_quotes;
      if (in_quotes) continue;
      if (rest[at] == '<') ++template_arguments;
      if (rest[at] == '>' && rest[at - 1] != '-') --template_arguments;
      if (rest[at] == ' ' && template_arguments == 0 && (rest[at - 1] == ',' || stands_before_operator(rest, at)))
        cut = at;
    }
    if (cut == std::string::npos) break;
    result += rest.substr(0, cut) + "\n    ";
    rest = rest.substr(cut + 1);
    room = columns - indentation - 4;
  }
  return result + rest;
}

}  // namespace torsor
