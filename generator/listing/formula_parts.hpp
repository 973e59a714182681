// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "generator/program/formula.hpp"

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

/// a − b; of an a that is a sum the terms stay where they are.
inline Formula difference(Formula a, Formula b) {
  Formula formula = a.kind == Formula::Kind::sum ? std::move(a) : sum({std::move(a)});
  formula.children.push_back(std::move(b));
  formula.negative.push_back(true);
  return formula;
}

inline Formula quotient(Formula a, Formula b) { return of_kind(Formula::Kind::quotient, {std::move(a), std::move(b)}); }

}  // namespace torsor::formula_parts
