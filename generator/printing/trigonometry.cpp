// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/trigonometry.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace torsor::printing {
namespace {

/// Above this many terms only the greedy search is made: the normal forms would cost more than they save.
constexpr std::size_t normal_form_limit = 2000;

bool is(const Power& power, Function function) {
  return power.base->kind == Base::Kind::function && power.base->function == function && power.halves % 2 == 0;
}
bool trigonometric(const Power& power) { return is(power, Function::sin) || is(power, Function::cos); }

Function other(Function function) { return function == Function::sin ? Function::cos : Function::sin; }

/// The twin of a sine or cosine: the other function of the same argument. The argument is already in normal form.
Product twin(const Power& power, int halves) {
  Base base = *power.base;
  base.function = other(base.function);
  return {{std::make_shared<const Base>(std::move(base)), halves}};
}

Product without(const Product& product, const Power& power, int halves) {
  return product * Product{{power.base, -halves}};
}

std::optional<Number> coefficient(const Sum& sum, const Product& product) {
  const auto place = sum.terms().find(product);
  if (place == sum.terms().end()) return std::nullopt;
  return place->second;
}

/// coefficient · product · by.
struct MergedTerm {
  Number coefficient;
  Product product;
  Sum by;
};

/// Replaces two terms by one.
void merge(Sum& sum, const Product& first, const Product& second, const MergedTerm& merged) {
  sum.add(first, -*coefficient(sum, first));
  sum.add(second, -*coefficient(sum, second));
  Sum factor;
  factor.add(merged.product, merged.coefficient);
  sum += factor * merged.by;
}

/// a m sin² + a m cos² = a m.
bool pythagoras(Sum& sum, const Product& product, const Number& a) {
  for (const Power& power : product) {
    if (!is(power, Function::sin) || power.halves < 4) continue;
    const Product common = without(product, power, 4);
    const Product mate = common * twin(power, 4);
    const std::optional<Number> b = coefficient(sum, mate);
    if (!b || *b != a) continue;
    merge(sum, product, mate, {a, common, Sum(Number(1))});
    return true;
  }
  return false;
}

/// a m − a m sin² = a m cos², and with the functions exchanged.
bool complement(Sum& sum, const Product& product, const Number& a) {
  for (const Power& power : product) {
    if (!trigonometric(power) || power.halves < 4) continue;
    const Product common = without(product, power, 4);
    const std::optional<Number> b = coefficient(sum, common);
    if (!b || *b != -a) continue;
    Sum square;
    square.add(twin(power, 4), Number(1));
    merge(sum, product, common, {-a, common, square});
    return true;
  }
  return false;
}

/// a m cos² − a m sin² = a m cos of the double angle.
bool double_angle(Sum& sum, const Product& product, const Number& a) {
  for (const Power& power : product) {
    if (!is(power, Function::cos) || power.halves < 4) continue;
    const Product common = without(product, power, 4);
    const Product mate = common * twin(power, 4);
    const std::optional<Number> b = coefficient(sum, mate);
    if (!b || *b != -a) continue;
    merge(sum, product, mate, {a, common, Sum::function(Function::cos, Number(2) * power.base->inside)});
    return true;
  }
  return false;
}

/// cos a cos b ± sin a sin b = cos(a ∓ b) and sin a cos b ± cos a sin b = sin(a ± b), each with a common factor.
bool addition(Sum& sum, const Product& product, const Number& a) {
  for (std::size_t i = 0; i < product.size(); ++i) {
    if (!trigonometric(product[i]) || product[i].halves < 2) continue;
    for (std::size_t j = i + 1; j < product.size(); ++j) {
      if (!trigonometric(product[j]) || product[j].halves < 2) continue;
      if (compare(product[i].base->inside, product[j].base->inside) == 0) continue;
      const Product common = without(without(product, product[i], 2), product[j], 2);
      const Product mate = common * twin(product[i], 2) * twin(product[j], 2);
      const std::optional<Number> b = coefficient(sum, mate);
      if (!b || (*b != a && *b != -a)) continue;
      const bool same = *b == a;
      const bool cosine = product[i].base->function == product[j].base->function;
      // The difference is taken as (argument of the sine) − (argument of the cosine) when the functions differ.
      const bool swapped = !cosine && product[i].base->function == Function::cos;
      const Sum& first = product[swapped ? j : i].base->inside;
      const Sum& second = product[swapped ? i : j].base->inside;
      const bool plus = cosine ? !same : same;
      Sum argument = first;
      argument += Number(plus ? 1 : -1) * second;
      Number sign = a;
      // sin a sin b is the first term of the pair: cos a cos b has the coefficient b.
      if (cosine && product[i].base->function == Function::sin && !same) sign = *b;
      merge(sum, product, mate, {sign, common, Sum::function(cosine ? Function::cos : Function::sin, argument)});
      return true;
    }
  }
  return false;
}

/// Applies a rule until it applies nowhere; each success restarts at the first term, and merges two terms.
template <class Rule>
bool exhaust(Sum& sum, const Rule& rule) {
  bool changed = false;
  for (bool again = true; again;) {
    again = false;
    std::vector<std::pair<Product, Number>> terms(sum.terms().begin(), sum.terms().end());
    for (const auto& [product, number] : terms) {
      const std::optional<Number> now = coefficient(sum, product);
      if (now && rule(sum, product, *now)) again = changed = true;
    }
  }
  return changed;
}

Sum greedy(Sum sum) {
  for (bool again = true; again;) {
    exhaust(sum, pythagoras);
    again = exhaust(sum, addition);
    again = exhaust(sum, complement) || again;
    again = exhaust(sum, double_angle) || again;
  }
  return sum;
}

/// Replaces the square of one function everywhere: unique modulo sin² + cos² = 1.
Sum without_squares(const Sum& sum, Function function) {
  Sum result;
  for (const auto& [product, number] : sum.terms()) {
    Sum term{number};
    for (const Power& power : product) {
      Sum factor;
      if (is(power, function) && power.halves >= 4) {
        Sum square{Number(1)};
        square.add(twin(power, 4), Number(-1));
        factor = printing::power(square, 2 * (power.halves / 4));
        Sum rest{Number(1)};
        if (power.halves % 4 != 0) rest = Sum::function(function, power.base->inside);
        factor = factor * rest;
      } else {
        factor.add({power}, Number(1));
      }
      term = term * factor;
    }
    result += term;
  }
  return result;
}

/// sin 2x as 2 sin x cos x beside such products: 2 A cos x sin x − C sin 2x is 2 (A − C) cos x sin x.
Sum without_double_sines(const Sum& sum) {
  std::set<Product, ProductOrder> beside;  // cos x sin x
  for (const auto& [product, number] : sum.terms()) {
    for (const Power& power : product) {
      if (!is(power, Function::sin) || power.halves < 2) continue;
      const Product cosine = twin(power, 2);
      const bool pair = std::any_of(product.begin(), product.end(), [&](const Power& other) {
        return other.halves >= 2 && compare(*other.base, *cosine[0].base) == 0;
      });
      if (pair) beside.insert(Product{{power.base, 2}} * cosine);
    }
  }
  if (beside.empty()) return sum;
  Sum result;
  for (const auto& [product, number] : sum.terms()) {
    Sum term;
    const auto doubled = std::find_if(product.begin(), product.end(), [&](const Power& power) {
      if (!is(power, Function::sin) || power.halves != 2) return false;
      const Sum half = Number::rational(1, 2) * power.base->inside;
      const Sum pair = Sum::function(Function::sin, half) * Sum::function(Function::cos, half);
      return beside.count(pair.terms().begin()->first) > 0;
    });
    if (doubled == product.end()) {
      term.add(product, number);
    } else {
      const Sum half = Number::rational(1, 2) * doubled->base->inside;
      term.add(without(product, *doubled, 2), Number(2) * number);
      term = term * (Sum::function(Function::sin, half) * Sum::function(Function::cos, half));
    }
    result += term;
  }
  return result;
}

}  // namespace

Sum simplified(const Sum& sum) {
  Sum best = greedy(sum);
  if (sum.size() > normal_form_limit) return best;
  for (const Function function : {Function::sin, Function::cos}) {
    const Sum candidate = greedy(without_squares(sum, function));
    if (candidate.size() < best.size()) best = candidate;
  }
  if (const Sum candidate = without_double_sines(best); candidate.size() <= best.size()) return candidate;
  return best;
}

}  // namespace torsor::printing
