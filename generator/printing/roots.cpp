// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/roots.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/printing/factoring.hpp"

namespace torsor::printing {
namespace {

/// Whether no run can change the value of a formula: it holds no parameter that is given at run time, itself or by way of
/// others.
bool is_fixed(const SceneContent& scene, const Expression& formula) {
  return std::all_of(scene.parameters.begin(), scene.parameters.end(), [&](const ParameterContent& p) {
    return !formula.depends_on(p.symbol) || (p.value && !p.run_time && is_fixed(scene, *p.value));
  });
}

bool is_positive(const Base& base, const PositiveSymbols& positive) {
  if (base.kind == Base::Kind::symbol) return positive.contains(base.symbol.get());
  return base.kind == Base::Kind::function && base.function == Function::exp;
}

/// Of a product the squares of what is positive; {those, the rest}.
std::pair<Product, Product> split_squares(const Product& product, const PositiveSymbols& positive) {
  Product squares, rest = product;
  for (const Power& power : product) {
    const int whole = power.halves / 4 * 4;
    if (whole == 0 || power.halves % 2 != 0 || !is_positive(*power.base, positive)) continue;
    squares.push_back({power.base, whole});
  }
  return {squares, rest * inverse(squares)};
}

bool all_positive(const Sum& sum, const PositiveSymbols& positive) {
  return std::all_of(sum.terms().begin(), sum.terms().end(), [&](const auto& term) {
    return term.second.sign() > 0 && std::all_of(term.first.begin(), term.first.end(), [&](const Power& power) {
             return is_positive(*power.base, positive);
           });
  });
}

/// Of a number what leaves a root as a rational: 2 of 8 = 2² · 2.
Number root_of_square(const Number& number) {
  for (const long rest : {1, 2, 3, 6}) {
    const std::optional<Number> root = (number / Number(rest)).square_root();
    if (root && root->is_rational()) return *root;
  }
  return Number(1);
}

/// The base whose square is all that stands under a root; none for any other factor.
BasePointer rooted_square(const Power& power) {
  if (power.base->kind != Base::Kind::group || power.halves % 2 == 0 || power.base->inside.size() != 1) return nullptr;
  const auto& [product, coefficient] = *power.base->inside.terms().begin();
  return coefficient.is_one() && product.size() == 1 && product[0].halves == 4 ? product[0].base : nullptr;
}

}  // namespace

PositiveSymbols positive_parameters(const SceneContent& scene) {
  PositiveSymbols positive;
  for (const ParameterContent& parameter : scene.parameters) {
    if (parameter.run_time || !parameter.value || !is_fixed(scene, *parameter.value)) continue;
    if (parameter_value(scene, *parameter.value) > Real(0)) positive.insert(parameter.symbol.get());
  }
  return positive;
}

Sum root(const Sum& sum, int halves, const PositiveSymbols& positive) {
  if (sum.is_zero()) return power(sum, halves);
  // What all terms share: a product, and the square of a rational. √2 stays under the root: √(2 x + 2 y).
  const Product common = sum.size() == 1 ? sum.terms().begin()->first : common_factor(sum);
  Product outside = split_squares(common, positive).first;
  const Number number = sum.size() == 1 ? Number(1) : root_of_square(shared_number(sum));
  Sum inside;
  for (const auto& [product, coefficient] : sum.terms()) {
    inside.add(product * inverse(outside), coefficient / (number * number));
  }
  for (Power& power : outside) power.halves = power.halves / 2 * halves;
  Sum result;
  result.add(outside, number.pow(halves));
  const std::optional<Sum> known = square_root(inside);
  return result * (known && all_positive(*known, positive) ? power(*known, 2 * halves) : power(inside, halves));
}

Sum with_squares_beside_roots(const Sum& sum) {
  Sum result;
  for (const auto& [product, coefficient] : sum.terms()) {
    Product apart = product;
    for (const Power& power : product) {
      const BasePointer base = rooted_square(power);
      if (!base || power.halves < 0) continue;
      apart = apart * Product{{power.base, -power.halves - 1}} * Product{{base, 2 * power.halves + 2}};
    }
    result.add(apart, coefficient);
  }
  return result;
}

Sum with_squares_in_roots(const Sum& sum) {
  Sum result;
  for (const auto& [product, coefficient] : sum.terms()) {
    Product absorbed = product;
    for (const Power& power : product) {
      const BasePointer base = rooted_square(power);
      if (!base || power.halves > 0) continue;
      const auto beside = std::find_if(product.begin(), product.end(),
                                       [&](const Power& other) { return compare(*other.base, *base) == 0; });
      if (beside == product.end() || beside->halves < 4) continue;
      const int squares = std::min(beside->halves / 4, (1 - power.halves) / 2);
      absorbed = absorbed * Product{{power.base, 2 * squares}} * Product{{base, -4 * squares}};
    }
    result.add(absorbed, coefficient);
  }
  return result;
}

}  // namespace torsor::printing
