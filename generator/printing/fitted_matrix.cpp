// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/fitted_matrix.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {
namespace {

std::size_t width_of(const WrittenMatrix& rows) {
  std::size_t total = 0;
  for (std::size_t j = 0; j < rows[0].size(); ++j) {
    std::size_t widest = 0;
    for (const auto& row : rows) widest = std::max(widest, text(row[j]).size());
    total += widest + 3;
  }
  return total;
}

std::string entry_name(const std::string& entry, const WrittenMatrix& rows, std::size_t i, std::size_t j) {
  return rows[i].size() == 1 ? fmt::format("{}[{}]", entry, i + 1) : fmt::format("{}[{},{}]", entry, i + 1, j + 1);
}

/// Names for what is longer than `longest`.
FittedMatrix with_names(const std::string& entry, const WrittenMatrix& rows, std::size_t longest) {
  FittedMatrix result{rows, {}};
  std::map<std::string, std::string> known;  // by the text of an entry; looked up only
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const std::string content = text(rows[i][j]);
      if (content.size() <= longest) continue;
      const auto [place, fresh] = known.emplace(content, entry_name(entry, rows, i, j));
      if (fresh) result.named.emplace_back(place->second, rows[i][j]);
      result.rows[i][j] = named(place->second);
    }
  }
  return result;
}

}  // namespace

FittedMatrix fitted(const std::string& entry, const WrittenMatrix& rows, std::size_t width, const NaturalLanguage& say) {
  if (width_of(rows) <= width) return {rows, {}};
  FittedMatrix list{{}, {}, say("entries that are not zero")};
  if (rows[0].size() == 1) {  // a column of names says nothing
    list.instead = say("by components");
    for (std::size_t i = 0; i < rows.size(); ++i) list.named.emplace_back(entry_name(entry, rows, i, 0), rows[i][0]);
    return list;
  }
  for (const std::size_t longest : {80U, 60U, 40U, 30U, 20U, 12U}) {
    FittedMatrix result = with_names(entry, rows, longest);
    if (width_of(result.rows) <= width) return result;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (!rows[i][j].empty()) list.named.emplace_back(entry_name(entry, rows, i, j), rows[i][j]);
    }
  }
  return list;
}

}  // namespace torsor::printing
