// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/state_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::printing {

void refuse_values_of_each_other(const StateValues& state) {
  for (const auto& [symbol, value] : state) {
    for (const SymbolPointer& other : value.symbols()) {
      const bool given = std::any_of(state.begin(), state.end(), [&other](const auto& each) { return each.first == other; });
      if (given) {
        throw UsageError(fmt::format("--about {} = {}: the value depends on '{}', which --about gives too; put its value in",
                                     symbol->name, value.to_string(), other->name));
      }
      if (other->kind != SymbolKind::velocity && other->kind != SymbolKind::acceleration) continue;
      throw UsageError(fmt::format("--about {} = {}: the value depends on '{}'; give a formula of parameters, the time and "
                                   "other coordinates",
                                   symbol->name, value.to_string(), other->name));
    }
  }
}

}  // namespace torsor::printing
