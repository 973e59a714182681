// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/paired_signs.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {
namespace {

bool is(const Program& program, const Factor& factor, Function function) {
  return program[factor.value_number].function == function;
}
bool has_sign(const Program& program, const Factor& factor) {
  return is(program, factor, Function::abs) || is(program, factor, Function::sign);
}
bool has_sign(const Program& program, const Monomial& monomial) {
  return std::any_of(monomial.begin(), monomial.end(), [&](const Factor& factor) { return has_sign(program, factor); });
}

/// The product that a value number stands for.
const Term* product_of(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
  const std::vector<Term>& terms = definition.polynomial.terms();
  return definition.symbol || definition.function || terms.size() != 1 ? nullptr : &terms[0];
}

/// A value number to a power; a product as its factors, so that they meet others.
Term power_of(const Program& program, ValueNumber value_number, int exponent) {
  if (const Term* term = product_of(program, value_number)) {
    return {pow(term->monomial, exponent), term->coefficient.pow(exponent)};
  }
  return {{{value_number, exponent}}, Number(1)};
}

Term times(const Term& a, const Term& b) { return {a.monomial * b.monomial, a.coefficient * b.coefficient}; }

/// Roots of a product, each with the sign of its exponent.
using Roots = std::vector<std::pair<ValueNumber, bool>>;

Roots roots_of(const Program& program, const Monomial& monomial, bool divides) {
  Roots roots;
  for (const Factor& factor : monomial) {
    if (is(program, factor, Function::sqrt)) roots.emplace_back(factor.value_number, (factor.exponent < 0) != divides);
  }
  return roots;
}

/// With products as their factors that have a sign in them, or a root that another factor divides by or is divided by.
Term opened(const Program& program, const Term& term) {
  Roots roots = roots_of(program, term.monomial, false);
  const auto of_product = [&program](const Factor& factor) {
    const Term* inner = product_of(program, factor.value_number);
    return inner == nullptr ? Roots() : roots_of(program, inner->monomial, factor.exponent < 0);
  };
  for (const Factor& factor : term.monomial) {
    const Roots behind = of_product(factor);
    roots.insert(roots.end(), behind.begin(), behind.end());
  }
  const auto cancels = [&roots](const std::pair<ValueNumber, bool>& root) {
    return std::find(roots.begin(), roots.end(), std::pair(root.first, !root.second)) != roots.end();
  };
  const auto opens = [&](const Factor& factor) {
    const Term* inner = product_of(program, factor.value_number);
    if (inner == nullptr) return false;
    const Roots behind = of_product(factor);
    return has_sign(program, inner->monomial) || std::any_of(behind.begin(), behind.end(), cancels);
  };
  if (std::none_of(term.monomial.begin(), term.monomial.end(), opens)) return term;
  Term result{{}, term.coefficient};
  for (const Factor& factor : term.monomial) {
    result = times(result, opens(factor) ? power_of(program, factor.value_number, factor.exponent) : Term{{factor}, Number(1)});
  }
  return result;
}

Term without_paired_signs(const Program& program, const Term& given) {
  const Term term = opened(program, given);
  if (!has_sign(program, term.monomial)) return term;
  Term result{{}, term.coefficient};
  const auto argument = [&program](const Factor& call) { return program[call.value_number].arguments[0]; };
  Monomial left;
  for (const Factor& factor : term.monomial) {
    const int odd = factor.exponent % 2;
    if (is(program, factor, Function::sign)) {
      if (odd != 0) left.push_back({factor.value_number, 1});  // 1/sign(x) is sign(x)
    } else if (is(program, factor, Function::abs)) {
      if (odd != factor.exponent) result = times(result, power_of(program, argument(factor), factor.exponent - odd));
      if (odd != 0) left.push_back({factor.value_number, odd});
    } else {
      left.push_back(factor);
    }
  }
  for (auto sign = left.begin(); sign != left.end();) {
    const std::vector<ValueNumber>& arguments = program[sign->value_number].arguments;
    const auto size = std::find_if(left.begin(), left.end(), [&](const Factor& factor) {
      return is(program, factor, Function::abs) && program[factor.value_number].arguments == arguments;
    });
    if (!is(program, *sign, Function::sign) || size == left.end()) {
      ++sign;
      continue;
    }
    result = times(result, power_of(program, argument(*size), size->exponent));
    left.erase(std::max(sign, size));
    left.erase(std::min(sign, size));
    sign = left.begin();
  }
  return times(result, {left, Number(1)});
}

}  // namespace

Term product(const Program& program, const Term& a, const Term& b) {
  return without_paired_signs(program, times(a, b));
}

Term power(const Program& program, const Term& base, int exponent) {
  return without_paired_signs(program, {pow(base.monomial, exponent), base.coefficient.pow(exponent)});
}

}  // namespace torsor
