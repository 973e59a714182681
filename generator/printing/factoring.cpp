// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/factoring.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace torsor::printing {
namespace {

Written plain(const Sum& sum);

WrittenFactor written(const Power& power) {
  WrittenFactor factor;
  factor.halves = power.halves;
  if (power.base->kind == Base::Kind::group && power.halves % 2 != 0) {
    if (const std::optional<Sum> root = square_root(power.base->inside)) {  // sqrt((x - y)^2) = |x - y|
      factor.inside = plain(*root);
      factor.halves = 2 * power.halves;
      factor.size = true;
      return factor;
    }
  }
  if (power.base->kind != Base::Kind::group) factor.base = power.base;
  if (power.base->kind == Base::Kind::function || power.base->kind == Base::Kind::group) {
    factor.inside = plain(power.base->inside);
    for (const Sum& other : power.base->others) factor.others.push_back(plain(other));
  }
  if (power.base->kind == Base::Kind::group) {  // 1 - x rather than -x + 1
    const auto positive = [](const WrittenTerm& term) { return term.coefficient.sign() > 0; };
    const auto first = std::find_if(factor.inside.begin(), factor.inside.end(), positive);
    if (first != factor.inside.end()) std::rotate(factor.inside.begin(), first, first + 1);
  }
  return factor;
}

Written plain(const Sum& sum) {
  Written result;
  for (const auto& [product, coefficient] : sum.terms()) result.push_back({coefficient, written(product)});
  return result;
}

bool is_short(const Number& number) {
  return number.is_rational() && cln::abs(cln::numerator(number.part(0))) <= 100 &&
         cln::denominator(number.part(0)) <= 12;
}

/// Whether dividing a sum that is linear in coordinates by this number leaves fractions before them, as of 4 x + y.
bool leaves_fractions(const Sum& sum, const Number& number) {
  bool fractions = false;
  for (const auto& [product, coefficient] : sum.terms()) {
    int degree = 0;
    for (const Power& power : product) degree += power.base->level >= Level::configuration ? power.halves : 0;
    if (degree > 2) return false;
    fractions = fractions || (degree == 2 && !(coefficient / number).is_integer());
  }
  return fractions;
}

/// The number to take out of a sum, with the sign of its first term: of parameters the greatest rational that all
/// coefficients share, of coordinates the first coefficient, so that X − X0 and x − pi/2 stay what they are. Only short numbers.
Number common_number(const Sum& sum) {
  const Number& first = sum.terms().begin()->second;
  const Number sign(first.sign());
  const bool whole = (sign * first).is_one() || !leaves_fractions(sum, first);
  if (level(sum) < Level::configuration || !whole) return sign * shared_number(sum);
  return is_short(first) ? first : sign;
}

/// The base that most terms share, at least two and not all; among equals the one created last: lengths are shared
/// rather than masses.
BasePointer most_shared(const Sum& sum) {
  BasePointer best;
  int best_uses = 1;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      if (power.halves < 2) continue;
      int uses = 0;
      for (const auto& [other, number] : sum.terms()) {
        uses += std::any_of(other.begin(), other.end(),
                            [&](const Power& p) { return p.halves >= 2 && compare(*p.base, *power.base) == 0; });
      }
      const bool later = best && uses == best_uses && compare(*power.base, *best) > 0;
      if (uses > best_uses || (uses >= 2 && later)) {
        best = power.base;
        best_uses = uses;
      }
    }
  }
  return best;
}

/// Where a factor stands in a product: by level, and a sum in parentheses at the place of its first symbol.
std::tuple<Level, int, int> place(const WrittenFactor& factor) {
  if (factor.base) {
    const bool call = factor.base->kind == Base::Kind::function;
    return {factor.base->level, call ? 1 : 0, factor.base->symbol ? factor.base->symbol->index : 0};
  }
  std::tuple<Level, int, int> highest{Level::constant, 0, 0};
  bool first = true;
  for (const WrittenTerm& term : factor.inside) {
    for (const WrittenFactor& inner : term.factors) {
      const auto here = place(inner);
      if (first || std::get<0>(here) > std::get<0>(highest)) highest = here;
      first = false;
    }
  }
  return highest;
}

Level level_of(const WrittenTerm& term) {
  Level highest = Level::constant;
  for (const WrittenFactor& factor : term.factors) highest = std::max(highest, std::get<0>(place(factor)));
  return highest;
}

/// 1 + eps cos(theta) rather than eps cos(theta) + 1, as where such a sum is a coefficient; x - x_0 stays, whose coordinate
/// leads.
/// The first term keeps or gets its plus: whether all signs were turned for that.
bool constants_first(Written& sum) {
  const auto moves = [](const WrittenTerm& term) { return level_of(term) >= Level::configuration; };
  const bool leads = std::any_of(sum.begin(), sum.end(), [&](const WrittenTerm& term) {
    return moves(term) && std::all_of(term.factors.begin(), term.factors.end(), [](const WrittenFactor& factor) {
             return factor.base && factor.base->kind == Base::Kind::symbol;
           });
  });
  if (leads) return false;
  std::stable_partition(sum.begin(), sum.end(), [&](const WrittenTerm& term) { return !moves(term); });
  if (sum.empty() || sum[0].coefficient.sign() > 0) return false;
  for (WrittenTerm& term : sum) term.coefficient = -term.coefficient;
  return true;
}

}  // namespace

