// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/division_by_zero.hpp"
#include "torsor/generator/program/paired_signs.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {
namespace {

Program* common_program(const Value& a, const Value& b) {
  if (a.program() != nullptr && b.program() != nullptr && a.program() != b.program()) {
    throw Error(fmt::format("{} and {} belong to different programs", to_string(a), to_string(b)));
  }
  return a.program() != nullptr ? a.program() : b.program();
}

/// The value as one term: a sum is bound first.
Term as_term(const Value& value) {
  if (value.polynomial().terms().size() == 1) return value.polynomial().terms()[0];
  return value.program()->bind(value).polynomial().terms()[0];
}

}  // namespace

Value::Value(Program& program, Polynomial polynomial, Unit unit)
    : program_(&program), polynomial_(std::move(polynomial)), unit_(unit) {}

std::optional<ValueNumber> Value::value_number() const {
  if (!polynomial_.is_single_value_number()) return std::nullopt;
  return polynomial_.terms()[0].monomial[0].value_number;
}

Value& Value::operator+=(const Value& other) {
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  program_ = common_program(*this, other);
  if (!(unit_ == other.unit_)) {
    throw UnitError(fmt::format("cannot add {} [{}] and {} [{}]: both terms of a sum need the same unit",
                                to_string(*this), unit_.to_string(), to_string(other), other.unit_.to_string()));
  }
  polynomial_ += other.polynomial_;
  program_->simplify(polynomial_);
  return *this;
}

Value operator-(Value a) {
  a.polynomial_ *= Number(-1);
  return a;
}
Value& Value::operator-=(const Value& other) { return *this += -other; }

Value operator*(const Number& a, Value b) {
  b.polynomial_ *= a;
  return b;
}

Value operator*(const Value& a, const Value& b) {
  const Unit unit = a.unit_ * b.unit_;
  if (a.is_zero() || b.is_zero()) {
    Value zero;
    zero.program_ = common_program(a, b);
    zero.unit_ = unit;
    return zero;
  }
  Program& program = *common_program(a, b);
  if (a.is_constant() || b.is_constant()) {
    Polynomial scaled = a.is_constant() ? b.polynomial_ : a.polynomial_;
    scaled *= a.is_constant() ? a.polynomial_.constant() : b.polynomial_.constant();
    return {program, std::move(scaled), unit};
  }
  const Term left = as_term(a);  // named, so that every compiler binds sums in the same order
  const Term right = as_term(b);
  return {program, Polynomial(product(program, left, right)), unit};
}

Value pow(const Value& base, int exponent) {
  if (exponent == 0) return {*base.program(), Polynomial(Number(1)), Unit()};
  const Unit unit = base.unit_.pow(exponent);
  if (base.is_zero()) {
    if (exponent < 0) throw DivisionByZero();
    return base;
  }
  return {*base.program(), Polynomial(power(*base.program(), as_term(base), exponent)), unit};
}

std::string label(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
  if (definition.symbol) return definition.symbol->name;
  if (definition.function) {
    std::string inside;
    for (const ValueNumber argument : definition.arguments)
      inside += (inside.empty() ? "" : ", ") + label(program, argument);
    return fmt::format("{}({})", to_string(*definition.function), inside);
  }
  return definition.name.empty() ? fmt::format("z{}", value_number) : definition.name;
}

std::string to_string(const Value& value) {
  std::string text;
  for (const Term& term : value.polynomial().terms()) {
    if (!text.empty()) text += " + ";
    text += term.coefficient.to_string();
    for (const Factor& factor : term.monomial) {
      text += " " + label(*value.program(), factor.value_number);
      if (factor.exponent != 1) text += fmt::format("^{}", factor.exponent);
    }
  }
  return text.empty() ? "0" : text;
}

}  // namespace torsor
