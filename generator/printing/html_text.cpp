// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/html_text.hpp"

#include <algorithm>

#include "torsor/generator/base/entities.hpp"
#include "torsor/generator/base/printable.hpp"

namespace torsor {

std::string html_escaped(std::string_view text) { return with_entities(printable(text), "&<>\"'"); }

std::string html_lines(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += html_escaped(text.substr(begin, end - begin));
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

}  // namespace torsor
