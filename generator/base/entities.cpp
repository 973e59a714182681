// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/entities.hpp"

namespace torsor {

std::string with_entities(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) == std::string_view::npos) {
      result += c;
    } else {
      result += c == '&'   ? "&amp;"
                : c == '<' ? "&lt;"
                : c == '>' ? "&gt;"
                : c == '"' ? "&quot;"
                           : "&#" + std::to_string(static_cast<int>(c)) + ";";
    }
  }
  return result;
}

}  // namespace torsor
