// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/canonical_sum.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <cln/integer.h>
#include <cln/rational.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/division_by_zero.hpp"

namespace torsor::printing {
namespace {

Level level_of(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::pi:
      return Level::constant;
    case SymbolKind::parameter:
      return Level::parameter;
    case SymbolKind::time:
    case SymbolKind::coordinate:
      return Level::configuration;
    case SymbolKind::velocity:
      return Level::velocity;
    case SymbolKind::acceleration:
      return Level::acceleration;
    case SymbolKind::input:
      return Level::input;
    case SymbolKind::multiplier:
      return Level::multiplier;
  }
  return Level::constant;
}

Sum of_base(Base base) {
  Sum sum;
  sum.add({{std::make_shared<const Base>(std::move(base)), 2}}, Number(1));
  return sum;
}

/// Greatest rational that divides every rational part of every coefficient a whole number of times; positive.
Number content(const Sum& sum) {
  cln::cl_I numerators = 0;
  cln::cl_I denominators = 1;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (int i = 0; i < 4; ++i) {
      numerators = cln::gcd(numerators, cln::numerator(coefficient.part(i)));
      denominators = cln::lcm(denominators, cln::denominator(coefficient.part(i)));
    }
  }
  return {numerators / denominators};
}

/// A whole positive power of a group that a product has built up is a sum again.
bool expandable(const Power& power) {
  return power.base->kind == Base::Kind::group && power.halves > 0 && power.halves % 2 == 0;
}

/// coefficient · product with its groups multiplied out.
Sum expanded(const Product& product, const Number& coefficient) {
  const auto place = std::find_if(product.begin(), product.end(), expandable);
  Sum sum;
  if (place == product.end()) {
    sum.add(product, coefficient);
    return sum;
  }
  Product rest = product;
  rest.erase(rest.begin() + (place - product.begin()));
  return expanded(rest, coefficient) * power(place->base->inside, place->halves);
}

Sum group(const Sum& inside, int halves) {
  Base base;
  base.kind = Base::Kind::group;
  base.level = level(inside);
  base.inside = inside;
  Sum sum;
  sum.add({{std::make_shared<const Base>(std::move(base)), halves}}, Number(1));
  return sum;
}

Sum power_of_term(const Product& product, const Number& coefficient, int halves) {
  if (halves % 2 == 0) {
    Product raised = product;
    for (Power& power : raised) power.halves *= halves / 2;
    return expanded(raised, coefficient.pow(halves / 2));
  }
  // Roots of a product are not taken apart: only a root of a number or of one symbol has a sign that is known.
  const std::optional<Number> root = coefficient.sign() > 0 ? coefficient.square_root() : std::nullopt;
  if (root && product.empty()) return Sum(root->pow(halves));
  if (root && product.size() == 1 && product[0].halves == 2 && product[0].base->kind != Base::Kind::group) {
    Sum sum;
    sum.add({{product[0].base, halves}}, root->pow(halves));
    return sum;
  }
  Sum inside;
  inside.add(product, root ? Number(1) : coefficient);
  return (root ? root->pow(halves) : Number(1)) * group(inside, halves);
}

}  // namespace

std::strong_ordering compare(const Base& a, const Base& b) {
  if (&a == &b) return std::strong_ordering::equal;
  if (a.level != b.level) return b.level <=> a.level;
  if (a.kind != b.kind) return a.kind <=> b.kind;
  switch (a.kind) {
    case Base::Kind::symbol:
      return a.symbol->index <=> b.symbol->index;
    case Base::Kind::definition:
      return a.definition <=> b.definition;
    case Base::Kind::function:
      if (a.function != b.function) return b.function <=> a.function;
      break;
    case Base::Kind::group:
      break;
  }
  if (const auto inside = compare(a.inside, b.inside); inside != 0) return inside;
  for (std::size_t i = 0; i < a.others.size() && i < b.others.size(); ++i) {
    if (const auto others = compare(a.others[i], b.others[i]); others != 0) return others;
  }
  return a.others.size() <=> b.others.size();
}

std::strong_ordering compare(const Product& a, const Product& b) {
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const std::strong_ordering bases =
        a[i].base == b[i].base ? std::strong_ordering::equal : compare(*a[i].base, *b[i].base);
    if (bases != 0) return bases;
    if (a[i].halves != b[i].halves) return b[i].halves <=> a[i].halves;
  }
  return b.size() <=> a.size();
}

std::strong_ordering compare(const Sum& a, const Sum& b) {
  auto i = a.terms().begin();
  auto j = b.terms().begin();
  for (; i != a.terms().end() && j != b.terms().end(); ++i, ++j) {
    if (const auto products = compare(i->first, j->first); products != 0) return products;
    if (const auto numbers = torsor::compare(i->second, j->second); numbers != 0) return numbers;
  }
  return a.size() <=> b.size();
}

Level level(const Product& product) { return product.empty() ? Level::constant : product[0].base->level; }
Level level(const Sum& sum) { return sum.is_zero() ? Level::constant : level(sum.terms().begin()->first); }

