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

namespace {

void mark(const Formula& formula, std::vector<bool>& read) {
  if (formula.kind == Formula::Kind::atom) read[static_cast<std::size_t>(formula.atom)] = true;
  for (const Formula& child : formula.children) mark(child, read);
}

}  // namespace

std::vector<bool> read_statements(const Listing& listing, bool literals_are_computed) {
  std::vector<bool> read(listing.quantities.size(), false);
  const auto is_read = [&read](Atom quantity) { return read[static_cast<std::size_t>(quantity)]; };
  for (const Output& output : listing.outputs) mark(output.value.formula, read);
  for (const auto& [pivot, diagonal] : listing.pivots) mark(pivot.formula, read), mark(diagonal.formula, read);
  for (const Statement& each : listing.of_pivots) mark(std::get<Assigned>(each).right, read);
  if (listing.recurrence) {
    for (const Statement& each : listing.recurrence->steps) mark(std::get<Assigned>(each).right, read);
    for (const Formula& rate : listing.recurrence->rates) mark(rate, read);
  }
  std::vector<bool> kept(listing.statements.size(), true);
  for (std::size_t i = listing.statements.size(); i-- > 0;) {
    const Statement& each = listing.statements[i];
    if (const auto* group = std::get_if<SinesAndCosines>(&each)) {
      for (const SineCosine& pair : group->angles) read[static_cast<std::size_t>(pair.angle)] = true;
    } else if (const auto* literal = std::get_if<Literal>(&each)) {
      kept[i] = is_read(literal->quantity);
      if (kept[i] && literals_are_computed) mark(literal->right, read);
    } else if (const auto* assigned = std::get_if<Assigned>(&each)) {
      kept[i] = is_read(assigned->quantity);
      if (kept[i]) mark(assigned->right, read);
    } else {
      kept[i] = is_read(std::get<Pi>(each).quantity);
    }
  }
  return kept;
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
