// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/recurrence_lowering.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/program/formula_parts.hpp"

namespace torsor {

using formula_parts::add;
using formula_parts::difference;
using formula_parts::number;
using formula_parts::product;
using formula_parts::quotient;
using formula_parts::sum;

RecurrenceLowering::RecurrenceLowering(ListingBuilder& builder, Program& program, const SeriesResult& series,
                                       const Block& block)
    : builder_(builder), program_(program), series_(series), nodes_(series.program.nodes()) {
  const std::size_t count = nodes_.size();
  begin_.resize(count);
  inverse_.resize(count);
  weighted_.resize(count);
  x_.resize(count, 0);
  without_.resize(count);
  partial_.resize(count);
  lanes_.resize(count);
  known_.resize(program.size(), false);
  const auto know = [this](const std::vector<ValueNumber>& value_numbers) {
    for (const ValueNumber value_number : value_numbers) known_[static_cast<std::size_t>(value_number)] = true;
  };
  if (series.solve) {
    // Not all of the block: what it holds for the sake of coefficients depends on which of them are read.
    know(program.live(series.solve->at_start(series.program)));
  } else {
    know(block.symbols), know(block.given), know(block.definitions);
  }
  marked_ = series_.solve ? series_.program.depending_on(series_.solve->unknowns) : std::vector<bool>(count, false);
  for (const SeriesNode& each : nodes_) depth_.push_back(depth_of(each));
  int lanes = 0;
  for (std::size_t id = 0; id < count; ++id) {
    if (is_nonlinear(nodes_[id])) lanes_[id] = lanes++;
  }
}

void RecurrenceLowering::run() {
  const auto count = static_cast<int>(nodes_.size());
  for (int id = 0; id < count; ++id) {
    if (is_unknown(id)) continue;
    if (!marked(id)) write_order(id);
  }
  if (series_.solve) write_solve();
  const std::vector<SeriesForm>& outputs = series_.program.outputs();
  const std::size_t given = outputs.size() - unknown_count();
  for (std::size_t i = 0; i < given; ++i) {
    recurrence_.rates.push_back(form(outputs[i], false));
    recurrence_.constant.push_back(outputs[i].terms.empty());
  }
  for (std::size_t i = 0; i < unknown_count(); ++i) {
    recurrence_.rates.push_back(Formula::of_value_number(rates_[i]));
    recurrence_.constant.push_back(false);
  }
  std::vector<Formula> first;
  for (std::size_t i = 0; i < given; ++i) first.push_back(form(outputs[i], true));
  for (std::size_t i = 0; i < unknown_count(); ++i) {
    first.push_back(builder_.formula_of(series_.solve->start[i].polynomial()));
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    builder_.write({"coefficients", "0", i}, Formula::of_value_number(builder_.place_of(series_.state[i])));
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) builder_.write({"coefficients", "1", i}, std::move(first[i]));
  for (std::size_t id = 0; id < nodes_.size(); ++id) {
    if (lanes_[id]) recurrence_.convolutions.push_back(operands(static_cast<int>(id)));
  }
  builder_.listing().recurrence = std::move(recurrence_);
}

int RecurrenceLowering::depth_of(const SeriesNode& each) const {
  int depth = 0;
  const auto wait_for = [&](std::optional<int> operand) {
    if (operand) depth = std::max(depth, depth_[place(*operand)] + 1);
  };
  for (const SeriesForm::Term& term : each.form.terms) wait_for(term.node);
  wait_for(each.left);
  if (!has_slope(each)) wait_for(each.right);
  return depth + (each.kind == Kind::quotient ? 1 : 0);
}

std::size_t RecurrenceLowering::unknown_of(int id) const {
  const std::vector<SymbolPointer>& all = series_.solve->unknowns;
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), program_[*node(id).value_number].symbol) -
                                  all.begin());
}

Formula RecurrenceLowering::sum_of(int id) {
  return Formula::of_value_number(builder_.read(Table::convolution, static_cast<std::size_t>(*lanes_[place(id)])));
}

Formula RecurrenceLowering::order(OrderQuantity which) {
  return Formula::of_value_number(builder_.read(Table::order, static_cast<std::size_t>(which)));
}

/// The factor without its sign; nothing for one.
RecurrenceLowering::Optional RecurrenceLowering::factor(const Polynomial& coefficient, bool& negative) {
  auto [positive, minus] = without_sign(coefficient);
  negative = minus;
  if (positive.is_constant()) {
    return positive.constant().is_one() ? std::nullopt : Optional(number(positive.constant()));
  }
  if (positive.is_single_value_number())
    return Formula::of_value_number(builder_.place_of(positive.terms()[0].monomial[0].value_number));
  const auto [index, added] = factors_.add(positive);
  if (added) {
    factor_places_.push_back(builder_.assign(fmt::format("f{}", index), builder_.formula_of(positive)));
  }
  return Formula::of_value_number(factor_places_[index]);
}

