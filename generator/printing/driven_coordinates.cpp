// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/driven_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace torsor::printing {
namespace {

constexpr int highest_power = 8;  // of a law in a sum: beyond it nobody sees the powers of a binomial
constexpr double weight_of_division = 20;  // a shorter formula that divides by what the longer one does not is no better

/// law = rest + slope · base^(halves/2): the base is time or a function of it, in the rest at most with a lower power.
struct LawByBase {
  BasePointer base;
  int halves = 2;
  Number coefficient;  ///< of the slope
  Product slope;
  Sum rest;
};

bool depends_on_time(const Base& base) {
  if (base.symbol) return base.symbol->kind == SymbolKind::time;
  const auto depends = [](const Sum& argument) { return depends_on_time(argument); };
  return depends(base.inside) || std::any_of(base.others.begin(), base.others.end(), depends);
}

bool depends_on_time(const Product& product) {
  return std::any_of(product.begin(), product.end(), [](const Power& power) { return depends_on_time(*power.base); });
}

/// The product without a base, and the halves of its exponent.
std::pair<Product, int> without(const Product& product, const Base& base) {
  Product rest;
  int halves = 0;
  for (const Power& power : product) {
    if (compare(*power.base, base) == 0) {
      halves = power.halves;
    } else {
      rest.push_back(power);
    }
  }
  return {std::move(rest), halves};
}

/// The law by the highest power of the first base that has one, beside constants; nothing where there is none.
std::optional<LawByBase> by_base(const Sum& law) {
  for (const auto& [product, coefficient] : law.terms()) {
    for (const Power& power : product) {
      if (power.halves < 2 || power.halves % 2 != 0 || !depends_on_time(*power.base)) continue;
      LawByBase result{power.base, power.halves, coefficient, without(product, *power.base).first, law};
      result.rest.add(product, -coefficient);
      const auto is_as_high = [&](const auto& term) { return without(term.first, *power.base).second >= power.halves; };
      const bool highest = std::none_of(result.rest.terms().begin(), result.rest.terms().end(), is_as_high);
      if (highest && !depends_on_time(result.slope)) return result;
    }
  }
  return std::nullopt;
}

/// The sum with powers of the base written by the name of the law, (name − rest)/slope; nothing where they are too high.
std::optional<Sum> by_name(Sum sum, const SymbolPointer& name, const LawByBase& law) {
  Product inverse_slope = law.slope;
  for (Power& power : inverse_slope) power.halves = -power.halves;
  Sum scaled, difference = Sum::symbol(name);
  scaled.add(inverse_slope, Number(1) / law.coefficient);
  difference += Number(-1) * law.rest;
  const Sum base = difference * scaled;
  for (int round = 0; round < highest_power; ++round) {
    Sum lower;
    bool found = false;
    for (const auto& [product, coefficient] : sum.terms()) {
      auto [rest, halves] = without(product, *law.base);
      Sum term;
      if (halves < law.halves) {
        term.add(product, coefficient);
        lower += term;
        continue;
      }
      found = true;
      term.add(rest, coefficient);
      Sum others{Number(1)};
      if (halves > law.halves) {
        others = Sum();
        others.add({{law.base, halves - law.halves}}, Number(1));
      }
      lower += term * others * base;
    }
    sum = std::move(lower);
    if (!found) return sum;
  }
  return std::nullopt;
}

double reading_length(const Sum& sum);

/// What a reader has to read of a factor, divisions with their weight.
double reading_length(const Power& power) {
  double base = 1;
  if (power.base->kind == Base::Kind::function || power.base->kind == Base::Kind::group) base += reading_length(power.base->inside);
  for (const Sum& other : power.base->others) base += reading_length(other);
  return (base + (power.halves < 0 ? weight_of_division : 0)) * std::abs(power.halves) / 2;
}

double reading_length(const Sum& sum) {
  double total = 0;
  for (const auto& [product, coefficient] : sum.terms()) {
    total += 1;
    for (const Power& power : product) total += reading_length(power);
  }
  return total;
}

}  // namespace

bool depends_on_time(const Sum& sum) {
  return std::any_of(sum.terms().begin(), sum.terms().end(), [](const auto& term) { return depends_on_time(term.first); });
}

Sum DrivenCoordinates::named_in_angle(Sum angle) const {
  for (const auto& [name, law] : laws_) {
    const auto& [first, coefficient] = *law.terms().begin();
    const auto place = angle.terms().find(first);
    if (place == angle.terms().end()) continue;
    const Number factor = place->second / coefficient;
    Sum rest = angle;
    rest += (-factor) * law;
    if (rest.size() + law.size() != angle.size()) continue;  // the angle has not all of the law in it
    rest += factor * Sum::symbol(name);
    angle = std::move(rest);
  }
  return angle;
}

Sum DrivenCoordinates::named(Sum sum) const {
  for (const auto& [name, law] : laws_) {
    const std::optional<LawByBase> base = by_base(law);
    if (!base) continue;
    std::optional<Sum> shorter = by_name(sum, name, *base);
    if (shorter && shorter->size() <= sum.size() && reading_length(*shorter) < reading_length(sum)) sum = std::move(*shorter);
  }
  return sum;
}

}  // namespace torsor::printing
