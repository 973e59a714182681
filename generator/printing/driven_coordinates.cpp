// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/driven_coordinates.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace torsor::printing {
namespace {

constexpr int highest_power = 8;  // of a law in a sum: beyond it nobody sees the powers of a binomial

/// law = rest + slope · base: the base is time or a function of it.
struct AffineLaw {
  BasePointer base;
  Number coefficient;  ///< of the slope
  Product slope;
  Sum rest;
};

bool depends_on_time(const Sum& sum);

bool depends_on_time(const Base& base) {
  if (base.symbol) return base.symbol->kind == SymbolKind::time;
  const auto depends = [](const Sum& argument) { return depends_on_time(argument); };
  return depends(base.inside) || std::any_of(base.others.begin(), base.others.end(), depends);
}

bool depends_on_time(const Product& product) {
  return std::any_of(product.begin(), product.end(), [](const Power& power) { return depends_on_time(*power.base); });
}

bool depends_on_time(const Sum& sum) {
  return std::any_of(sum.terms().begin(), sum.terms().end(), [](const auto& term) { return depends_on_time(term.first); });
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

/// The law by the first base that one of its terms alone has, once, beside constants.
std::optional<AffineLaw> affine(const Sum& law) {
  for (const auto& [product, coefficient] : law.terms()) {
    for (const Power& power : product) {
      if (power.halves != 2 || !depends_on_time(*power.base)) continue;
      AffineLaw result{power.base, coefficient, without(product, *power.base).first, law};
      result.rest.add(product, -coefficient);
      const auto has_base = [&](const auto& term) { return without(term.first, *power.base).second != 0; };
      const bool alone = std::none_of(result.rest.terms().begin(), result.rest.terms().end(), has_base);
      if (alone && !depends_on_time(result.slope)) return result;
    }
  }
  return std::nullopt;
}

/// The sum with the base written by the name of the law, (name − rest)/slope; nothing where it has another than a whole,
/// positive power.
std::optional<Sum> by_name(const Sum& sum, const SymbolPointer& name, const AffineLaw& law) {
  Product inverse_slope = law.slope;
  for (Power& power : inverse_slope) power.halves = -power.halves;
  Sum scaled;
  scaled.add(inverse_slope, Number(1) / law.coefficient);
  Sum difference = Sum::symbol(name);
  difference += Number(-1) * law.rest;
  const Sum base = difference * scaled;
  std::vector<Sum> powers{Sum(Number(1))};
  Sum result;
  for (const auto& [product, coefficient] : sum.terms()) {
    const auto [rest, halves] = without(product, *law.base);
    if (halves < 0 || halves % 2 != 0 || halves > 2 * highest_power) return std::nullopt;
    while (powers.size() <= static_cast<std::size_t>(halves / 2)) powers.push_back(powers.back() * base);
    Sum term;
    term.add(rest, coefficient);
    result += term * powers[static_cast<std::size_t>(halves / 2)];
  }
  return result;
}

}  // namespace

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
    const std::optional<AffineLaw> affine_law = affine(law);
    if (!affine_law) continue;
    std::optional<Sum> shorter = by_name(sum, name, *affine_law);
    if (shorter && shorter->size() < sum.size()) sum = std::move(*shorter);
  }
  return sum;
}

}  // namespace torsor::printing
