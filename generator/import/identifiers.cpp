// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/identifiers.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/identifier.hpp"

namespace torsor {
namespace {

bool acceptable(const std::string& name, const std::string& kind) {
  try {
    require_identifier(name, "name");
  } catch (const SceneError&) {
    return false;
  }
  return reserved_in_headers(name, kind == "robot") == nullptr;
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::string as_identifier(const std::string& name, const std::string& kind) {
  std::string word;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      word += c;
    } else if (!word.empty() && word.back() != '_') {
      word += '_';
    }
  }
  while (!word.empty() && word.back() == '_') word.pop_back();
  if (word.empty()) return kind;
  return acceptable(word, kind) ? word : kind + "_" + word;
}

std::string Identifiers::take(const std::string& name, const std::string& kind,
                              const std::vector<std::string>& suffixes) {
  const std::string word = as_identifier(name, kind);
  std::string candidate = word;
  const auto is_taken = [&](const std::string& suffix) { return taken_.contains(candidate + suffix); };
  const auto is_reserved = [&](const std::string& suffix) {
    return !suffix.empty() && reserved_in_headers(candidate + suffix, false) != nullptr;
  };
  const auto is_free = [&](const std::string& suffix) { return !is_taken(suffix) && !is_reserved(suffix); };
  for (int number = 2; !std::all_of(suffixes.begin(), suffixes.end(), is_free); ++number) {
    candidate = word + "_" + std::to_string(number);
    if (!acceptable(candidate, kind)) candidate = kind + "_" + candidate;
  }
  for (const std::string& suffix : suffixes) taken_.insert(candidate + suffix);
  return candidate;
}

std::string FileIdentifiers::frame(const std::string& name, const std::string& kind,
                                   const std::vector<std::string>& suffixes) {
  std::string identifier = frames_.take(name, kind, suffixes);
  note(kind, name, identifier);
  return identifier;
}

std::string FileIdentifiers::symbol(const std::string& name, const std::string& kind,
                                    const std::vector<std::string>& suffixes) {
  std::string identifier = symbols_.take(name, kind, suffixes);
  note(kind, name, identifier);
  return identifier;
}

void FileIdentifiers::note(const std::string& kind, const std::string& name, const std::string& identifier) {
  if (name == identifier) return;
  std::string note = fmt::format("{} '{}' is {}", kind, name, identifier);
  if (std::find(renamed_.begin(), renamed_.end(), note) == renamed_.end()) renamed_.push_back(std::move(note));
}

}  // namespace torsor
