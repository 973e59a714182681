// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <tuple>

#include "generator/reading/written.hpp"

namespace torsor::reading {
namespace {

WrittenFactor parenthesised(Written inside) {
  WrittenFactor factor;
  factor.inside = std::move(inside);
  return factor;
}

Written plain(const Sum& sum);

WrittenFactor written(const Power& power) {
  WrittenFactor factor;
  factor.halves = power.halves;
  if (power.base->kind != Base::Kind::group) factor.base = power.base;
  if (power.base->kind == Base::Kind::function || power.base->kind == Base::Kind::group) {
    factor.inside = plain(power.base->inside);
  }
  return factor;
}

/// Factors in the order of writing: lowest level first, functions after the symbols of their level.
std::vector<WrittenFactor> written(const Product& product) {
  Product ordered = product;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Power& a, const Power& b) { return a.base->level < b.base->level; });
  std::vector<WrittenFactor> factors;
  for (const Power& power : ordered) factors.push_back(written(power));
  return factors;
}

Written plain(const Sum& sum) {
  Written result;
  for (const auto& [product, coefficient] : sum.terms()) result.push_back({coefficient, written(product)});
  return result;
}

bool is_dynamic(const Power& power) { return power.base->kind == Base::Kind::symbol && power.base->level >= Level::velocity; }

/// The part of a product for which `predicate` holds, and the rest.
template <class Predicate>
std::pair<Product, Product> split(const Product& product, const Predicate& predicate) {
  std::pair<Product, Product> parts;
  for (const Power& power : product) (predicate(power) ? parts.first : parts.second).push_back(power);
  return parts;
}

/// The greatest product that divides every term (whole positive powers only).
Product common_factor(const Sum& sum) {
  if (sum.is_zero()) return {};
  Product common;
  for (const Power& power : sum.terms().begin()->first) {
    int least = power.halves;
    for (const auto& [product, coefficient] : sum.terms()) {
      const auto place = std::find_if(product.begin(), product.end(), [&](const Power& other) {
        return compare(*other.base, *power.base) == 0;
      });
      least = std::min(least, place == product.end() ? 0 : place->halves);
    }
    if (least >= 2) common.push_back({power.base, least - least % 2});
  }
  return common;
}

Product inverse(Product product) {
  for (Power& power : product) power.halves = -power.halves;
  return product;
}

bool is_short(const Number& number) {
  return number.is_rational() && cln::abs(cln::numerator(number.part(0))) <= 100 &&
         cln::denominator(number.part(0)) <= 12;
}

/// The greatest rational that all coefficients share, if it is short; positive.
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

