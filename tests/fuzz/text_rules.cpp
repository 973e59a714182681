// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/text_rules.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

#include <tinyxml2.h>

namespace torsor::fuzzing {
namespace {

[[noreturn]] void refuse(const std::string& what, std::string_view text, std::size_t at) {
  const std::size_t begin = at < 40 ? 0 : at - 40;
  throw std::logic_error(what + " in: " + std::string(text.substr(begin, 80)));
}

/// The character that begins at a byte, and the bytes that it takes; none where it is no UTF-8 (RFC 3629).
std::size_t character(std::string_view text, std::size_t at, std::uint32_t& code) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(at);
  const std::size_t length = first < 0x80 ? 1 : first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4 : 0;
  if (length == 0 || at + length > text.size()) return 0;
  code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(at + i) & 0x3FU);
  }
  const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  return too_long || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF) ? 0 : length;
}

bool is_control(std::uint32_t code) {
  return (code < 0x20 && code != '\n') || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
}
/// Characters that take no room: soft hyphen, joiners, word joiner and other invisible ones, byte order mark,
/// annotations, tags.
bool is_unseen(std::uint32_t code) {
  return code == 0xAD || code == 0x180E || (code >= 0x200B && code <= 0x200D) || (code >= 0x2060 && code <= 0x2065) ||
         code == 0xFEFF || (code >= 0xFFF9 && code <= 0xFFFB) || (code >= 0xE0000 && code <= 0xE0FFF);
}
/// Marks, embeddings, overrides and isolates of Unicode's bidirectional algorithm.
bool turns_direction(std::uint32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

void expect_clean_text(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t code = 0;
    const std::size_t length = character(text, at, code);
    if (length == 0) refuse("a byte that is no UTF-8", text, at);
    if (is_control(code)) refuse("control character " + std::to_string(code), text, at);
    if (turns_direction(code)) refuse("a character that turns the direction of writing", text, at);
    if (is_unseen(code)) refuse("a character that is not seen", text, at);
    at += length;
  }
}

void expect_source_text(std::string_view text) {
  expect_clean_text(text);
  for (std::size_t at = text.find("?""?"); at != std::string_view::npos; at = text.find("?""?", at + 1)) {
    if (at + 2 < text.size() && std::string_view("=/'()!<>-").find(text[at + 2]) != std::string_view::npos)
      refuse("a trigraph", text, at);
  }
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1)) {
    const std::size_t last = text.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
    const std::size_t begin = text.rfind('\n', end == 0 ? 0 : end - 1);
    const std::string_view line = text.substr(begin == std::string_view::npos ? 0 : begin + 1, end - begin - 1);
    if (last != std::string_view::npos && text[last] == '\\' && line.find("//") != std::string_view::npos)
      refuse("a comment that goes on in the next line", text, end);
  }
}

void expect_lines(std::string_view text) {
  expect_clean_text(text);
  if (!text.empty() && text.back() != '\n') refuse("a last line without its end", text, text.size());
  if (text.find("unexpected failure") != std::string_view::npos) refuse("a failure that nobody foresaw", text, text.find("unexpected"));
}

void expect_xml(std::string_view text) {
  expect_clean_text(text);
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || document.RootElement() == nullptr)
    refuse("no XML", text, 0);
  // What the parser forgives: a bare & or <, and ]]>, in a text.
  for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
    const std::string_view entity = text.substr(at, text.find(';', at) - at + 1);
    if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;") refuse("a bare &", text, at);
  }
  if (const std::size_t at = text.find("]]>"); at != std::string_view::npos) refuse("the end of a CDATA section", text, at);
}

void expect_dot(std::string_view text) {
  expect_clean_text(text);
  bool quoted = false;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted && c == '\\') {
      ++at;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (quoted && c == '\n') {
      refuse("a text of dot that is not closed in its line", text, at);
    } else if (!quoted) {
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      const bool plain = std::string_view("abcdefghijklmnopqrstuvwxyz0123456789 {}[]=-,;\n#").find(c) != std::string_view::npos;
      if (!plain) refuse("a character of a name outside its quotes", text, at);
    }
  }
  if (quoted || depth != 0) refuse("no graph of dot", text, text.size());
}

void expect_message(std::string_view message) {
  if (message.empty()) throw std::logic_error("an error says nothing");
  expect_clean_text(message);
  if (message.find('\n') != std::string_view::npos) refuse("an error of several lines", message, message.find('\n'));
}

}  // namespace torsor::fuzzing
