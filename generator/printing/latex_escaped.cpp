// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {
namespace {

/// Signs that text has and LaTeX reads otherwise, or lacks.
constexpr std::pair<std::string_view, std::string_view> signs[] = {
    {"\\", "\\textbackslash{}"}, {"<", "\\textless{}"}, {">", "\\textgreater{}"}, {"|", "\\textbar{}"}, {"~", "\\~{}"},
    {"^", "\\^{}"}, {"#", "\\#"}, {"$", "\\$"}, {"%", "\\%"}, {"&", "\\&"}, {"_", "\\_"}, {"{", "\\{"}, {"}", "\\}"},
    {"€", "\\texteuro{}"}, {"°", "\\textdegree{}"}, {"²", "\\texttwosuperior{}"}, {"³", "\\textthreesuperior{}"}};

/// From U+03B1 and from U+0391 on; what looks as a Latin letter does stands as that letter.
constexpr std::array<std::string_view, 25> small{
    "\\alpha", "\\beta", "\\gamma", "\\delta", "\\varepsilon", "\\zeta", "\\eta", "\\theta", "\\iota",
    "\\kappa", "\\lambda", "\\mu", "\\nu", "\\xi", "o", "\\pi", "\\rho", "\\varsigma",
    "\\sigma", "\\tau", "\\upsilon", "\\varphi", "\\chi", "\\psi", "\\omega"};
constexpr std::array<std::string_view, 25> capital{
    "A", "B", "\\Gamma", "\\Delta", "E", "Z", "H", "\\Theta", "I", "K", "\\Lambda", "M", "N", "\\Xi", "O", "\\Pi", "P", "",
    "\\Sigma", "T", "Y", "\\Phi", "X", "\\Psi", "\\Omega"};

std::string_view greek_letter(std::uint32_t code) {
  if (code >= 0x3b1 && code < 0x3b1 + small.size()) return small[code - 0x3b1];
  if (code >= 0x391 && code < 0x391 + capital.size()) return capital[code - 0x391];
  return {};
}

std::string utf8(std::uint32_t code) {
  return {static_cast<char>(0xc0U | (code >> 6U)), static_cast<char>(0x80U | (code & 0x3fU))};
}

std::string greek_in_text(std::string_view letter) { return fmt::format("\\ensuremath{{{}}}", letter); }

/// Letters of Europe, with the dashes and quotation marks: what inputenc knows.
bool is_known(std::uint32_t code) {
  return code < 0x180 || code == 0x2013 || code == 0x2014 || (code >= 0x2018 && code <= 0x201e) || code == 0x2026;
}

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

Character character_at(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = lead < 0xc0 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  if (bytes == 1 || bytes > text.size()) return {lead, 1};
  std::uint32_t code = lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3fU);
  return {code, bytes};
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = std::string_view(text).substr(i);
    const Character character = character_at(rest);
    const std::string_view itself = rest.substr(0, character.bytes);
    const auto sign = std::find_if(std::begin(signs), std::end(signs), [&](const auto& each) { return each.first == itself; });
    const std::string_view letter = greek_letter(character.code);
    if (sign != std::end(signs)) result += sign->second;
    else if (!letter.empty()) result += greek_in_text(letter);
    else if (is_known(character.code)) result += itself;
    else result += fmt::format("[U+{:04X}]", character.code);
    i += character.bytes;
  }
  return result;
}

std::string latex_unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    const auto sign = std::find_if(std::begin(signs), std::end(signs), [&](const auto& each) { return rest.starts_with(each.second); });
    if (sign != std::end(signs)) {
      result += sign->first;
      i += sign->second.size();
      continue;
    }
    bool found = false;
    for (std::uint32_t code = 0x391; code < 0x3ca && !found && rest.starts_with("\\ensuremath{"); ++code) {
      const std::string letter = greek_letter(code).empty() ? "" : greek_in_text(greek_letter(code));
      if (letter.empty() || !rest.starts_with(letter)) continue;
      result += utf8(code);
      i += letter.size();
      found = true;
    }
    if (!found) result += text[i++];
  }
  return result;
}

}  // namespace torsor::printing
