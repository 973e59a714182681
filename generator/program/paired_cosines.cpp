// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/paired_cosines.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/program/flattening.hpp"

namespace torsor {
namespace {

constexpr std::size_t most_terms = 24;  ///< a term for each pair of a body and a link that carries it, of six links

/// A term as coefficient · rest · cos(angle), or sin; without either its angle is zero.
struct Wave {
  Number coefficient;
  Monomial rest;
  Function function = Function::cos;
  Value angle;
  bool taken = false;
};

/// Nothing of a term with more than one sine or cosine.
std::optional<Wave> wave(Program& program, const Term& term) {
  Wave found{term.coefficient, {}, Function::cos, {}};
  bool any = false;
  for (const Factor& factor : term.monomial) {
    const Definition& definition = program[factor.value_number];
    if (definition.function != Function::cos && definition.function != Function::sin) {
      found.rest.push_back(factor);
      continue;
    }
    if (any || factor.exponent != 1) return std::nullopt;
    any = true;
    found.function = *definition.function;
    // Of 1 rad/s times t nothing but t is left, with a unit that is no angle's.
    found.angle = Value(program, program.argument(definition, 0).polynomial(), Unit());
  }
  return found;
}

bool leaves_little(const Number& left, const Number& whole) {
  return (Number(4) * left.abs() - whole.abs()).sign() < 0;
}

class Pairing {
 public:
  Pairing(Program& program, const Value& whole) : program_(program), whole_(whole) {}

  /// Nothing where no pair is found.
  std::optional<Value> run(const Polynomial& sum) {
    for (const Term& term : sum.terms()) {
      std::optional<Wave> found = wave(program_, term);
      if (!found) {
        others_.add(term);
        continue;
      }
      waves_.push_back(std::move(*found));
    }
    bool any = false;
    for (std::size_t i = 0; i < waves_.size(); ++i) {
      for (std::size_t j = i + 1; j < waves_.size() && !waves_[i].taken; ++j) any = pair(waves_[i], waves_[j]) || any;
    }
    if (!any) return std::nullopt;
    Value result(program_, std::move(others_), whole_.unit());
    for (const Wave& each : waves_) {
      if (each.taken) continue;
      const Value factor =
          each.angle.is_zero() ? program_.number(Number(1)) : program_.apply(each.function, each.angle);
      result += term(each.coefficient, each.rest, factor);
    }
    return result + products_;
  }

 private:
  /// What is left of the larger one stays with it, for a further partner.
  bool pair(Wave& a, Wave& b) {
    if (a.taken || b.taken || a.function != b.function || a.rest != b.rest) return false;
    const bool same_sign = a.coefficient.sign() == b.coefficient.sign();
    Wave& larger = (a.coefficient.abs() - b.coefficient.abs()).sign() < 0 ? b : a;
    Wave& smaller = &larger == &a ? b : a;
    const Number left = same_sign ? larger.coefficient - smaller.coefficient : larger.coefficient + smaller.coefficient;
    if (!left.is_zero() && !leaves_little(left, larger.coefficient)) return false;
    const Number half = Number::rational(1, 2);
    const Value mean = program_.bind(half * (larger.angle + smaller.angle));
    const Value apart = program_.bind(half * (larger.angle - smaller.angle));
    // cos x + cos y = 2 cos m cos d, cos x − cos y = −2 sin m sin d, sin x ± sin y = 2 sin m cos d, 2 cos m sin d.
    const bool cosines = a.function == Function::cos;
    const Value first = cosines == same_sign ? program_.cos(mean) : program_.sin(mean);
    const Value second = same_sign ? program_.cos(apart) : program_.sin(apart);
    const Number taken = larger.coefficient - left;
    products_ += term(Number(cosines && !same_sign ? -2 : 2) * taken, a.rest, program_.bind(first * second));
    larger.coefficient = left;
    larger.taken = left.is_zero();
    smaller.taken = true;
    return true;
  }

  Value term(const Number& coefficient, const Monomial& rest, const Value& factor) const {
    return Value(program_, Polynomial(Term{rest, coefficient}), whole_.unit() / factor.unit()) * factor;
  }

  Program& program_;
  const Value& whole_;
  std::vector<Wave> waves_;
  Polynomial others_;
  Value products_;
};

}  // namespace

Value with_paired_cosines(Program& program, const Value& sum) {
  if (sum.is_constant()) return sum;
  const std::optional<Value> flat = Flattening(program, most_terms)(sum);
  return flat ? Pairing(program, *flat).run(flat->polynomial()).value_or(sum) : sum;
}

}  // namespace torsor
