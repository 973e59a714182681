// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/knots.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace torsor::printing {
namespace {

bool is_selection(const Base& base) {
  return base.kind == Base::Kind::function && base.function == Function::select && base.others.size() == 2;
}

/// {what varies, the number beside it}.
std::pair<Sum, Number> without_number(const Sum& sum) {
  Sum rest;
  Number number;
  for (const auto& [product, coefficient] : sum.terms()) {
    if (product.empty()) {
      number = coefficient;
    } else {
      rest.add(product, coefficient);
    }
  }
  return {rest, number};
}

/// The lowest form of [higher if x − k >= 0, else lower], where every k is the lowest form above it: then it is x rounded
/// down to a knot. `x` is found on the way.
std::optional<Number> lowest_knot(const Sum& form, std::optional<Sum>& x) {
  const auto [varying, number] = without_number(form);
  if (varying.is_zero()) return number;
  const auto& [product, coefficient] = *varying.terms().begin();
  const bool alone = number.is_zero() && varying.size() == 1 && coefficient.is_one() && product.size() == 1 &&
                     product[0].halves == 2 && is_selection(*product[0].base);
  if (!alone) return std::nullopt;
  const Base& selection = *product[0].base;
  const std::optional<Number> knot = lowest_knot(selection.others[0], x);
  if (!knot) return std::nullopt;
  Sum above = selection.inside;
  above += Sum(*knot);
  if (x && compare(*x, above) != 0) return std::nullopt;
  x = std::move(above);
  return lowest_knot(selection.others[1], x);
}

Sum sum_of(const BasePointer& base) {
  Sum sum;
  sum.add({{base, 2}}, Number(1));
  return sum;
}

/// What x is where the base is its knot.
std::optional<Sum> rounded_down(const BasePointer& base) {
  std::optional<Sum> x;
  return is_selection(*base) && lowest_knot(sum_of(base), x) ? x : std::nullopt;
}

/// The sum with `value` for whole positive powers of a base; nothing where it has others.
std::optional<Sum> replaced(const Sum& sum, const Base& base, const Sum& value) {
  Sum result;
  for (const auto& [product, coefficient] : sum.terms()) {
    Product rest = product;
    const auto place = std::find_if(rest.begin(), rest.end(), [&](const Power& p) { return compare(*p.base, base) == 0; });
    if (place == rest.end()) {
      result.add(product, coefficient);
      continue;
    }
    const int halves = place->halves;
    if (halves < 0 || halves % 2 != 0) return std::nullopt;
    rest.erase(place);
    Sum term;
    term.add(rest, coefficient);
    result += term * power(value, halves);
  }
  return result;
}

}  // namespace

Sum Knots::named(Sum sum) {
  std::vector<BasePointer> bases;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      if (!is_selection(*power.base)) continue;
      const bool known =
          std::any_of(bases.begin(), bases.end(), [&](const BasePointer& b) { return compare(*b, *power.base) == 0; });
      if (!known) bases.push_back(power.base);
    }
  }
  for (const BasePointer& base : bases) {
    const std::optional<Sum> x = rounded_down(base);
    if (!x) continue;
    auto place = std::find_if(distances_.begin(), distances_.end(),
                              [&](const Distance& distance) { return compare(*distance.knot, *base) == 0; });
    const bool is_new = place == distances_.end();
    const Sum name = is_new ? Sum::definition(-1 - static_cast<int>(distances_.size())) : place->name;
    Sum knot = *x;
    knot += Number(-1) * name;
    std::optional<Sum> shorter = replaced(sum, *base, knot);
    if (!shorter || shorter->size() >= sum.size()) continue;
    sum = std::move(*shorter);
    Sum value = *x;
    value += Number(-1) * sum_of(base);
    if (is_new) distances_.push_back({base, name, std::move(value)});
  }
  return sum;
}

Sum Knots::put_back(const Sum& sum) const {
  Sum result = sum;
  for (const Distance& distance : distances_) {
    Base group;
    group.kind = Base::Kind::group;
    group.level = level(distance.value);
    group.inside = distance.value;
    const BasePointer base = std::make_shared<const Base>(std::move(group));
    const Base& name = *distance.name.terms().begin()->first[0].base;
    Sum with_values;
    for (const auto& [product, coefficient] : result.terms()) {
      Product rest = product;
      const auto place = std::find_if(rest.begin(), rest.end(), [&](const Power& p) { return compare(*p.base, name) == 0; });
      if (place == rest.end()) {
        with_values.add(product, coefficient);
        continue;
      }
      const int halves = place->halves;
      rest.erase(place);
      with_values.add(rest * Product{{base, halves}}, coefficient);
    }
    result = std::move(with_values);
  }
  return result;
}

}  // namespace torsor::printing
