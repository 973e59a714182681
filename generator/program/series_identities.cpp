// SPDX-License-Identifier: GPL-3.0-or-later
// The part of series_lowering.hpp that knows sin² + cos² = 1, and sums of quotients in which it makes divisors cancel.
#include "torsor/generator/program/series_lowering.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace torsor {
namespace {

/// Longer sums are not brought over one divisor.
constexpr std::size_t longest_united = 8;

}  // namespace

void SeriesLowering::Product::multiply(int node, int exponent) {
  const auto place =
      std::lower_bound(powers.begin(), powers.end(), node, [](const Power& power, int n) { return power.node < n; });
  if (place == powers.end() || place->node != node) {
    powers.insert(place, {node, exponent});
  } else if ((place->exponent += exponent) == 0) {
    powers.erase(place);
  }
}

/// Adds to the product of the same powers, which goes when nothing is left of it.
void SeriesLowering::add(std::vector<Product>& sum, Product product) {
  const auto same =
      std::find_if(sum.begin(), sum.end(), [&](const Product& each) { return each.powers == product.powers; });
  if (same == sum.end()) {
    if (!product.coefficient.is_zero()) sum.push_back(std::move(product));
    return;
  }
  same->coefficient += product.coefficient;
  if (same->coefficient.is_zero()) sum.erase(same);
}

/// a sin² p + b cos² p = a p + (b - a) cos² p, for every product p.
void SeriesLowering::unite_squares(std::vector<Product>& products) const {
  if (!program_.passes().identities) return;
  for (std::size_t i = 0; i < products.size();) {
    const auto partner = [&](const Power& power) -> std::optional<Product> {
      const SeriesNode& node = nodes_[static_cast<std::size_t>(power.node)];
      if (power.exponent < 2 || node.kind != SeriesNode::Kind::sine) return std::nullopt;
      Product other = products[i];
      other.multiply(power.node, -2);
      other.multiply(*node.right, 2);
      return other;
    };
    const auto is_there = [&](const Product& other) {
      return std::any_of(products.begin(), products.end(),
                         [&](const Product& each) { return each.powers == other.powers; });
    };
    std::optional<Product> of_cosine, alone;
    for (const Power& power : products[i].powers) {
      of_cosine = partner(power);
      if (of_cosine && is_there(*of_cosine)) {
        alone = products[i];
        alone->multiply(power.node, -2);
        break;
      }
    }
    if (!alone) {
      ++i;
      continue;
    }
    products.erase(products.begin() + static_cast<std::ptrdiff_t>(i));
    of_cosine->coefficient *= Number(-1);
    add(products, std::move(*of_cosine));
    add(products, std::move(*alone));
    i = 0;
  }
}

void SeriesLowering::multiply_by_factors(Product& result, int node, int exponent) const {
  const SeriesNode& origin = nodes_[static_cast<std::size_t>(node)];
  if (origin.kind != SeriesNode::Kind::product && origin.kind != SeriesNode::Kind::quotient) {
    return result.multiply(node, exponent);
  }
  const bool divides = origin.kind == SeriesNode::Kind::quotient;
  if (origin.left) multiply_by_factors(result, *origin.left, exponent);
  multiply_by_factors(result, *origin.right, divides ? -exponent : exponent);
}

/// The same with what products and quotients among its factors are made of.
SeriesLowering::Product SeriesLowering::in_factors(const Product& product) const {
  Product result{product.coefficient, {}};
  for (const Power& power : product.powers) multiply_by_factors(result, power.node, power.exponent);
  return result;
}

/// p / d + q = (p + q d) / d where a single product is left of p + q d: so are pivots of mass matrices of bodies of
/// revolution, whose reciprocals then are products.
void SeriesLowering::unite_quotients(std::vector<Product>& products) const {
  if (!program_.passes().identities || products.size() < 2 || products.size() > longest_united) return;
  std::vector<Product> factored;
  for (const Product& each : products) factored.push_back(in_factors(each));
  std::optional<int> divisor;
  for (const Product& each : factored) {
    for (const Power& power : each.powers) {
      const bool sum = nodes_[static_cast<std::size_t>(power.node)].kind == SeriesNode::Kind::sum;
      if (power.exponent < 0 && sum) divisor = power.node;
    }
  }
  if (!divisor) return;
  const SeriesForm& form = nodes_[static_cast<std::size_t>(*divisor)].form;
  std::vector<Product> dividend;
  for (const Product& each : factored) {
    const bool divided = std::any_of(each.powers.begin(), each.powers.end(), [divisor](const Power& power) {
      return power.node == *divisor && power.exponent < 0;
    });
    if (divided) {
      Product whole = each;
      whole.multiply(*divisor, 1);
      add(dividend, std::move(whole));
      continue;
    }
    add(dividend, {product_of(each.coefficient, form.constant), each.powers});
    for (const SeriesForm::Term& term : form.terms) {
      Product longer{product_of(each.coefficient, term.coefficient), each.powers};
      multiply_by_factors(longer, term.node, 1);
      add(dividend, std::move(longer));
    }
  }
  unite_squares(dividend);
  if (dividend.size() > 1) return;
  if (!dividend.empty()) dividend[0].multiply(*divisor, -1);
  products = std::move(dividend);
}

}  // namespace torsor
