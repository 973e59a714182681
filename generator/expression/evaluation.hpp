// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "generator/expression/high_precision.hpp"
#include "generator/expression/program.hpp"

namespace torsor {

/// Evaluates values of a program in `double` or `Real`, each definition once. Exact constants are rounded once.
template <class Scalar>
class Evaluator {
 public:
  /// Value of a symbol in its SI unit.
  using SymbolValue = std::function<Scalar(const SymbolPointer&)>;

  Evaluator(const Program& program, SymbolValue symbol_value)
      : program_(&program), symbol_value_(std::move(symbol_value)) {}

  Scalar operator()(const Value& value) { return of_polynomial(value.polynomial()); }

 private:
  static Scalar constant(const Number& number) {
    if constexpr (std::is_same_v<Scalar, Real>) {
      return Real(number, Real::working_digits());
    } else {
      return number.to_double();
    }
  }

  static Scalar apply(Function function, const Scalar& x) {
    using std::cos, std::exp, std::log, std::sin, std::sqrt;
    switch (function) {
      case Function::sin: return sin(x);
      case Function::cos: return cos(x);
      case Function::sqrt: return sqrt(x);
      case Function::exp: return exp(x);
      case Function::log: return log(x);
    }
    return x;
  }

  Scalar power(const Scalar& x, int exponent) {
    Scalar result = constant(Number(1));
    for (int k = 0; k < std::abs(exponent); ++k) result = result * x;
    return exponent < 0 ? constant(Number(1)) / result : result;
  }

  Scalar of_polynomial(const Polynomial& polynomial) {
    Scalar sum = constant(Number());
    for (const Term& term : polynomial.terms()) {
      Scalar product = constant(term.coefficient);
      for (const Factor& factor : term.monomial) product = product * power(of_atom(factor.atom), factor.exponent);
      sum = sum + product;
    }
    return sum;
  }

  Scalar of_atom(Atom atom) {
    const auto index = static_cast<std::size_t>(atom);
    if (known_.size() <= index) known_.resize(program_->size());
    if (known_[index]) return *known_[index];
    const Definition& definition = (*program_)[atom];
    Scalar value = constant(Number());
    if (definition.symbol) {
      value = symbol_value_(definition.symbol);
    } else if (definition.function) {
      value = apply(*definition.function, of_atom(definition.argument));
    } else {
      value = of_polynomial(definition.polynomial);
    }
    known_[index] = value;
    return value;
  }

  const Program* program_;
  SymbolValue symbol_value_;
  std::vector<std::optional<Scalar>> known_;
};

/// Whether a value vanishes identically: exactly when it has no term, else tested at three pseudo-random states with
/// 60 digits (an identity of analytic functions fails at a random point with probability one).
bool vanishes(const Value& value);

}  // namespace torsor