/// The number to take out of a sum, with the sign of its first term: of parameters the greatest rational that all
/// coefficients share, of coordinates the first coefficient, so that X − X0 stays what it is. Only short numbers.
Number common_number(const Sum& sum) {
  const Number& first = sum.terms().begin()->second;
  const Number sign(first.sign());
  if (level(sum) >= Level::configuration) return is_short(first) ? first : sign;
  return sign * shared_number(sum);
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
        uses += std::any_of(other.begin(), other.end(), [&](const Power& p) {
          return p.halves >= 2 && compare(*p.base, *power.base) == 0;
        });
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

/// One term: number · common factor · (sum of the rest). Pure sums of parameters come out as (M1 + M2) l^2.
WrittenTerm as_term(const Sum& sum);

/// A sum of parameters: terms that share a parameter are put together.
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

/// The sum whose square this is, with a plus in front; nothing when there is none.
std::optional<Sum> square_root(const Sum& sum) {
  if (sum.size() < 3) return std::nullopt;
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

WrittenTerm as_term(const Sum& sum) {
  if (sum.size() == 1) return plain(sum)[0];
  const Number number = common_number(sum);
  const Product common = common_factor(sum);
  Sum rest;
  for (const auto& [product, coefficient] : sum.terms()) rest.add(product * inverse(common), coefficient / number);
  WrittenTerm term{number, written(common)};
  const std::optional<Sum> root = square_root(rest);
  term.factors.push_back(parenthesised(factored(root.value_or(rest))));
  if (root) term.factors.back().halves = 4;
  std::stable_sort(term.factors.begin(), term.factors.end(),
                   [](const WrittenFactor& a, const WrittenFactor& b) { return place(a) < place(b); });
  return term;
}

WrittenTerm times(WrittenTerm term, const Product& by) {
  for (WrittenFactor& factor : written(by)) term.factors.push_back(std::move(factor));
  return term;
}

using Groups = std::map<Product, Sum, ProductOrder>;

/// Groups by what depends on the configuration; the coefficients are sums of parameters.
Groups by_configuration(const Sum& sum) {
  Groups groups;
  for (const auto& [product, coefficient] : sum.terms()) {
    const auto [varying, constant] =
        split(product, [](const Power& power) { return power.base->level >= Level::configuration; });
    groups[varying].add(constant, coefficient);
  }
  return groups;
}

bool has(const Product& product, const BasePointer& base) {
  return std::any_of(product.begin(), product.end(), [&](const Power& p) { return compare(*p.base, *base) == 0; });
}
bool is_polynomial(const Product& product) {
  return std::all_of(product.begin(), product.end(), [](const Power& power) {
    return power.halves >= 2 && power.base->kind == Base::Kind::symbol;
  });
}
/// A stretch or its square, once the common factor is taken out: linear in the coordinates, with a constant or with
/// nothing but coordinates.
bool is_stretch(const Sum& sum, bool has_constant) {
  const Product common = common_factor(sum);
  Sum rest;
  for (const auto& [product, coefficient] : sum.terms()) {
    rest.add(product * inverse(common), coefficient / sum.terms().begin()->second);
  }
  if (square_root(rest)) return true;
  return std::all_of(rest.terms().begin(), rest.terms().end(), [&](const auto& term) {
    const bool constant = level(term.first) < Level::configuration;
    if (constant) return has_constant;
    return term.first.size() == 1 && term.first[0].halves == 2;
  });
}

/// Takes k (x − l) or k (x − y) out of the part without velocities: terms in plain coordinates that share a parameter,
/// the one that most of them share.
std::optional<Sum> take_elongation(Sum& rest) {
  Sum best;
  for (const auto& [product, number] : rest.terms()) {
    if (!is_polynomial(product)) continue;
    for (const Power& power : product) {
      if (power.base->level != Level::parameter) continue;
      Sum shared;
      bool moves = false;
      bool constant = false;
      for (const auto& [other, coefficient] : rest.terms()) {
        if (!is_polynomial(other) || !has(other, power.base)) continue;
        shared.add(other, coefficient);
        (level(other) >= Level::configuration ? moves : constant) = true;
      }
      const bool wanted = moves && shared.size() >= 2 && is_stretch(shared, constant);
      if (wanted && shared.size() > best.size()) best = shared;
    }
  }
  if (best.is_zero()) return std::nullopt;
  rest += Number(-1) * best;
  return best;
}

/// Groups by what depends on the configuration, constants first. `one_term`: a lone sum of parameters is to be a factor.
Written by_groups(const Sum& sum, bool one_term) {
  Groups groups = by_configuration(sum);
  Written result;
  const auto constant = groups.find(Product());
  if (constant != groups.end()) {
    result = one_term && groups.size() == 1 ? Written{as_term(constant->second)} : factored(constant->second);
    groups.erase(constant);
  }
  for (const auto& [product, coefficient] : groups) result.push_back(times(as_term(coefficient), product));
  return result;
}

Written without_motion(Sum rest) {
  Written springs;
  while (const std::optional<Sum> spring = take_elongation(rest)) springs.push_back(as_term(*spring));
  Written result = rest.is_zero() ? Written() : by_groups(rest, false);
  if (springs.empty()) return result;
  result.insert(result.begin(), springs.begin(), springs.end());
  return result;
}

/// Where a group of terms stands in an equation.
std::tuple<int, int> rank(const Product& motion, const Layout& layout) {
  int degree = 0;
  int group = 2;
  for (const Power& power : motion) {
    if (power.base->level == Level::velocity) degree -= power.halves;
  }
  if (degree != 0) group = 1;
  for (const Power& power : motion) {
    if (power.base->level == Level::input) group = 3;
    if (power.base->level == Level::multiplier) group = 4;
    if (power.base->level == Level::acceleration) group = power.base->symbol == layout.own ? -1 : 0;
  }
  return {group, degree};
}

/// number · common factors · (what remains) · motion.
WrittenTerm group_term(const Sum& coefficient, const Product& motion) {
  Written groups = by_groups(coefficient, true);
  if (groups.size() == 1) return times(std::move(groups[0]), motion);
  const Product common = common_factor(coefficient);
  const Number number = shared_number(coefficient);
  Sum rest;
  for (const auto& [product, value] : coefficient.terms()) rest.add(product * inverse(common), value / number);
  WrittenTerm term{number, written(common)};
  groups = by_groups(rest, true);
  if (groups[0].coefficient.sign() < 0) {
    term.coefficient = -term.coefficient;
    for (WrittenTerm& group : groups) group.coefficient = -group.coefficient;
  }
  term.factors.push_back(parenthesised(std::move(groups)));
  return times(std::move(term), motion);
}

/// A lone sum needs no parentheses.
Written unwrapped(Written written) {
  if (written.size() != 1 || !written[0].coefficient.is_one() || written[0].factors.size() != 1) return written;
  const WrittenFactor& factor = written[0].factors[0];
  return factor.base || factor.halves != 2 ? written : factor.inside;
}

}  // namespace

Written collected(const Sum& sum, const Layout& layout) {
  Groups groups;
  for (const auto& [product, coefficient] : sum.terms()) {
    const auto [motion, rest] = split(product, is_dynamic);
    groups[motion].add(rest, coefficient);
  }
  std::vector<std::pair<Product, Sum>> ordered(groups.begin(), groups.end());
  std::stable_sort(ordered.begin(), ordered.end(), [&](const auto& a, const auto& b) {
    return rank(a.first, layout) < rank(b.first, layout);
  });
  Written result;
  for (const auto& [motion, coefficient] : ordered) {
    if (motion.empty()) {
      for (WrittenTerm& term : without_motion(coefficient)) result.push_back(std::move(term));
    } else {
      result.push_back(group_term(coefficient, motion));
    }
  }
  return unwrapped(std::move(result));
}

}  // namespace torsor::reading
