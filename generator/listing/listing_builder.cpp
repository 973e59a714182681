// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/listing_builder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/listing/issue_order.hpp"
#include "torsor/generator/listing/local_names.hpp"

namespace torsor {
namespace {

bool is_trigonometric(const Definition& definition) {
  return definition.function == Function::sin || definition.function == Function::cos;
}

/// Calls for each earlier value number of the program that a definition reads.
template <class Call>
void for_each_operand(const Definition& definition, const Call& call) {
  for (const Term& term : definition.polynomial.terms()) {
    for (const Factor& factor : term.monomial) call(factor.value_number);
  }
  for (const ValueNumber argument : definition.arguments) call(argument);
}

Table table_of(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::time:
      return Table::time;
    case SymbolKind::coordinate:
      return Table::coordinate;
    case SymbolKind::velocity:
      return Table::velocity;
    case SymbolKind::acceleration:
      return Table::acceleration;
    case SymbolKind::multiplier:
      return Table::multiplier;
    case SymbolKind::input:
      return Table::input;
    case SymbolKind::parameter:
      return Table::parameter;
    case SymbolKind::pi:
      break;
  }
  return Table::local;
}

}  // namespace

void ListingBuilder::compute(const Block& block) {
  live_.insert(block.definitions.begin(), block.definitions.end());
  for (const ValueNumber value_number : block.symbols) read_symbol(value_number);
  for (const ValueNumber value_number : block.given) read_member(value_number);
  define_sines_and_cosines(block);
  std::vector<ValueNumber> left;
  for (const ValueNumber value_number : block.definitions) {
    if (!done_.contains(value_number)) left.push_back(value_number);
  }
  for (const ValueNumber value_number : issue_order(*program_, starts_, left)) define(value_number);
}

void ListingBuilder::write(const Assignment& assignment) {
  auto [value, repeats] = value_of(assignment.value, listing_.outputs.size());
  const bool checked = !repeats && !assignment.value.is_constant();
  Output output{assignment.target, std::move(value), checked};
  if (!assignment.value.is_zero()) output.unit = assignment.value.unit();
  listing_.outputs.push_back(std::move(output));
}

void ListingBuilder::write_member(const Target& target, ValueNumber value_number, const std::string& meaning) {
  write(target, Formula::of_value_number(place_of(value_number)), meaning);
}

void ListingBuilder::measure(const PivotTest& test) {
  const Value& d = test.pivot;
  if (d.is_constant() && d.polynomial().constant().sign() > 0) return;  // regular once and for all
  Signed left = operand(d);
  listing_.pivots.push_back({std::move(left), test.of_several_rows ? bound_beside(test.measure) : operand(test.measure)});
}

Listing ListingBuilder::take(bool has_status) {
  listing_.has_status = has_status;
  return std::move(listing_);
}

Formula ListingBuilder::formula_of(const Polynomial& sum) {
  const auto [positive, negative] = without_sign(sum);
  Formula right;
  if (const auto ready = around_.schedule != nullptr ? around_.schedule->results.find(positive) : std::nullopt) {
    right = Formula::of_value_number(read(Table::precomputed, around_.schedule->members.size() + *ready));
  } else {
    right = placed(starts_.scheduled(positive));
  }
  return negative ? negated(std::move(right)) : right;
}

ValueNumber ListingBuilder::add(Quantity quantity) {
  listing_.quantities.push_back(std::move(quantity));
  return static_cast<ValueNumber>(listing_.quantities.size()) - 1;
}

ValueNumber ListingBuilder::add_local(ValueNumber value_number) {
  const std::string meaningful = local_name(*program_, value_number);
  const ValueNumber number = add_local(meaningful.empty() ? fmt::format("z{}", numbered_++) : meaningful);
  places_.emplace(value_number, number);
  return number;
}