WrittenFactor parenthesised(Written inside) {
  WrittenFactor factor;
  factor.inside = std::move(inside);
  return factor;
}

void put_in_order(std::vector<WrittenFactor>& factors) {
  std::stable_sort(factors.begin(), factors.end(),
                   [](const WrittenFactor& a, const WrittenFactor& b) { return place(a) < place(b); });
}

std::vector<WrittenFactor> written(const Product& product) {
  Product ordered = product;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Power& a, const Power& b) { return a.base->level < b.base->level; });
  std::vector<WrittenFactor> factors;
  for (const Power& power : ordered) factors.push_back(written(power));
  return factors;
}

Product common_factor(const Sum& sum) {
  if (sum.is_zero()) return {};
  Product common;
  for (const Power& power : sum.terms().begin()->first) {
    const int side = power.halves > 0 ? 1 : -1;  // over or under the stroke
    int least = std::abs(power.halves);
    for (const auto& [product, coefficient] : sum.terms()) {
      const auto place = std::find_if(product.begin(), product.end(),
                                      [&](const Power& other) { return compare(*other.base, *power.base) == 0; });
      least = std::min(least, place == product.end() ? 0 : side * place->halves);
    }
    if (least >= 2) common.push_back({power.base, side * (least - least % 2)});
  }
  return common;
}

Product inverse(Product product) {
  for (Power& power : product) power.halves = -power.halves;
  return product;
}

Number shared_number(const Sum& sum) {
  cln::cl_I numerators = 0;
  cln::cl_I denominators = 1;
  for (const auto& [product, coefficient] : sum.terms()) {
    if (!coefficient.is_rational()) return Number(1);
    numerators = cln::gcd(numerators, cln::numerator(coefficient.part(0)));
    denominators = cln::lcm(denominators, cln::denominator(coefficient.part(0)));
  }
  const Number shared(numerators / denominators);
  return is_short(shared) ? shared : Number(1);
}

std::optional<Sum> square_root(const Sum& sum) {
  if (sum.is_zero() || sum.size() == 2) return std::nullopt;
  Sum root;
  for (const auto& [product, coefficient] : sum.terms()) {
    const bool square = std::all_of(product.begin(), product.end(), [](const Power& p) { return p.halves % 4 == 0; });
    const std::optional<Number> size = square && coefficient.sign() > 0 ? coefficient.square_root() : std::nullopt;
    if (!size) continue;
    Product half = product;
    for (Power& power : half) power.halves /= 2;
    int sign = 1;
    if (!root.is_zero()) {
      const auto cross = sum.terms().find(half * root.terms().begin()->first);
      if (cross == sum.terms().end()) return std::nullopt;
      sign = cross->second.sign();
    }
    root.add(half, Number(sign) * *size);
  }
  return compare(root * root, sum) == 0 ? std::optional<Sum>(root) : std::nullopt;
}

// Where all coefficients of a square's root are those of one root of 2, 3 or 6, that number, which stands before the square of
// what is left: 2 (m + 3)^2.
Number taken_out(Sum& root) {
  for (const auto& [unit, square] : {std::pair(Number::sqrt2(), 2), std::pair(Number::sqrt3(), 3),
                                     std::pair(Number::sqrt2() * Number::sqrt3(), 6)}) {
    Sum left;
    bool rational = true;
    for (const auto& [product, coefficient] : root.terms()) {
      left.add(product, coefficient / unit);
      rational = rational && (coefficient / unit).is_rational();
    }
    if (!rational) continue;
    root = left;
    return Number(square);
  }
  return Number(1);
}

WrittenTerm as_term(const Sum& sum) {
  if (sum.size() == 1) return plain(sum)[0];
  const Number number = common_number(sum);
  const Product common = common_factor(sum);
  Sum rest;
  for (const auto& [product, coefficient] : sum.terms()) rest.add(product * inverse(common), coefficient / number);
  std::optional<Sum> root = square_root(rest);
  WrittenTerm term{root ? number * taken_out(*root) : number, written(common)};
  Written inside = factored(root.value_or(rest));
  if (constants_first(inside) && !root) term.coefficient = -term.coefficient;
  term.factors.push_back(parenthesised(std::move(inside)));
  if (root) term.factors.back().halves = 4;
  put_in_order(term.factors);
  return term;
}

Written factored(const Sum& sum) {
  if (sum.size() > 1 && !common_factor(sum).empty()) return {as_term(sum)};
  if (sum.size() < 3) return plain(sum);
  const BasePointer shared = most_shared(sum);
  if (!shared) return plain(sum);
  Sum inside;
  Sum outside;
  for (const auto& [product, coefficient] : sum.terms()) {
    const bool has = std::any_of(product.begin(), product.end(),
                                 [&](const Power& p) { return p.halves >= 2 && compare(*p.base, *shared) == 0; });
    (has ? inside : outside).add(product, coefficient);
  }
  Written result = factored(outside);
  const bool leads = compare(inside.terms().begin()->first, sum.terms().begin()->first) == 0;
  result.insert(leads ? result.begin() : result.end(), as_term(inside));
  return result;
}

}  // namespace torsor::printing
