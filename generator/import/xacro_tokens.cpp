// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_tokens.hpp"

#include <array>

#include <fmt/format.h>

namespace torsor::xacro {
namespace {

bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_numeral(char c) { return c >= '0' && c <= '9'; }

std::size_t end_of_number(std::string_view text, std::size_t at) {
  const auto digits = [&] {
    while (at < text.size() && (is_numeral(text[at]) || text[at] == '_')) ++at;
  };
  digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    digits();
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t next = at + 1;
    if (next < text.size() && (text[next] == '+' || text[next] == '-')) ++next;
    if (next < text.size() && is_numeral(text[next])) {
      at = next;
      digits();
    }
  }
  return at;
}

Token number_token(std::string_view word) {
  if (word.find_first_of(".eE") == std::string_view::npos) {
    if (word.size() > 1 && word[0] == '0' && word.find_first_not_of("0_") != std::string_view::npos) {
      throw ExpressionError(fmt::format("the integer {} begins with 0, which Python refuses; leave the 0 out", word));
    }
    if (const auto whole = python_integer(word)) return {Token::Kind::number, std::string(word), *whole};
    throw ExpressionError(fmt::format("the integer {} is beyond 64 bits; write it as a decimal", word));
  }
  if (const auto real = python_float(word)) return {Token::Kind::number, std::string(word), *real};
  throw ExpressionError(fmt::format("'{}' is no number", word));
}

/// A text in quotes that begins at `at`, which is moved behind it.
Token quoted_text(std::string_view text, std::size_t& at) {
  const char quote = text[at];
  std::string content;
  for (++at; at < text.size() && text[at] != quote; ++at) {
    if (text[at] == '\\' && at + 1 < text.size()) {
      ++at;
      if (std::string_view("nt\\'\"").find(text[at]) == std::string_view::npos) {
        throw ExpressionError(fmt::format("the escape \\{} is not read here; write the character itself", text[at]));
      }
      content += text[at] == 'n' ? '\n' : text[at] == 't' ? '\t' : text[at];
    } else {
      content += text[at];
    }
  }
  if (at >= text.size()) throw ExpressionError(fmt::format("a text is not closed; end it with {}", quote));
  ++at;
  return {Token::Kind::text, content, content};
}

}  // namespace

std::vector<Token> tokens(std::string_view text) {
  static constexpr std::array<std::string_view, 26> symbols{"**", "//", "==", "!=", "<=", ">=", "+", "-", "*",
                                                            "/",  "%",  "(",  ")",  "[",  "]",  "{", "}", ",",
                                                            ":",  ".",  "<",  ">",  "=",  "&",  "|", "~"};
  std::vector<Token> words;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at;
      continue;
    }
    if (is_numeral(c) || (c == '.' && at + 1 < text.size() && is_numeral(text[at + 1]))) {
      const std::size_t end = end_of_number(text, at);
      words.push_back(number_token(text.substr(at, end - at)));
      at = end;
      continue;
    }
    if (begins_name(c)) {
      std::size_t end = at;
      while (end < text.size() && (begins_name(text[end]) || is_numeral(text[end]))) ++end;
      words.push_back({Token::Kind::name, std::string(text.substr(at, end - at)), {}});
      at = end;
      continue;
    }
    if (c == '\'' || c == '"') {
      words.push_back(quoted_text(text, at));
      continue;
    }
    bool found = false;
    for (const std::string_view symbol : symbols) {
      if (text.substr(at, symbol.size()) != symbol) continue;
      words.push_back({Token::Kind::symbol, std::string(symbol), {}});
      at += symbol.size();
      found = true;
      break;
    }
    if (!found) throw ExpressionError(fmt::format("the character '{}' has no meaning in an expression", c));
  }
  words.emplace_back();
  return words;
}

}  // namespace torsor::xacro
