// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/reading_notes.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace torsor {
namespace {

constexpr std::size_t parts_named = 4;

}  // namespace

std::string note_of_parts(const std::string& kind, const std::vector<std::string>& parts, bool all) {
  // One more name is not longer than saying that there is one more.
  all = all || parts.size() <= parts_named + 1;
  const std::size_t named = all ? parts.size() : parts_named;
  std::string line = kind;
  for (std::size_t i = 0; i < named; ++i) line += (i == 0 ? ": " : ", ") + parts[i];
  if (!all) line += fmt::format(" and {} more", parts.size() - named);
  return line;
}

void ReadingNotes::add(const std::string& kind, const std::string& part, const XmlPlace& place, Parts named) {
  auto found = std::find_if(kinds_.begin(), kinds_.end(), [&kind](const Kind& each) { return each.text == kind; });
  if (found == kinds_.end()) found = kinds_.insert(kinds_.end(), {kind, place, named});
  if (part.empty() || (!found->parts.empty() && found->parts.back() == part)) return;
  found->parts.push_back(part);
}

std::vector<std::string> ReadingNotes::lines() const {
  std::vector<std::string> lines;
  for (const Kind& kind : kinds_) lines.push_back(note_of_parts(kind.text, kind.parts, kind.named == Parts::each));
  return lines;
}

void ReadingNotes::refuse() const {
  if (!kinds_.empty()) kinds_.front().place.fail(kinds_.front().text + "; correct the file, or leave out --strict");
}

}  // namespace torsor
