// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/size_table.hpp"

#include <fmt/format.h>

namespace torsor {
namespace {

/// As runtime/abi/size_check.hpp and templates/fmi/sizes.h.in name it.
const char* name_of(SizeBound::Relation relation) {
  switch (relation) {
    case SizeBound::Relation::at_least: return "at_least";
    case SizeBound::Relation::at_most: return "at_most";
    case SizeBound::Relation::below: break;
  }
  return "below";
}

}  // namespace

std::string sentence_literal(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    literal += c == SizeBound::number ? "\\001" : std::string(1, c == '%' ? '_' : c);
  }
  return literal + "\"";
}

std::size_t count_of_numbers(const std::vector<SizeBound>& bounds) {
  std::size_t count = 0;
  for (const SizeBound& each : bounds) count += each.formulas().size();
  return count;
}

std::string size_table(const std::vector<SizeBound>& bounds, const std::string& scope) {
  std::string entries;
  std::size_t first = 0;
  for (const SizeBound& each : bounds) {
    entries += fmt::format("{}\n    {{{}{}, {}, {}, {}}}", entries.empty() ? "" : ",", scope, name_of(each.relation), first,
                           first + each.first_shown(), sentence_literal(each.said));
    first += each.formulas().size();
  }
  return entries;
}

}  // namespace torsor
