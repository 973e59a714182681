// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/unit_quaternions.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace torsor::printing {
namespace {

using Attitude = std::shared_ptr<const AttitudeSymbols>;

/// The quaternion of which a factor is a component, under a whole positive power; null for any other factor.
Attitude attitude_of(const Power& power) {
  const bool component = power.base->kind == Base::Kind::symbol && power.halves > 0 && power.halves % 2 == 0;
  return component ? power.base->symbol->attitude.lock() : nullptr;
}

/// The quaternions in a sum, by order of creation in the scene.
std::vector<Attitude> attitudes(const Sum& sum) {
  std::vector<Attitude> found;
  for (const auto& [product, coefficient] : sum.terms()) {
    for (const Power& power : product) {
      const Attitude attitude = attitude_of(power);
      if (attitude && std::find(found.begin(), found.end(), attitude) == found.end()) found.push_back(attitude);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Attitude& a, const Attitude& b) { return a->e[0]->index < b->e[0]->index; });
  return found;
}

/// A polynomial in the components of one quaternion without the square of component k.
Sum without_square(const Sum& sum, const AttitudeSymbols& attitude, std::size_t k) {
  Sum square{Number(1)};
  for (std::size_t j = 0; j < 4; ++j) {
    if (j != k) square += Number(-1) * power(Sum::symbol(attitude.e[j]), 4);
  }
  Sum result;
  for (const auto& [product, coefficient] : sum.terms()) {
    Sum term{coefficient};
    for (const Power& factor : product) {
      const bool squared = factor.base->kind == Base::Kind::symbol && factor.base->symbol == attitude.e[k] &&
                           factor.halves >= 4 && factor.halves % 2 == 0;
      Sum by;
      by.add({{factor.base, squared ? 2 : factor.halves}}, Number(1));
      if (!squared) {
        term = term * by;
        continue;
      }
      term = term * power(square, 2 * (factor.halves / 4));
      if (factor.halves % 4 != 0) term = term * by;
    }
    result += term;
  }
  return result;
}

Sum shortest(const Sum& sum, const AttitudeSymbols& attitude) {
  Sum best = sum;
  for (std::size_t k = 0; k < 4; ++k) {
    const Sum candidate = without_square(sum, attitude, k);
    if (candidate.size() < best.size()) best = candidate;
  }
  return best;
}

}  // namespace

Sum with_unit_quaternions(const Sum& sum) {
  Sum result = sum;
  for (const Attitude& attitude : attitudes(sum)) {
    std::map<Product, Sum, ProductOrder> groups;  // by what stands beside the components of this quaternion
    for (const auto& [product, coefficient] : result.terms()) {
      Product components, rest;
      for (const Power& power : product) (attitude_of(power) == attitude ? components : rest).push_back(power);
      groups[rest].add(components, coefficient);
    }
    result = Sum();
    for (const auto& [rest, polynomial] : groups) {
      Sum beside;
      beside.add(rest, Number(1));
      result += beside * shortest(polynomial, *attitude);
    }
  }
  return result;
}

}  // namespace torsor::printing
