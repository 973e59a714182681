// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/expression/symbol.hpp"

// The inline view of a quantity in an order of our own. GiNaC orders terms, and chooses some signs, by addresses; what
// a person reads must be the same in every run, so whatever GiNaC returns is brought into this form before it is
// printed.

namespace torsor::printing {

/// What a quantity depends on at most, from what never changes to what is chosen at each call. Terms of a sum are
/// written from the highest level down, factors of a product from the lowest up.
enum class Level { constant, parameter, definition, configuration, velocity, acceleration, input, multiplier };

struct Base;
using BasePointer = std::shared_ptr<const Base>;

/// base^(halves/2).
struct Power {
  BasePointer base;
  int halves = 2;
};

/// Powers of distinct bases, highest level first, then by order of creation in the scene; empty for 1.
using Product = std::vector<Power>;

std::strong_ordering compare(const Base& a, const Base& b);
std::strong_ordering compare(const Product& a, const Product& b);

struct ProductOrder {
  bool operator()(const Product& a, const Product& b) const { return compare(a, b) < 0; }
};

/// Σ coefficient · product with distinct products and no zero, in the order of `compare`: equal sums are equal objects.
class Sum {
 public:
  using Terms = std::map<Product, Number, ProductOrder>;

  Sum() = default;
  explicit Sum(const Number& constant) { add({}, constant); }

  static Sum symbol(const SymbolPointer& symbol);
  /// The k-th named definition of a long result.
  static Sum definition(int k);
  /// f(arguments); signs leave odd and even functions, so that the first term of their (first) argument is positive.
  static Sum function(Function function, const Sum& argument) { return Sum::function(function, std::vector{argument}); }
  static Sum function(Function function, const std::vector<Sum>& arguments);

  const Terms& terms() const { return terms_; }
  std::size_t size() const { return terms_.size(); }
  bool is_zero() const { return terms_.empty(); }
  void add(const Product& product, const Number& coefficient);

  Sum& operator+=(const Sum& other);
  friend Sum operator*(const Number& factor, const Sum& sum);
  friend Sum operator*(const Sum& a, const Sum& b);

 private:
  Terms terms_;
};

std::strong_ordering compare(const Sum& a, const Sum& b);

/// sum^(halves/2). A sum under a negative or odd power becomes one base: for a whole power its rational content and
/// the sign of its first term come out of it, so that 1/(x − y) and −1/(y − x) are the same object.
Sum power(const Sum& sum, int halves);

/// One factor of a product: a symbol, a named definition, a function of a sum, or a sum that keeps its own power.
struct Base {
  enum class Kind { symbol, definition, function, group };

  Kind kind = Kind::symbol;
  Level level = Level::constant;
  SymbolPointer symbol;  ///< of a symbol
  int definition = 0;    ///< number of a definition
  Function function{};   ///< of a function
  Sum inside;            ///< (first) argument of a function, the sum of a group
  std::vector<Sum> others{};  ///< further arguments of a function
};

/// Terms that a reader meets: those of the sum, and those of every longer sum that stands inside a function, a root or a
/// denominator. Roots and denominators that occur again have a name and count once.
std::size_t written_terms(const Sum& sum);

/// Adds the symbols that stand in a sum. The set is for looking up.
void add_symbols(const Sum& sum, std::set<const Symbol*>& symbols);

/// The highest level in a product or a sum; constant for a number.
Level level(const Product& product);
Level level(const Sum& sum);

Product operator*(const Product& a, const Product& b);

}  // namespace torsor::printing
