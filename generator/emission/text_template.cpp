// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/text_template.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

struct Placeholder {
  std::string name;
  std::size_t end = 0;  ///< of its text in the line
};

Placeholder placeholder_at(std::string_view name, std::string_view line, std::size_t begin, int line_number) {
  const std::size_t end = line.find('@', begin + 1);
  const std::string_view word = line.substr(begin + 1, end == std::string_view::npos ? end : end - begin - 1);
  const bool well_formed =
      end != std::string_view::npos && !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
      });
  if (!well_formed) {
    throw Error(
        fmt::format("template '{}', line {}: the '@' in \"{}\" begins no placeholder; write @name@ with "
                    "lower-case letters, digits and underscores",
                    name, line_number, line));
  }
  return {std::string(word), end + 1};
}

}  // namespace

std::string indented(const std::string& text, std::string_view indentation) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) result.append(indentation).append(text, begin, end - begin);
    result += '\n';
    begin = end + 1;
  }
  return result;
}

std::string fill_template(std::string_view name, std::string_view text,
                          const std::map<std::string, std::string>& values) {
  std::string result;
  std::set<std::string> used;
  int line_number = 0;
  const auto text_of = [&](const Placeholder& placeholder) -> const std::string& {
    const auto found = values.find(placeholder.name);
    if (found == values.end()) {
      throw Error(
          fmt::format("template '{}', line {}: nothing is given for the placeholder @{}@; give it a text or "
                      "take it out of the template",
                      name, line_number, placeholder.name));
    }
    used.insert(placeholder.name);
    return found->second;
  };
  for (std::size_t begin = 0; begin < text.size();) {
    ++line_number;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string_view::npos && line[first] == '@') {
      const Placeholder placeholder = placeholder_at(name, line, first, line_number);
      if (placeholder.end == line.size()) {
        result += indented(text_of(placeholder), line.substr(0, first));
        continue;
      }
    }
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t next = std::min(line.find('@', at), line.size());
      result.append(line, at, next - at);
      if (next == line.size()) break;
      const Placeholder placeholder = placeholder_at(name, line, next, line_number);
      result += text_of(placeholder);
      at = placeholder.end;
    }
    if (end < text.size()) result += '\n';
  }
  for (const auto& [key, value] : values) {
    if (!used.contains(key)) {
      throw Error(
          fmt::format("template '{}' has no placeholder @{}@ for the text that is given: add it to the template "
                      "or do not give it",
                      name, key));
    }
  }
  return result;
}

}  // namespace torsor
