// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <optional>
#include <variant>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/polynomial.hpp"

namespace torsor {

/// Two factors of a product: a value number, and another (perhaps the same) or a positive number other than one.
struct FactorPair {
  ValueNumber first;
  std::variant<Number, ValueNumber> second;  ///< a value number is not before the first

  /// The other value number, if there is one.
  const ValueNumber* other() const { return std::get_if<ValueNumber>(&second); }

  friend std::strong_ordering operator<=>(const FactorPair& a, const FactorPair& b) = default;
  friend bool operator==(const FactorPair& a, const FactorPair& b) = default;

  Polynomial product() const;
  /// The sum with the value number `product` for the pair, wherever a term multiplies both.
  Polynomial replaced(const Polynomial& sum, ValueNumber product) const;
};

/// The pair of which a sum is the product.
std::optional<FactorPair> as_pair(const Polynomial& sum);

/// Appends the pairs that a formula multiplies, once for each time.
void add_pairs(const Formula& formula, std::vector<FactorPair>& pairs);

/// Whether two formulas differ in nothing but `product` for the pair, and the order of terms and factors: the same sums
/// are formed, with the same signs, before they are multiplied: the same roundings but for those of the products.
bool same_factoring(const Formula& before, const Formula& after, const FactorPair& pair, ValueNumber product);

}  // namespace torsor
