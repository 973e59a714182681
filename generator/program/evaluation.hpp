// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "generator/base/high_precision.hpp"
#include "generator/program/formula.hpp"
#include "generator/program/function_values.hpp"
#include "generator/program/program.hpp"

namespace torsor {

/// Evaluates values of a program in `double` or `Real`, each definition once, factored as it is emitted; constants are
/// rounded once. (The terms of a text stand in another order: see listing_evaluator.hpp.) `move_to` evaluates at another state without new formulas.
/// Any other scalar tells by a static `of_number(Number)` what a constant is to it.
template <class Scalar>
class Evaluator {
 public:
  /// Value of a symbol in its SI unit.
  using SymbolValue = std::function<Scalar(const SymbolPointer&)>;

  Evaluator(const Program& program, SymbolValue symbol_value)
      : program_(&program), symbol_value_(std::move(symbol_value)) {}

  void move_to(SymbolValue symbol_value) {
    symbol_value_ = std::move(symbol_value);
    known_.assign(known_.size(), std::nullopt);
  }

  /// What a number is to the scalar, in place of `of_number`; asked once for each. To be set before any evaluation.
  void set_constants(std::function<Scalar(const Number&)> of_number) { of_number_ = std::move(of_number); }

  /// Gives a definition its value, at every state: what a header has as a literal.
  void fix(ValueNumber value_number, Scalar value) { fixed_.insert_or_assign(value_number, std::move(value)); }

  Scalar operator()(const Value& value) {
    grow();
    const std::optional<ValueNumber> value_number = value.value_number();
    return value_number ? of_value_number(*value_number) : of_formula(formula(*program_, value.polynomial()));
  }

  /// All of them, in order.
  std::vector<Scalar> operator()(const std::vector<Value>& values) {
    std::vector<Scalar> results;
    results.reserve(values.size());
    for (const Value& value : values) results.push_back((*this)(value));
    return results;
  }

 private:
  Scalar constant(const Number& number) {
    if constexpr (std::is_same_v<Scalar, Real>) {
      const int digits = Real::working_digits();
      if (number.is_rational()) return Real(number, digits);  // one division
      if (constant_digits_ != digits) constants_.clear();
      constant_digits_ = digits;
      if (const auto place = constants_.find(number); place != constants_.end()) return place->second;
      return constants_.emplace(number, Real(number, digits)).first->second;
    } else {
      if (const auto place = constants_.find(number); place != constants_.end()) return place->second;
      if (of_number_) return constants_.emplace(number, of_number_(number)).first->second;
      if constexpr (requires { Scalar::of_number(number); }) {
        return constants_.emplace(number, Scalar::of_number(number)).first->second;
      } else {
        return constants_.emplace(number, number.to_double()).first->second;
      }
    }
  }

  void grow() {
    known_.resize(program_->size());
    formulas_.resize(program_->size());
  }

  Scalar of_formula(const Formula& formula) {
    switch (formula.kind) {
      case Formula::Kind::constant: return constant(formula.number);
      case Formula::Kind::value_number: return of_value_number(formula.value_number);
      case Formula::Kind::function: {
        std::vector<Scalar> arguments;
        arguments.reserve(formula.children.size());
        for (const Formula& child : formula.children) arguments.push_back(of_value_number(child.value_number));
        return value_of_call(formula.function, arguments);
      }
      case Formula::Kind::quotient: {
        const Scalar numerator = of_formula(formula.children[0]);
        return numerator / of_formula(formula.children[1]);
      }
      case Formula::Kind::sum:
      case Formula::Kind::product: break;
    }
    const bool sum = formula.kind == Formula::Kind::sum;
    Scalar result = of_formula(formula.children[0]);
    if (sum && formula.negative[0]) result = -result;
    for (std::size_t i = 1; i < formula.children.size(); ++i) {
      const Scalar next = of_formula(formula.children[i]);
      if (!sum) {
        result = result * next;
      } else {
        result = formula.negative[i] ? result - next : result + next;
      }
    }
    return result;
  }

  Scalar of_value_number(ValueNumber value_number) {
    const auto index = static_cast<std::size_t>(value_number);
    if (known_[index]) return *known_[index];
    const Definition& definition = (*program_)[value_number];
    if (definition.symbol) {
      known_[index] = symbol_value_(definition.symbol);
    } else if (const auto fixed = fixed_.find(value_number); fixed != fixed_.end()) {
      known_[index] = fixed->second;
    } else {
      if (!formulas_[index]) formulas_[index] = formula(*program_, definition);
      known_[index] = of_formula(*formulas_[index]);
    }
    return *known_[index];
  }

  const Program* program_;
  SymbolValue symbol_value_;
  std::vector<std::optional<Scalar>> known_;
  std::vector<std::optional<Formula>> formulas_;
  std::unordered_map<ValueNumber, Scalar> fixed_;        // looked up only, and so the next one
  std::function<Scalar(const Number&)> of_number_;
  std::unordered_map<Number, Scalar> constants_;  // rounding an exact number takes longer than using it
  int constant_digits_ = 0;                       // of Real: those that the constants were rounded to
};

extern template class Evaluator<double>;
extern template class Evaluator<Real>;

}  // namespace torsor
