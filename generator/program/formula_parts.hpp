// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/program/formula.hpp"

/// Formulas put together as they are to be computed.
namespace torsor::formula_parts {

inline Formula number(const Number& value) { return Formula::of_number(value); }

inline Formula of_kind(Formula::Kind kind, std::vector<Formula> children) {
  Formula formula;
  formula.kind = kind;
  formula.children = std::move(children);
  return formula;
}

inline Formula product(std::vector<Formula> factors) { return of_kind(Formula::Kind::product, std::move(factors)); }

inline Formula sum(std::vector<Formula> terms) {
  Formula formula = of_kind(Formula::Kind::sum, std::move(terms));
  formula.negative.assign(formula.children.size(), false);
  return formula;
}

/// One more term; of a sum that is the first the terms stay where they are.
inline void add(Formula& sum, Formula term, bool negative) {
  if (sum.children.empty() && term.kind == Formula::Kind::sum && !negative) {
    sum = std::move(term);
    return;
  }
  sum.children.push_back(std::move(term));
  sum.negative.push_back(negative);
}

/// a − b; of an a that is a sum the terms stay where they are.
inline Formula difference(Formula a, Formula b) {
  Formula formula = sum({});
  add(formula, std::move(a), false);
  add(formula, std::move(b), true);
  return formula;
}

/// What a sum is that has one term, and does not subtract it.
inline Formula collapsed(Formula sum) {
  if (sum.children.size() != 1 || sum.negative[0]) return sum;
  Formula only = std::move(sum.children[0]);
  return only;
}

inline Formula quotient(Formula a, Formula b) { return of_kind(Formula::Kind::quotient, {std::move(a), std::move(b)}); }

}  // namespace torsor::formula_parts