Formula RecurrenceLowering::form(const SeriesForm& form, bool at_begin) {
  Optional before;
  if (at_begin && !form.constant.is_zero()) {
    bool negative = false;
    const Optional size = factor(form.constant, negative);
    before = size ? *size : number(Number(1));
    if (negative) before = negated(std::move(*before));
  }
  const Optional all =
      with_terms(std::move(before), form, [&](int id) { return Optional(at_begin ? begin(id) : x(id)); });
  return all ? *all : number(Number());
}

/// What stands there and the terms of a sum that are asked for.
RecurrenceLowering::Optional RecurrenceLowering::with_terms(Optional before, const SeriesForm& form,
                                                            const OperandOf& operand) {
  std::vector<SeriesForm::Term> terms = form.terms;  // what is known last is added last
  std::stable_sort(terms.begin(), terms.end(),
                   [this](const auto& a, const auto& b) { return is_deeper(b.node, a.node); });
  Formula all = sum({});
  if (before) add(all, std::move(*before), false);
  for (const SeriesForm::Term& term : terms) {
    Optional value = operand(term.node);
    if (!value) continue;
    bool negative = false;
    const Optional size = factor(term.coefficient, negative);
    add(all, size ? product({*size, *value}) : *value, negative);
  }
  if (all.children.empty()) return std::nullopt;
  return formula_parts::collapsed(std::move(all));
}

/// A node's value at the start; what is not known yet is computed.
Formula RecurrenceLowering::begin(int id) {
  std::optional<ValueNumber>& known = begin_[place(id)];
  if (known) return Formula::of_value_number(*known);
  const SeriesNode& each = node(id);
  if (each.value_number && known_[static_cast<std::size_t>(*each.value_number)]) {
    known = builder_.place_of(*each.value_number);
    return Formula::of_value_number(*known);
  }
  Formula right = number(Number());
  switch (each.kind) {
    case Kind::symbol:
      right = is_unknown(id) ? builder_.formula_of(series_.solve->start[unknown_of(id)].polynomial())
                             : Formula::of_value_number(builder_.place_of(program_[*each.value_number].symbol));
      break;
    case Kind::sum:
      right = form(each.form, true);
      break;
    case Kind::product: {
      Formula left = begin(*each.left);  // in this order: compilers evaluate arguments in different ones
      right = product({std::move(left), begin(*each.right)});
      break;
    }
    case Kind::quotient:
      if (!each.left) {
        right = inverse(id);
      } else {
        Formula top = begin(*each.left);
        right = quotient(std::move(top), begin(*each.right));
      }
      break;
    default:
      break;
  }
  begin_[place(id)] = builder_.assign(fmt::format("b{}", id), std::move(right));
  return Formula::of_value_number(*begin_[place(id)]);
}

/// What a quotient, a square root or a logarithm is multiplied by at each order, computed when it is first asked for.
Formula RecurrenceLowering::inverse(int id) {
  if (inverse_[place(id)]) return Formula::of_value_number(*inverse_[place(id)]);
  const SeriesNode& each = node(id);
  const int divisor = each.kind == Kind::quotient ? *each.right : each.kind == Kind::logarithm ? *each.left : id;
  Formula value = begin(divisor);
  Formula right =
      quotient(each.kind == Kind::square_root ? number(Number::rational(1, 2)) : number(Number(1)), std::move(value));
  inverse_[place(id)] = builder_.assign(fmt::format("i{}", id), std::move(right));
  return Formula::of_value_number(*inverse_[place(id)]);
}

ValueNumber RecurrenceLowering::step(const std::string& name, Formula right, const std::string& meaning) {
  const ValueNumber made = builder_.add_local(name);
  recurrence_.steps.emplace_back(Assigned{made, std::move(right), meaning});
  return made;
}

/// k times the coefficient of order k.
ValueNumber RecurrenceLowering::weighted(int id) {
  std::optional<ValueNumber>& known = weighted_[place(id)];
  if (!known) known = step(fmt::format("w{}", id), product({order(OrderQuantity::number), x(id)}));
  return *known;
}

Formula RecurrenceLowering::symbol_of_order(const SeriesNode& each) {
  const auto found = std::find(series_.state.begin(), series_.state.end(), program_[*each.value_number].symbol);
  if (found == series_.state.end()) return order(OrderQuantity::first);  // time
  return Formula::of_value_number(
      builder_.read(Table::coefficient, static_cast<std::size_t>(found - series_.state.begin())));
}

