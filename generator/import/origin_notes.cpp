// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/origin_notes.hpp"

#include "torsor/generator/base/printable.hpp"

namespace torsor {

void append_notes(std::vector<std::string>& notes, const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  notes.push_back(title);
  for (const std::string& line : lines) notes.push_back("  " + printable(line));
}

}  // namespace torsor
