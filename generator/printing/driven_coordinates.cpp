// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/driven_coordinates.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

namespace torsor::printing {
namespace {

constexpr int highest_power = 8;  // of a law in a sum: beyond it nobody sees the powers of a binomial
constexpr std::size_t most_growth = 16;  // of the terms of a sum while a law is put in

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
    if (lower.size() > most_growth * (sum.size() + 1)) return std::nullopt;
    sum = std::move(lower);
    if (!found) return sum;
  }
  return std::nullopt;
}

std::size_t reading_length(const Sum& sum);

/// What a reader has to read of a factor.
std::size_t reading_length(const Power& power) {
  std::size_t base = 1;
  if (power.base->kind == Base::Kind::function || power.base->kind == Base::Kind::group) {
    base += reading_length(power.base->inside);
  }
  for (const Sum& other : power.base->others) base += reading_length(other);
  return base * static_cast<std::size_t>(std::abs(power.halves));
}

std::size_t reading_length(const Sum& sum) {
  std::size_t total = 0;
  for (const auto& [product, coefficient] : sum.terms()) {
    total += 2;
    for (const Power& power : product) total += reading_length(power);
  }
  return total;
}

/// The lowest exponent of a base in a sum, in halves, 0 at most.
int lowest_halves(const Sum& sum, const Base& base) {
  int lowest = 0;
  for (const auto& [product, coefficient] : sum.terms()) lowest = std::min(lowest, without(product, base).second);
  return lowest;
}

/// Whether `shorter` divides by nothing that `sum` does not divide by as often.
bool divides_no_more(const Sum& shorter, const Sum& sum) {
  for (const auto& [product, coefficient] : shorter.terms()) {
    for (const Power& power : product) {
      if (power.halves < 0 && power.halves < lowest_halves(sum, *power.base)) return false;
    }
  }
  return true;
}

/// The sum by the factors that are neither constants nor functions of time: what stands with each of them.
std::map<Product, Sum, ProductOrder> by_other_factors(const Sum& sum) {
  std::map<Product, Sum, ProductOrder> parts;
  for (const auto& [product, coefficient] : sum.terms()) {
    Product others, of_time;
    for (const Power& power : product) {
      const bool inner = power.base->level <= Level::parameter || depends_on_time(*power.base);
      (inner ? of_time : others).push_back(power);
    }
    parts[others].add(of_time, coefficient);
  }
  return parts;
}

}  // namespace

bool depends_on_time(const Sum& sum) {
  return std::any_of(sum.terms().begin(), sum.terms().end(), [](const auto& term) { return depends_on_time(term.first); });
}

void DrivenCoordinates::add(SymbolPointer name, Sum law, bool stands) {
  std::optional<LawByBase> base = stands ? by_base(law) : std::nullopt;
  laws_.push_back({std::move(name), std::move(law), stands, std::move(base)});
}

std::optional<Sum> DrivenCoordinates::law(const SymbolPointer& name) const {
  const auto of = std::find_if(laws_.begin(), laws_.end(), [&](const Law& each) { return each.name == name; });
  return of == laws_.end() ? std::nullopt : std::optional(of->written);
}

Sum DrivenCoordinates::named_in_angle(Sum angle) const {
  for (const auto& [name, law, stands, base] : laws_) {
    if (!stands) continue;
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
  if (laws_.empty()) return sum;
  for (bool changed = true; changed && depends_on_time(sum);) {
    changed = false;
    Sum whole;
    for (auto& [others, part] : by_other_factors(sum)) {
      std::optional<Sum> best;
      for (const auto& [name, law, stands, base] : laws_) {
        std::optional<Sum> shorter = base && depends_on_time(part) ? by_name(part, name, *base) : std::nullopt;
        if (!shorter || shorter->size() > part.size() || !divides_no_more(*shorter, part)) continue;
        if (reading_length(*shorter) < reading_length(best ? *best : part)) best = std::move(shorter);
      }
      changed = changed || best;
      Sum factor;
      factor.add(others, Number(1));
      whole += (best ? *best : part) * factor;
    }
    sum = std::move(whole);
  }
  return sum;
}

}  // namespace torsor::printing