/// The coefficient of the form that a selection takes at the start.
Formula RecurrenceLowering::selected(const SeriesNode& each, int id) {
  const Definition& call = program_[*each.value_number];
  const auto argument = [&](std::size_t i) { return Formula::of_value_number(builder_.place_of(call.arguments[i])); };
  const auto of = [&](std::optional<int> operand) { return operand ? x(*operand) : number(Number()); };
  Formula condition = argument(0);
  if (call.function == Function::maximum) {
    Formula apart = difference(std::move(condition), argument(1));
    condition = Formula::of_value_number(builder_.assign(fmt::format("c{}", id), std::move(apart)));
  }
  Formula choice;
  choice.kind = Formula::Kind::function;
  choice.function = Function::select;
  Formula second = call.function == Function::abs ? negated(x(*each.left)) : of(each.right);
  choice.children = {std::move(condition), of(each.left), std::move(second)};
  return choice;
}

/// The coefficient of order k of a node.
void RecurrenceLowering::write_order(int id) {
  const SeriesNode& each = node(id);
  Formula right;
  switch (each.kind) {
    case Kind::symbol:
      right = symbol_of_order(each);
      break;
    case Kind::sum:
      right = form(each.form, false);
      break;
    case Kind::weighted:
      right = product({order(OrderQuantity::number), x(*each.left)});
      break;
    case Kind::integrated:
      right = product({order(OrderQuantity::inverse), x(*each.left)});
      break;
    case Kind::selection:
      right = selected(each, id);
      break;
    case Kind::product:
      if (each.left == each.right) {
        const Formula b = begin(*each.left);
        right = sum({sum_of(id), product({sum({b, b}), x(*each.left)})});
      } else {
        const bool left_first = is_deeper(*each.right, *each.left);
        const auto [soon, late] = left_first ? std::pair(*each.left, *each.right) : std::pair(*each.right, *each.left);
        const Formula a = begin(late);
        const Formula b = begin(soon);
        right = sum({sum_of(id), product({a, x(soon)}), product({b, x(late)})});
      }
      break;
    case Kind::quotient: {
      const Formula q = begin(id);
      const Formula factor = inverse(id);
      const Formula of_divisor = product({q, x(*each.right)});
      if (!each.left) {
        right = negated(product({sum({sum_of(id), of_divisor}), factor}));
      } else if (is_deeper(*each.left, *each.right)) {
        right = product({difference(x(*each.left), sum({sum_of(id), of_divisor})), factor});
      } else {
        Formula top = difference(x(*each.left), sum_of(id));
        add(top, of_divisor, true);
        right = product({std::move(top), factor});
      }
      break;
    }
    case Kind::square_root:
      right = product({difference(x(*each.left), sum_of(id)), inverse(id)});
      break;
    case Kind::sine:
    case Kind::primitive: {
      const Formula slope = begin(*each.right);
      right = sum({product({order(OrderQuantity::inverse), sum_of(id)}), product({slope, x(*each.left)})});
      break;
    }
    case Kind::cosine: {
      const Formula slope = begin(*each.right);
      right =
          difference(negated(product({order(OrderQuantity::inverse), sum_of(id)})), product({slope, x(*each.left)}));
      break;
    }
    case Kind::logarithm: {
      const Formula factor = inverse(id);
      right = product({difference(x(*each.left), product({order(OrderQuantity::inverse), sum_of(id)})), factor});
      break;
    }
  }
  const std::string meaning =
      each.value_number && each.kind != Kind::symbol ? program_[*each.value_number].name : "";
  x_[place(id)] = step(fmt::format("x{}", id), std::move(right), meaning);
  if (each.kind == Kind::sine || each.kind == Kind::primitive) weighted(*each.left);
  if (each.kind == Kind::logarithm) weighted(id);
}

/// The two series whose convolution an operation takes.
std::pair<ValueNumber, ValueNumber> RecurrenceLowering::operands(int id) const {
  const SeriesNode& each = node(id);
  const auto coefficient = [this](int of) { return x_[place(of)]; };
  const auto weighted = [this](int of) { return weighted_[place(of)].value(); };
  switch (each.kind) {
    case Kind::product:
      return {coefficient(*each.left), coefficient(*each.right)};
    case Kind::quotient:
      return {coefficient(id), coefficient(*each.right)};
    case Kind::sine:
    case Kind::cosine:
    case Kind::primitive:
      return {weighted(*each.left), coefficient(*each.right)};
    case Kind::logarithm:
      return {weighted(id), coefficient(*each.left)};
    default:
      return {coefficient(id), coefficient(id)};
  }
}

}  // namespace torsor
