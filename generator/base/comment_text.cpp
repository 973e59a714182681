// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/comment_text.hpp"

#include <string_view>

#include "torsor/generator/base/printable.hpp"

namespace torsor {

std::string comment_text(const std::string& text) {
  const std::string visible = printable(text);
  std::string safe;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    safe += visible[i];
    constexpr std::string_view ends_of_trigraphs = "=/'()!<>-";
    const bool trigraph = visible[i] == '?' && i + 2 < visible.size() && visible[i + 1] == '?' &&
                          ends_of_trigraphs.find(visible[i + 2]) != std::string_view::npos;
    if (trigraph) safe += ' ';
  }
  // A backslash at the end, blanks behind it or not, would make the next line part of the comment.
  for (std::size_t last = safe.find_last_not_of(' '); last != std::string::npos && safe[last] == '\\'; --last) {
    safe[last] = '/';
    if (last == 0) break;
  }
  return safe;
}

}  // namespace torsor
