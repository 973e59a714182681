// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/contact_letters.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace torsor::printing {
namespace {

bool is_of_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The first spelling that no symbol of the scene has; the last one otherwise.
Spelling free_spelling(const SceneContent& scene, std::initializer_list<Spelling> spellings) {
  const auto is_free = [&](const Spelling& each) { return !scene.names.contains("symbol " + each.plain); };
  const auto place = std::find_if(spellings.begin(), spellings.end(), is_free);
  return place == spellings.end() ? *(spellings.end() - 1) : *place;
}

}  // namespace

ContactLetters::ContactLetters(const SceneContent& scene) {
  const auto letter = [&](const std::string& usual, const std::string& index, const char* word) {
    const std::string stem = usual.substr(0, 1), more = usual.size() > 1 ? usual.substr(2) : "";
    const Spelling itself{usual, usual};
    const Spelling indexed{stem + "_" + index + more, stem + "_{" + index + (more.empty() ? "" : "," + more) + "}"};
    const Spelling in_words{word, std::string("\\mathrm{") + word + "}" + (more.empty() ? "" : "_" + more)};
    const Spelling here = free_spelling(scene, {itself, indexed, in_words});
    if (here.plain != usual) letters_.push_back({usual, here});
  };
  letter("g", "N", "gap");
  letter("e", "N", "restitution");
  letter("f", "T", "friction");
  letter("f_s", "T", "friction_at_rest");
  letter("h", "M", "length");
  letter("h_s", "M", "length_at_rest");
  letter("b", "T", "bound");
  letter("b_s", "T", "bound_at_rest");
}

std::string ContactLetters::replaced(const std::string& text, bool latex) const {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\\' && latex) {  // a command
      result += text[i++];
      while (i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0) result += text[i++];
      continue;
    }
    if (!is_of_name(text[i])) {
      result += text[i++];
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::string word = text.substr(i, end - i);
    const auto place = std::find_if(letters_.begin(), letters_.end(), [&](const Letter& each) { return each.usual == word; });
    result += place == letters_.end() ? word : latex ? place->here.latex : place->here.plain;
    i = end;
  }
  return result;
}

std::string ContactLetters::in_sentence(const std::string& text) const {
  std::string result;
  bool inside = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('$', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    result += inside ? latex(part) : part;
    if (end < text.size()) result += '$';
    inside = !inside;
    begin = end + 1;
  }
  return result;
}

}  // namespace torsor::printing
