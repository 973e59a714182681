// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_text.hpp"

#include <fmt/format.h>

namespace torsor::xacro {
namespace {

/// Behind the bracket that closes the one at `at`; brackets in quotes do not count. Without one that pairs up, behind
/// the first that closes: an apostrophe may be no quote.
std::size_t end_of_bracket(const std::string& text, std::size_t at) {
  const char open = text[at];
  const char close = open == '{' ? '}' : ')';
  int depth = 0;
  char quote = 0;
  for (std::size_t i = at; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == open) {
      ++depth;
    } else if (c == close && --depth == 0) {
      return i + 1;
    }
  }
  const std::size_t first = text.find(close, at);
  if (first != std::string::npos) return first + 1;
  throw ExpressionError(fmt::format("'{}' is not closed; end it with '{}'", text.substr(at - 1), close));
}

}  // namespace

std::vector<TextPart> text_parts(const std::string& text) {
  std::vector<TextPart> parts;
  const auto add_text = [&parts](const std::string& more) {
    if (parts.empty() || parts.back().kind != TextPart::Kind::text) parts.push_back({TextPart::Kind::text, {}});
    parts.back().content += more;
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t dollar = text.find('$', at);
    if (dollar == std::string::npos || dollar + 1 == text.size()) {
      add_text(text.substr(at));
      break;
    }
    if (dollar > at) add_text(text.substr(at, dollar - at));
    std::size_t next = dollar;
    while (next < text.size() && text[next] == '$') ++next;
    const bool bracket = next < text.size() && (text[next] == '{' || text[next] == '(');
    if (next - dollar > 1 && bracket) {
      add_text(text.substr(dollar + 1, next - dollar));
      at = next + 1;
    } else if (bracket) {
      const std::size_t end = end_of_bracket(text, next);
      parts.push_back({text[next] == '{' ? TextPart::Kind::expression : TextPart::Kind::command,
                       text.substr(next + 1, end - next - 2)});
      at = end;
    } else {
      add_text(text.substr(dollar, next - dollar));
      at = next;
    }
  }
  return parts;
}

Value text_value(const std::string& text, const std::function<Value(const std::string&)>& expression,
                 const std::function<Value(const std::string&)>& command) {
  const std::vector<TextPart> parts = text_parts(text);
  const auto value = [&](const TextPart& part) -> Value {
    if (part.kind == TextPart::Kind::text) return part.content;
    return part.kind == TextPart::Kind::expression ? expression(part.content) : command(part.content);
  };
  if (parts.size() == 1) return value(parts[0]);
  std::string whole;
  for (const TextPart& part : parts) {
    whole += value(part).to_string();
    if (whole.size() > longest_text) throw ExpressionError("a text grows without end");
  }
  return whole;
}

}  // namespace torsor::xacro
