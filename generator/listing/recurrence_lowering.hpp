// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/listing/listing_builder.hpp"

namespace torsor {

/// The recurrence of a function that gives Taylor coefficients: the values at the start, then what is done at each
/// order. At order k the convolutions over coefficients 1..k-1 of all operations come first, since none waits for
/// another; what remains is to add, one operation after another, the terms with the coefficients k and 0. With a solve,
/// what depends on the accelerations is added up twice: without those of order k, and with them.
class RecurrenceLowering {
 public:
  /// `block` is what has been computed.
  RecurrenceLowering(ListingBuilder& builder, Program& program, const SeriesResult& series, const Block& block);

  void run();

 private:
  using Kind = SeriesNode::Kind;
  using Optional = std::optional<Formula>;
  using OperandOf = std::function<Optional(int)>;  ///< nothing: left out

  int depth_of(const SeriesNode& each) const;
  bool is_deeper(int a, int b) const { return depth_[place(a)] > depth_[place(b)]; }
  static std::size_t place(int id) { return static_cast<std::size_t>(id); }
  const SeriesNode& node(int id) const { return nodes_[place(id)]; }
  bool marked(std::optional<int> id) const { return id && marked_[place(*id)]; }
  bool is_unknown(int id) const { return marked(id) && node(id).kind == Kind::symbol; }
  std::size_t unknown_of(int id) const;
  std::size_t unknown_count() const { return series_.solve ? series_.solve->unknowns.size() : 0; }

  Formula x(int id) const { return Formula::of_value_number(x_[place(id)]); }
  Formula sum_of(int id);
  Formula order(OrderQuantity which);
  Formula begin(int id);
  Formula inverse(int id);
  ValueNumber weighted(int id);
  Optional factor(const Polynomial& coefficient, bool& negative);

  Formula form(const SeriesForm& form, bool at_begin);
  Optional with_terms(Optional before, const SeriesForm& form, const OperandOf& operand);
  Optional with_marked(int id, const OperandOf& operand);
  ValueNumber step(const std::string& name, Formula right, const std::string& meaning = {});
  void write_order(int id);
  Formula symbol_of_order(const SeriesNode& each);
  Formula selected(const SeriesNode& each, int id);
  void write_solve();
  void write_partial(int id);
  void write_accelerations();
  std::pair<int, int> factors_of(const SeriesNode& product) const;
  std::pair<ValueNumber, ValueNumber> operands(int id) const;

  ListingBuilder& builder_;
  Program& program_;
  const SeriesResult& series_;
  const std::vector<SeriesNode>& nodes_;
  Recurrence recurrence_;
  std::vector<bool> known_;                                      ///< by value number: computed by the block
  std::vector<std::optional<ValueNumber>> begin_, inverse_, weighted_;  ///< by node
  std::vector<ValueNumber> x_;                                          ///< by node: its coefficient of order k
  std::vector<int> depth_;         ///< by node: how many operations of one order follow one another up to it
  std::vector<std::optional<int>> lanes_;  ///< by node: which convolution is its own
  std::vector<bool> marked_;       ///< by node: depends on the accelerations that are solved for
  std::vector<Optional> without_;  ///< by marked node: what does not come from marked operands
  std::vector<Optional> partial_;  ///< by marked node: its coefficient without the accelerations
  std::vector<ValueNumber> rates_;        ///< of the accelerations: coefficients of order k
  SumTable factors_;
  std::vector<ValueNumber> factor_places_;
};

}  // namespace torsor
