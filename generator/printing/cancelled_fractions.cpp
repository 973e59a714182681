// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/cancelled_fractions.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "torsor/generator/printing/factoring.hpp"

namespace torsor::printing {
namespace {

struct BaseOrder {
  bool operator()(const BasePointer& a, const BasePointer& b) const { return compare(*a, *b) < 0; }
};
using Bases = std::set<BasePointer, BaseOrder>;

int halves_of(const Product& product, const Base& base) {
  for (const Power& power : product) {
    if (compare(*power.base, base) == 0) return power.halves;
  }
  return 0;
}

bool is_denominator(const Power& power) {
  return power.base->kind == Base::Kind::group && power.halves < 0 && power.halves % 2 == 0;
}

/// The sums that are denominators.
Bases denominators(const Sum& sum) {
  Bases bases;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      if (is_denominator(power)) bases.insert(power.base);
    }
  }
  return bases;
}

Bases bases_of(const Sum& sum) {
  Bases bases;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) bases.insert(power.base);
  }
  return bases;
}

Sum times(const Sum& sum, const Product& product) {
  Sum factor;
  factor.add(product, Number(1));
  return sum * factor;
}

/// The powers that make each of the bases appear with exponents from zero up.
Product clearing(const Sum& sum, const Bases& bases) {
  Product clears;
  for (const BasePointer& base : bases) {
    int least = 0;
    bool first = true;
    for (const auto& [product, coefficient] : sum.terms()) {
      const int halves = halves_of(product, *base);
      least = first ? halves : std::min(least, halves);
      first = false;
    }
    if (least != 0) clears.push_back({base, -least});
  }
  return clears;
}

/// dividend/divisor where nothing is left over; both are polynomials of the bases, of which powers may be negative or odd.
/// Terms stand in the order of their powers, so that those in front give the quotient's one after the other. A root among
/// the bases would end that order: its square is a sum of others.
std::optional<Sum> quotient(const Sum& dividend, const Sum& divisor, const Bases& bases) {
  constexpr std::size_t most_terms = 400;
  const auto is_root = [](const BasePointer& base) { return base->kind == Base::Kind::group; };
  if (std::any_of(bases.begin(), bases.end(), is_root)) return std::nullopt;
  const Product of_dividend = clearing(dividend, bases), of_divisor = clearing(divisor, bases);
  Sum rest = times(dividend, of_dividend);
  const Sum by = times(divisor, of_divisor);
  const auto& [leading, coefficient] = *by.terms().begin();
  Sum result;
  for (std::size_t steps = 0; !rest.is_zero(); ++steps) {
    if (steps == most_terms) return std::nullopt;
    const auto& [product, number] = *rest.terms().begin();
    Sum term;
    term.add(product * inverse(leading), number / coefficient);
    const Product& ratio = term.terms().begin()->first;
    if (std::any_of(ratio.begin(), ratio.end(), [](const Power& p) { return p.halves < 0; })) return std::nullopt;
    result += term;
    rest += Number(-1) * (term * by);
  }
  return times(times(result, inverse(of_dividend)), of_divisor);
}

/// Terms, what stands under them, and the factors in that.
std::size_t length(const Sum& sum) {
  std::set<Product, ProductOrder> under;
  for (const auto& [product, coefficient] : sum.terms()) {
    Product groups;
    std::copy_if(product.begin(), product.end(), std::back_inserter(groups), is_denominator);
    under.insert(std::move(groups));
  }
  std::size_t factors = 0;
  for (const Product& groups : under) factors += groups.size();
  return sum.size() + under.size() + factors;
}

/// Terms of nothing but a denominator and its bases, over that denominator; as they are where that is no shorter.
Sum over(const Sum& terms, const BasePointer& denominator, const Bases& bases) {
  constexpr std::size_t most_products = 20000;
  int most = 0;
  for (const auto& [product, coefficient] : terms.terms()) {
    const int halves = halves_of(product, *denominator);
    if (halves % 2 != 0 || halves > 0) return terms;
    most = std::max(most, -halves / 2);
  }
  if (most == 0 || most > 8) return terms;
  Sum numerator;
  std::vector<Sum> powers{Sum(Number(1))};
  for (int k = 1; k <= most; ++k) {
    if (powers.back().size() * denominator->inside.size() * terms.size() > most_products) return terms;
    powers.push_back(powers.back() * denominator->inside);
  }
  for (const auto& [product, coefficient] : terms.terms()) {
    Product without = product;
    std::erase_if(without, [&](const Power& power) { return compare(*power.base, *denominator) == 0; });
    Sum term;
    term.add(without, coefficient);
    numerator += term * powers[static_cast<std::size_t>(most + halves_of(product, *denominator) / 2)];
  }
  int left = most;
  while (left > 0 && !numerator.is_zero()) {
    std::optional<Sum> divided = quotient(numerator, denominator->inside, bases);
    if (!divided) break;
    numerator = std::move(*divided);
    --left;
  }
  const Sum shared = left == 0 ? numerator : times(numerator, {{denominator, -2 * left}});
  return length(shared) < length(terms) ? shared : terms;
}

}  // namespace

Sum cancelled(const Sum& sum) {
  Sum result = sum;
  for (const BasePointer& denominator : denominators(sum)) {
    const Bases bases = bases_of(denominator->inside);
    std::map<Product, Sum, ProductOrder> by_factor;  // that has nothing of the denominator in it
    for (const auto& [product, coefficient] : result.terms()) {
      Product factor, own;
      for (const Power& power : product) {
        const bool inside = bases.count(power.base) > 0 || compare(*power.base, *denominator) == 0;
        (inside ? own : factor).push_back(power);
      }
      by_factor[factor].add(own, coefficient);
    }
    result = Sum();
    for (const auto& [factor, terms] : by_factor) result += times(over(terms, denominator, bases), factor);
  }
  return result;
}

}  // namespace torsor::printing
