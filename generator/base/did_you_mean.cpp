// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/did_you_mean.hpp"

#include <algorithm>
#include <array>

namespace torsor {
namespace {

constexpr std::size_t longest_word = 100;  // the time grows with the product of both lengths
constexpr std::size_t most_suggestions = 3;

/// Of ASCII only: what a locale says must change no byte.
char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_letter(char a, char b) { return small_letter(a) == small_letter(b); }

std::size_t edits_allowed(std::string_view a, std::string_view b) {
  return std::min<std::size_t>(std::max(a.size(), b.size()) / 3, 3);
}

void add_once(std::vector<std::string>& words, const std::string& word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

bool begins_with(std::string_view word, std::string_view start) {
  return word.size() >= start.size() && std::equal(start.begin(), start.end(), word.begin(), same_letter);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between beginnings: two letters of a earlier, one earlier, and now.
  std::array<std::vector<std::size_t>, 3> rows;
  for (std::vector<std::size_t>& row : rows) row.resize(b.size() + 1);
  auto& [before, last, row] = rows;
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

namespace {

bool differ_by(std::string_view a, std::string_view b, std::size_t edits) {
  if (std::max(a.size(), b.size()) > longest_word) return false;
  const std::size_t apart = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  return apart <= edits && edit_distance(a, b) <= edits;
}

}  // namespace

bool looks_like(std::string_view word, std::string_view known) {
  return differ_by(word, known, edits_allowed(word, known));
}

namespace {

/// Those at the least distance that are within the edits that words may differ by, and `more`.
std::vector<std::string> nearest_within(std::string_view word, const std::vector<std::string>& known, std::size_t more) {
  std::vector<std::string> nearest;
  std::size_t least = longest_word;
  for (const std::string& each : known) {
    if (!differ_by(word, each, edits_allowed(word, each) + more)) continue;
    const std::size_t distance = edit_distance(word, each);
    if (distance > least) continue;
    if (distance < least) nearest.clear();
    least = distance;
    add_once(nearest, each);
  }
  return nearest;
}

}  // namespace

std::vector<std::string> nearest_words(std::string_view word, const std::vector<std::string>& known) {
  return nearest_within(word, known, 0);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  std::vector<std::string> suggestions = nearest_words(word, known);
  if (suggestions.empty() && word.size() >= 5) suggestions = nearest_within(word, known, 1);
  if (suggestions.size() > most_suggestions) suggestions.resize(most_suggestions);
  if (suggestions.empty() && word.size() >= 3 && word.size() <= longest_word) {
    for (const std::string& each : known) {
      if (begins_with(each, word)) add_once(suggestions, each);
    }
    if (suggestions.size() > most_suggestions) suggestions.clear();
  }
  std::string text;
  for (const std::string& each : suggestions) text += (text.empty() ? "did you mean '" : " or '") + each + "'";
  return text.empty() ? text : text + "? ";
}

}  // namespace torsor
