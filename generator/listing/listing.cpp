// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/listing/listing.hpp"

#include <algorithm>

#include "generator/expression/error.hpp"

namespace torsor {

const std::vector<SymbolPointer>& Layout::of(Table table) const {
  switch (table) {
    case Table::coordinate: return coordinates;
    case Table::velocity: return velocities;
    case Table::acceleration: return accelerations;
    case Table::multiplier: return multipliers;
    case Table::input: return inputs;
    case Table::parameter: return parameters;
    default: break;
  }
  throw Error("a listing asks for symbols where there are none");
}

bool Listing::reads(Table table) const {
  return std::any_of(quantities.begin(), quantities.end(), [table](const Quantity& each) { return each.table == table; });
}

OperationCount count(const Listing& listing) {
  OperationCount total;
  for (const auto* statements : {&listing.statements, &listing.of_pivots}) {
    for (const Statement& each : *statements) {
      if (const auto* assigned = std::get_if<Assigned>(&each)) total += count(assigned->right);
      if (const auto* group = std::get_if<SinesAndCosines>(&each)) {
        total.sincos_pairs += static_cast<int>(group->angles.size());
      }
    }
  }
  for (const Output& output : listing.outputs) total += count(output.value.formula);
  if (listing.recurrence) {
    for (const Statement& each : listing.recurrence->steps) total += count(std::get<Assigned>(each).right);
    for (const Formula& rate : listing.recurrence->rates) total += count(rate);
  }
  return total;
}

}  // namespace torsor
