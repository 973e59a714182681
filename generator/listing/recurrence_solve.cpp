// SPDX-License-Identifier: GPL-3.0-or-later
// The part of recurrence_lowering.hpp that solves for accelerations.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/program/formula_parts.hpp"
#include "torsor/generator/listing/recurrence_lowering.hpp"

namespace torsor {

using formula_parts::add;
using formula_parts::number;
using formula_parts::product;
using formula_parts::sum;

std::vector<Value> SeriesSolve::at_start(const SeriesProgram& program) const {
  std::vector<Value> all = start;
  for (const std::vector<Value>& row : lower) all.insert(all.end(), row.begin(), row.end());
  all.insert(all.end(), inverse_pivots.begin(), inverse_pivots.end());
  for (const SeriesNode& node : program.nodes()) {
    for (const ValueNumber value_number : program.known_at_start(node))
      all.push_back(program.value(Polynomial(value_number)));
  }
  return all;
}

std::vector<bool> SeriesSolve::wanted(const SeriesProgram& program) const {
  const std::vector<bool> marked = program.depending_on(unknowns);
  std::vector<bool> wanted(marked.size(), false);
  const auto want = [&](std::optional<int> id) {
    if (id && marked[static_cast<std::size_t>(*id)]) wanted[static_cast<std::size_t>(*id)] = true;
  };
  for (std::size_t id = marked.size(); id-- > 0;) {
    const SeriesNode& each = program.nodes()[id];
    if (is_nonlinear(each)) {
      want(each.left);
      want(each.right);
      if (each.kind == SeriesNode::Kind::quotient) want(static_cast<int>(id));
    }
    if (!wanted[id]) continue;
    for (const SeriesForm::Term& term : each.form.terms) want(term.node);
  }
  return wanted;
}

std::vector<Polynomial> SeriesSolve::coefficients(const SeriesProgram& program) const {
  const std::vector<bool> marked = program.depending_on(unknowns), wanted = this->wanted(program);
  const std::vector<ValueNumber> known = program.program().live(at_start(program));
  std::vector<bool> part(marked.size());  // by node: whether anything of it does not come from the accelerations
  std::vector<Polynomial> all;
  const auto read = [&](const SeriesForm& form, bool value, bool whole) {
    if (value) all.push_back(form.constant);
    for (const SeriesForm::Term& term : form.terms) {
      if (whole || part[static_cast<std::size_t>(term.node)]) all.push_back(term.coefficient);
    }
  };
  for (std::size_t id = 0; id < marked.size(); ++id) {
    const SeriesNode& node = program.nodes()[id];
    const std::vector<SeriesForm::Term>& terms = node.form.terms;
    const auto has_part = [&](const SeriesForm::Term& term) { return part[static_cast<std::size_t>(term.node)]; };
    part[id] = !marked[id] || (node.kind == SeriesNode::Kind::sum ? std::any_of(terms.begin(), terms.end(), has_part)
                                                                  : node.kind != SeriesNode::Kind::symbol);
    const bool is_known = node.value_number && std::binary_search(known.begin(), known.end(), *node.value_number);
    read(node.form, !is_known, wanted[id]);
  }
  const std::vector<SeriesForm>& outputs = program.outputs();
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const bool rate = i + unknowns.size() < outputs.size();
    read(outputs[i], rate, rate);
  }
  return all;
}

/// The marked factor of a product and the other one.
std::pair<int, int> RecurrenceLowering::factors_of(const SeriesNode& product) const {
  return marked(product.left) ? std::pair(*product.left, *product.right) : std::pair(*product.right, *product.left);
}

/// What an operation is without marked operands, and these added as they are given; nothing if all is zero.
RecurrenceLowering::Optional RecurrenceLowering::with_marked(int id, const OperandOf& operand) {
  const SeriesNode& each = node(id);
  const Optional& alone = without_[place(id)];
  if (each.kind == Kind::sum) {
    return with_terms(alone, each.form, [&](int of) { return marked(of) ? operand(of) : std::nullopt; });
  }
  const bool is_product = each.kind == Kind::product;
  const Optional value = operand(is_product ? factors_of(each).first : *each.left);
  if (!value) return alone;
  const Formula factor = is_product ? begin(factors_of(each).second) : inverse(id);
  return sum({*alone, product({factor, *value})});
}

