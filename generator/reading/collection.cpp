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

/// Greatest rational common to all coefficients, with the sign of the first; 1 when there are surds.
Number common_number(const Sum& sum) {
  const Number& first = sum.terms().begin()->second;
  const Number sign(first.sign());
  cln::cl_I numerators = 0;
  cln::cl_I denominators = 1;
  for (const auto& [product, coefficient] : sum.terms()) {
    if (!coefficient.is_rational()) return sign;
    numerators = cln::gcd(numerators, cln::numerator(coefficient.part(0)));
    denominators = cln::lcm(denominators, cln::denominator(coefficient.part(0)));
  }
  return sign * Number(numerators / denominators);
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
  if (outside.is_zero()) return {as_term(sum)};
  Written result{as_term(inside)};
  for (WrittenTerm& term : factored(outside)) result.push_back(std::move(term));
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

WrittenTerm as_term(const Sum& sum) {
  if (sum.size() == 1) return plain(sum)[0];
  const Number number = common_number(sum);
  const Product common = common_factor(sum);
  Sum rest;
  for (const auto& [product, coefficient] : sum.terms()) rest.add(product * inverse(common), coefficient / number);
  WrittenTerm term{number, written(common)};
  term.factors.push_back(parenthesised(factored(rest)));
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

/// Takes a spring's k (x − l) out of the part without velocities: a parameter shared by a constant and by terms that
/// are linear in coordinates.
std::optional<Sum> take_elongation(Sum& rest) {
  const auto polynomial = [](const Product& product) {
    return std::all_of(product.begin(), product.end(), [](const Power& power) {
      return power.halves >= 2 && power.base->kind == Base::Kind::symbol;
    });
  };
  const auto has = [](const Product& product, const BasePointer& base) {
    return std::any_of(product.begin(), product.end(), [&](const Power& p) { return compare(*p.base, *base) == 0; });
  };
  for (const auto& [constant, number] : rest.terms()) {
    if (level(constant) > Level::parameter || !polynomial(constant)) continue;
    for (auto power = constant.rbegin(); power != constant.rend(); ++power) {
      Sum shared;
      bool moves = false;
      for (const auto& [product, coefficient] : rest.terms()) {
        if (!polynomial(product) || !has(product, power->base)) continue;
        shared.add(product, coefficient);
        moves = moves || level(product) >= Level::configuration;
      }
      if (!moves || shared.size() < 2) continue;
      for (const auto& [product, coefficient] : shared.terms()) rest.add(product, -coefficient);
      return shared;
    }
  }
  return std::nullopt;
}

Written coefficient_of_motion(const Sum& sum) {
  Groups groups = by_configuration(sum);
  Written result;
  const auto constant = groups.find(Product());
  if (constant != groups.end()) {
    for (WrittenTerm& term : groups.size() == 1 ? Written{as_term(constant->second)} : factored(constant->second)) {
      result.push_back(std::move(term));
    }
    groups.erase(constant);
  }
  for (const auto& [product, coefficient] : groups) result.push_back(times(as_term(coefficient), product));
  return result;
}

Written without_motion(Sum rest) {
  Written springs;
  while (const std::optional<Sum> spring = take_elongation(rest)) springs.push_back(as_term(*spring));
  Written result;
  for (const auto& [product, coefficient] : by_configuration(rest)) {
    if (product.empty()) {
      for (WrittenTerm& term : factored(coefficient)) result.push_back(std::move(term));
    } else {
      result.push_back(times(as_term(coefficient), product));
    }
  }
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

/// number · (coefficient) · motion; the parentheses fall where there is one term.
WrittenTerm group_term(Written coefficient, const Product& motion) {
  if (coefficient.size() == 1) return times(std::move(coefficient[0]), motion);
  WrittenTerm term;
  if (coefficient[0].coefficient.sign() < 0) {
    term.coefficient = Number(-1);
    for (WrittenTerm& inner : coefficient) inner.coefficient = -inner.coefficient;
  }
  term.factors.push_back(parenthesised(std::move(coefficient)));
  return times(std::move(term), motion);
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
      result.push_back(group_term(coefficient_of_motion(coefficient), motion));
    }
  }
  return result;
}

Real evaluate(const Written& written, const std::function<Real(const SymbolPointer&)>& value_of, int digits) {
  Real sum(Number(0), digits);
  for (const WrittenTerm& term : written) {
    Real product(term.coefficient, digits);
    for (const WrittenFactor& factor : term.factors) {
      Real base;
      if (!factor.base) {
        base = evaluate(factor.inside, value_of, digits);
      } else if (factor.base->kind == Base::Kind::function) {
        base = apply(factor.base->function, evaluate(factor.inside, value_of, digits));
      } else if (factor.base->kind == Base::Kind::symbol) {
        base = value_of(factor.base->symbol);
      } else {
        throw Error("a named definition has no value of its own: evaluate the program instead");
      }
      const int whole = factor.halves / 2;
      product *= pow(base, whole);
      if (factor.halves % 2 != 0) {
        const Real root = sqrt(base);
        product = factor.halves > 0 ? product * root : product / root;
      }
    }
    sum += product;
  }
  return sum;
}

}  // namespace torsor::reading
