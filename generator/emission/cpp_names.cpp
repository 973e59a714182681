// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/cpp_names.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/article.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/identifier.hpp"

namespace torsor {

std::string symbol_access(const Symbol& symbol, const std::string& parameters) {
  const std::string name = member_name(symbol);
  switch (symbol.kind) {
    case SymbolKind::pi:
      return "traits::pi()";
    case SymbolKind::time:
      return "state.time";
    case SymbolKind::parameter:
      return parameters + name;
    case SymbolKind::coordinate:
      return "state.q." + name;
    case SymbolKind::velocity:
      return "state.v." + name;
    case SymbolKind::acceleration:
      return "accelerations." + name;
    case SymbolKind::input:
      return "inputs." + name;
    case SymbolKind::multiplier:
      return "multipliers." + name;
  }
  return name;
}

void require_cpp_name(const std::string& name, const std::string& what) {
  const char* reason = nullptr;
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (!is_word || (name[0] >= '0' && name[0] <= '9') || name[0] == '_' || name.back() == '_' ||
      name.find("__") != std::string::npos) {
    reason = "is not made of letters, digits and single inner underscores, a letter first,";
  }
  if (reason == nullptr) reason = reserved_in_headers(name, what == "scene");
  if (reason == nullptr) return;
  throw SceneError(fmt::format("the name '{}' of {} {} and cannot stand in a generated header: choose another name",
                               name, with_article(what), reason));
}

}  // namespace torsor