/// What depends on the accelerations of order k: first without them, which gives the equations' left sides, then, the
/// accelerations known, what convolutions of higher orders read.
void RecurrenceLowering::write_solve() {
  const auto nodes = static_cast<int>(nodes_.size());
  for (int id = 0; id < nodes; ++id) {
    if (marked(id) && !is_unknown(id)) write_partial(id);
  }
  write_accelerations();
  const std::vector<bool> wanted = series_.solve->wanted(series_.program);
  for (int id = 0; id < nodes; ++id) {
    if (is_unknown(id)) x_[place(id)] = rates_[unknown_of(id)];
    if (!wanted[place(id)] || is_unknown(id)) continue;
    const Optional all = with_marked(id, [this](int operand) { return Optional(x(operand)); });
    x_[place(id)] = step(fmt::format("x{}", id), *all);
  }
}

/// Coefficient k of an operation, where the accelerations are taken as zero: of its operands that do not depend on
/// them alone, and with the others.
void RecurrenceLowering::write_partial(int id) {
  const SeriesNode& each = node(id);
  Optional alone;
  if (each.kind == Kind::sum) {
    alone = with_terms({}, each.form,
                       [this](int operand) { return marked(operand) ? std::nullopt : Optional(x(operand)); });
  } else if (each.kind == Kind::product) {
    const auto [with, other] = factors_of(each);
    const Formula value = begin(with);
    alone = sum({sum_of(id), product({value, x(other)})});
  } else {
    const Formula value = begin(id);
    const Formula factor = inverse(id);
    alone = negated(product({sum({sum_of(id), product({value, x(*each.right)})}), factor}));
  }
  Optional& without = without_[place(id)];
  if (alone) without = Formula::of_value_number(step(fmt::format("o{}", id), std::move(*alone)));
  bool more = false;
  Optional all = with_marked(id, [&](int operand) {
    const Optional& part = partial_[place(operand)];
    more = more || part.has_value();
    return part;
  });
  partial_[place(id)] =
      more ? Optional(Formula::of_value_number(step(fmt::format("p{}", id), std::move(*all)))) : without;
}

/// Lᵀ D L a_k = -(left sides without a_k).
void RecurrenceLowering::write_accelerations() {
  const SeriesSolve& solve = *series_.solve;
  const std::size_t n = solve.unknowns.size(), given = series_.state.size() - n;
  std::vector<Optional> rest(n);
  const auto subtract = [&](Optional& from, std::size_t row, std::size_t column, const Optional& value) {
    const Polynomial& coefficient = solve.lower[row][column].polynomial();
    if (coefficient.is_zero() || !value) return;
    bool negative = false;
    const Optional size = factor(coefficient, negative);
    Formula all = sum({});
    if (from) add(all, std::move(*from), false);
    add(all, size ? product({*size, *value}) : *value, !negative);
    from = std::move(all);
  };
  for (std::size_t k = n; k-- > 0;) {
    Optional left = with_terms({}, series_.program.outputs()[given + k], [this](int operand) {
      return marked(operand) ? partial_[place(operand)] : Optional(x(operand));
    });
    Optional right;
    if (left) {  // minus all of it, rounded as it is
      right = sum({});
      add(*right, std::move(*left), true);
    }
    for (std::size_t i = n; i-- > k + 1;) subtract(right, i, k, rest[i]);
    if (right) rest[k] = Formula::of_value_number(step(fmt::format("r{}", k), std::move(*right)));
  }
  for (std::size_t k = 0; k < n; ++k) {
    bool negative = false;
    const Optional size = factor(solve.inverse_pivots[k].polynomial(), negative);
    Optional right;
    if (rest[k]) {
      right = size ? product({*size, *rest[k]}) : *rest[k];
      if (negative) right = negated(std::move(*right));
    }
    for (std::size_t i = 0; i < k; ++i) subtract(right, k, i, Formula::of_value_number(rates_[i]));
    rates_.push_back(step(fmt::format("a{}", k), right ? std::move(*right) : number(Number())));
  }
}

}  // namespace torsor
