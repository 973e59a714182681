// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// Place of a symbol or of a definition in its program. Creation order is the canonical order of everything.
using ValueNumber = std::int32_t;

/// value number^exponent; a negative exponent divides.
struct Factor {
  ValueNumber value_number = 0;
  std::int32_t exponent = 1;
  friend auto operator<=>(const Factor&, const Factor&) = default;
};

/// A product of powers of distinct value numbers, sorted by value number; empty for 1.
using Monomial = std::vector<Factor>;

Monomial operator*(const Monomial& a, const Monomial& b);
Monomial pow(const Monomial& base, int exponent);

struct Term {
  Monomial monomial;
  Number coefficient;
  friend bool operator==(const Term&, const Term&) = default;
};

/// A flat sum of monomials with exact coefficients: the only shape a definition may have.
///
/// Terms are sorted by monomial, distinct and non-zero, so that equal sums are equal objects whatever the order in which
/// they were built. Since 1, √2, √3, √6 are independent over the rationals, the sum vanishes identically in its value numbers
/// exactly when it has no term.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(Number constant);
  explicit Polynomial(ValueNumber value_number);
  explicit Polynomial(Term term);

  const std::vector<Term>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_[0].monomial.empty()); }
  bool is_single_value_number() const;                 ///< exactly one value number, exponent 1, coefficient 1
  Number constant() const;                     ///< its value when it is constant, else the constant term
  int sign() const;                            ///< sign of the leading coefficient: 0 for zero

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator*=(const Number& factor);
  void erase(std::size_t term) { terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(term)); }
  void add(Term term);

  friend bool operator==(const Polynomial&, const Polynomial&) = default;
  std::size_t hash() const;

 private:
  std::vector<Term> terms_;
};

struct HashOfPolynomial {
  std::size_t operator()(const Polynomial& polynomial) const { return polynomial.hash(); }
};

}  // namespace torsor
