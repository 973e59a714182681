// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "torsor/generator/listing/listing.hpp"
#include "torsor/generator/program/function_values.hpp"

namespace torsor {

/// What a scalar makes of the numbers that a text states.
template <class Scalar>
struct NumbersOf {
  std::function<Scalar(const Number&)> constant;
  std::function<Scalar(const RoundedConstant&)> literal;
  Scalar pi;
};

/// Computes what a listing states, operation by operation and in the order of its text: with a scalar of the text's
/// precision the results are the text's, bit for bit where no product is fused with a sum.
template <class Scalar>
class ListingEvaluator {
 public:
  /// What an argument or a member of Precomputed is, by its place.
  using Argument = std::function<Scalar(Table, std::size_t)>;

  ListingEvaluator(const Listing& listing, NumbersOf<Scalar> numbers)
      : listing_(&listing), numbers_(std::move(numbers)), locals_(listing.quantities.size(), Scalar(0)) {}

  /// Taylor coefficients up to that order; of a listing without a recurrence it does not matter.
  void operator()(Argument argument, int order = 1) {
    argument_ = std::move(argument);
    outputs_.clear();
    pivots_.clear();
    for (const ValueNumber quantity : listing_->given) assign(quantity, at_place(listing_->quantity(quantity)));
    for (const Statement& each : listing_->statements) define(each);
    for (const Output& each : listing_->outputs) outputs_.push_back(of(each.value));
    if (listing_->recurrence) compute(*listing_->recurrence, order);
    for (const Statement& each : listing_->of_pivots) define(each);
    for (const Pivot& each : listing_->pivots) {
      Scalar pivot = of(each.pivot);
      pivots_.emplace_back(std::move(pivot), of(each.diagonal));
    }
  }

  /// Of a recurrence the coefficients of the orders 0 and 1.
  const std::vector<Scalar>& outputs() const { return outputs_; }
  /// By order, from 0.
  const std::vector<std::vector<Scalar>>& coefficients() const { return coefficients_; }
  /// Each with what it is measured against.
  const std::vector<std::pair<Scalar, Scalar>>& pivots() const { return pivots_; }

 private:
  void assign(ValueNumber quantity, Scalar value) { locals_[static_cast<std::size_t>(quantity)] = std::move(value); }

  Scalar at_place(const Quantity& quantity) const {
    switch (quantity.table) {
      case Table::output: return outputs_[quantity.index];
      case Table::coefficient: return coefficients_[order_][quantity.index];
      case Table::convolution: return sums_[quantity.index];
      case Table::order: return of_order_[quantity.index];
      default: return argument_(quantity.table, quantity.index);
    }
  }
  Scalar of(ValueNumber number) const {
    const Quantity& quantity = listing_->quantity(number);
    return quantity.name.empty() ? at_place(quantity) : locals_[static_cast<std::size_t>(number)];
  }
  Scalar of(const Signed& value) {
    const Scalar result = of(value.formula);
    return value.negative ? -result : result;
  }

  const Scalar& constant(const Number& number) {
    if (const auto known = constants_.find(number); known != constants_.end()) return known->second;
    return constants_.emplace(number, numbers_.constant(number)).first->second;
  }

  Scalar of(const Formula& formula) {
    switch (formula.kind) {
      case Formula::Kind::constant: return constant(formula.number);
      case Formula::Kind::value_number: return of(*formula.value_number);
      case Formula::Kind::function: {
        std::vector<Scalar> arguments;
        for (const Formula& child : formula.children) arguments.push_back(of(child));
        return value_of_call(formula.function, arguments);
      }
      case Formula::Kind::quotient: {
        const Scalar numerator = of(formula.children[0]);
        return numerator / of(formula.children[1]);
      }
      case Formula::Kind::sum:
      case Formula::Kind::product: break;
    }
    const bool sum = formula.kind == Formula::Kind::sum;
    Scalar result = of(formula.children[0]);
    if (sum && formula.negative[0]) result = -result;
    for (std::size_t i = 1; i < formula.children.size(); ++i) {
      const Scalar next = of(formula.children[i]);
      if (!sum)
        result = result * next;
      else
        result = formula.negative[i] ? result - next : result + next;
    }
    return result;
  }

  void define(const Statement& statement) {
    std::visit([this](const auto& each) { this->define(each); }, statement);
  }
  void define(const Assigned& each) { assign(each.quantity, of(each.right)); }
  void define(const Literal& each) { assign(each.quantity, numbers_.literal(each.rounded)); }
  void define(const Pi& each) { assign(each.quantity, numbers_.pi); }
  void define(const SinesAndCosines& group) {
    for (const SineCosinePair& each : group.angles) {
      const Scalar angle = of(each.angle);
      if (each.sine) assign(*each.sine, value_of_call(Function::sin, std::vector<Scalar>{angle}));
      if (each.cosine) assign(*each.cosine, value_of_call(Function::cos, std::vector<Scalar>{angle}));
    }
  }

  void compute(const Recurrence& recurrence, int order) {
    const auto half = static_cast<std::ptrdiff_t>(outputs_.size() / 2);
    coefficients_.assign({{outputs_.begin(), outputs_.begin() + half}, {outputs_.begin() + half, outputs_.end()}});
    const std::size_t lanes = recurrence.convolutions.size();
    left_.assign(lanes, {Scalar(0)});  // by pair and order; those of order 0 stand in the steps
    right_.assign(lanes, {Scalar(0)});
    Scalar number(1), inverse(1);
    for (int k = 1; k < order; ++k) {
      order_ = static_cast<std::size_t>(k);
      const Scalar following = number + Scalar(1);
      const Scalar next = Scalar(1) / following;
      of_order_ = {number, inverse, next, Scalar(k == 1 ? 1 : 0)};
      sums_.clear();
      for (std::size_t lane = 0; lane < lanes; ++lane) sums_.push_back(convolution(lane));
      for (const Statement& each : recurrence.steps) define(each);
      coefficients_.emplace_back();
      for (std::size_t i = 0; i < recurrence.rates.size(); ++i) {
        const Scalar rate = of(recurrence.rates[i]);
        coefficients_.back().push_back(recurrence.constant[i] ? rate : next * rate);
      }
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        left_[lane].push_back(of(recurrence.convolutions[lane].first));
        right_[lane].push_back(of(recurrence.convolutions[lane].second));
      }
      number = following, inverse = next;
    }
  }

  /// In the order of templates/jets.hpp: what has only just been computed comes last.
  Scalar convolution(std::size_t lane) const {
    Scalar sum(0);
    const auto add = [&](std::size_t i) { sum = sum + left_[lane][i] * right_[lane][order_ - i]; };
    for (std::size_t i = 2; i + 1 < order_; ++i) add(i);
    if (order_ > 1) add(1);
    if (order_ > 2) add(order_ - 1);
    return sum;
  }

  const Listing* listing_;
  NumbersOf<Scalar> numbers_;
  Argument argument_;
  std::vector<Scalar> locals_;  ///< by quantity
  std::vector<Scalar> outputs_;
  std::vector<std::vector<Scalar>> coefficients_;
  std::vector<std::pair<Scalar, Scalar>> pivots_;
  std::unordered_map<Number, Scalar> constants_;  ///< looked up only
  std::size_t order_ = 0;
  std::vector<Scalar> of_order_, sums_;
  std::vector<std::vector<Scalar>> left_, right_;
};

}  // namespace torsor
