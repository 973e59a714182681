// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/polynomial.hpp"

#include <algorithm>

namespace torsor {

Monomial operator*(const Monomial& a, const Monomial& b) {
  Monomial product;
  product.reserve(a.size() + b.size());
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->value_number < j->value_number)) {
      product.push_back(*i++);
    } else if (i == a.end() || j->value_number < i->value_number) {
      product.push_back(*j++);
    } else {
      const std::int32_t exponent = i->exponent + j->exponent;
      if (exponent != 0) product.push_back({i->value_number, exponent});
      ++i, ++j;
    }
  }
  return product;
}

Monomial pow(const Monomial& base, int exponent) {
  if (exponent == 0) return {};
  Monomial power = base;
  for (Factor& factor : power) factor.exponent *= exponent;
  return power;
}

Polynomial::Polynomial(Number constant) {
  if (!constant.is_zero()) terms_.push_back({{}, std::move(constant)});
}
Polynomial::Polynomial(ValueNumber value_number) { terms_.push_back({{{value_number, 1}}, Number(1)}); }
Polynomial::Polynomial(Term term) {
  if (!term.coefficient.is_zero()) terms_.push_back(std::move(term));
}

bool Polynomial::is_single_value_number() const {
  return terms_.size() == 1 && terms_[0].coefficient.is_one() && terms_[0].monomial.size() == 1 &&
         terms_[0].monomial[0].exponent == 1;
}

Number Polynomial::constant() const {
  // The empty monomial sorts first.
  return terms_.empty() || !terms_[0].monomial.empty() ? Number() : terms_[0].coefficient;
}

int Polynomial::sign() const { return terms_.empty() ? 0 : terms_[0].coefficient.sign(); }

void Polynomial::add(Term term) {
  const auto place = std::lower_bound(terms_.begin(), terms_.end(), term.monomial,
                                      [](const Term& t, const Monomial& m) { return t.monomial < m; });
  if (place == terms_.end() || place->monomial != term.monomial) {
    if (!term.coefficient.is_zero()) terms_.insert(place, std::move(term));
    return;
  }
  place->coefficient += term.coefficient;
  if (place->coefficient.is_zero()) terms_.erase(place);
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  if (other.terms_.size() <= 2) {
    for (const Term& term : other.terms_) add(term);
    return *this;
  }
  std::vector<Term> sum;
  sum.reserve(terms_.size() + other.terms_.size());
  auto i = terms_.begin();
  auto j = other.terms_.begin();
  while (i != terms_.end() || j != other.terms_.end()) {
    if (j == other.terms_.end() || (i != terms_.end() && i->monomial < j->monomial)) {
      sum.push_back(std::move(*i++));
    } else if (i == terms_.end() || j->monomial < i->monomial) {
      sum.push_back(*j++);
    } else {
      Number coefficient = i->coefficient + j->coefficient;
      if (!coefficient.is_zero()) sum.push_back({std::move(i->monomial), std::move(coefficient)});
      ++i, ++j;
    }
  }
  terms_ = std::move(sum);
  return *this;
}

Polynomial& Polynomial::operator*=(const Number& factor) {
  if (factor.is_zero()) {
    terms_.clear();
  } else if (!factor.is_one()) {
    for (Term& term : terms_) term.coefficient *= factor;
  }
  return *this;
}

std::size_t Polynomial::hash() const {
  std::size_t h = terms_.size();
  const auto mix = [&h](std::size_t value) { h = (h ^ (value + 0x9e3779b97f4a7c15ULL + (h << 6U) + (h >> 2U))); };
  for (const Term& term : terms_) {
    mix(term.coefficient.hash());
    for (const Factor& factor : term.monomial) {
      mix(static_cast<std::size_t>(factor.value_number) * 31U + static_cast<std::size_t>(factor.exponent + 7));
    }
  }
  return h;
}

}  // namespace torsor