void add_symbols(const Sum& sum, std::set<const Symbol*>& symbols) {
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      if (power.base->symbol) symbols.insert(power.base->symbol.get());
      add_symbols(power.base->inside, symbols);
      for (const Sum& other : power.base->others) add_symbols(other, symbols);
    }
  }
}

namespace {

struct SumOrder {
  bool operator()(const Sum* a, const Sum* b) const { return compare(*a, *b) < 0; }
};

std::size_t written_terms(const Sum& sum, std::set<const Sum*, SumOrder>& named) {
  std::size_t count = sum.size();
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      const Sum& inside = power.base->inside;
      const bool has_name = power.base->kind == Base::Kind::group && (power.halves < 0 || power.halves % 2 != 0);
      if (inside.size() > 1 && !(has_name && !named.insert(&inside).second)) count += written_terms(inside, named);
      for (const Sum& other : power.base->others) count += other.size() > 1 ? written_terms(other, named) : 0;
    }
  }
  return count;
}

}  // namespace

std::size_t written_terms(const Sum& sum) {
  std::set<const Sum*, SumOrder> named;
  return written_terms(sum, named);
}

Product operator*(const Product& a, const Product& b) {
  Product product;
  product.reserve(a.size() + b.size());
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    const std::strong_ordering order = j == b.end()   ? std::strong_ordering::less
                                       : i == a.end() ? std::strong_ordering::greater
                                                      : compare(*i->base, *j->base);
    if (order < 0) {
      product.push_back(*i++);
    } else if (order > 0) {
      product.push_back(*j++);
    } else {
      const int halves = i->halves + j->halves;
      if (halves != 0) product.push_back({i->base, halves});
      ++i, ++j;
    }
  }
  return product;
}

Sum Sum::symbol(const SymbolPointer& symbol) {
  Base base;
  base.level = level_of(symbol->kind);
  base.symbol = symbol;
  return of_base(std::move(base));
}

Sum Sum::definition(int k) {
  Base base;
  base.kind = Base::Kind::definition;
  base.level = Level::definition;
  base.definition = k;
  return of_base(std::move(base));
}

Sum Sum::function(Function function, const std::vector<Sum>& arguments) {
  const Sum& argument = arguments[0];
  if (function == Function::sqrt) return power(argument, 1);
  const Parity parity = traits_of(function).parity;
  if (argument.is_zero() && arguments.size() == 1) {
    if (const std::optional<int> value = traits_of(function).at_zero) return *value == 0 ? Sum() : Sum(Number(*value));
  }
  if (parity != Parity::none && !argument.is_zero() && argument.terms().begin()->second.sign() < 0) {
    std::vector<Sum> mirrored = arguments;
    mirrored[0] = Number(-1) * argument;
    const Sum value = Sum::function(function, mirrored);
    return parity == Parity::odd ? Number(-1) * value : value;
  }
  Base base;
  base.kind = Base::Kind::function;
  base.level = printing::level(argument);
  base.function = function;
  base.inside = argument;
  base.others.assign(arguments.begin() + 1, arguments.end());
  for (const Sum& other : base.others) base.level = std::max(base.level, printing::level(other));
  return of_base(std::move(base));
}

void Sum::add(const Product& product, const Number& coefficient) {
  if (coefficient.is_zero()) return;
  const auto [place, added] = terms_.emplace(product, coefficient);
  if (added) return;
  place->second += coefficient;
  if (place->second.is_zero()) terms_.erase(place);
}

Sum& Sum::operator+=(const Sum& other) {
  for (const auto& [product, coefficient] : other.terms()) add(product, coefficient);
  return *this;
}

Sum operator*(const Number& factor, const Sum& sum) {
  Sum scaled;
  for (const auto& [product, coefficient] : sum.terms()) scaled.add(product, factor * coefficient);
  return scaled;
}

Sum operator*(const Sum& a, const Sum& b) {
  Sum result;
  for (const auto& [left, x] : a.terms()) {
    for (const auto& [right, y] : b.terms()) {
      const Product product = left * right;
      if (std::none_of(product.begin(), product.end(), expandable)) {
        result.add(product, x * y);
      } else {
        result += expanded(product, x * y);
      }
    }
  }
  return result;
}

Sum power(const Sum& sum, int halves) {
  if (halves == 0) return Sum(Number(1));
  if (sum.is_zero()) {
    if (halves < 0) throw DivisionByZero();
    return sum;
  }
  if (sum.size() == 1) return power_of_term(sum.terms().begin()->first, sum.terms().begin()->second, halves);
  if (halves % 2 != 0) return group(sum, halves);
  if (halves < 0) {
    Number factor = content(sum);
    if (sum.terms().begin()->second.sign() < 0) factor = -factor;
    return factor.pow(halves / 2) * group((Number(1) / factor) * sum, halves);
  }
  Sum result(Number(1));
  for (int k = 0; k < halves / 2; ++k) result = result * sum;
  return result;
}

}  // namespace torsor::printing