std::pair<Table, std::size_t> ListingBuilder::argument(const SymbolPointer& symbol) const {
  const Table table = table_of(symbol->kind);
  if (table == Table::time) return {table, 0};
  const std::vector<SymbolPointer>& known = around_.layout->of(table);
  const auto place = std::find(known.begin(), known.end(), symbol);
  if (place == known.end()) {
    throw Error(
        fmt::format("the kernel '{}' needs '{}', which is not among its arguments", around_.function, symbol->name));
  }
  return {table, static_cast<std::size_t>(place - known.begin())};
}

ValueNumber ListingBuilder::place_of(const SymbolPointer& symbol) {
  const auto [table, index] = argument(symbol);
  return read(table, index);
}

void ListingBuilder::read_symbol(ValueNumber value_number) {
  const auto [table, index] = argument((*program_)[value_number].symbol);
  listing_.given.push_back(add({table, index, local_name(*program_, value_number)}));
  places_.emplace(value_number, listing_.given.back());
}

void ListingBuilder::read_member(ValueNumber value_number) {
  const std::vector<ValueNumber>& members = around_.schedule->members;
  const auto place = std::lower_bound(members.begin(), members.end(), value_number);
  const auto index = static_cast<std::size_t>(place - members.begin());
  listing_.given.push_back(add({Table::precomputed, index, precomputed_name(*program_, *around_.schedule, index)}));
  places_.emplace(value_number, listing_.given.back());
}

ValueNumber ListingBuilder::place_of(ValueNumber value_number) const {
  const auto place = places_.find(value_number);
  if (place != places_.end()) return place->second;
  throw Error(fmt::format("the kernel '{}' reads '{}' before it is computed", around_.function,
                          label(*program_, value_number)));
}

Formula ListingBuilder::placed(Formula formula) const {
  if (formula.kind == Formula::Kind::value_number) formula.value_number = place_of(*formula.value_number);
  for (Formula& child : formula.children) child = placed(std::move(child));
  return formula;
}

void ListingBuilder::define(ValueNumber value_number) {
  if (!done_.insert(value_number).second) return;
  const Definition& definition = (*program_)[value_number];
  if (definition.symbol) {
    listing_.statements.emplace_back(Pi{add_local(value_number)});
    return;
  }
  Formula right = placed(starts_.scheduled(definition));
  const bool number = !definition.function && definition.polynomial.is_constant();
  const ValueNumber quantity = add_local(value_number);
  if (definition.stage != Stage::generation || number) {
    listing_.statements.emplace_back(Assigned{quantity, std::move(right), definition.name});
  } else {
    const RoundedConstant rounded = rounded_constant(*program_, value_number);
    listing_.statements.emplace_back(Literal{quantity, std::move(right), rounded, definition.name});
  }
}

void ListingBuilder::define_sines_and_cosines(const Block& block) {
  // How many sines or cosines stand one behind the other before and in each definition.
  std::unordered_map<ValueNumber, std::size_t> depth;  // looked up only
  std::vector<std::vector<ValueNumber>> groups;
  for (const ValueNumber value_number : block.definitions) {
    const Definition& definition = (*program_)[value_number];
    std::size_t own = 0;
    for_each_operand(definition, [&](ValueNumber operand) {
      const auto known = depth.find(operand);
      if (known != depth.end()) own = std::max(own, known->second);
    });
    const bool counts = is_trigonometric(definition) && definition.stage != Stage::generation;
    if (counts && ++own > groups.size()) groups.emplace_back();
    if (own > 0) depth.emplace(value_number, own);
    if (!counts) continue;
    std::vector<ValueNumber>& group = groups[own - 1];
    const bool with_partner = std::find(group.begin(), group.end(), *definition.partner) != group.end();
    if (!with_partner) group.push_back(value_number);
  }
  for (const std::vector<ValueNumber>& group : groups) {
    std::vector<bool> needed(program_->size(), false);
    for (const ValueNumber value_number : group)
      needed[static_cast<std::size_t>((*program_)[value_number].arguments[0])] = true;
    for (auto each = block.definitions.rbegin(); each != block.definitions.rend(); ++each) {
      if (!needed[static_cast<std::size_t>(*each)]) continue;
      for_each_operand((*program_)[*each],
                       [&](ValueNumber operand) { needed[static_cast<std::size_t>(operand)] = true; });
    }
    for (const ValueNumber value_number : block.definitions) {
      if (needed[static_cast<std::size_t>(value_number)]) define(value_number);
    }
    define_group(group);
  }
}

