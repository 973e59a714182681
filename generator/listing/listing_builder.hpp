// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "torsor/generator/listing/earliest_start.hpp"
#include "torsor/generator/listing/lowering.hpp"
#include "torsor/generator/program/pivot_test.hpp"
#include "torsor/generator/program/program.hpp"
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {

/// Builds a listing from a program, statement by statement; see lowering.hpp.
class ListingBuilder {
 public:
  ListingBuilder(Program& program, const Surroundings& around)
      : program_(&program), starts_(program), around_(around) {}

  void compute(const Block& block);
  void write(const Assignment& assignment);
  void write(const Target& target, Formula value, const std::string& meaning = {}) {
    listing_.outputs.push_back({target, {std::move(value)}, false, meaning});
  }
  void write_member(const Target& target, ValueNumber value_number, const std::string& meaning);
  void measure(const PivotTest& test);
  Listing take(bool has_status);

  // Of recurrences
  Formula formula_of(const Polynomial& sum);   ///< in what has been computed
  ValueNumber place_of(ValueNumber value_number) const;              ///< what has been computed
  ValueNumber place_of(const SymbolPointer& symbol);  ///< an argument
  ValueNumber read(Table table, std::size_t index);   ///< where it stands
  ValueNumber add_local(const std::string& name) { return add({Table::local, locals_++, name}); }
  /// A new local quantity.
  ValueNumber assign(const std::string& name, Formula right) {
    const ValueNumber quantity = add_local(name);
    listing_.statements.emplace_back(Assigned{quantity, std::move(right), {}});
    return quantity;
  }
  Listing& listing() { return listing_; }

 private:
  ValueNumber add(Quantity quantity);
  ValueNumber add_local(ValueNumber value_number);
  std::pair<Table, std::size_t> argument(const SymbolPointer& symbol) const;
  void read_symbol(ValueNumber value_number);
  void read_member(ValueNumber value_number);
  Formula placed(Formula formula) const;  ///< its leaves as quantities
  void define(ValueNumber value_number);
  void define_sines_and_cosines(const Block& block);
  void define_group(const std::vector<ValueNumber>& group);
  std::pair<Signed, bool> value_of(const Value& value, std::size_t output);
  ValueNumber written(std::size_t place);
  Signed operand(const Value& value);
  Signed bound_beside(const Value& measure);

  Program* program_;
  EarliestStarts starts_;
  Surroundings around_;
  Listing listing_;
  std::unordered_map<ValueNumber, ValueNumber>
      places_;  ///< of the program's value numbers among the quantities; looked up only, as the next two
  std::unordered_set<ValueNumber> done_, live_;
  std::map<std::pair<Table, std::size_t>, ValueNumber> standing_;  ///< quantities that are read where they stand
  std::size_t locals_ = 0, numbered_ = 0;
  SumTable written_;                                 ///< results that cost something, with
  std::vector<std::optional<std::size_t>> outputs_;  ///< the output of each, or
  std::unordered_map<std::size_t, ValueNumber> locals_of_pivots_;
  std::optional<ValueNumber> many_roundings_;
  SumTable measures_;                ///< of several rows, with
  std::vector<ValueNumber> bounds_;  ///< many roundings of each
  std::vector<bool> negative_;  ///< and whether it holds it with the other sign
};

}  // namespace torsor
