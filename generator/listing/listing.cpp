// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/listing.hpp"

#include "torsor/generator/base/error.hpp"

namespace torsor {

const std::vector<SymbolPointer>& Layout::of(Table table) const {
  switch (table) {
    case Table::coordinate:
      return coordinates;
    case Table::velocity:
      return velocities;
    case Table::acceleration:
      return accelerations;
    case Table::multiplier:
      return multipliers;
    case Table::input:
      return inputs;
    case Table::parameter:
      return parameters;
    default:
      break;
  }
  throw Error("a listing asks for symbols where there are none");
}

namespace {

void mark(const Formula& formula, std::vector<bool>& read) {
  if (formula.kind == Formula::Kind::value_number) read[static_cast<std::size_t>(*formula.value_number)] = true;
  for (const Formula& child : formula.children) mark(child, read);
}

}  // namespace

bool is_needed(const Statement& statement, const std::vector<bool>& read) {
  const auto is_read = [&read](ValueNumber quantity) { return read[static_cast<std::size_t>(quantity)]; };
  if (const auto* literal = std::get_if<Literal>(&statement)) return is_read(literal->quantity);
  if (const auto* assigned = std::get_if<Assigned>(&statement)) return is_read(assigned->quantity);
  if (const auto* pi = std::get_if<Pi>(&statement)) return is_read(pi->quantity);
  return true;
}

std::vector<bool> read_quantities(const Listing& listing, bool literals_are_computed) {
  std::vector<bool> read(listing.quantities.size(), false);
  for (const Output& output : listing.outputs) mark(output.value.formula, read);
  for (const Pivot& each : listing.pivots) mark(each.pivot.formula, read), mark(each.diagonal.formula, read);
  for (const Statement& each : listing.of_pivots) mark(std::get<Assigned>(each).right, read);
  if (listing.recurrence) {
    for (const Statement& each : listing.recurrence->steps) mark(std::get<Assigned>(each).right, read);
    for (const Formula& rate : listing.recurrence->rates) mark(rate, read);
  }
  for (auto each = listing.statements.rbegin(); each != listing.statements.rend(); ++each) {
    if (!is_needed(*each, read)) continue;
    if (const auto* assigned = std::get_if<Assigned>(&*each)) mark(assigned->right, read);
    if (const auto* literal = std::get_if<Literal>(&*each); literal != nullptr && literals_are_computed)
      mark(literal->right, read);
    if (const auto* group = std::get_if<SinesAndCosines>(&*each)) {
      for (const SineCosinePair& pair : group->angles) read[static_cast<std::size_t>(pair.angle)] = true;
    }
  }
  return read;
}

bool Listing::reads(Table table) const {
  const std::vector<bool> read = read_quantities(*this, true);
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    if (read[k] && quantities[k].table == table) return true;
  }
  return false;
}

OperationCount count(const Listing& listing) {
  OperationCount total;
  const std::vector<bool> read = read_quantities(listing, true);
  for (const auto* statements : {&listing.statements, &listing.of_pivots}) {
    for (const Statement& each : *statements) {
      if (statements == &listing.statements && !is_needed(each, read)) continue;
      if (const auto* assigned = std::get_if<Assigned>(&each)) total += count(assigned->right);
      if (const auto* group = std::get_if<SinesAndCosines>(&each)) {
        total.sincos_pairs += static_cast<int>(group->angles.size());
      }
    }
  }
  for (const Output& output : listing.outputs) total += count(output.value.formula);
  if (listing.recurrence) total += count(*listing.recurrence);
  return total;
}

OperationCount count(const Recurrence& recurrence) {
  OperationCount total;
  for (const Statement& each : recurrence.steps) total += count(std::get<Assigned>(each).right);
  for (const Formula& rate : recurrence.rates) total += count(rate);
  return total;
}

}  // namespace torsor
