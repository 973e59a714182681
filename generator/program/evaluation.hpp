// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/formula_code.hpp"
#include "torsor/generator/program/function_values.hpp"
#include "torsor/generator/program/program.hpp"

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
    ++state_;
  }

  /// What a number is to the scalar, in place of `of_number`; asked once for each. To be set before any evaluation.
  void set_constants(std::function<Scalar(const Number&)> of_number) { of_number_ = std::move(of_number); }

  /// Gives a definition its value, at every state: what a header has as a literal.
  void fix(ValueNumber value_number, Scalar value) {
    fixed_.insert_or_assign(value_number, std::move(value));
    if (static_cast<std::size_t>(value_number) < parts_.size()) parts_[static_cast<std::size_t>(value_number)].reset();
  }

  Scalar operator()(const Value& value) {
    grow();
    const std::optional<ValueNumber> value_number = value.value_number();
    if (!value_number) return of_sum(value.polynomial());
    know(*value_number);
    return *known_[static_cast<std::size_t>(*value_number)].value;
  }

  /// A value that was looked up once, for many states: to find the formula of a sum takes as long as to evaluate it.
  class Ready {
    friend class Evaluator;
    std::optional<Scalar> constant;
    std::optional<ValueNumber> definition;
    bool minus = false;  ///< that definition
    FormulaCode::Part part{};
  };
  Ready ready(const Value& value) {
    Ready result;
    result.definition = value.value_number();
    if (result.definition) return result;
    const Polynomial& sum = value.polynomial();
    result.definition = minus_which(sum);
    result.minus = result.definition.has_value();
    if (result.minus) return result;
    result.part = without_number(sum);
    if constexpr (!std::is_same_v<Scalar, Real>) {  // whose digits may change
      if (sum.is_constant()) result.constant = of_part(result.part);
    }
    return result;
  }
  Scalar operator()(const Ready& value) {
    if (value.constant) return *value.constant;
    grow();
    if (!value.definition) return of_part(value.part);
    know(*value.definition);
    const Scalar& known = *known_[static_cast<std::size_t>(*value.definition)].value;
    return value.minus ? Scalar(-known) : known;
  }

  /// All of them, in order.
  std::vector<Scalar> operator()(const std::vector<Value>& values) {
    std::vector<Scalar> results;
    results.reserve(values.size());
    for (const Value& value : values) results.push_back((*this)(value));
    return results;
  }

 private:
  struct Known {
    std::optional<Scalar> value;
    std::uint64_t state = 0;  ///< where it was computed
  };

  void grow() {
    known_.resize(program_->size());
    parts_.resize(program_->size());
    if constexpr (std::is_same_v<Scalar, Real>) {
      if (constant_digits_ == Real::working_digits()) return;
      constant_digits_ = Real::working_digits();
      constants_.clear();
    }
  }

  Scalar rounded(const Number& number) const {
    if constexpr (std::is_same_v<Scalar, Real>) {
      return Real(number, constant_digits_);
    } else {
      if (of_number_) return of_number_(number);
      if constexpr (requires { Scalar::of_number(number); }) {
        return Scalar::of_number(number);
      } else {
        return number.to_double();
      }
    }
  }

  const Scalar& constant(std::size_t place) {
    if (place >= constants_.size()) constants_.resize(code_.constants().size());
    std::optional<Scalar>& known = constants_[place];
    if (!known) known = rounded(code_.constants()[place]);
    return *known;
  }

  // The definition that a sum is minus of.
  std::optional<ValueNumber> minus_which(const Polynomial& sum) const {
    const std::vector<Term>& terms = sum.terms();
    const bool one = terms.size() == 1 && terms[0].monomial.size() == 1 && terms[0].monomial[0].exponent == 1;
    return one && terms[0].coefficient == minus_one_ ? std::optional(terms[0].monomial[0].value_number) : std::nullopt;
  }

  // Most entries of a Jacobian are zero, or minus a definition: neither is looked up.
  Scalar of_sum(const Polynomial& sum) {
    if (sum.terms().empty() && zero_) return *zero_;
    if (const std::optional<ValueNumber> of = minus_which(sum)) {
      know(*of);
      return -*known_[static_cast<std::size_t>(*of)].value;
    }
    const Scalar& result = of_part(without_number(sum));
    if (sum.terms().empty()) zero_ = result;
    return result;
  }

  const FormulaCode::Part& without_number(const Polynomial& sum) {
    const auto known = without_number_.find(sum);
    if (known != without_number_.end()) return known->second;
    return without_number_.emplace(sum, code_.add(formula(*program_, sum))).first->second;
  }

  const Scalar& of(const FormulaCode::Operand& operand) {
    switch (operand.kind) {
      case FormulaCode::Operand::Kind::value_number: return *known_[operand.index].value;
      case FormulaCode::Operand::Kind::constant: return constant(operand.index);
      case FormulaCode::Operand::Kind::result: break;
    }
    return registers_[operand.index];
  }

  Scalar called(const FormulaCode::Operation& each) {
    arguments_.clear();
    for (std::size_t i = 0; i < each.right.index; ++i) {
      arguments_.push_back(*known_[static_cast<std::size_t>(code_.needs()[each.left.index + i])].value);
    }
    return value_of_call(each.function, arguments_);
  }

  const Scalar& of_part(const FormulaCode::Part part) {
    for (std::size_t i = part.first_need; i < part.last_need; ++i) know(code_.needs()[i]);
    if (registers_.size() < code_.registers()) registers_.resize(code_.registers());
    for (std::size_t i = part.first; i < part.last; ++i) {
      using Kind = FormulaCode::Operation::Kind;
      const FormulaCode::Operation& each = code_.operations()[i];
      Scalar& result = registers_[each.result];
      switch (each.kind) {
        case Kind::negate: result = -of(each.left); break;
        case Kind::add: result = of(each.left) + of(each.right); break;
        case Kind::subtract: result = of(each.left) - of(each.right); break;
        case Kind::multiply: result = of(each.left) * of(each.right); break;
        case Kind::divide: result = of(each.left) / of(each.right); break;
        case Kind::call: result = called(each); break;
      }
    }
    return of(part.result);
  }

  void know(ValueNumber value_number) {
    const auto index = static_cast<std::size_t>(value_number);
    if (known_[index].state == state_) return;
    if (parts_[index]) {
      known_[index].value = of_part(*parts_[index]);
    } else {
      look_up(value_number);
    }
    known_[index].state = state_;
  }

  void look_up(ValueNumber value_number) {
    const auto index = static_cast<std::size_t>(value_number);
    const Definition& definition = (*program_)[value_number];
    if (definition.symbol) {
      known_[index].value = symbol_value_(definition.symbol);
    } else if (const auto fixed = fixed_.find(value_number); fixed != fixed_.end()) {
      known_[index].value = fixed->second;
    } else {
      parts_[index] = code_.add(formula(*program_, definition));
      known_[index].value = of_part(*parts_[index]);
    }
  }

  const Program* program_;
  SymbolValue symbol_value_;
  std::uint64_t state_ = 1;
  std::vector<Known> known_;
  FormulaCode code_;
  std::vector<std::optional<FormulaCode::Part>> parts_;  ///< of definitions
  std::unordered_map<Polynomial, FormulaCode::Part, HashOfPolynomial> without_number_;  ///< looked up only
  std::vector<std::optional<Scalar>> constants_;  ///< rounding an exact number takes longer than using it
  std::unordered_map<ValueNumber, Scalar> fixed_;        ///< looked up only
  std::function<Scalar(const Number&)> of_number_;
  const Number minus_one_ = Number(-1);
  std::optional<Scalar> zero_;
  int constant_digits_ = 0;  ///< of Real: those that the constants were rounded to
  std::vector<Scalar> registers_, arguments_;
};

extern template class Evaluator<double>;
extern template class Evaluator<Real>;

}  // namespace torsor