void ListingBuilder::define_group(const std::vector<ValueNumber>& group) {
  SinesAndCosines together;
  for (const ValueNumber value_number : group) {
    const Definition& definition = (*program_)[value_number];
    SineCosinePair pair{place_of(definition.arguments[0]), {}, {}, definition.name};
    const bool sine = definition.function == Function::sin;
    for (const bool of_sine : {true, false}) {
      const ValueNumber each = sine == of_sine ? value_number : *definition.partner;
      done_.insert(each);
      if (group.size() > 1 && !live_.contains(each)) continue;  // a group of one gives both
      (of_sine ? pair.sine : pair.cosine) = add_local(each);
    }
    together.angles.push_back(std::move(pair));
  }
  listing_.statements.emplace_back(std::move(together));
}

/// What gives a value, and whether it has been computed before: a sum that costs something is remembered as what goes
/// to the next output.
std::pair<Signed, bool> ListingBuilder::value_of(const Value& value, std::size_t output) {
  const auto [sum, negative] = without_sign(value.polynomial());
  Formula tree = starts_.scheduled(sum);
  if (count(tree).total() == 0) return {{placed(std::move(tree)), negative}, false};
  if (const auto ready = around_.schedule != nullptr ? around_.schedule->results.find(sum) : std::nullopt) {
    const std::size_t member = around_.schedule->members.size() + *ready;
    return {{Formula::of_value_number(read(Table::precomputed, member)), negative}, false};
  }
  const auto [place, added] = written_.add(sum);
  if (added) {
    outputs_.push_back(output);
    negative_.push_back(negative);
    return {{placed(std::move(tree)), negative}, false};
  }
  return {{Formula::of_value_number(written(place)), negative != negative_[place]}, true};
}

ValueNumber ListingBuilder::read(Table table, std::size_t index) {
  const auto known = standing_.find({table, index});
  if (known != standing_.end()) return known->second;
  const ValueNumber number = add({table, index, ""});
  standing_.emplace(std::pair(table, index), number);
  return number;
}

ValueNumber ListingBuilder::written(std::size_t place) {
  const std::optional<std::size_t>& output = outputs_[place];
  return output ? read(Table::output, *output) : locals_of_pivots_.at(place);
}

/// Of a pivot: what costs something under a name of its own.
Signed ListingBuilder::operand(const Value& value) {
  const std::size_t before = outputs_.size();
  Signed result = value_of(value, 0).first;
  if (outputs_.size() == before) return result;
  outputs_.back().reset();
  const ValueNumber local = add_local(fmt::format("y{}", before));
  locals_of_pivots_.emplace(before, local);
  negative_.back() = false;
  const bool negative = result.negative;
  listing_.of_pivots.emplace_back(Assigned{local, std::move(result.formula), {}});
  return {Formula::of_value_number(local), negative};
}

/// Many roundings of what a pivot must be positive beside, in units of those that the pivot's test takes of it.
Signed ListingBuilder::bound_beside(const Value& measure) {
  Signed of = operand(measure);
  const auto [place, added] = measures_.add(without_sign(measure.polynomial()).first);
  if (added) {
    if (!many_roundings_) {
      many_roundings_ = add_local("roundings_");
      const RoundedConstant many{many_roundings::in_double, many_roundings::in_float};
      listing_.statements.emplace_back(Literal{*many_roundings_, Formula::of_number(Number(many_roundings::in_double)), many});
    }
    bounds_.push_back(add_local(fmt::format("bound{}_", place)));
    Formula product;
    product.kind = Formula::Kind::product;
    product.children = {Formula::of_value_number(*many_roundings_), std::move(of.formula)};
    listing_.of_pivots.emplace_back(Assigned{bounds_.back(), std::move(product), {}});
  }
  return {Formula::of_value_number(bounds_[place]), of.negative};
}

}  // namespace torsor
