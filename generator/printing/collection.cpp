// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>

#include "torsor/generator/printing/factoring.hpp"
#include "torsor/generator/printing/written.hpp"

namespace torsor::printing {
namespace {

bool is_dynamic(const Power& power) {
  return power.base->kind == Base::Kind::symbol && power.base->level >= Level::velocity;
}

/// The part of a product for which `predicate` holds, and the rest.
template <class Predicate>
std::pair<Product, Product> split(const Product& product, const Predicate& predicate) {
  std::pair<Product, Product> parts;
  for (const Power& power : product) (predicate(power) ? parts.first : parts.second).push_back(power);
  return parts;
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
/// Whole powers of symbols, those of coordinates positive.
bool is_polynomial(const Product& product) {
  return std::all_of(product.begin(), product.end(), [](const Power& power) {
    const bool over = power.halves >= 2 || (power.halves % 2 == 0 && power.base->level < Level::configuration);
    return over && power.base->kind == Base::Kind::symbol;
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

/// The root of a product; nothing where a power would not be whole.
std::optional<Product> root_of(Product product) {
  for (Power& power : product) {
    if (power.halves % 4 != 0) return std::nullopt;
    power.halves /= 2;
  }
  return product;
}

/// Takes k P² ± 2 k P Q + k Q² out of a longer sum: k (P ± Q)² is read sooner.
std::optional<Sum> take_square(Sum& rest) {
  constexpr std::size_t most = 60;  // terms: those of longer sums are named rather than read
  if (rest.size() > most) return std::nullopt;
  for (auto first = rest.terms().begin(); first != rest.terms().end(); ++first) {
    for (auto second = std::next(first); second != rest.terms().end(); ++second) {
      const std::optional<Product> middle = root_of(first->first * second->first);
      const auto cross = middle ? rest.terms().find(*middle) : rest.terms().end();
      if (cross == rest.terms().end()) continue;
      if (!(cross->second * cross->second - Number(4) * first->second * second->second).is_zero()) continue;
      Sum square;
      for (const auto& term : {first, second, cross}) square.add(term->first, term->second);
      rest += Number(-1) * square;
      return square;
    }
  }
  return std::nullopt;
}

/// Groups by what depends on the configuration, constants first, squares last. `one_term`: a lone sum of parameters is to
/// be a factor.
Written by_groups(Sum sum, bool one_term) {
  Written squares;
  while (const std::optional<Sum> square = take_square(sum)) squares.push_back(as_term(*square));
  if (!squares.empty()) {
    Written result = sum.is_zero() ? Written() : by_groups(sum, false);
    result.insert(result.end(), squares.begin(), squares.end());
    return result;
  }
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

bool moves_by_itself(const WrittenTerm& term) {
  return std::any_of(term.factors.begin(), term.factors.end(), [](const WrittenFactor& factor) {
    return factor.base && factor.base->kind == Base::Kind::symbol && factor.base->level == Level::configuration;
  });
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
  if (is_stretch(rest, true) && groups[0].coefficient.sign() > 0) {  // x + l, as where it is squared
    const auto moves = [](const WrittenTerm& each) { return moves_by_itself(each); };
    const auto first = std::find_if(groups.begin(), groups.end(), moves);
    if (first != groups.end() && first->coefficient.sign() > 0) std::stable_partition(groups.begin(), groups.end(), moves);
    term.factors.push_back(parenthesised(std::move(groups)));
    put_in_order(term.factors);
    return times(std::move(term), motion);
  }
  term.factors.push_back(parenthesised(std::move(groups)));
  return times(std::move(term), motion);
}

/// Whether a factor depends on the configuration by a function: what all terms share with it is taken out as it is before a
/// velocity.
bool varies(const Product& common) {
  return std::any_of(common.begin(), common.end(), [](const Power& power) {
    return power.base->level >= Level::configuration && power.base->kind != Base::Kind::symbol;
  });
}

bool is_negative(const Written& written) { return !written.empty() && written[0].coefficient.sign() < 0; }
void negate(Written& written) {
  for (WrittenTerm& term : written) term.coefficient = -term.coefficient;
}

/// −max(−a, −b) as min(a, b), wherever that takes minus signs away. The first term of a sum keeps its plus.
void name_minima(Written& written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    WrittenTerm& term = written[i];
    for (WrittenFactor& factor : term.factors) {
      name_minima(factor.inside);
      for (Written& other : factor.others) name_minima(other);
      const bool maximum = factor.base && factor.base->kind == Base::Kind::function &&
                           factor.base->function == Function::maximum && !factor.least && factor.others.size() == 1;
      if (!maximum || factor.halves % 2 != 0) continue;
      int fewer = 0;
      for (const Written* argument : {&factor.inside, &factor.others[0]}) {
        if (!argument->empty()) fewer += is_negative(*argument) ? 1 : -1;
      }
      const bool turns = factor.halves % 4 != 0, minus = term.coefficient.sign() < 0;
      if (turns) fewer += minus ? 1 : -1;
      if (fewer <= 0 || (turns && !minus && i == 0)) continue;
      factor.least = true;
      negate(factor.inside);
      negate(factor.others[0]);
      if (turns) term.coefficient = -term.coefficient;
    }
  }
}

bool is_call(const WrittenFactor& factor, Function function) {
  return factor.base && factor.base->kind == Base::Kind::function && factor.base->function == function &&
         factor.halves % 2 == 0;
}

/// sin x^n/cos x^n is tan x^n: no more factors, and one denominator less.
void name_tangents(Written& written) {
  for (WrittenTerm& term : written) {
    for (WrittenFactor& factor : term.factors) {
      name_tangents(factor.inside);
      for (Written& other : factor.others) name_tangents(other);
    }
    for (std::size_t i = 0; i < term.factors.size(); ++i) {
      WrittenFactor& sine = term.factors[i];
      if (!is_call(sine, Function::sin) || sine.tangent || sine.halves < 0) continue;
      const auto cosine = std::find_if(term.factors.begin(), term.factors.end(), [&](const WrittenFactor& other) {
        return is_call(other, Function::cos) && other.halves < 0 && -other.halves <= sine.halves &&
               compare(other.base->inside, sine.base->inside) == 0;
      });
      if (cosine == term.factors.end()) continue;
      const int rest = sine.halves + cosine->halves;
      sine.halves = -cosine->halves;
      sine.tangent = true;
      const auto place = static_cast<std::size_t>(cosine - term.factors.begin());
      WrittenFactor remaining = sine;
      term.factors.erase(cosine);
      if (rest == 0) continue;
      remaining.tangent = false;
      remaining.halves = rest;
      const std::size_t at = place < i ? i - 1 : i;
      term.factors.insert(term.factors.begin() + static_cast<std::ptrdiff_t>(at), remaining);
    }
  }
}

bool same(const Written& a, const Written& b);
bool same(const WrittenFactor& a, const WrittenFactor& b) {
  if (!a.base != !b.base || (a.base && compare(*a.base, *b.base) != 0)) return false;
  if (a.halves != b.halves || a.size != b.size || a.least != b.least || a.tangent != b.tangent) return false;
  return a.base || same(a.inside, b.inside);
}
bool same(const Written& a, const Written& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const WrittenTerm& x, const WrittenTerm& y) {
    return x.coefficient == y.coefficient && std::equal(x.factors.begin(), x.factors.end(), y.factors.begin(), y.factors.end(),
                                                        [](const auto& u, const auto& v) { return same(u, v); });
  });
}

/// Takes sums in parentheses that all terms share out of them.
std::vector<WrittenFactor> take_shared_sums(Written& terms) {
  std::vector<WrittenFactor> shared;
  const std::vector<WrittenFactor> candidates = terms[0].factors;
  for (const WrittenFactor& factor : candidates) {
    const auto is_it = [&](const WrittenFactor& other) { return same(other, factor); };
    const auto place = [&](WrittenTerm& term) { return std::find_if(term.factors.begin(), term.factors.end(), is_it); };
    const auto has_it = [&](WrittenTerm& term) { return place(term) != term.factors.end(); };
    if (factor.base || !std::all_of(terms.begin(), terms.end(), has_it)) continue;
    for (WrittenTerm& term : terms) term.factors.erase(place(term));
    shared.push_back(factor);
  }
  return shared;
}

bool has_parentheses(const Written& written) {
  return std::any_of(written.begin(), written.end(), [](const WrittenTerm& term) {
    return std::any_of(term.factors.begin(), term.factors.end(), [](const WrittenFactor& factor) { return !factor.base; });
  });
}

bool has_denominators(const Written& written) {
  return std::any_of(written.begin(), written.end(), [](const WrittenTerm& term) {
    return std::any_of(term.factors.begin(), term.factors.end(), [](const WrittenFactor& factor) { return factor.halves < 0; });
  });
}

/// b − a rather than −a + b.
void lead_by_plus(Written& written) {
  const auto is_plus = [](const WrittenTerm& term) { return term.coefficient.sign() > 0; };
  const auto first = std::find_if(written.begin(), written.end(), is_plus);
  if (first != written.end()) std::rotate(written.begin(), first, first + 1);
}

/// A lone sum needs no parentheses.
Written unwrapped(Written written) {
  if (written.size() != 1 || !written[0].coefficient.is_one() || written[0].factors.size() != 1) return written;
  const WrittenFactor& factor = written[0].factors[0];
  return factor.base || factor.halves != 2 || factor.size ? written : factor.inside;
}

}  // namespace

Written collected(const Sum& sum, const Layout& layout) {
  Groups groups;
  for (const auto& [product, coefficient] : sum.terms()) {
    const auto [motion, rest] = split(product, is_dynamic);
    groups[motion].add(rest, coefficient);
  }
  std::vector<std::pair<Product, Sum>> ordered(groups.begin(), groups.end());
  std::stable_sort(ordered.begin(), ordered.end(),
                   [&](const auto& a, const auto& b) { return rank(a.first, layout) < rank(b.first, layout); });
  Written result;
  auto put_whole = [&, done = false](bool now) mutable {
    if (now && !done) result.insert(result.end(), layout.whole.begin(), layout.whole.end());
    done = done || now;
  };
  for (const auto& [motion, coefficient] : ordered) {
    put_whole(std::get<0>(rank(motion, layout)) >= 2);
    if (motion.empty() && !varies(common_factor(coefficient))) {
      for (WrittenTerm& term : without_motion(coefficient)) result.push_back(std::move(term));
    } else {
      result.push_back(group_term(coefficient, motion));
    }
  }
  put_whole(true);
  result = unwrapped(std::move(result));
  name_minima(result);
  name_tangents(result);
  return result;
}

Written collected_entry(const Sum& sum) {
  Written whole = collected(sum);
  if (whole.size() < 2) return whole;
  const auto reacts = [](const auto& term) { return level(term.first) == Level::multiplier; };
  const auto reactions = std::count_if(sum.terms().begin(), sum.terms().end(), reacts);
  const bool alike = reactions == 0 || reactions == static_cast<std::ptrdiff_t>(sum.size());  // reactions stand beside the rest
  const Product common = alike ? common_factor(sum) : Product();
  const Number number = shared_number(sum);
  Sum rest;
  for (const auto& [product, value] : sum.terms()) rest.add(product * inverse(common), value / number);
  Written inside = collected(rest);
  const bool shares = alike && inside.size() > 1;
  const std::vector<WrittenFactor> sums = shares ? take_shared_sums(inside) : std::vector<WrittenFactor>();
  constexpr std::size_t most = 4;  // terms that are read within parentheses
  const bool readable = inside.size() > 1 && inside.size() <= most && !has_parentheses(inside) && !has_denominators(inside);
  if ((common.empty() && sums.empty()) || !readable) {
    if (whole.size() == 2) lead_by_plus(whole);
    return whole;
  }
  lead_by_plus(inside);
  WrittenTerm term{number, {}};
  if (is_negative(inside)) {
    term.coefficient = -term.coefficient;
    negate(inside);
  }
  const auto [motion, still] = split(common, is_dynamic);
  term.factors = sums;
  term = times(std::move(term), still);
  put_in_order(term.factors);
  term.factors.push_back(parenthesised(std::move(inside)));
  return {times(std::move(term), motion)};
}

}  // namespace torsor::printing
